"""Close of a session at every moment of a write."""

from dataclasses import dataclass
from functools import cache
from itertools import product

import pytest

from tests.devices.trex.client.test_interrupted_writing import (
    CALIBRATIONS,
    CASES,
    FAST,
    SLOW,
    Case,
    InterruptedWrite,
    all_parameters,
    line_and_polynomial,
    require_old_or_new_values,
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
STEP = 0.004  # seconds between two moments, less than a transaction

CRC_STAYS_ON = line_and_polynomial(FAST, 0x33, SLOW, 0x44)
VIA_FACTORY_LINE = Case(
    (("motor1_acceleration", 9), ("serial_timeout", 20), *CRC_STAYS_ON.parameters),
    stored=CRC_STAYS_ON.stored,
)
SLOWEST = line_and_polynomial(wire(1200, Detection.CRC7, 2), 0x33, FAST, 0x44)

CLOSED_CASES = {
    "all_parameters": Case(all_parameters("1.2")[-6:], CALIBRATIONS[:1]),
    "CRC off": CASES["CRC off"],
    "via factory line settings": VIA_FACTORY_LINE,
}


@dataclass
class SessionWrite:
    """Write in a session, with the reports of the session by time."""

    attempt: InterruptedWrite
    reports: list[tuple[float, Report]]

    @property
    def outcome(self) -> Outcome:
        return outcomes(report for _, report in self.reports)[1]

    @property
    def results(self) -> dict[str, WriteResult]:
        return {result.key: result for result in self.attempt.results}

    def time_of(self, kind: type[Report]) -> float:
        """Return the time of the only report of one type."""
        (found,) = [time for time, report in self.reports if isinstance(report, kind)]
        return found


def run(attempt: InterruptedWrite) -> SessionWrite:
    settings = attempt.case.link(attempt.case.before)
    attempt.harness.line.host = settings.line
    return SessionWrite(attempt, timed_run(attempt.harness, settings))


def scheduled_write(case: Case) -> InterruptedWrite:
    """Return an attempt whose script starts to write at once."""
    attempt = InterruptedWrite(case)
    attempt.harness.script.at(0.0, Write(1, case.parameters, case.calibrations))
    return attempt


def run_to_outcome(attempt: InterruptedWrite) -> SessionWrite:
    """Run the script. The write must have results."""
    writing = run(attempt)
    assert writing.outcome.error is None
    value = writing.outcome.value
    assert isinstance(value, Written)
    attempt.results = value.results
    return writing


def close_at(case: Case, moment: float) -> SessionWrite:
    attempt = scheduled_write(case)
    attempt.harness.script.at(moment, Close())
    return run_to_outcome(attempt)


@cache
def moments(case: Case) -> tuple[float, ...]:
    """Return moments from the start to the end of an undisturbed write."""
    attempt = scheduled_write(case)
    attempt.harness.script.at(10.0 if case == SLOWEST else 3.0, Close())
    writing = run_to_outcome(attempt)
    assert attempt.stored == case.after
    start, end = writing.time_of(Connected), writing.time_of(Outcome)
    return tuple(start + STEP * (number + 1) for number in range(int((end - start) / STEP)))


# --- Results ----------------------------------------------------------------------------


@pytest.mark.parametrize("first", sampled(range(3), every=3))
@pytest.mark.parametrize("name", CLOSED_CASES)
def test_close_reports_each_setting_and_splits_no_pair(name: str, first: int) -> None:
    counts = set()
    for moment in moments(CLOSED_CASES[name])[first::3]:
        writing = close_at(CLOSED_CASES[name], moment)
        require_old_or_new_values(writing.attempt, lost=0)
        before, stored = writing.attempt.case.before, writing.attempt.stored
        failed = {key for key, result in writing.results.items() if result.error is not None}
        assert all(isinstance(writing.results[key].error, Skipped) for key in failed)
        assert all(stored[key] == before[key] for key in failed if key in before)
        assert writing.reports[-1][1] == Closed(None)
        counts.add(len(failed))
        old_pair, new_pair, pair = (
            tuple(values[key] for key in PAIR)
            for values in (before, writing.attempt.case.after, stored)
        )
        assert pair in {old_pair, new_pair}
        succeeded = [writing.results[key].error is None for key in PAIR]
        assert succeeded == [pair == new_pair] * 2
        writing.attempt.board.power_cycle()
        require_reachable(writing.attempt)
    assert len(counts) > 1 or name == "CRC off"  # this case is only a pair


def test_close_cancels_write_that_has_not_started() -> None:
    attempt = scheduled_write(CLOSED_CASES["all_parameters"])
    attempt.harness.script.at(0.0, Close())
    assert "closed before the request was complete" in str(run(attempt).outcome.error)
    assert attempt.stored == attempt.case.before


# --- Duration ---------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("case", "limit"), [*product(CLOSED_CASES.values(), [0.3]), (SLOWEST, 2.0)]
)
def test_close_waits_for_at_most_one_setting_or_pair(case: Case, limit: float) -> None:
    """`SessionThread.shut_down` waits for three seconds."""
    stride = max(1, len(moments(case)) // 8)
    for moment in moments(case)[::stride]:
        assert close_at(case, moment).time_of(Closed) - moment < limit


def test_close_does_not_wait_long_for_unresponsive_board() -> None:
    for moment in moments(VIA_FACTORY_LINE)[::3]:
        attempt = scheduled_write(VIA_FACTORY_LINE)
        attempt.at(moment, attempt.board.power_off)
        attempt.harness.script.at(moment, Close())
        writing = run_to_outcome(attempt)
        require_old_or_new_values(attempt, lost=2)
        failed = any(isinstance(result.error, NoReply | Skipped) for result in attempt.results)
        assert failed or attempt.stored == attempt.case.after  # the power loss follows the write
        assert writing.time_of(Closed) - moment < 2.0


# --- Motors -----------------------------------------------------------------------------


def scheduled_drive(case: Case, moment: float) -> InterruptedWrite:
    """Return an attempt whose script drives a motor, and closes at a moment."""
    attempt = scheduled_write(case)
    attempt.harness.script.at(moments(case)[0], SetMotor(1, Drive.at(100)))
    attempt.harness.script.at(moment, Close())
    return attempt


def run_to_stop(attempt: InterruptedWrite, moment: float) -> SessionWrite:
    """Run the script. The first packet after the moment must be a stop."""
    attempt.at(moment, attempt.harness.transport.sent.clear)
    writing = run_to_outcome(attempt)
    require_old_or_new_values(attempt, lost=0)
    assert tuple(commands(attempt.harness.transport.sent)[: len(STOP)]) == STOP
    return writing


def test_close_stops_motors_before_remaining_writes() -> None:
    case = CLOSED_CASES["all_parameters"]
    for moment in moments(case)[10::5]:
        attempt = scheduled_drive(case, moment)
        writing = run_to_stop(attempt, moment)
        assert writing.reports[-1][1] == Closed(None, may_move=False)
        assert all(motor.direction is MotorDirection.BRAKE for motor in attempt.board.motors)


def test_close_sends_one_confirmed_stop() -> None:
    case = CLOSED_CASES["all_parameters"]
    attempt = scheduled_drive(case, moments(case)[20])
    run(attempt)
    sent = motor_commands_in(attempt.harness.transport.sent)
    stops = [command for command in sent if command in STOP]
    assert len(stops) == 2 * len(STOP)  # the second confirms the first
    assert GetStatus() in commands(attempt.harness.transport.sent)


def test_close_drops_setpoints_during_remaining_writes() -> None:
    case = VIA_FACTORY_LINE
    for moment in moments(case)[::5]:
        attempt = scheduled_write(case)
        script = attempt.harness.script.at(moment, SetMotor(1, Drive.at(100))).at(moment, Close())
        script.at(moment, SetMotor(2, Drive.at(100))).at(moment + 0.01, SetAuxiliary(100))
        writing = run(attempt)
        assert writing.reports[-1][1] == Closed(None, may_move=False)
        assert [motor.speed for motor in attempt.board.motors] == [0, 0]
        assert attempt.board.aux.speed == 0


def test_stop_at_close_is_sent_first_and_confirmed() -> None:
    case = CLOSED_CASES["all_parameters"]
    for moment in moments(case)[::10]:
        attempt = scheduled_write(case)
        attempt.harness.script.at(moment, Stop(2)).at(moment, Close())
        writing = run_to_stop(attempt, moment)
        assert outcomes(report for _, report in writing.reports)[2].error is None
