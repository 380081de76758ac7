"""Cuts of the servo power, by which users stop the robot.

After a power cut, a servo's speed is unlimited, and the link does not report it.
"""

import pytest

from tests.devices.aracna.session.scripted_session import ScriptedSession
from trex_gui.core.session import Outcome
from trex_gui.devices.aracna.session.messages import (
    Ending,
    Move,
    Moving,
    Play,
    PlayEnded,
    SpeedsHeld,
    Step,
)
from trex_gui.devices.aracna.session.servo_estimates import SPEED_VALIDITY

SLOW = (30,) * 8
FASTEST = 2.28 * 30 * 1.25
"""Units per second of a motor at speed `SLOW`, with a margin for the sampling."""


def sampled_speeds(session: ScriptedSession, begin: float, seconds: float) -> list[float]:
    """Return the speed of motor 0 in units/s, sampled every 20 ms."""
    speeds: list[float] = []
    positions: list[float] = []

    def sample() -> None:
        positions.append(session.line.servos[0].position)
        if len(positions) > 1:
            speeds.append(abs(positions[-1] - positions[-2]) / 0.02)

    for turn in range(round(seconds / 0.02)):
        session.at(begin + turn * 0.02, sample)
    return speeds


@pytest.mark.parametrize("cut", [0.4, 0.8, 3.5], ids="{} s".format)
def test_move_after_power_cut_in_motion_keeps_requested_speed(cut: float) -> None:
    session = ScriptedSession(positions=[100] * 8)
    session.at(0.5, Move(1, (110,) * 8, SLOW)).at(3.0, Move(2, (600,) * 8, SLOW))
    session.at(4.0, "servo power off").at(4.0 + cut, "servo power on")
    session.at(4.7 + cut, Move(3, (600,) * 8, SLOW))
    seen = sampled_speeds(session, 4.72 + cut, 2.0)
    session.run()
    assert 0 < max(seen) < FASTEST
    assert session.when(SpeedsHeld)[-1] > 4.0 + cut, "the speeds were set again"
    assert session.stage.speeds == SLOW


def test_speeds_are_resent_after_long_motion_but_not_short_one() -> None:
    session = ScriptedSession(positions=[500] * 8)
    for number, (time, goal) in enumerate(((0.5, 520), (1.0, 540), (1.5, 800), (6.0, 810))):
        session.at(time, Move(number, (goal,) * 8, SLOW, dragged=number > 0))
    session.until(8.0).run()
    assert len(session.of(Moving)) == 4
    held = session.when(SpeedsHeld)
    assert len(held) == 2
    assert held[1] > session.when(Moving)[2]


@pytest.mark.parametrize(("cut", "seconds"), [(5.75, 0.3), (5.85, 0.1), (5.9, 0.05)])
def test_speed_is_limited_again_soon_after_power_cut_near_goal(cut: float, seconds: float) -> None:
    session = ScriptedSession(positions=[300] * 8)
    steps = (Step((300,) * 8, 1.5), Step((500,) * 8, 1.5))
    session.at(0.5, Move(1, (300,) * 8, (100,) * 8)).at(1.5, Play(2, steps, 0))
    session.at(cut, "servo power off").at(cut + seconds, "servo power on")
    seen = sampled_speeds(session, cut + seconds + SPEED_VALIDITY, 5.0)
    session.run()
    assert 0 < max(seen) < 300, "200 units in 1.4 s"


@pytest.mark.parametrize("cut", [1.5, 1.8, 2.3])
def test_move_after_power_cut_near_goal_keeps_requested_speed(cut: float) -> None:
    session = ScriptedSession(positions=[300] * 8).at(0.5, Move(1, (390,) * 8, SLOW))
    session.at(cut, "servo power off").at(cut + 0.3, "servo power on")
    session.at(cut + 0.8, Move(2, (900,) * 8, SLOW))
    seen = sampled_speeds(session, cut + 0.82, 1.5)
    session.run()
    assert 0 < max(seen) < FASTEST


def test_sequence_does_not_resume_when_power_returns() -> None:
    session = ScriptedSession(positions=[300] * 8)
    steps = (Step((300,) * 8, 2.0, "A"), Step((500,) * 8, 2.0, "B"))
    session.at(0.5, Move(1, (300,) * 8, (100,) * 8)).at(1.5, Play(2, steps, 0))
    session.at(5.8, "servo power off").at(7.3, "servo power on").until(20.0).run()
    [ended] = session.of(PlayEnded)
    assert ended.ending is Ending.MISSED
    assert not [time for time in session.when(Moving) if time > 7.3]
    [error] = [outcome.error for outcome in session.of(Outcome) if outcome.id == 2]
    assert "from its goal 300" in str(error)
    assert "then play the sequence again" in str(error)


def test_single_unreadable_position_does_not_end_sequence() -> None:
    session = ScriptedSession(positions=[300] * 8)
    steps = (Step((300,) * 8, 0.6), Step((400,) * 8, 0.6))
    session.at(0.5, Move(1, (300,) * 8, (100,) * 8)).at(1.5, Play(2, steps, 3))
    session.at(2.3, "servo 2 lose position 1").until(12.0).run()
    assert [ended.ending for ended in session.of(PlayEnded)] == [Ending.DONE]
