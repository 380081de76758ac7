"""Helpers for session tests."""

from collections.abc import Callable, Iterable
from enum import Enum
from typing import Any, TypeVar, cast

from tests.devices.trex.simulator.ports import create_board
from tests.support.virtual import SessionHarness
from trex_gui.core.session import Close, Outcome
from trex_gui.devices.trex.client.client import Requester
from trex_gui.devices.trex.client.telemetry import Sample
from trex_gui.devices.trex.driving.requests import HEARTBEAT_INTERVAL, Heartbeat
from trex_gui.devices.trex.protocol.commands import Command, ReplyT_co
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.devices.trex.protocol.errors import TrexError
from trex_gui.devices.trex.protocol.framing import Framing, Packet, PacketParser
from trex_gui.devices.trex.protocol.line_settings import Detection, LineSettings
from trex_gui.devices.trex.protocol.raw_packets import packets_of
from trex_gui.devices.trex.session.messages import Report, SendPacket
from trex_gui.devices.trex.session.session import TrexSession
from trex_gui.devices.trex.simulator.firmware import Board
from trex_gui.devices.trex.simulator.memory import Eeprom
from trex_gui.devices.trex.simulator.motors import MotorDirection

KindT = TypeVar("KindT")


def create_harness(
    baud: int = 19200,
    detection: Detection = Detection.NONE,
    *,
    model: str = "trex",
    firmware: str = "1.2",
    mode: str = "serial",
    echo: bool = False,
) -> tuple[SessionHarness, ConnectionSettings]:
    """Return a harness for a board with these line settings, and its connection settings."""
    line = LineSettings(baud, detection)
    eeprom = Eeprom(model)
    eeprom.write("uart_settings", line.to_wire())
    board = Board(model, firmware, eeprom=eeprom, mode=mode)
    return SessionHarness(board, echo=echo), ConnectionSettings("virtual", line)


def fake_requester(
    harness: SessionHarness, kind: type[Command[Any]], replies: Iterable[object]
) -> Requester:
    """Return a requester that replaces the replies to one kind of command."""
    client, replacements = harness.client(), iter(replies)

    def request(command: Command[ReplyT_co]) -> ReplyT_co:
        reply = client.request(command)
        return cast("ReplyT_co", next(replacements)) if isinstance(command, kind) else reply

    return request


def packet(number: int, command: Command[Any]) -> SendPacket:
    """Return a request that sends the command as a typed packet."""
    (typed,) = packets_of(Framing().encode(command), None)
    return SendPacket(number, typed)


def of_type(reports: Iterable[object], kind: type[KindT]) -> list[KindT]:
    """Return the reports of one type, in their order."""
    return [report for report in reports if isinstance(report, kind)]


def outcomes(reports: Iterable[object]) -> dict[int, Outcome]:
    """Return the outcome of each request. Fail if a request has two."""
    found = of_type(reports, Outcome)
    by_id = {outcome.id: outcome for outcome in found}
    assert len(by_id) == len(found), "a request has two outcomes"
    return by_id


def error_code(reports: Iterable[object], request_id: int) -> Enum | None:
    """Return the code of the error of a request."""
    error = outcomes(reports)[request_id].error
    return error.code if isinstance(error, TrexError) else None


def samples(reports: Iterable[object], kind: type[KindT]) -> list[KindT]:
    """Return the samples of one type, in their order."""
    batches: list[Sample] = []
    for report in reports:
        batches += getattr(report, "samples", ())
    return of_type(batches, kind)


def commands(sent: bytes | bytearray, polynomial: int | None = None) -> list[Command[object]]:
    """Parse the sent packets. Fail if any is malformed."""
    parser = PacketParser(polynomial)
    events = parser.feed(bytes(sent)) + parser.flush()
    packets = of_type(events, Packet)
    assert len(packets) == len(events), "a sent packet is malformed"
    return [packet.command for packet in packets]


def motor_commands_in(
    sent: bytes | bytearray, polynomial: int | None = None
) -> list[Command[object]]:
    """Return the sent motor commands."""
    return [command for command in commands(sent, polynomial) if command.moves]


def latch_fault(board: Board, *motors: int) -> None:
    """Set and clear the faults of motors. Their status bits remain latched."""
    for motor in motors:
        board.set_fault(motor, fault=True)
        board.set_fault(motor, fault=False)


def is_stopped(board: Board) -> bool:
    """True if both motors brake fully and the auxiliary motor is off."""
    return board.aux.speed == 0 and all(
        motor.direction is MotorDirection.BRAKE and motor.speed == 127 for motor in board.motors
    )


def schedule_heartbeats(harness: SessionHarness, start: float, end: float) -> None:
    """Schedule heartbeats between two times."""
    for number in range(int((end - start) / HEARTBEAT_INTERVAL) + 1):
        harness.script.at(start + number * HEARTBEAT_INTERVAL, Heartbeat())


def run_for(
    harness: SessionHarness,
    seconds: float,
    settings: ConnectionSettings | None = None,
    *,
    may_move: bool = False,
) -> list[Report]:
    """Run the script of a harness. Close the line after `seconds`."""
    harness.script.at(seconds, Close())
    return harness.run(settings, may_move=may_move)


def read_at(harness: SessionHarness, moment: float, read: Callable[[], KindT]) -> list[KindT]:
    """Schedule a reading of the board. Return a list that receives the value."""
    values: list[KindT] = []
    harness.script.at(moment, lambda: values.append(read()))
    return values


def on_write(
    harness: SessionHarness,
    before: Callable[[bytes], object] = lambda _packet: None,
    after: Callable[[bytes], object] = lambda _packet: None,
) -> None:
    """Call a function before or after each packet is sent."""
    send = harness.transport.write

    def write(data: bytes) -> None:
        before(data)
        send(data)
        after(data)

    harness.transport.write = write  # type: ignore[method-assign]


class TwoBoards(SessionHarness):
    """Boards 7 and 9 on one line."""

    def __init__(self) -> None:
        self.seventh, self.ninth = create_board(7), create_board(9)
        super().__init__(self.seventh, self.ninth)


def timed_run(harness: SessionHarness, settings: ConnectionSettings) -> list[tuple[float, Report]]:
    """Run the script of a harness. Return each report with its time."""
    reports: list[tuple[float, Report]] = []
    session = TrexSession(
        settings,
        harness.script,
        lambda report: reports.append((harness.line.now, report)),
        lambda _settings: harness.transport,
    )
    session.run()
    return reports
