"""Power cuts and pulled cables at every byte of a write.

An undisturbed run finds the moments: after every byte on the wire, and several times within each
write to the EEPROM. Then the write is repeated for each moment.
"""

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field, replace
from functools import cache

import pytest

from tests.devices.trex.session.helpers import commands
from tests.support.matrix import sampled
from tests.support.virtual import SessionHarness
from trex_gui.core.discovery.scan import scan_port
from trex_gui.core.errors import BadReply, BadRequest, NoReply, PortUnavailable
from trex_gui.devices.trex.client.client import TrexClient
from trex_gui.devices.trex.client.writing import WriteResult, write_all
from trex_gui.devices.trex.discovery import TREX_PROBER, FoundBoard
from trex_gui.devices.trex.protocol.calibration import (
    CALIBRATION_FIELDS,
    DEFAULT_CALIBRATION,
    Calibration,
    CalibrationKey,
)
from trex_gui.devices.trex.protocol.commands import GetSignature, SetParameter
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.devices.trex.protocol.errors import Skipped
from trex_gui.devices.trex.protocol.flags import CHANNELS, InputSource
from trex_gui.devices.trex.protocol.framing import DEFAULT_POLYNOMIAL
from trex_gui.devices.trex.protocol.line_settings import Detection, LineSettings
from trex_gui.devices.trex.protocol.parameters import ParameterSet, parameters_of
from trex_gui.devices.trex.simulator.firmware import Board
from trex_gui.devices.trex.simulator.memory import Eeprom

Values = Mapping[str, int]
"""Content of an EEPROM: parameters by key, calibrations by names like `RC 1 minimum`."""

_PROBE = 0.0001  # seconds between two probes of an undisturbed run
_WITHIN_A_WRITE = 0.0013  # seconds between two moments within a write to the EEPROM

CALIBRATIONS = tuple(
    (
        CalibrationKey.of(InputSource.RC, channel),
        Calibration(2400 + channel, 3700 + channel, 5100 + channel, 60 + channel),
    )
    for channel in CHANNELS
)


def calibration_values(source: InputSource, channel: int, curve: Calibration) -> dict[str, int]:
    return {f"{source.value} {channel} {name}": getattr(curve, name) for name in CALIBRATION_FIELDS}


def contents(eeprom: Eeprom, specs: ParameterSet) -> dict[str, int]:
    values = {spec.key: eeprom[spec.key] for spec in specs.readable}
    for source in InputSource:
        for channel in CHANNELS:
            values |= calibration_values(source, channel, eeprom.calibration(source, channel))
    return values


def factory_value(name: str, specs: ParameterSet) -> int:
    if " " not in name:
        return specs[name].default
    source, _, part = name.split()
    value: int = getattr(DEFAULT_CALIBRATION[InputSource(source)], part)
    return value


@dataclass(frozen=True)
class Case:
    """Stored values, and values to write."""

    parameters: tuple[tuple[str, int], ...]
    calibrations: tuple[tuple[CalibrationKey, Calibration], ...] = ()
    stored: tuple[tuple[str, int], ...] = ()
    firmware: str = "1.2"
    expanded: bool = False

    @property
    def specs(self) -> ParameterSet:
        return parameters_of("trex", self.firmware)

    @property
    def before(self) -> Values:
        return contents(self.eeprom(), self.specs)

    @property
    def after(self) -> Values:
        values = {**self.before, **dict(self.parameters)}
        for key, calibration in self.calibrations:
            values |= calibration_values(key.source, key.channel, calibration)
        return values

    def eeprom(self) -> Eeprom:
        eeprom = Eeprom("trex")
        for key, wire in self.stored:
            eeprom.write(key, wire)
        return eeprom

    def link(self, values: Values) -> ConnectionSettings:
        """Return the connection settings of a board that has started with these values."""
        line = LineSettings.from_wire(values["uart_settings"])
        line = replace(line, baud=line.real_baud(self.firmware))
        number = values["device_number"] if self.expanded else None
        return ConnectionSettings("virtual", line, number, 0x80 | values["crc7_polynomial"])


def wire(baud: int, detection: Detection = Detection.NONE, stop_bits: int = 1) -> int:
    return LineSettings(baud, detection, stop_bits).to_wire()


def all_parameters(firmware: str) -> tuple[tuple[str, int], ...]:
    """Return a change of every readable parameter. The line settings come last."""
    specs = parameters_of("trex", firmware).readable
    changes = [
        (spec.key, max(spec.valid) if spec.default != max(spec.valid) else min(spec.valid))
        for spec in specs
        if spec.group != "serial" or spec.key not in {"uart_settings", "crc7_polynomial"}
    ]
    return (*changes, ("crc7_polynomial", 0x21), ("uart_settings", wire(57600, Detection.CRC7)))


CRC = Detection.CRC7
SLOW, FAST = wire(9600, CRC), wire(115200, CRC, 2)


def line_and_polynomial(
    old: int, old_polynomial: int, new: int, new_polynomial: int, firmware: str = "1.2"
) -> Case:
    return Case(
        (("crc7_polynomial", new_polynomial), ("uart_settings", new)),
        stored=(("crc7_polynomial", old_polynomial), ("uart_settings", old)),
        firmware=firmware,
    )


SERIAL = {
    "the line": Case((("uart_settings", wire(57600, Detection.EVEN)),)),
    "two stop bits": Case((("uart_settings", wire(19200, stop_bits=2)),)),
    "CRC on": line_and_polynomial(wire(38400), 0x09, FAST, 0x33),
    "CRC on, unchanged polynomial": Case(
        (("uart_settings", FAST),), stored=(("crc7_polynomial", 0x33),)
    ),
    "CRC off": line_and_polynomial(SLOW, 0x33, wire(57600, Detection.ODD), 0x09),
    "CRC off, unchanged polynomial": Case(
        (("uart_settings", wire(57600)),),
        stored=(("crc7_polynomial", 0x33), ("uart_settings", FAST)),
    ),
    "CRC stays on": line_and_polynomial(FAST, 0x33, SLOW, 0x44),
    "CRC stays on, from the default polynomial": line_and_polynomial(FAST, 0x09, SLOW, 0x44),
    "CRC stays on, to the default polynomial": line_and_polynomial(FAST, 0x33, SLOW, 0x09),
    "number and line": Case(
        (
            ("device_number", 9),
            ("serial_timeout", 1),
            ("uart_response_delay", 1),
            ("crc7_polynomial", 0x44),
            ("uart_settings", SLOW),
        ),
        stored=(("device_number", 21), ("crc7_polynomial", 0x33), ("uart_settings", FAST)),
        expanded=True,
    ),
    "half the rate": line_and_polynomial(wire(28800), 0x09, wire(38400, CRC), 0x33, firmware="1.1"),
    "half the rate, CRC stays on": line_and_polynomial(
        wire(28800, CRC), 0x33, wire(38400, CRC), 0x44, firmware="1.0"
    ),
}

MANY = {
    "everything": Case(all_parameters("1.2"), CALIBRATIONS),
    "calibrations": Case((), CALIBRATIONS),
    "many, at half the rate": Case(
        all_parameters("1.1")[-8:],
        CALIBRATIONS[:1],
        stored=(("uart_settings", wire(28800)),),
        firmware="1.1",
    ),
}

POLYNOMIAL_ALONE = Case(
    (("crc7_polynomial", 0x44),), stored=(("crc7_polynomial", 0x33), ("uart_settings", FAST))
)

CASES = {**SERIAL, **MANY, "the polynomial alone": POLYNOMIAL_ALONE}

_ALWAYS = {"CRC on", "number and line", "many, at half the rate"}
every_case = pytest.mark.parametrize(
    "name",
    [name if name in _ALWAYS else pytest.param(name, marks=pytest.mark.slow) for name in CASES],
)


# --- Disturbed writes -------------------------------------------------------------------


@dataclass
class InterruptedWrite:
    """Write to a simulated board. It may be disturbed at any moment."""

    case: Case
    results: tuple[WriteResult, ...] = ()
    board: Board = field(init=False)
    harness: SessionHarness = field(init=False)

    def __post_init__(self) -> None:
        self.board = Board("trex", self.case.firmware, eeprom=self.case.eeprom())
        self.harness = SessionHarness(self.board)
        self.harness.transport.latency = 0.0

    def run(self, device_number: int | None = None) -> "InterruptedWrite":
        case = self.case
        settings = case.link(case.before)
        if case.expanded and device_number is not None:
            settings = replace(settings, device_number=device_number)
        self.harness.line.host = settings.line
        client = self.harness.client(settings)
        self.results = write_all(client.request, case.specs, case.parameters, case.calibrations)
        return self

    def at(self, moment: float, action: Callable[[], None]) -> "InterruptedWrite":
        self.harness.line.timeline.at(moment, action)
        return self

    @property
    def stored(self) -> Values:
        return contents(self.board.eeprom, self.case.specs)

    @property
    def reported_values(self) -> dict[str, int]:
        """Return the values that are stored according to the results."""
        values: dict[str, int] = {}
        for result in self.results:
            if isinstance(result.stored, int):
                values[result.key] = result.stored
            elif result.stored is not None:
                values |= calibration_values(InputSource.RC, result.channel or 0, result.stored)
        return values

    @property
    def requested_keys(self) -> set[str]:
        return {key for key, _ in (*self.case.parameters, *self.case.calibrations)}


@cache
def moments(name: str) -> tuple[float, ...]:
    """Return the times after each byte, and times within the writes to the EEPROM."""
    attempt = InterruptedWrite(CASES[name])
    line, memory = attempt.harness.line, attempt.board.memory
    times: list[float] = []
    seen = 0

    def probe() -> None:
        nonlocal seen
        passed = line.faults.counters["sent"] + line.faults.counters["received"]
        is_writing = bool(memory.busy_for)
        if passed != seen or (is_writing and line.now - times[-1] > _WITHIN_A_WRITE):
            times.append(line.now)
        seen = passed

    for number in range(int(2 / _PROBE)):
        line.timeline.at(number * _PROBE, probe)
    attempt.run()
    assert [result.error for result in attempt.results] == [None] * len(attempt.results)
    assert line.now < 2
    assert attempt.stored == attempt.case.after
    return (0.0, *(moment for moment in times if moment <= line.now))


def sampled_moments(name: str) -> tuple[float, ...]:
    """Return all moments of a short write, and a sample for a long write."""
    return moments(name)[:: 1 + len(moments(name)) // 100]


def responds(harness: SessionHarness, settings: ConnectionSettings) -> bool:
    """Return whether the board replies at these settings."""
    harness.line.host = settings.line
    harness.line.advance(1.0)
    client = TrexClient(harness.transport, settings)
    for _ in range(2):  # the first request may follow bytes at another rate
        try:
            client.request(GetSignature())
        except (NoReply, BadReply):
            continue
        return True
    return False


def candidate_connections(case: Case) -> Iterator[ConnectionSettings]:
    """Yield connection settings to try: the old, the new and the default settings."""
    numbers = {case.before["device_number"], case.after["device_number"], 7}
    links = [case.link(case.before), case.link(case.after), ConnectionSettings("virtual")]
    if case == POLYNOMIAL_ALONE:
        links.append(ConnectionSettings("virtual", links[0].line))
    for link in links:
        for number in numbers if case.expanded else {None}:
            yield replace(link, device_number=number)


_reached: set[object] = set()


def require_reachable(attempt: InterruptedWrite) -> None:
    """Check that the board is found in the state after the interruption."""
    case, harness, memory = attempt.case, attempt.harness, attempt.board.memory
    polynomial, number = memory.crc_polynomial, memory.active["device_number"]
    state = (case, memory.line_settings, polynomial, number)
    if state in _reached:
        return
    assert attempt.board.powered
    if polynomial in {None, DEFAULT_POLYNOMIAL}:  # other polynomials need a full scan
        harness.line.advance(1.0)
        (found,) = scan_port(
            ConnectionSettings("virtual"),
            {"trex": TREX_PROBER},
            open_wire=lambda _settings: harness.transport,
        ).found
        assert isinstance(found, FoundBoard)
        assert found.device_number == number
        assert responds(harness, found.settings)
    assert any(responds(harness, settings) for settings in candidate_connections(case)), state
    _reached.add(state)


def require_old_or_new_values(attempt: InterruptedWrite, *, lost: int) -> None:
    """Check that values are old or new, except for a limited number of defaults."""
    case, stored = attempt.case, attempt.stored
    before, after = case.before, case.after
    unexpected = {name for name in stored if stored[name] not in {before[name], after[name]}}
    assert len(unexpected) <= lost, unexpected
    assert all(stored[name] == factory_value(name, case.specs) for name in unexpected)
    untouched = {name for name in before if before[name] == after[name]}
    assert {name: stored[name] for name in untouched} == {name: before[name] for name in untouched}
    assert attempt.reported_values.items() <= stored.items()
    assert {result.key for result in attempt.results} == attempt.requested_keys
    assert all(str(result.error) for result in attempt.results if result.error is not None)


def goes_via_factory_settings(case: Case) -> bool:
    """Return whether the write goes via the factory settings of the line.

    It does if CRC stays on while both the line and the polynomial change.
    """
    lines = [
        LineSettings.from_wire(values["uart_settings"]) for values in (case.before, case.after)
    ]
    changes = case.before["crc7_polynomial"] != case.after["crc7_polynomial"]
    return all(line.detection is CRC for line in lines) and lines[0] != lines[1] and changes


# --- Power ------------------------------------------------------------------------------


@pytest.mark.parametrize("first", sampled(range(3), every=3))
@every_case
def test_power_cut_loses_only_values_being_written(name: str, first: int) -> None:
    for moment in moments(name)[first::3]:
        attempt = InterruptedWrite(CASES[name])
        attempt.at(moment, attempt.board.power_off).run()
        require_old_or_new_values(attempt, lost=2 if goes_via_factory_settings(attempt.case) else 1)
        attempt.board.power_on()
        require_reachable(attempt)


@every_case
def test_brief_power_cut_loses_only_values_being_written(name: str) -> None:
    """Writing may continue after the board has returned."""
    for moment in sampled_moments(name):
        attempt = InterruptedWrite(CASES[name])
        attempt.at(moment, attempt.board.power_off)
        attempt.at(moment + 0.01, attempt.board.power_on).run()
        require_old_or_new_values(attempt, lost=2 if goes_via_factory_settings(attempt.case) else 1)
        attempt.harness.line.advance(0.01)
        require_reachable(attempt)
        attempt.board.power_cycle()
        require_reachable(attempt)


# --- Cable ------------------------------------------------------------------------------


@every_case
def test_unplugged_cable_leaves_every_value_valid(name: str) -> None:
    for moment in sampled_moments(name):
        attempt = InterruptedWrite(CASES[name])
        attempt.at(moment, attempt.harness.line.unplug).run()
        attempt.harness.line.advance(0.1)
        require_old_or_new_values(attempt, lost=int(goes_via_factory_settings(attempt.case)))
        attempt.harness.line.plug()
        if attempt.case.expanded:
            require_reachable(attempt)
        else:
            assert responds(attempt.harness, attempt.case.link(attempt.case.before))
        attempt.board.power_cycle()
        require_reachable(attempt)


@every_case
def test_interrupted_write_completes_after_replugging(name: str) -> None:
    for moment in sampled_moments(name)[::5]:
        attempt = InterruptedWrite(CASES[name])
        attempt.at(moment, attempt.harness.line.unplug).run()
        attempt.harness.line.advance(0.1)
        attempt.harness.line.plug()
        attempt.run(device_number=attempt.stored["device_number"])
        assert [result.error for result in attempt.results] == [None] * len(attempt.results)
        assert attempt.stored == attempt.case.after


@every_case
def test_port_loss_is_reported_for_all_remaining_settings(name: str) -> None:
    for moment in sampled_moments(name):
        attempt = InterruptedWrite(CASES[name])

        def pull(attempt: InterruptedWrite = attempt) -> None:
            attempt.harness.line.unplug()
            attempt.harness.transport.fail = PortUnavailable("The port is gone.")

        attempt.at(moment, pull).run()
        attempt.harness.line.advance(0.1)
        require_old_or_new_values(attempt, lost=int(goes_via_factory_settings(attempt.case)))
        failed = [result for result in attempt.results if result.error is not None]
        assert all(isinstance(result.error, PortUnavailable) for result in failed)
        assert attempt.results[len(attempt.results) - len(failed) :] == tuple(failed)


# --- Changed boards ---------------------------------------------------------------------


def test_changed_input_source_retains_its_calibrations() -> None:
    """The stored input source may differ from the active input source."""
    refused = 0
    for moment in sampled_moments("calibrations"):
        attempt = InterruptedWrite(CASES["calibrations"])
        attempt.board.eeprom.write("channel_input_source", 1)
        attempt.at(moment, attempt.board.power_off)
        attempt.at(moment + 0.01, attempt.board.power_on).run()
        for channel in CHANNELS:
            analog = attempt.board.eeprom.calibration(InputSource.ANALOG, channel)
            assert analog == DEFAULT_CALIBRATION[InputSource.ANALOG]
        failed = [str(result.error) for result in attempt.results if result.error is not None]
        assert failed
        refused += "is for RC inputs, but the board now reads analog inputs" in failed[0]
    assert refused > 0


def test_write_ends_when_board_returns_in_rc_mode() -> None:
    attempt = InterruptedWrite(CASES["everything"])
    attempt.board.mode_jumper = "rc"
    attempt.at(0.2, attempt.board.power_off).at(0.21, attempt.board.power_on).run()
    assert "not in serial mode" in str(attempt.results[-1].error)
    require_old_or_new_values(attempt, lost=1)


# --- Cancelled writes -------------------------------------------------------------------


def cancel_after(case: Case, count: int) -> tuple[SessionHarness, tuple[WriteResult, ...]]:
    """Cancel a write after a number of settings. Return its harness and its results."""
    attempt = InterruptedWrite(case)
    harness, settings = attempt.harness, case.link(case.before)
    tried: list[int] = []
    results = write_all(
        harness.client(settings).request,
        case.specs,
        case.parameters,
        case.calibrations,
        lambda done, _total, _name: tried.append(done),
        cancelled=lambda: len(tried) >= count,
    )
    return harness, results


@pytest.mark.parametrize("count", [0, 1, 4, 5, 6, 20])
def test_cancelled_write_ends_between_settings(count: int) -> None:
    case = CASES["everything"]
    harness, results = cancel_after(case, count)
    assert [result.error is None for result in results] == [
        number < count for number in range(len(results))
    ]
    assert all(isinstance(result.error, Skipped) for result in results[count:])
    stored = contents(harness.board.eeprom, case.specs)
    changed = {name for name in stored if stored[name] != case.before[name]}
    assert len({name.rsplit(" ", 1)[0] for name in changed}) == count


@pytest.mark.parametrize("name", ["CRC on", "CRC off", "CRC stays on"])
def test_line_settings_and_polynomial_are_written_together(name: str) -> None:
    case = CASES[name]
    harness, results = cancel_after(case, 1)
    assert [result.error for result in results] == [None, None]
    assert contents(harness.board.eeprom, case.specs) == case.after


# --- Default settings in between --------------------------------------------------------


def test_line_change_with_crc_goes_via_factory_settings() -> None:
    case = CASES["CRC stays on"]
    attempt = InterruptedWrite(case).run()
    sent = commands(attempt.harness.transport.sent, 0x80 | case.before["crc7_polynomial"])
    assert [command for command in sent if isinstance(command, SetParameter)] == [
        SetParameter(0x7E, 0x05),
        SetParameter(0x7D, 0x44),
        SetParameter(0x7E, SLOW),
    ]


def test_possible_factory_line_settings_are_reported() -> None:
    attempt = InterruptedWrite(CASES["CRC stays on"])
    writes = moments("CRC stays on")
    attempt.at(writes[len(writes) // 2], attempt.harness.line.unplug).run()
    assert attempt.board.eeprom["uart_settings"] == 0x05
    last = attempt.results[-1]
    assert last.key == "uart_settings"
    assert isinstance(last.error, NoReply)
    assert str(last.error).endswith(
        "UART Settings may have been reset to the factory default: after a power cycle, the board "
        "would run at 19200 baud, no error detection, 1 stop bit"
    )


def test_unwritable_line_settings_skip_factory_detour() -> None:
    case = line_and_polynomial(FAST, 0x33, 0x0F, 0x44)
    attempt = InterruptedWrite(case).run()
    errors = {result.key: result.error for result in attempt.results}
    assert errors["crc7_polynomial"] is None
    assert isinstance(errors["uart_settings"], BadRequest)
    assert attempt.board.eeprom["uart_settings"] == FAST
