"""Board that returns with other line settings after a power cut."""

from dataclasses import replace
from functools import partial
from itertools import cycle, pairwise, product

import pytest

from tests.devices.trex.session.helpers import create_harness, of_type, outcomes, packet
from tests.devices.trex.simulator.ports import a_board
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
from trex_gui.devices.trex.protocol.line_settings import Detection, LineSettings, baud_rates
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
EVERYWHERE = [
    LineSettings(baud, detection, stop_bits)
    for detection, stop_bits, baud in product(Detection, (1, 2), baud_rates())
]
EACH_ONCE = [
    LineSettings(baud, detection, stop_bits)
    for baud, detection, stop_bits in zip(
        (*baud_rates(), *baud_rates()), cycle(Detection), cycle((1, 2, 2)), strict=False
    )
]
"""Every rate twice, every error detection with either number of stop bits."""

CRC = LineSettings(57600, Detection.CRC7)
STOPS = [Framing().encode(command) for command in STOP]
OFF, ON, END = 1.5, 2.5, 30.0


class Place(SessionHarness):
    """A board and a port with the settings `old`."""

    def __init__(self, old: ConnectionSettings = OLD, *, echo: bool = False) -> None:
        number = 7 if old.device_number is None else old.device_number
        board = a_board(
            number, old.line.to_wire(), crc7_polynomial=old.polynomial & 0x7F, uart_error_shutdown=0
        )
        super().__init__(board, echo=echo)
        self.old = old
        self.line.host = old.line

    def store(self, new: ConnectionSettings) -> None:
        """Set the line settings of the next start."""
        self.board.eeprom.write("uart_settings", new.line.to_wire())
        self.board.eeprom.write("crc7_polynomial", new.polynomial & 0x7F)

    def go(self, *expected: ConnectionSettings, new: ConnectionSettings | None = None) -> "Place":
        """Schedule a power cut, after which the board has the settings `new`."""
        self.script.at(OFF - 0.1, SetReconnectCandidates(expected))
        self.script.at(OFF, self.board.power_off)
        self.script.at(OFF, lambda: self.store(new or self.old))
        self.script.at(ON, self.board.power_on)
        return self

    def end(self, moment: float = END) -> list[Report]:
        self.script.at(moment, Close())
        return self.run(self.old)

    @property
    def connections(self) -> list[Connected]:
        return of_type(self.reports, Connected)


def the_return(place: Place, moment: float = 5.0) -> Connected:
    """Run. Return the report of the board's return."""
    place.end(moment)
    first, second = place.connections
    assert (first.occasion, second.occasion) == (ReadReason.OPENED, ReadReason.RETURNED)
    assert first.settings == place.old
    assert place.reports[-1] == Closed(None)
    return second


def moment_of_end(new: LineSettings) -> float:
    return 5.0 if new.baud > 4800 else 14.0


# --- Scan -------------------------------------------------------------------------------


@pytest.mark.slow
@pytest.mark.timeout(600)
def test_board_reconnects_at_every_line_setting(motor_commands: list[str]) -> None:
    for line in EVERYWHERE:
        a_board_is_found_again_at(line, motor_commands)


@pytest.mark.parametrize("line", sampled(EACH_ONCE, every=6), ids=lambda line: line.text())
def test_board_reconnects_at_expected_line_settings(
    line: LineSettings, motor_commands: list[str]
) -> None:
    a_board_is_found_again_at(line, motor_commands)


def a_board_is_found_again_at(line: LineSettings, motor_commands: list[str]) -> None:
    new = replace(OLD, line=line)
    place = Place().go(new, new=new)
    assert the_return(place, moment_of_end(line)).settings == new
    assert place.line.host == line
    assert of_type(place.reports, Batch)[-1].samples
    assert not motor_commands


def test_board_reconnects_with_new_polynomial() -> None:
    old = replace(OLD, line=CRC)
    new = replace(old, polynomial=0xFF)
    assert the_return(Place(old).go(new, new=new)).settings == new


def test_board_reconnects_with_new_device_number() -> None:
    place = Place(replace(OLD, device_number=7))
    new = ConnectionSettings("virtual", CRC, 100)
    place.script.at(1.2, Write(1, (("device_number", 100), ("uart_settings", CRC.to_wire()))))
    assert the_return(place.go(new, new=new)).settings == new
    assert outcomes(place.reports)[1].error is None


def test_board_reconnects_on_rs232_side() -> None:
    new = replace(OLD, line=CRC)
    back = the_return(Place(echo=True).go(new, new=new))
    assert (back.settings, back.echo) == (new, True)


@pytest.mark.parametrize(
    ("expected", "echo"), [((), False), ((replace(OLD, line=CRC),), True)], ids=["here", "anywhere"]
)
def test_board_reconnects_when_echo_changes(
    expected: tuple[ConnectionSettings, ...], *, echo: bool
) -> None:
    place = Place(echo=echo)
    place.script.at(OFF - 0.1, SetReconnectCandidates(expected))
    place.script.at(OFF, lambda: setattr(place.line, "echo", not echo))
    back = the_return(place)
    assert (back.settings, back.echo) == (OLD, not echo)
    assert of_type(place.reports, Batch)[-1].samples


def test_board_reconnects_at_settings_derived_from_stored_ones() -> None:
    place = Place()
    place.script.at(1.0, Write(1, (("uart_settings", CRC.to_wire()), ("crc7_polynomial", 0x11))))
    place.script.at(1.3, Reload(2))
    coming = ConnectionSettings("virtual", CRC, polynomial=0x91)
    place.go(coming, new=coming).end(6.0)
    _, reloaded, returned = place.connections
    assert reloaded.settings == OLD
    assert after_power_cycle(OLD, reloaded.state.parameters, "1.2") == coming == returned.settings


def test_board_reconnects_at_factory_line_settings() -> None:
    old = replace(OLD, line=LineSettings(9600))
    place = Place(old).go(replace(OLD, line=CRC), new=OLD)
    assert the_return(place).settings == OLD


def test_unchanged_board_keeps_reconnect_candidates() -> None:
    new = replace(OLD, line=CRC)
    place = Place().go(new, new=OLD)
    place.script.at(5.0, place.board.power_off).at(5.0, lambda: place.store(new))
    place.script.at(6.0, place.board.power_on)
    place.end(10.0)
    assert [each.settings for each in place.connections] == [OLD, OLD, new]
    assert len(of_type(place.reports, NotResponding)) == 2


def test_reconnect_clears_candidates() -> None:
    new = replace(OLD, line=CRC)
    place = Place().go(new, new=new)
    place.script.at(6.0, place.board.power_off)
    marks: list[int] = []
    place.script.at(7.0, lambda: marks.append(len(place.transport.sent)))
    place.end(9.0)
    packet = new.framing.encode(GetMode())
    sent = bytes(place.transport.sent[marks[0] :])
    assert sent.replace(packet, b"") == b""


def test_reconnect_candidates_can_be_cleared() -> None:
    new = replace(OLD, line=CRC)
    place = Place().go(new, new=new)
    place.script.at(ON - 0.1, SetReconnectCandidates(()))
    place.end(6.0)
    assert len(place.connections) == 1


def test_counters_continue_after_reconnect(motor_commands: list[str]) -> None:
    new = replace(OLD, line=CRC)
    place = Place().go(new, new=new)
    the_return(place)
    (silent,) = of_type(place.reports, NotResponding)
    assert of_type(place.reports, Batch)[-1].counters.requests > silent.counters.requests > 100


# --- Duration ---------------------------------------------------------------------------


def test_round_of_reconnect_probes_takes_at_most_1500_ms() -> None:
    place = Place().go(replace(OLD, line=CRC), new=OLD)
    place.transport.latency = 0.06  # as of a local port
    requested: list[tuple[float, SerialFormat | None]] = []
    write = place.transport.write

    def record(data: bytes) -> None:
        requested.append((place.line.now, place.line.host))
        write(data)

    place.transport.write = record  # type: ignore[method-assign] # a knob
    place.script.at(ON + 0.01, place.board.power_off)
    place.end(12.0)
    rounds = [moment for moment, host in requested if host == CRC]
    lengths = [after - before for before, after in pairwise(rounds)]
    assert len(lengths) > 4
    assert max(lengths) < 1.5


def test_stop_and_close_are_served_between_probes() -> None:
    place = Place().go(replace(OLD, line=CRC), new=OLD)
    place.transport.latency = 0.06
    place.script.at(ON + 0.01, place.board.power_off)
    stops: list[tuple[float, SerialFormat | None]] = []
    write = place.transport.write

    def record(data: bytes) -> None:
        if data == STOPS[0]:
            stops.append((place.line.now, place.line.host))
        write(data)

    place.transport.write = record  # type: ignore[method-assign] # a knob
    place.script.at(5.0, Stop(1))
    place.end(9.0)
    assert isinstance(outcomes(place.reports)[1].error, NoReply)
    assert 5.0 <= stops[0][0] < 5.4
    assert {host for _, host in stops} == {OLD.line}
    assert place.line.now < 9.4


def test_requests_are_rejected_while_reconnecting() -> None:
    place = Place().go(replace(OLD, line=CRC), new=OLD)
    place.script.at(ON + 0.01, place.board.power_off)
    marks: list[int] = []
    place.script.at(3.5, lambda: marks.append(len(place.transport.sent)))
    place.script.at(4.0, packet(1, GetSignature())).at(4.1, Reload(2))
    place.script.at(4.2, Write(3, (("serial_timeout", 5),))).at(4.3, SetMotor(1, Drive.at(9)))
    place.end(7.0)
    assert {str(outcomes(place.reports)[number].error) for number in (1, 2, 3)} == {
        "The board is not responding; scanning for it."
    }
    assert set(place.transport.sent[marks[0] :]) <= {0xFF, 0x81, 0x48}


# --- Safety -----------------------------------------------------------------------------

some_or_all_lines = pytest.mark.parametrize(
    "lines",
    [EVERYWHERE[::12], pytest.param(EVERYWHERE, marks=pytest.mark.slow)],
    ids=["some lines", "all lines"],
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
    """Every reply is lost, so every probe is sent."""
    for line in lines:
        if line.stop_bits == 2:
            continue
        place = Place(ConnectionSettings("virtual", old))
        place.go(replace(OLD, line=expected), new=ConnectionSettings("virtual", line))
        place.script.at(ON, place.fault(mute=True))
        place.end(4.5)
        assert len(place.connections) == 1
        assert not motor_commands, line.text()
        assert not place.board.memory.writes


def runs(board: Board) -> bool:
    """True if a command drives a motor."""
    return board.aux.target_speed > 0 or any(
        motor.target_direction is not MotorDirection.BRAKE for motor in board.motors
    )


def look(place: Place, seen: list[bool]) -> None:
    seen.append(runs(place.board))


@some_or_all_lines
def test_stop_retry_at_old_settings_starts_no_motor(lines: list[LineSettings]) -> None:
    """Motors were driven, and the repeated stop is not confirmed."""
    for line in lines:
        if line.stop_bits == 2 or line == OLD.line:
            continue
        place = Place()
        place.script.at(1.2, SetMotor(1, Drive.at(100)))
        place.go(ConnectionSettings("virtual", CRC), new=ConnectionSettings("virtual", line))
        place.script.at(ON, place.fault(mute=True))
        seen: list[bool] = []
        for step in range(200):
            place.script.at(ON + step / 100, partial(look, place, seen))
        place.end(4.5)
        assert bytes(place.transport.sent).count(STOPS[0]) > 5
        assert len(seen) == 200
        assert not any(seen), line.text()


# --- Probed settings --------------------------------------------------------------------


def test_factory_settings_are_probed_last() -> None:
    old, new = replace(OLD, line=CRC, name="here"), ConnectionSettings("", LineSettings(9600))
    assert settings_to_probe(old, [new]) == (
        old,
        replace(new, url="virtual", name="here"),
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
    place = Place(replace(OLD, line=LineSettings(9600))).go(replace(OLD, line=CRC), new=OLD)
    reconfigure = place.transport.reconfigure

    def refuse(line: SerialFormat) -> None:
        if line == CRC:
            raise BadRequest("no such rate")
        reconfigure(line)

    place.transport.reconfigure = refuse  # type: ignore[method-assign] # a knob
    assert the_return(place).settings == OLD


def test_port_loss_while_reconnecting_ends_session() -> None:
    gone = PortUnavailable("It is gone.")
    place = Place().go(replace(OLD, line=CRC), new=OLD)
    place.script.at(ON + 0.01, place.board.power_off)
    place.script.at(4.0, lambda: setattr(place.transport, "fail", gone))
    assert place.end(9.0)[-1] == Closed(gone)
    assert place.line.now < 5.0


def test_fixed_rate_port_probes_only_its_own_settings() -> None:
    place = Place().go(replace(OLD, line=CRC), new=OLD)
    place.transport.is_configurable = False
    assert the_return(place).settings == OLD
    assert bytes(place.transport.sent).count(b"\xff") <= 2  # when the line was opened


def test_probe_finds_board_only_at_its_line_settings() -> None:
    place = Place(replace(OLD, line=CRC))
    assert client_at(place.transport, place.old)
    assert not client_at(place.transport, OLD)


def test_probe_ignores_board_with_wrong_device_number() -> None:
    place = Place()
    number = place.board.eeprom["device_number"]
    assert client_at(place.transport, replace(OLD, device_number=number))
    assert not client_at(place.transport, replace(OLD, device_number=number + 1))


# --- Silence --------------------------------------------------------------------------


ELSEWHERE = (ConnectionSettings("virtual", LineSettings(57600)),)


def silent_at(now: float) -> LivenessMonitor:
    liveness = LivenessMonitor(Timeouts())
    assert [liveness.record_failure(now) for _ in range(3)] == [False, False, True]
    return liveness


def test_reply_between_failures_keeps_board_responding() -> None:
    liveness = LivenessMonitor(Timeouts())
    for _ in range(10):
        assert not liveness.record_failure(1.0)
        assert not liveness.record_failure(1.1)
        liveness.record_reply(Raw)
    assert not liveness.silent


def test_topic_that_always_fails_counts_despite_other_replies() -> None:
    for topic, fails in ((Control, True), (ModeSample, True), (Raw, False)):
        liveness = LivenessMonitor(Timeouts())
        for _ in range(3):
            liveness.record_failure(1.0, topic)
            liveness.record_reply(Currents)
        assert liveness.silent is fails
    liveness = LivenessMonitor(Timeouts())
    for _ in range(9):
        liveness.record_failure(1.0, ModeSample)
        liveness.record_reply(ModeSample)
    assert not liveness.silent


def test_third_failure_reports_not_responding_once() -> None:
    liveness = silent_at(7.0)
    assert liveness.silent
    assert liveness.retry_at == 7.0 + Timeouts().retry
    assert not liveness.record_failure(8.0)


def test_reading_board_again_ends_not_responding() -> None:
    liveness = silent_at(7.0)
    liveness.start()
    assert not liveness.silent
    assert not liveness.record_failure(8.0)


def test_candidates_are_scanned_only_when_not_responding() -> None:
    harness, settings = create_harness()
    client = harness.client(settings)
    responding = LivenessMonitor(Timeouts())
    responding.expect(ELSEWHERE)
    assert not responding.is_scanning(client)
    liveness = silent_at(0.0)
    assert not liveness.is_scanning(client)
    liveness.expect(ELSEWHERE)
    assert liveness.is_scanning(client)
    harness.transport.is_configurable = False
    assert not liveness.is_scanning(client)


def test_scan_continues_until_board_is_read() -> None:
    harness, settings = create_harness()
    client = harness.client(settings)
    liveness = silent_at(0.0)
    harness.board.power_off()
    liveness.expect(ELSEWHERE)
    assert liveness.probe_next(client) is None
    liveness.expect(())
    assert liveness.is_scanning(client)
    liveness.start()
    assert not liveness.is_scanning(client)


# --- Settings after the next start ------------------------------------------------------


NOW = ConnectionSettings("/dev/ttyUSB0", name="adapter", timeouts=Timeouts(extra=0.1))
FACTORY = {spec.key: spec.default for spec in parameters_of("trex", "1.2").readable}


@pytest.mark.parametrize("baud", baud_rates())
@pytest.mark.parametrize("detection", list(Detection))
def test_stored_uart_settings_become_line_settings(baud: int, detection: Detection) -> None:
    line = LineSettings(baud, detection, 2)
    coming = after_power_cycle(NOW, {"uart_settings": line.to_wire()}, "1.2")
    assert coming == replace(NOW, line=line)


CRC_19200 = LineSettings(19200, Detection.CRC7)


@pytest.mark.parametrize(
    ("link", "stored", "firmware", "coming"),
    [
        (NOW, FACTORY, "1.2", NOW),
        (NOW, {"uart_settings": LineSettings(38400).to_wire()}, "1.1", NOW),
        (
            NOW,
            {"uart_settings": CRC_19200.to_wire(), "crc7_polynomial": 0x15},
            "1.2",
            replace(NOW, line=CRC_19200, polynomial=0x95),
        ),
        (NOW, {"device_number": 9}, "1.2", NOW),
        (replace(NOW, device_number=7), {"device_number": 9}, "1.2", replace(NOW, device_number=9)),
        (NOW, {"uart_settings": 0x0F}, "1.2", None),
    ],
    ids=["factory", "half rate", "highest bit of polynomial", "not addressed", "number", "invalid"],
)
def test_stored_values_apply_after_power_cycle(
    link: ConnectionSettings,
    stored: dict[str, int],
    firmware: str,
    coming: ConnectionSettings | None,
) -> None:
    assert after_power_cycle(link, stored, firmware) == coming


def test_unchanged_line_has_no_reconnect_candidates() -> None:
    assert reconnect_candidates(NOW, FACTORY, {**FACTORY, "serial_timeout": 5}, "1.2") == ()


def test_reconnect_candidates_include_factory_polynomial() -> None:
    crc = LineSettings(19200, Detection.CRC7)
    link = ConnectionSettings("/dev/ttyUSB0", line=crc, polynomial=0x91)
    before = {**FACTORY, "uart_settings": crc.to_wire(), "crc7_polynomial": 0x11}
    places = reconnect_candidates(link, before, {**before, "crc7_polynomial": 0x15}, "1.2")
    assert [place.polynomial for place in places] == [0x95, 0x89]
    assert {place.line for place in places} == {crc}


def test_reconnect_candidates_include_factory_device_number() -> None:
    link = ConnectionSettings("/dev/ttyUSB0", device_number=20)
    before = {**FACTORY, "device_number": 20}
    places = reconnect_candidates(link, before, {**before, "device_number": 9}, "1.2")
    assert [place.device_number for place in places] == [9, 7]


def test_new_line_is_probed_with_new_and_factory_polynomial() -> None:
    crc = LineSettings(57600, Detection.CRC7)
    after = {**FACTORY, "uart_settings": crc.to_wire(), "crc7_polynomial": 0x15}
    places = reconnect_candidates(NOW, FACTORY, after, "1.2")
    assert {(place.line, place.framing.polynomial) for place in places} >= {
        (crc, 0x95),
        (crc, 0x89),
    }
