"""Sequences: the schedule of steps, and speeds that reach the goals in time."""

import itertools
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from tests.devices.aracna.session.scripted_session import ScriptedSession
from tests.support.matrix import examples
from trex_gui.core.errors import BadRequest
from trex_gui.core.session import Outcome
from trex_gui.devices.aracna.protocol.joints import MAX_EFFECTIVE_SPEED, travel_seconds
from trex_gui.devices.aracna.session.messages import (
    Ending,
    EndPlay,
    Halt,
    Move,
    Moved,
    Moving,
    Play,
    PlayEnded,
    Report,
    SetSpeeds,
    SetTimeScale,
    SpeedsHeld,
    Step,
    StepStarted,
)
from trex_gui.devices.aracna.session.player import SequencePlayer
from trex_gui.devices.aracna.session.servo_estimates import SPEED_VALIDITY, ServoEstimates

HERE = (512,) * 8
SLOW = (100,) * 8

ROUND_TRIP = 0.04
"""Seconds of a `.c` without motion: 33 to 37 ms, and some time until the session reads."""


def step(position: int, seconds: float, *others: int) -> Step:
    return Step((position, *(others or (position,) * 7)), seconds)


def positioned(positions: tuple[int, ...] = HERE, **options: Any) -> ScriptedSession:
    """Return a session in which positions are known after half a second."""
    session = ScriptedSession(positions=positions, **options)
    return session.at(0.1, SetSpeeds(90, (1023,) * 8)).at(0.3, Move(91, positions))


def steps_of(session: ScriptedSession) -> list[tuple[str, int, int]]:
    return [(started.part, started.index, started.round) for started in session.of(StepStarted)]


# --- Timing ---------------------------------------------------------------------------------


@examples(25)
@given(
    seconds=st.lists(st.floats(0.3, 2.0), min_size=1, max_size=4),
    positions=st.lists(st.integers(0, 1023), min_size=4, max_size=4),
    factor=st.floats(0.5, 2.0),
)
def test_steps_start_on_schedule_and_end_in_time(
    seconds: list[float], positions: list[int], factor: float
) -> None:
    steps = tuple(step(place, time) for time, place in zip(seconds, positions, strict=False))
    distances = [
        abs(a - b) for a, b in zip([512, *positions], positions[: len(steps)], strict=False)
    ]
    reachable = all(  # `.v`, `.c` and their replies take less than 0.12 s of a step
        travel_seconds(distance, MAX_EFFECTIVE_SPEED) < each.seconds * factor - 0.12
        for distance, each in zip(distances, steps, strict=True)
    )
    session = positioned().at(1.0, Play(1, steps, time_scale=factor))
    session.until(4.0 + factor * sum(seconds)).run()
    started = [report.time for report in session.of(StepStarted)]
    moved = [report.time for report in session.of(Moved)][1:]
    assert [ended.ending for ended in session.of(PlayEnded)] == [Ending.DONE]
    late = [report.late for report in session.of(StepStarted)]
    if not reachable:
        return
    due = started[0]
    for each, start, end, lateness in zip(steps, started, moved, late, strict=True):
        assert start == pytest.approx(due, abs=0.03)
        assert lateness == pytest.approx(start - due, abs=1e-6)
        due += each.seconds * factor
        assert end <= due + 0.03


def test_arrival_times_match_travel_time_formula() -> None:
    steps = (step(600, 1.0), step(300, 0.5), step(310, 2.0), step(900, 0.8))
    session = positioned().at(1.0, Play(1, steps, rounds=3)).until(15.0).run()
    for moving, moved in zip(session.of(Moving)[1:], session.of(Moved)[1:], strict=True):
        speeds = [held.held for held in session.of(SpeedsHeld) if held.time <= moving.time][-1]
        formula = max(
            travel_seconds(goal - (start or 0), speed)
            for start, goal, speed in zip(moving.starts, moving.goals, speeds, strict=True)
        )
        assert moving.expected == pytest.approx(formula)
        assert formula <= moved.time - moving.time <= formula + ROUND_TRIP
    assert all(report.late < 0.03 for report in session.of(StepStarted))


def test_all_motors_of_step_arrive_together() -> None:
    far = step(900, 1.0, 562, 462, 612, 412, 512, 712, 100)
    session = positioned().at(1.0, Play(1, (far,))).until(5.0).run()
    [_, held, *_] = session.of(SpeedsHeld)
    moving = session.of(Moving)[1]
    times = [
        travel_seconds(goal - 512, speed)
        for goal, speed in zip(moving.goals, held.held, strict=True)
        if goal != 512
    ]
    assert max(times) <= 1.0 - 0.08
    assert min(times) > 0.85


def test_schedule_does_not_drift_over_30_rounds() -> None:
    steps = (step(560, 0.4), step(460, 0.4))
    session = positioned().at(1.0, Play(1, steps, rounds=30)).until(27.0).run()
    started = [report.time for report in session.of(StepStarted)]
    assert len(started) == 60
    assert started[-1] - started[0] == pytest.approx(59 * 0.4, abs=0.01)
    assert session.when(PlayEnded)[0] - session.when(StepStarted)[0] == pytest.approx(24.0, abs=0.2)


def test_steps_rarely_resend_unchanged_speeds() -> None:
    steps = (step(560, 0.5), step(460, 0.5))
    session = positioned().at(1.0, Play(1, steps, rounds=10)).until(13.0).run()
    assert len(session.of(SpeedsHeld)) <= 5 + 10 / SPEED_VALIDITY, "only to confirm the speeds"


def test_late_steps_are_reported_and_none_is_skipped() -> None:
    steps = (step(1000, 0.2), step(20, 0.2))
    session = positioned().at(1.0, Play(1, steps, rounds=5)).until(10.0).run()
    assert steps_of(session) == [("steps", index, turn) for turn in range(5) for index in (0, 1)]
    assert max(report.late for report in session.of(StepStarted)) > 0.3
    # The schedule is shifted, so that delays do not accumulate.
    assert session.of(StepStarted)[-1].late < 1.0
    starts, ends = session.when(Moving), session.when(Moved)
    assert all(end <= start for end, start in zip(ends, starts[1:], strict=False))


def test_first_step_from_unknown_position_is_slow() -> None:
    session = ScriptedSession().at(0.5, Play(1, (step(600, 0.1),))).until(8.0).run()
    assert session.of(SpeedsHeld)[0].requested == SLOW
    assert [ended.ending for ended in session.of(PlayEnded)] == [Ending.DONE]


# --- Sequences ------------------------------------------------------------------------------


@pytest.mark.parametrize("time", [1.15, 1.0 + 2 * SPEED_VALIDITY])
def test_requested_speeds_are_restored_after_sequence(time: float) -> None:
    session = ScriptedSession().at(0.5, Move(1, HERE, SLOW)).at(1.0, Move(2, (400,) * 8, SLOW))
    session.at(1.1, SetSpeeds(3, (20,) * 8)).at(time, Play(4, (Step((420,) * 8, 1.0),))).until(10.0)
    session.run()
    assert session.stage.speeds == (20,) * 8


def test_end_finishes_current_step_and_plays_blend_out() -> None:
    play = Play(1, (step(560, 0.5), step(460, 0.5)), 0, (), (step(512, 0.4),))
    session = positioned().at(1.0, play).at(2.7, EndPlay()).until(8.0).run()
    assert steps_of(session)[-2:] == [("steps", 1, 1), ("out", 0, 0)]
    assert session.when(StepStarted)[-1] == pytest.approx(3.0, abs=0.1)
    assert [ended.ending for ended in session.of(PlayEnded)] == [Ending.ENDED]
    assert session.stage.goals == HERE


@pytest.mark.parametrize("time", [1.0, 1.03, 1.2, 1.55, 1.99])
def test_halt_sends_no_further_step_and_reports_motion_end(time: float) -> None:
    session = positioned().at(1.0, Play(1, (step(600, 0.5), step(400, 0.5)), 0)).at(time, Halt())
    session.until(4.0).run()
    [ended] = session.of(PlayEnded)
    assert ended.ending is Ending.HALTED
    assert session.when(PlayEnded)[0] == pytest.approx(time, abs=0.03)
    assert all(start <= session.when(PlayEnded)[0] for start in session.when(Moving))
    assert len(session.of(Moved)) == len(session.of(Moving))
    [outcome] = [outcome for outcome in session.of(Outcome) if outcome.id == 1]
    assert (outcome.value, outcome.error) == (Ending.HALTED, None)
    assert session.reports.index(ended) < session.reports.index(outcome)


def test_valid_time_scale_applies_from_next_step() -> None:
    session = positioned().at(1.0, Play(1, (step(560, 0.5), step(460, 0.5)), 3))
    session.at(1.1, SetTimeScale(0.0)).at(1.1, SetTimeScale(float("nan")))
    session.at(1.7, SetTimeScale(2.0)).until(6.0).run()
    times = session.when(StepStarted)
    gaps = [b - a for a, b in itertools.pairwise(times)]
    assert gaps == pytest.approx([0.5, 0.5, 1.0, 1.0, 1.0], abs=0.04)


def test_moves_and_speeds_are_rejected_during_playback() -> None:
    session = positioned().at(1.0, Play(1, (step(560, 0.5), step(460, 0.5))))
    session.at(1.2, Move(2, HERE)).at(1.2, Play(3, (step(1, 1),))).at(1.2, SetSpeeds(4, SLOW))
    session.until(5.0).run()
    assert session.errors[1] is None
    assert all(isinstance(session.errors[number], BadRequest) for number in (2, 3, 4))


@pytest.mark.parametrize(
    "play",
    [
        Play(1, ()),
        Play(1, (), 0, (step(5, 1),)),
        Play(1, (step(5, 1),), -1),
        Play(1, (Step((1, 2), 1.0),)),
        Play(1, (step(1024, 1),)),
        Play(1, (step(5, 0.0),)),
        Play(1, (step(5, float("inf")),)),
        Play(1, (step(5, 1),), time_scale=0),
        Play(1, (step(5, 1),), blend_out=(Step((1,), 1),)),
    ],
)
def test_invalid_play_request_is_rejected(play: Play) -> None:
    session = positioned().at(1.0, play).until(2.0).run()
    assert isinstance(session.errors[1], BadRequest)
    assert not session.of(PlayEnded)


@examples(40)
@given(
    counts=st.tuples(st.integers(0, 3), st.integers(1, 3), st.integers(0, 3)),
    rounds=st.integers(1, 4),
    end_after=st.none() | st.integers(1, 10),
)
def test_blend_in_precedes_rounds_and_blend_out_follows(
    counts: tuple[int, int, int], rounds: int, end_after: int | None
) -> None:
    before, many, after = counts
    each = step(5, 1.0)
    reports: list[Report] = []
    player = SequencePlayer(reports.append, ServoEstimates(8))
    player.start(Play(1, (each,) * many, rounds, (each,) * before, (each,) * after), 0.0)
    expected = [("in", index, 0) for index in range(before)]
    expected += [("steps", index, turn) for turn in range(rounds) for index in range(many)]
    out = [("out", index, 0) for index in range(after)]
    for _ in range(3 + 4 * 3 + 3 + 1):  # the longest sequence and its end
        player.next_speeds(0.0)
        player.next_goals()
        player.on_arrival()
        if len(reports) == end_after:
            player.end()
    assert not player.is_playing
    started = [report for report in reports if isinstance(report, StepStarted)]
    played = [(step.part, step.index, step.round) for step in started]
    assert played == [*expected[:end_after], *out]
