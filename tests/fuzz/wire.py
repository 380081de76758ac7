"""Fuzzing of replies, of requests to simulated devices, and of control lines."""

from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any, Protocol

from tests.devices.aracna.session.scripted_session import ScriptedSession
from tests.devices.trex.session.helpers import packet
from tests.fuzz.fuzzing import InputFactory, Target, mutations
from tests.support.aracna import AracnaHarness
from tests.support.virtual import SessionHarness, VirtualTransport
from trex_gui.composition import PLUGINS
from trex_gui.core.discovery.scan import scan_port
from trex_gui.core.errors import PortUnavailable
from trex_gui.core.session import Closed, Outcome
from trex_gui.core.simulator.rfc2217_endpoint import Rfc2217Endpoint
from trex_gui.core.transport.settings import Parity, PortSettings, SerialFormat
from trex_gui.core.transport.traffic import (
    Decoder,
    TrafficDirection,
    TrafficEvent,
    TransactionAssembler,
)
from trex_gui.devices.aracna.session import messages as robot
from trex_gui.devices.aracna.session.errors import ErrorCode as RobotErrorCode
from trex_gui.devices.aracna.session.traffic_decoder import AracnaDecoder
from trex_gui.devices.aracna.simulator.control import control as control_robot
from trex_gui.devices.aracna.simulator.line import STORED_BYTES, AracnaLine
from trex_gui.devices.trex.driving.requests import Arm, Heartbeat, SetAuxiliary, SetMotor, Stop
from trex_gui.devices.trex.protocol.calibration import Calibration, CalibrationKey
from trex_gui.devices.trex.protocol.commands import GetSignature, SetParameter
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.devices.trex.protocol.driving import Drive
from trex_gui.devices.trex.protocol.errors import ErrorCode
from trex_gui.devices.trex.protocol.flags import InputSource
from trex_gui.devices.trex.protocol.framing import Framing
from trex_gui.devices.trex.protocol.line_settings import Detection, LineSettings
from trex_gui.devices.trex.session import messages as board
from trex_gui.devices.trex.session.traffic_decoder import TrexDecoder
from trex_gui.devices.trex.simulator.control import control as control_board
from trex_gui.devices.trex.simulator.control import report
from trex_gui.devices.trex.simulator.firmware import Board
from trex_gui.devices.trex.simulator.line import SimulatedBoards
from trex_gui.devices.trex.simulator.memory import Eeprom
from trex_gui.devices.trex.simulator.uart import SEND_BUFFER

MAX_READS = 30_000
"""Reads of a session or scan that does not hang. Without faults, a tenth of them suffices."""

MAX_REPLIES = 10_000
"""Bytes of replies that the host may not yet have read after a block of requests."""


class Wire(Protocol):
    """Transport with a simulated line."""

    line: Any

    def clock(self) -> float: ...


class LineFault:
    """Corrupts replies. A byte of the data specifies the fault of a read, until the data ends."""

    def __init__(self, data: bytes) -> None:
        self._data = data
        self._position = 0
        self._unread = b""
        self.reads = 0

    def _read(self, size: int) -> bytes:
        data = self._data[self._position : self._position + size]
        self._position += size
        return data

    def __call__(self, wire: Wire, received: bytes, size: int) -> bytes:
        self.reads += 1
        assert self.reads < MAX_READS, f"the program still reads at {wire.clock():.3f} s"
        received = self._unread + received
        (kind,) = self._read(1) or b"\0"
        number = kind % 16
        match kind // 16:
            case 6:
                received = b""
            case 7:
                received = received[:number]
            case 8:
                received = self._read(max(number, len(received)))
            case 9:
                received = self._read(number) + received
            case 10:
                received += self._read(number)
            case 11:
                received = bytes(byte ^ 1 << number % 8 for byte in received)
            case 12:
                wire.line.advance(number / 10)
            case 13:
                wire.line.inject(self._read(number))
            case 14:
                received += received[:100]
            case 15 if number == 15:
                raise PortUnavailable("The line is gone.")
            case 15 if number == 14:
                _first_board(wire).power_off()
            case 15 if number == 13:
                _first_board(wire).power_on()
        self._unread = received[size:]
        return received[:size]


def _first_board(wire: Wire) -> Any:
    station = wire.line.stations[0]
    return getattr(station, "board", station)


def _add_fault(transport: Any, fault: LineFault) -> None:
    read = transport.read
    transport.read = lambda size, seconds: fault(transport, read(size, seconds), size)


# --- Replies to the program -------------------------------------------------------------

BOARD_REQUESTS: Sequence[tuple[float, board.Request]] = (
    (0.8, board.Write(1, (("serial_timeout", 5), ("motor_mode", 0)))),
    (1.2, Arm()),
    (1.3, SetMotor(1, Drive.at(60))),
    (1.3, SetAuxiliary(30)),
    (1.4, Heartbeat()),
    (1.6, packet(2, GetSignature())),
    (1.8, Stop(3)),
    (2.2, board.Write(4, (), ((CalibrationKey.of(InputSource.RC, 1), Calibration(1, 2, 3, 1)),))),
    (2.6, board.Write(5, (("uart_settings", 0x05),))),
    (2.8, packet(6, SetParameter(0, 8))),
    (3.0, board.Reload(7)),
)


def check_board_replies(data: bytes, folder: Path) -> None:
    """Check a session. The first byte selects line settings, the other bytes are faults."""
    flags = data[0] if data else 0
    line = LineSettings(19200, Detection.CRC7 if flags & 1 else Detection.NONE)
    eeprom = Eeprom()
    eeprom.write("uart_settings", line.to_wire())
    harness = SessionHarness(Board(eeprom=eeprom), echo=bool(flags & 2))
    fault = LineFault(data[1:])
    if flags & 8:  # the faults begin after the connection
        harness.script.at(0.5, lambda: _add_fault(harness.transport, fault))
    else:
        _add_fault(harness.transport, fault)
    for time, request in BOARD_REQUESTS:
        harness.script.at(time, request)
    reports = harness.run(ConnectionSettings("virtual", line, 7 if flags & 4 else None))
    unsent = [request for _, request in harness.script._steps]
    sent = [request for _, request in BOARD_REQUESTS if request not in unsent]
    _check_session(reports, sent, ErrorCode.INTERNAL)
    assert harness.transport.closed
    assert harness.line.now < 60


def _check_session(reports: Sequence[Any], requests: Sequence[Any], internal: object) -> None:
    """Check that a session ends without an internal error, and each request with one outcome."""
    ids = [request.id for request in requests if hasattr(request, "id")]
    last = reports[-1]
    assert isinstance(last, Closed)
    assert getattr(last.error, "code", None) is not internal, str(last.error)
    assert sorted(report.id for report in reports if isinstance(report, Outcome)) == ids
    for each in reports:
        str(getattr(each, "error", "")).encode()


ROBOT_REQUESTS: Sequence[tuple[float, robot.Request]] = (
    (0.5, robot.SetSpeeds(1, (300,) * 8)),
    (0.6, robot.Move(2, (500,) * 8, (200,) * 8)),
    (1.5, robot.Move(3, (510,) * 8, dragged=True)),
    (1.8, robot.Play(4, (robot.Step((520,) * 8, 0.3), robot.Step((500,) * 8, 0.3)), 2)),
    (2.5, robot.EndPlay()),
    (3.0, robot.Halt()),
)


def check_robot_replies(data: bytes, folder: Path) -> None:
    session = ScriptedSession()
    _add_fault(session.stage.transport, LineFault(data))
    for time, request in ROBOT_REQUESTS:
        session.at(time, request)
    reports = session.until(6.0).run().reports
    unsent = [request for _, request in session._actions]
    sent = [request for _, request in ROBOT_REQUESTS if request not in unsent]
    _check_session(reports, sent, RobotErrorCode.INTERNAL)
    assert session.stage.transport.closed
    assert session.line.now < session.started_at + 120


def check_scan(data: bytes, folder: Path) -> None:
    """Scan for every kind of device on a line with corrupted replies."""
    transport: Any = VirtualTransport(SimulatedBoards([Board()]))
    if data[:1] > b"\x80":
        transport = AracnaHarness().transport
    _add_fault(transport, LineFault(data[1:]))
    probers = {plugin.key: plugin.prober.load() for plugin in PLUGINS}
    result = scan_port(PortSettings("virtual"), probers, open_wire=lambda _: transport)
    assert not str(result.error).startswith("Internal error"), result.lines
    assert result.device or result.lines
    assert transport.closed


REPLIES: Sequence[bytes] = (
    *(b"TReX1.2", b"TReXJr1.3", b"r", b"\0", b"\x0f", b"\xff", b"\x60" * 8, b"\xff\xfe"),
    *(b".q1,8\r\n", b".h\r\n", b".c512,", b".v300,300,300,300,300,300,300,300\r\n", b"-1"),
    *(b"\xd8", b"\xf0", b"\xb1"),
)


# --- Rows of the traffic log ------------------------------------------------------------


def check_traffic(data: bytes, folder: Path) -> None:
    for decoder in (TrexDecoder(), AracnaDecoder()):
        _check_rows(decoder, data)


def _check_rows(decoder: Decoder, data: bytes) -> None:
    """Check the bytes in pieces. A byte before each piece specifies its direction and length."""
    assembler = TransactionAssembler(decoder)
    line = LineSettings(19200, Detection.CRC7 if data[:1] > b"\x80" else Detection.NONE)
    settings = ConnectionSettings("virtual", line)
    events = [TrafficEvent(0.0, TrafficDirection.LINE, text="Opened.", settings=settings)]
    assembler.echo = data[:1] > b"\xc0"
    at = 1
    while at < len(data):
        length = data[at] % 32 + 1
        direction = TrafficDirection.SENT if data[at] & 0x40 else TrafficDirection.RECEIVED
        piece = data[at + 1 : at + 1 + length]
        if piece:
            events.append(TrafficEvent(at / 100, direction, piece))
        at += 1 + length
    rows = {row.number: row for event in events for row in assembler.feed([event])}
    for row in rows.values():
        assert decoder.decoded(row).text
        assert decoder.display_text(row.sent).isprintable()
        assert decoder.display_text(row.received).isprintable()
    for direction in (TrafficDirection.SENT, TrafficDirection.RECEIVED):
        logged = b"".join(event.data for event in events if event.direction is direction)
        listed = b"".join(
            row.sent if direction is TrafficDirection.SENT else row.received
            for row in rows.values()
        )
        assert listed == logged


def _traffic_samples() -> Sequence[bytes]:
    pairs = [
        (b"\x81", b"TReX1.2"),
        (b"\x9f\x07", b"\x0f"),
        (b".q\n", b".q1,8\r\n"),
        (b".c512\n", b".c5"),
    ]
    log = b"".join(
        bytes([0x40 + len(sent) - 1]) + sent + bytes([len(received) - 1]) + received
        for sent, received in pairs
    )
    return [b"\0" + log, b"\x81" + log, b"\xff" + log]


# --- Requests to simulated devices ------------------------------------------------------


def check_board_requests(data: bytes, folder: Path) -> None:
    """Check boards, which must respond at the end. The first two bytes select the boards."""
    flags, mode = (*data[:2], 0, 0)[:2]
    boards = [Board(mode=("serial", "serial", "rc", "analog")[mode % 4], seed=0)]
    if flags & 1:
        eeprom = Eeprom()
        eeprom.write("device_number", 9)
        boards.append(Board(eeprom=eeprom))
    line = SimulatedBoards(boards, echo=bool(flags & 2), paced=bool(flags & 4))
    line.faults.noise = 0.1 if flags & 8 else 0.0
    for at in range(2, len(data), 40):
        line.send(data[at : at + 40])
        line.advance(0.05)
        _check_sizes(line)
        line.receive()
    line.advance(1.0)
    line.faults.noise = 0.0
    for simulated in boards:
        state = report(simulated)
        assert all(0 <= motor["speed"] <= 127 for motor in state["motors"])
        if mode % 4 > 1 and simulated is boards[0]:  # not in serial mode
            assert state["parameters"] == report(Board())["parameters"]
        simulated.memory.active["device_number"] = 7 if simulated is boards[0] else 9
    line.advance(simulated.memory.busy_for + 0.1)
    line.receive()
    line.send(b"\xff\xff")
    line.advance(0.1)
    line.receive()
    for simulated, number in zip(boards, (7, 9), strict=False):
        uart = simulated.memory.line_settings
        framing = Framing(number, simulated.memory.crc_polynomial)
        packet = framing.encode(GetSignature())
        line.host = uart
        line.send(packet)
        line.advance(0.3)
        assert b"TReX1.2" in line.receive(), (number, uart)
        line.host = None


def _check_sizes(line: Any) -> None:
    assert len(line._received) < MAX_REPLIES
    assert len(line._frames) < 100
    for station in line.stations:
        assert len(station.port.outgoing) <= SEND_BUFFER


class NetworkPort(Rfc2217Endpoint):
    """RFC 2217 protocol without a socket."""

    def __init__(self) -> None:
        self._baud, self._client = 19200, None
        self.on_connected()

    def drop_client(self) -> None:
        self._manager = None


def check_network_port(data: bytes, folder: Path) -> None:
    """Check data of an RFC 2217 client, as the server handles them."""
    port, line = NetworkPort(), SimulatedBoards([Board(seed=0)])
    for at in range(0, len(data), 30):
        for settings, received in port.arrivals(data[at : at + 30]):
            assert settings is not None
            line.host = SerialFormat(
                settings.baud, settings.parity or Parity.NONE, settings.stop_bits
            )
            line.send(received)
        line.advance(0.02)
        port.write(line.receive())


def check_robot_requests(data: bytes, folder: Path) -> None:
    """Send blocks with pauses. After a reset, the robot must respond."""
    flags = data[0] if data else 0
    harness = AracnaHarness(
        booted=bool(flags & 1), paced=bool(flags & 2), keeps_last=bool(flags & 4)
    )
    for at in range(1, len(data), 70):
        harness.line.send(data[at : at + 70])
        harness.line.advance(data[at] / 200)
        assert len(harness.line.station.held) <= STORED_BYTES
        assert len(harness.line.receive()) < MAX_REPLIES
    harness.line.drop_unsent()
    harness.do("reset")
    harness.line.advance(1.1)
    harness.line.receive()
    assert harness.request(b".q\n", 0.1) == b".q1,8\r\n"
    for servo in harness.line.servos:
        assert 0 <= servo.goal <= 1023
        assert 0 <= servo.speed <= 1023
        assert -1 < servo.position < 1024


PACKETS = tuple(
    bytes.fromhex(packet)
    for packet in (
        *("81", "82", "83", "84", "85", "86 1F", "87 1F", "8D", "8E", "8F", "9F 07", "FF", "81 48"),
        *("AF 07 05 55 2A", "AF 7F 7F 55 2A", "AF 7E 25 55 2A", "AF 7C 01 55 2A", "C1 7F"),
        *("A0 01 02 03 04 05 06 07 08 55 2A", "D0 7F 7F", "E0 7F 7F", "F0 7F"),
        *("80 07 01", "80 09 01", "80 07 2F 00 08 55 2A"),
    )
)
LINES: Sequence[bytes] = (
    *(b".c512,512,512,512,512,512,512,512\n", b".v1,1,1,1,1,1,1,1\n", b".q\n", b".l1\n"),
    *(b".c\n", b"\r", b",", b"-1", b".c999999999,1,1,1,1,1,1,1\n"),
)


TELNET = tuple(  # messages for baud rate, data bits, parity, stop bits, control, purge, options
    bytes.fromhex(message)
    for message in (
        *("FFFA2C0100004B00FFF0", "FFFA2C0208FFF0", "FFFA2C0301FFF0", "FFFA2C0401FFF0"),
        *("FFFA2C0501FFF0", "FFFA2C07FFF0", "FFFA2C0C03FFF0", "FFFB2C", "FFFD00", "FFFE01"),
        *("FFFC03", "FFFF", "8181", "FFFA2C01", "FFF0"),
    )
)


# --- Control lines ----------------------------------------------------------------------


def check_control(data: bytes, folder: Path) -> None:
    """Send control lines to one board, to two boards and to a robot."""
    numbered = Eeprom()
    numbered.write("device_number", 9)
    lines: Sequence[tuple[Any, Callable[[Any, str], str]]] = (
        (SimulatedBoards([Board(seed=0)]), control_board),
        (SimulatedBoards([Board(seed=0), Board(eeprom=numbered)]), control_board),
        (AracnaLine(), control_robot),
    )
    for line, control in lines:
        for text in data.decode("utf-8", "replace").split("\n")[:50]:
            reply = control(line, text)
            assert reply.startswith(("ok", "error ")), reply
            assert "\n" not in reply
            line.advance(0.02)


CONTROL_LINES = (
    *("channel 1 1500us", "channel 2 2.5V noise 2us", "channel 5 invalid", "factory", "reset"),
    *("channel 3 silent lost 0.5", "jumper mode rc", "jumper mix on", "jumper so-ground on"),
    *("power off", "power on", "power cycle", "load 1 5", "current 2 3.5", "current 1 auto"),
    *("fault 1 on", "battery 11.5 0.1", "eeprom device_number 8", "line mute on", "show"),
    *("line drop 5 sent", "line garbage FF80", "line noise 0.1", "line unplug", "line plug"),
    *("line error framing 3", "line cut 4", "@9 show", "quit", "servo 3 dead", "servo power off"),
    *("servo 2 load 0.5", "servo 1 lose position 3"),
)
WORDS = tuple(
    f" {word} ".encode()
    for word in (
        *("on", "off", "cycle", "auto", "rc", "nan", "inf", "1e999", "-1", "0x10"),
        *("\u0663", "\u00b2"),
        *("@7", "@9", "@", "99999999999999999999", "us", "V", "9us", "1500us"),
    )
)


# --- Targets ----------------------------------------------------------------------------


def _mutated(*samples: bytes, words: Sequence[bytes] = REPLIES) -> InputFactory:
    return mutations(lambda: samples, words)


NO_FAULTS = b"\0" * 40
ALL_PACKETS = b"".join(PACKETS)

WIRE_TARGETS = (
    Target(
        "board_replies",
        _mutated(NO_FAULTS, b"\x01" + b"\0\x6f" * 30, b"\x06" + b"\0\0\0\x83TReX" * 10),
        check_board_replies,
        examples=6,
    ),
    Target(
        "robot_replies",
        _mutated(NO_FAULTS, b"\0\x6f" * 30, b"\0\0\0\x97.q1,8\r\n" * 4),
        check_robot_replies,
        examples=8,
    ),
    Target(
        "scan",
        _mutated(NO_FAULTS, b"\0" + b"\x60" * 80, b"\xff" + b"\x83TReX1.2" * 9),
        check_scan,
        examples=8,
    ),
    Target("traffic", mutations(_traffic_samples, (*REPLIES, *PACKETS)), check_traffic),
    Target(
        "board_requests",
        _mutated(b"\0\0" + ALL_PACKETS, b"\x07\0" + ALL_PACKETS, words=PACKETS),
        check_board_requests,
        examples=15,
    ),
    Target(
        "robot_requests",
        _mutated(b"\x07" + b"".join(LINES), b"\0" + b".q\n" * 9, words=LINES),
        check_robot_requests,
        examples=20,
    ),
    Target(
        "control",
        _mutated(b"\n".join(map(str.encode, CONTROL_LINES)), words=WORDS),
        check_control,
        examples=15,
    ),
    Target("network_port", _mutated(*TELNET, words=TELNET), check_network_port, examples=20),
)
