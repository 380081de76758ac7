"""Boards that return with other line settings after a power cut."""

from dataclasses import replace
from functools import partial
from itertools import pairwise
from typing import Any

import pytest

from tests.devices.trex.discovery.test_prober import ALL_LINES
from tests.devices.trex.session.helpers import (
    create_harness,
    of_type,
    on_write,
    outcomes,
    packet,
    read_at,
)
from tests.devices.trex.simulator.ports import create_board
from tests.support.matrix import sampled
from tests.support.virtual import SessionHarness
from trex_gui.core.errors import BadRequest, NoReply, PortUnavailable
from trex_gui.core.session import Close, Closed
from trex_gui.core.timing import Timeouts
from trex_gui.core.transport.settings import SerialFormat
from trex_gui.devices.trex.client.telemetry import Control, Currents, ModeSample, Raw
from trex_gui.devices.trex.driving.requests import SetMotor, Stop
from trex_gui.devices.trex.protocol.commands import STOP, GetMode, GetSignature
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.devices.trex.protocol.driving import Drive
from trex_gui.devices.trex.protocol.framing import Framing
from trex_gui.devices.trex.protocol.line_settings import Detection, LineSettings
from trex_gui.devices.trex.protocol.parameters import parameters_of
from trex_gui.devices.trex.session.messages import (
    Batch,
    Connected,
    NotResponding,
    ReadReason,
    Reload,
    Report,
    SetReconnectCandidates,
    Write,
)
from trex_gui.devices.trex.session.reconnecting import (
    LivenessMonitor,
    after_power_cycle,
    client_at,
    reconnect_candidates,
    settings_to_probe,
)
from trex_gui.devices.trex.simulator.firmware import Board
from trex_gui.devices.trex.simulator.motors import MotorDirection

OLD = ConnectionSettings("virtual")
CRC = LineSettings(57600, Detection.CRC7)
FIRST_STOP = Framing().encode(STOP[0])
OFF, ON = 1.5, 2.5  # seconds until the power cut, and until its end


class ReconnectHarness(SessionHarness):
    """Harness for a board and a port with the settings `old`."""

    def __init__(self, old: ConnectionSettings = OLD, *, echo: bool = False) -> None:
        number = 7 if old.device_number is None else old.device_number
        board = create_board(
            number, old.line.to_wire(), crc7_polynomial=old.polynomial & 0x7F, uart_error_shutdown=0
        )
        super().__init__(board, echo=echo)
        self.old = old
        self.line.host = old.line

    def store(self, new: ConnectionSettings) -> None:
        """Store line settings, which apply after the next power cycle."""
        self.board.eeprom.write("uart_settings", new.line.to_wire())
        self.board.eeprom.write("crc7_polynomial", new.polynomial & 0x7F)

    def cut_power(
        self, *candidates: ConnectionSettings, new: ConnectionSettings | None = None
    ) -> "ReconnectHarness":
        """Schedule a power cut, after which the board has the settings `new`."""
        self.script.at(OFF - 0.1, SetReconnectCandidates(candidates))
        self.script.at(OFF, self.board.power_off)
        self.script.at(OFF, lambda: self.store(new or self.old))
        self.script.at(ON, self.board.power_on)
        return self

    def run_until(self, end: float) -> list[Report]:
        self.script.at(end, Close())
        return self.run(self.old)

    @property
    def connections(self) -> list[Connected]:
        return of_type(self.reports, Connected)


def run_until_return(harness: ReconnectHarness, end: float = 5.0) -> Connected:
    """Run the script. Return the report of the board that has returned."""
    harness.run_until(end)
    first, second = harness.connections
    assert (first.occasion, second.occasion) == (ReadReason.OPENED, ReadReason.RETURNED)
    assert first.settings == harness.old
    assert harness.reports[-1] == Closed(None)
    return second


# --- Scan -------------------------------------------------------------------------------


@pytest.mark.parametrize("line", sampled(ALL_LINES, every=17), ids=lambda line: line.text())
def test_board_reconnects_at_any_expected_line_settings(
    line: LineSettings, motor_commands: list[str]
) -> None:
    new = replace(OLD, line=line)
    harness = ReconnectHarness().cut_power(new, new=new)
    assert run_until_return(harness, 5.0 if line.baud > 4800 else 14.0).settings == new
    assert harness.line.host == line
    assert of_type(harness.reports, Batch)[-1].samples
    assert not motor_commands


def test_board_reconnects_with_new_device_number() -> None:
    harness = ReconnectHarness(replace(OLD, device_number=7))
    new = ConnectionSettings("virtual", CRC, 100)
    harness.script.at(1.2, Write(1, (("device_number", 100), ("uart_settings", CRC.to_wire()))))
    assert run_until_return(harness.cut_power(new, new=new)).settings == new
    assert outcomes(harness.reports)[1].error is None


def test_board_reconnects_on_rs232_side() -> None:
    new = replace(OLD, line=CRC)
    returned = run_until_return(ReconnectHarness(echo=True).cut_power(new, new=new))
    assert (returned.settings, returned.echo) == (new, True)


@pytest.mark.parametrize(
    ("candidates", "echo"),
    [((), False), ((replace(OLD, line=CRC),), True)],
    ids=["without candidates", "with candidates"],
)
def test_board_reconnects_when_echo_changes(
    candidates: tuple[ConnectionSettings, ...], *, echo: bool
) -> None:
    harness = ReconnectHarness(echo=echo)
    harness.script.at(OFF - 0.1, SetReconnectCandidates(candidates))
    harness.script.at(OFF, lambda: setattr(harness.line, "echo", not echo))
    returned = run_until_return(harness)
    assert (returned.settings, returned.echo) == (OLD, not echo)
    assert of_type(harness.reports, Batch)[-1].samples


def test_board_reconnects_at_settings_that_it_stored() -> None:
    harness = ReconnectHarness()
    harness.script.at(1.0, Write(1, (("uart_settings", CRC.to_wire()), ("crc7_polynomial", 0x11))))
    harness.script.at(1.3, Reload(2))
    new = ConnectionSettings("virtual", CRC, polynomial=0x91)
    harness.cut_power(new, new=new).run_until(6.0)
    _, reloaded, returned = harness.connections
    assert reloaded.settings == OLD
    assert after_power_cycle(OLD, reloaded.state.parameters, "1.2") == new == returned.settings


def test_candidates_survive_return_at_unchanged_settings() -> None:
    new = replace(OLD, line=CRC)
    harness = ReconnectHarness().cut_power(new, new=OLD)
    harness.script.at(5.0, harness.board.power_off).at(5.0, lambda: harness.store(new))
    harness.script.at(6.0, harness.board.power_on)
    harness.run_until(10.0)
    assert [connection.settings for connection in harness.connections] == [OLD, OLD, new]
    assert len(of_type(harness.reports, NotResponding)) == 2


def test_reconnect_clears_candidates() -> None:
    new = replace(OLD, line=CRC)
    harness = ReconnectHarness().cut_power(new, new=new)
    harness.script.at(6.0, harness.board.power_off)
    sizes = read_at(harness, 7.0, lambda: len(harness.transport.sent))
    harness.run_until(9.0)
    sent = bytes(harness.transport.sent[sizes[0] :])
    assert sent.replace(new.framing.encode(GetMode()), b"") == b"", "only polls at new settings"


def test_reconnect_candidates_can_be_cleared() -> None:
    new = replace(OLD, line=CRC)
    harness = ReconnectHarness().cut_power(new, new=new)
    harness.script.at(ON - 0.1, SetReconnectCandidates(()))
    harness.run_until(6.0)
    assert len(harness.connections) == 1


def test_counters_continue_after_reconnect(motor_commands: list[str]) -> None:
    new = replace(OLD, line=CRC)
    harness = ReconnectHarness().cut_power(new, new=new)
    run_until_return(harness)
    (silent,) = of_type(harness.reports, NotResponding)
    assert of_type(harness.reports, Batch)[-1].counters.requests > silent.counters.requests > 100


# --- Duration ---------------------------------------------------------------------------


def test_round_of_reconnect_probes_takes_at_most_1500_ms() -> None:
    harness = ReconnectHarness().cut_power(replace(OLD, line=CRC), new=OLD)
    harness.transport.latency = 0.06  # the latency of a local port
    starts: list[float] = []

    def record(_packet: bytes) -> None:
        if harness.line.host == CRC:
            starts.append(harness.line.now)

    on_write(harness, before=record)
    harness.script.at(ON + 0.01, harness.board.power_off)
    harness.run_until(12.0)
    lengths = [after - before for before, after in pairwise(starts)]
    assert len(lengths) > 4
    assert max(lengths) < 1.5


def test_stop_and_close_are_served_between_probes() -> None:
    harness = ReconnectHarness().cut_power(replace(OLD, line=CRC), new=OLD)
    harness.transport.latency = 0.06
    harness.script.at(ON + 0.01, harness.board.power_off)
    stops: list[tuple[float, SerialFormat | None]] = []

    def record(packet: bytes) -> None:
        if packet == FIRST_STOP:
            stops.append((harness.line.now, harness.line.host))

    on_write(harness, before=record)
    harness.script.at(5.0, Stop(1))
    harness.run_until(9.0)
    assert isinstance(outcomes(harness.reports)[1].error, NoReply)
    assert 5.0 <= stops[0][0] < 5.4
    assert {host for _, host in stops} == {OLD.line}
    assert harness.line.now < 9.4


def test_requests_are_rejected_while_reconnecting() -> None:
    harness = ReconnectHarness().cut_power(replace(OLD, line=CRC), new=OLD)
    harness.script.at(ON + 0.01, harness.board.power_off)
    sizes = read_at(harness, 3.5, lambda: len(harness.transport.sent))
    harness.script.at(4.0, packet(1, GetSignature())).at(4.1, Reload(2))
    harness.script.at(4.2, Write(3, (("serial_timeout", 5),))).at(4.3, SetMotor(1, Drive.at(9)))
    harness.run_until(7.0)
    assert {str(outcomes(harness.reports)[number].error) for number in (1, 2, 3)} == {
        "The board is not responding; scanning for it."
    }
    assert set(harness.transport.sent[sizes[0] :]) <= {0xFF, 0x81, 0x48}


# --- Safety -----------------------------------------------------------------------------

some_or_all_lines = pytest.mark.parametrize(
    "lines",
    [ALL_LINES[::12], pytest.param(ALL_LINES, marks=pytest.mark.slow)],
    ids=["sample", "all"],
)


@pytest.mark.parametrize(
    ("old", "expected"),
    [
        (LineSettings(), CRC),
        (LineSettings(38400, Detection.CRC7), LineSettings(14400, Detection.CRC7)),
        (LineSettings(9600), LineSettings(115200, Detection.EVEN)),
    ],
    ids=lambda line: line.text(),
)
@some_or_all_lines
def test_reconnect_probes_command_no_motor_at_any_settings(
    old: LineSettings, expected: LineSettings, lines: list[LineSettings], motor_commands: list[str]
) -> None:
    """All replies are lost, so all probes are sent."""
    for line in lines:
        if line.stop_bits == 2:
            continue
        harness = ReconnectHarness(ConnectionSettings("virtual", old))
        harness.cut_power(replace(OLD, line=expected), new=ConnectionSettings("virtual", line))
        harness.script.at(ON, harness.fault(mute=True))
        harness.run_until(4.5)
        assert len(harness.connections) == 1
        assert not motor_commands, line.text()
        assert not harness.board.memory.writes


def is_driven(board: Board) -> bool:
    """Return whether a command drives a motor."""
    return board.aux.target_speed > 0 or any(
        motor.target_direction is not MotorDirection.BRAKE for motor in board.motors
    )


@some_or_all_lines
def test_stop_retry_at_old_settings_starts_no_motor(lines: list[LineSettings]) -> None:
    """The board does not confirm the stop of a driven motor, so the stop is repeated."""
    for line in lines:
        if line.stop_bits == 2 or line == OLD.line:
            continue
        harness = ReconnectHarness()
        harness.script.at(1.2, SetMotor(1, Drive.at(100)))
        harness.cut_power(
            ConnectionSettings("virtual", CRC), new=ConnectionSettings("virtual", line)
        )
        harness.script.at(ON, harness.fault(mute=True))
        read = partial(is_driven, harness.board)
        driven = [read_at(harness, ON + step / 100, read) for step in range(200)]
        harness.run_until(4.5)
        assert bytes(harness.transport.sent).count(FIRST_STOP) > 5
        assert driven == [[False]] * 200, line.text()


# --- Probed settings --------------------------------------------------------------------


def test_factory_settings_are_probed_last() -> None:
    old, new = replace(OLD, line=CRC, name="adapter"), ConnectionSettings("", LineSettings(9600))
    assert settings_to_probe(old, [new]) == (
        old,
        replace(new, url="virtual", name="adapter"),
        replace(old, line=LineSettings()),
    )


def test_reconnect_candidates_are_unique() -> None:
    new = replace(OLD, line=CRC)
    assert settings_to_probe(OLD, [new, OLD, new]) == (OLD, new)


def test_polynomial_is_ignored_without_crc() -> None:
    assert settings_to_probe(OLD, [replace(OLD, polynomial=0x91)]) == (OLD,)


def test_probe_readable_as_motor_command_is_skipped() -> None:
    """81 2E at 14400 baud is F0 0E at 38400 with odd parity."""
    unsafe = next(
        polynomial
        for polynomial in range(0x80, 0x100)
        if settings_to_probe(
            replace(OLD, line=LineSettings(14400, Detection.CRC7), polynomial=polynomial),
            [replace(OLD, line=LineSettings(38400, Detection.ODD))],
        )[0].line.baud
        != 14400
    )
    old = replace(OLD, line=LineSettings(14400, Detection.CRC7), polynomial=unsafe)
    assert old in settings_to_probe(old, [replace(OLD, line=LineSettings(9600))])


def test_unsupported_line_settings_are_skipped() -> None:
    harness = ReconnectHarness(replace(OLD, line=LineSettings(9600))).cut_power(
        replace(OLD, line=CRC), new=OLD
    )
    reconfigure = harness.transport.reconfigure

    def refuse(line: SerialFormat) -> None:
        if line == CRC:
            raise BadRequest("unsupported rate")
        reconfigure(line)

    harness.transport.reconfigure = refuse  # type: ignore[method-assign]
    assert run_until_return(harness).settings == OLD


def test_port_loss_while_reconnecting_ends_session() -> None:
    lost = PortUnavailable("The port is lost.")
    harness = ReconnectHarness().cut_power(replace(OLD, line=CRC), new=OLD)
    harness.script.at(ON + 0.01, harness.board.power_off)
    harness.script.at(4.0, lambda: setattr(harness.transport, "fail", lost))
    assert harness.run_until(9.0)[-1] == Closed(lost)
    assert harness.line.now < 5.0


def test_fixed_rate_port_is_probed_only_at_its_own_settings() -> None:
    harness = ReconnectHarness().cut_power(replace(OLD, line=CRC), new=OLD)
    harness.transport.is_configurable = False
    assert run_until_return(harness).settings == OLD
    assert bytes(harness.transport.sent).count(b"\xff") <= 2  # sent when the line opens


def test_probe_finds_board_only_at_its_line_settings() -> None:
    harness = ReconnectHarness(replace(OLD, line=CRC))
    assert client_at(harness.transport, harness.old)
    assert not client_at(harness.transport, OLD)


def test_probe_ignores_board_with_wrong_device_number() -> None:
    harness = ReconnectHarness()
    number = harness.board.eeprom["device_number"]
    assert client_at(harness.transport, replace(OLD, device_number=number))
    assert not client_at(harness.transport, replace(OLD, device_number=number + 1))


# --- Silence --------------------------------------------------------------------------


CANDIDATES = (ConnectionSettings("virtual", LineSettings(57600)),)


def silent_monitor(now: float) -> LivenessMonitor:
    """Return the monitor of a board that stopped responding at `now`."""
    liveness = LivenessMonitor(Timeouts())
    assert [liveness.record_failure(now) for _ in range(3)] == [False, False, True]
    return liveness


def test_reply_between_failures_resets_their_count() -> None:
    liveness = LivenessMonitor(Timeouts())
    for _ in range(10):
        assert not liveness.record_failure(1.0)
        assert not liveness.record_failure(1.1)
        liveness.record_reply(Raw)
    assert not liveness.is_silent


def test_repeated_failure_of_safety_topic_counts_as_silence() -> None:
    for topic, silent in ((Control, True), (ModeSample, True), (Raw, False)):
        liveness = LivenessMonitor(Timeouts())
        for _ in range(3):
            liveness.record_failure(1.0, topic)
            liveness.record_reply(Currents)
        assert liveness.is_silent is silent
    liveness = LivenessMonitor(Timeouts())
    for _ in range(9):
        liveness.record_failure(1.0, ModeSample)
        liveness.record_reply(ModeSample)
    assert not liveness.is_silent


def test_third_failure_is_reported_as_silence_once() -> None:
    liveness = silent_monitor(7.0)
    assert liveness.is_silent
    assert liveness.retry_at == 7.0 + Timeouts().retry
    assert not liveness.record_failure(8.0)


def test_reread_board_counts_as_responding() -> None:
    liveness = silent_monitor(7.0)
    liveness.start()
    assert not liveness.is_silent
    assert not liveness.record_failure(8.0)


def test_candidates_are_scanned_only_during_silence() -> None:
    harness, settings = create_harness()
    client = harness.client(settings)
    responding = LivenessMonitor(Timeouts())
    responding.set_candidates(CANDIDATES)
    assert not responding.is_scanning(client)
    liveness = silent_monitor(0.0)
    assert not liveness.is_scanning(client)
    liveness.set_candidates(CANDIDATES)
    assert liveness.is_scanning(client)
    harness.transport.is_configurable = False
    assert not liveness.is_scanning(client)


def test_scan_continues_until_board_is_read() -> None:
    harness, settings = create_harness()
    client = harness.client(settings)
    liveness = silent_monitor(0.0)
    harness.board.power_off()
    liveness.set_candidates(CANDIDATES)
    assert liveness.probe_next(client) is None
    liveness.set_candidates(())
    assert liveness.is_scanning(client)
    liveness.start()
    assert not liveness.is_scanning(client)


# --- Settings after a power cycle -------------------------------------------------------


CONNECTION = ConnectionSettings("/dev/ttyUSB0", name="adapter", timeouts=Timeouts(extra=0.1))
FACTORY = {spec.key: spec.default for spec in parameters_of("trex", "1.2").readable}


CRC_19200 = LineSettings(19200, Detection.CRC7)


@pytest.mark.parametrize(
    ("old", "stored", "firmware", "new"),
    [
        (CONNECTION, FACTORY, "1.2", CONNECTION),
        (CONNECTION, {"uart_settings": LineSettings(38400).to_wire()}, "1.1", CONNECTION),
        (
            CONNECTION,
            {"uart_settings": CRC_19200.to_wire(), "crc7_polynomial": 0x15},
            "1.2",
            replace(CONNECTION, line=CRC_19200, polynomial=0x95),
        ),
        (CONNECTION, {"device_number": 9}, "1.2", CONNECTION),
        (
            replace(CONNECTION, device_number=7),
            {"device_number": 9},
            "1.2",
            replace(CONNECTION, device_number=9),
        ),
        (CONNECTION, {"uart_settings": 0x0F}, "1.2", None),
    ],
    ids=["factory", "half rate", "polynomial", "without number", "number", "invalid"],
)
def test_power_cycle_activates_stored_values(
    old: ConnectionSettings,
    stored: dict[str, int],
    firmware: str,
    new: ConnectionSettings | None,
) -> None:
    assert after_power_cycle(old, stored, firmware) == new


@pytest.mark.parametrize(
    ("old", "before", "after", "new"),
    [
        (CONNECTION, {}, {"serial_timeout": 5}, []),
        (
            replace(CONNECTION, device_number=20),
            {"device_number": 20},
            {"device_number": 9},
            [{"device_number": 9}, {"device_number": 7}],
        ),
        (
            replace(CONNECTION, line=CRC_19200, polynomial=0x91),
            {"uart_settings": CRC_19200.to_wire(), "crc7_polynomial": 0x11},
            {"crc7_polynomial": 0x15},
            [{"polynomial": 0x95}, {"polynomial": 0x89}],
        ),
        (
            CONNECTION,
            {},
            {"uart_settings": CRC.to_wire(), "crc7_polynomial": 0x15},
            [{"line": CRC, "polynomial": 0x95}, {"line": CRC}, {"polynomial": 0x95}],
        ),
    ],
    ids=["unchanged line", "number", "polynomial", "line and polynomial"],
)
def test_reconnect_candidates_include_factory_defaults(
    old: ConnectionSettings,
    before: dict[str, int],
    after: dict[str, int],
    new: list[dict[str, Any]],
) -> None:
    before = {**FACTORY, **before}
    candidates = reconnect_candidates(old, before, {**before, **after}, "1.2")
    assert candidates == tuple(replace(old, **changes) for changes in new)
