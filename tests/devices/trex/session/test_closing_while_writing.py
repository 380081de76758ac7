"""`Close` at every moment of a `Write`."""

from dataclasses import dataclass
from functools import cache

import pytest

from tests.devices.trex.client.test_interrupted_writing import (
    CALIBRATIONS,
    CASES,
    FAST,
    SLOW,
    Case,
    InterruptedWrite,
    everything,
    line_and_polynomial,
    require_order,
    require_reachable,
    wire,
)
from tests.devices.trex.session.helpers import commands, motor_commands_in, outcomes, timed_run
from tests.support.matrix import sampled
from trex_gui.core.errors import NoReply
from trex_gui.core.session import Close, Closed, Outcome
from trex_gui.devices.trex.client.writing import WriteResult
from trex_gui.devices.trex.driving.requests import SetAuxiliary, SetMotor, Stop
from trex_gui.devices.trex.protocol.commands import STOP, GetStatus
from trex_gui.devices.trex.protocol.driving import Drive
from trex_gui.devices.trex.protocol.errors import Skipped
from trex_gui.devices.trex.protocol.line_settings import Detection
from trex_gui.devices.trex.session.messages import Connected, Report, Write, Written
from trex_gui.devices.trex.simulator.motors import MotorDirection

PAIR = ("crc7_polynomial", "uart_settings")
STEP = 0.004
"""Seconds between two moments, less than a transaction."""

CRC_STAYS_ON = line_and_polynomial(FAST, 0x33, SLOW, 0x44)
BY_WAY_OF_FACTORY = Case(
    (("motor1_acceleration", 9), ("serial_timeout", 20), *CRC_STAYS_ON.parameters),
    stored=CRC_STAYS_ON.stored,
)
SLOWEST = line_and_polynomial(wire(1200, Detection.CRC7, 2), 0x33, FAST, 0x44)

CLOSED = {
    "everything": Case(everything("1.2")[-6:], CALIBRATIONS[:1]),
    "CRC off": CASES["CRC off"],
    "by way of the factory's line": BY_WAY_OF_FACTORY,
}
ALL = tuple(CLOSED.values())


@dataclass
class Writing:
    """InterruptedWrite to write in a session."""

    attempt: InterruptedWrite
    reports: list[tuple[float, Report]]

    @property
    def outcome(self) -> Outcome:
        return outcomes(report for _, report in self.reports)[1]

    @property
    def results(self) -> dict[str, WriteResult]:
        return {result.key: result for result in self.attempt.results}

    def when(self, kind: type[Report]) -> float:
        (moment,) = [time for time, report in self.reports if isinstance(report, kind)]
        return moment


def run(attempt: InterruptedWrite) -> Writing:
    """Run the rest of the script."""
    settings = attempt.case.link(attempt.case.before)
    attempt.stage.line.host = settings.line
    return Writing(attempt, timed_run(attempt.stage, settings))


def begun(case: Case) -> InterruptedWrite:
    attempt = InterruptedWrite(case)
    attempt.stage.script.at(0.0, Write(1, case.parameters, case.calibrations))
    return attempt


def taken(writing: Writing) -> Writing:
    """Handle the outcome."""
    assert writing.outcome.error is None
    value = writing.outcome.value
    assert isinstance(value, Written)
    writing.attempt.results = value.results
    return writing


def closed_at(case: Case, moment: float) -> Writing:
    attempt = begun(case)
    attempt.stage.script.at(moment, Close())
    return taken(run(attempt))


@cache
def moments(case: Case) -> tuple[float, ...]:
    """Return moments from the start to the end of an undisturbed write."""
    attempt = begun(case)
    attempt.stage.script.at(10.0 if case == SLOWEST else 3.0, Close())
    writing = taken(run(attempt))
    assert attempt.stored == case.after
    begin, end = writing.when(Connected), writing.when(Outcome)
    return tuple(begin + STEP * (number + 1) for number in range(int((end - begin) / STEP)))


# --- Results ----------------------------------------------------------------------------


@pytest.mark.parametrize("first", sampled(range(3), every=3))
@pytest.mark.parametrize("name", CLOSED)
def test_close_reports_each_setting_and_parts_no_pair(name: str, first: int) -> None:
    counts = set()
    for moment in moments(CLOSED[name])[first::3]:
        writing = closed_at(CLOSED[name], moment)
        require_order(writing.attempt, lost=0)
        before, stored = writing.attempt.case.before, writing.attempt.stored
        untried = {what for what, one in writing.results.items() if one.error is not None}
        assert all(isinstance(writing.results[what].error, Skipped) for what in untried)
        parameters = {what for what in untried if what in before}
        assert {what: stored[what] for what in parameters} == {
            what: before[what] for what in parameters
        }
        assert writing.reports[-1][1] == Closed(None)
        counts.add(len(untried))
        # Line settings and polynomial stay together.
        pair = tuple(stored[key] for key in PAIR)
        after = writing.attempt.case.after
        whole = [tuple(values[key] for key in PAIR) for values in (before, after)]
        assert pair in whole
        notes = [writing.results[key].error is None for key in PAIR]
        assert notes == [pair == whole[1]] * 2
        writing.attempt.board.power_cycle()
        require_reachable(writing.attempt)
    assert len(counts) > 1 or name == "CRC off"  # it is a pair alone, which is not parted


def test_skipped_settings_can_be_written_later() -> None:
    case = CLOSED["everything"]
    for moment in moments(case)[::15]:
        writing = closed_at(case, moment)
        attempt = writing.attempt.run()
        assert [result.error for result in attempt.results] == [None] * len(attempt.results)
        assert attempt.stored == case.after


def test_close_cancels_write_that_has_not_started() -> None:
    attempt = begun(CLOSED["everything"])
    attempt.stage.script.at(0.0, Close())
    assert "closed before this was complete" in str(run(attempt).outcome.error)
    assert attempt.stored == attempt.case.before


# --- Duration ---------------------------------------------------------------------------


@pytest.mark.parametrize(("case", "longest"), [*((one, 0.3) for one in ALL), (SLOWEST, 2.0)])
def test_close_waits_for_at_most_one_setting_or_pair(case: Case, longest: float) -> None:
    """`Line.shut_down` gives it three seconds."""
    share = max(1, len(moments(case)) // 8)
    for moment in moments(case)[::share]:
        assert closed_at(case, moment).when(Closed) - moment < longest


def test_close_does_not_wait_long_for_unresponsive_board() -> None:
    for moment in moments(BY_WAY_OF_FACTORY)[::3]:
        attempt = begun(BY_WAY_OF_FACTORY)
        attempt.at(moment, attempt.board.power_off)
        attempt.stage.script.at(moment, Close())
        writing = taken(run(attempt))
        require_order(attempt, lost=2)
        is_failed = any(isinstance(one.error, NoReply | Skipped) for one in attempt.results)
        assert is_failed or attempt.stored == attempt.case.after  # off behind the last value
        assert writing.when(Closed) - moment < 2.0


# --- Motors -----------------------------------------------------------------------------


def driven(case: Case, moment: float) -> InterruptedWrite:
    attempt = begun(case)
    attempt.stage.script.at(moments(case)[0], SetMotor(1, Drive.at(100)))
    attempt.stage.script.at(moment, Close())
    return attempt


def stopped_first(attempt: InterruptedWrite, moment: float) -> Writing:
    """Run. The first packet after the moment must be a stop."""
    attempt.at(moment, attempt.stage.transport.sent.clear)
    writing = taken(run(attempt))
    require_order(attempt, lost=0)
    assert tuple(commands(attempt.stage.transport.sent)[: len(STOP)]) == STOP
    return writing


def test_close_stops_motors_before_remaining_writes() -> None:
    case = CLOSED["everything"]
    for moment in moments(case)[10::5]:
        attempt = driven(case, moment)
        writing = stopped_first(attempt, moment)
        assert writing.reports[-1][1] == Closed(None, may_move=False)
        assert all(motor.direction is MotorDirection.BRAKE for motor in attempt.board.motors)


def test_close_sends_one_confirmed_stop() -> None:
    case = CLOSED["everything"]
    attempt = driven(case, moments(case)[20])
    run(attempt)
    sent = motor_commands_in(attempt.stage.transport.sent)
    stops = [command for command in sent if command in STOP]
    assert len(stops) == 2 * len(STOP)  # two rounds are the proof
    assert GetStatus() in commands(attempt.stage.transport.sent)


def test_close_drops_setpoints_during_remaining_writes() -> None:
    case = BY_WAY_OF_FACTORY
    for moment in moments(case)[::5]:
        attempt = begun(case)
        script = attempt.stage.script.at(moment, SetMotor(1, Drive.at(100))).at(moment, Close())
        script.at(moment, SetMotor(2, Drive.at(100))).at(moment + 0.01, SetAuxiliary(100))
        writing = run(attempt)
        assert writing.reports[-1][1] == Closed(None, may_move=False)
        assert [motor.speed for motor in attempt.board.motors] == [0, 0]
        assert attempt.board.aux.speed == 0


def test_stop_at_close_is_sent_first_and_confirmed() -> None:
    case = CLOSED["everything"]
    for moment in moments(case)[::10]:
        attempt = begun(case)
        attempt.stage.script.at(moment, Stop(2)).at(moment, Close())
        writing = stopped_first(attempt, moment)
        assert outcomes(report for _, report in writing.reports)[2].error is None
