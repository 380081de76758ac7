"""Servo power is cut and given back, which is how people stop this robot: it stays as it was.

A servo that was without power is as fast as it can be; nothing on the link tells of it.
"""

import pytest

from tests.aracna.link.scene import Scene
from trex_gui.aracna.link.messages import (
    Drag,
    Ending,
    Move,
    Moving,
    Play,
    PlayEnded,
    SpeedsHeld,
    Step,
)
from trex_gui.aracna.link.servos import TRUST
from trex_gui.link.messages import Outcome

SLOW = (30,) * 8
FASTEST = 2.28 * 30 * 1.1
"""Units a second of a motor at that speed, and what an instant between two looks adds."""


def watched(scene: Scene, begin: float, seconds: float) -> list[float]:
    """Return how fast motor 0 is in units a second, looked at every 20 ms from then on."""
    seen: list[float] = []
    places: list[float] = []

    def look() -> None:
        places.append(scene.line.servos[0].position)
        if len(places) > 1:
            seen.append(abs(places[-1] - places[-2]) / 0.02)

    for turn in range(round(seconds / 0.02)):
        scene.at(begin + turn * 0.02, look)
    return seen


@pytest.mark.parametrize("cut", [0.4, 0.8, 3.5], ids="{} s".format)
def test_a_move_after_a_cut_in_mid_motion_is_as_slow_as_was_asked(cut: float) -> None:
    scene = Scene(positions=[100] * 8)
    scene.at(0.5, Move(1, (110,) * 8, SLOW)).at(3.0, Move(2, (600,) * 8, SLOW))
    scene.at(4.0, lambda: scene.stage.do("servo power off"))
    scene.at(4.0 + cut, lambda: scene.stage.do("servo power on"))
    scene.at(4.7 + cut, Move(3, (600,) * 8, SLOW))
    seen = watched(scene, 4.72 + cut, 2.0)
    scene.until(16.0).run()
    assert 0 < max(seen) < FASTEST
    assert scene.when(SpeedsHeld)[-1] > 4.0 + cut, "told anew"
    assert scene.stage.speeds == SLOW


def test_after_a_long_motion_speeds_are_told_anew_and_after_a_short_one_not() -> None:
    scene = Scene(positions=[500] * 8)
    scene.at(0.5, Move(1, (520,) * 8, SLOW)).at(1.0, Drag((540,) * 8, SLOW))
    scene.at(1.5, Drag((800,) * 8, SLOW)).at(6.0, Drag((810,) * 8, SLOW)).until(8.0)
    scene.run()
    assert len(scene.of(Moving)) == 4
    held = scene.when(SpeedsHeld)
    assert len(held) == 2
    assert held[1] > scene.when(Moving)[2]


@pytest.mark.parametrize(("cut", "seconds"), [(5.75, 0.3), (5.85, 0.1), (5.9, 0.05)])
def test_a_cut_near_the_goal_runs_off_for_no_longer_than_speeds_are_trusted(
    cut: float, seconds: float
) -> None:
    scene = Scene(positions=[300] * 8)
    steps = (Step((300,) * 8, 1.5), Step((500,) * 8, 1.5))
    scene.at(0.5, Move(1, (300,) * 8, (100,) * 8)).at(1.5, Play(2, steps, 0))
    scene.at(cut, lambda: scene.stage.do("servo power off"))
    scene.at(cut + seconds, lambda: scene.stage.do("servo power on"))
    seen = watched(scene, cut + seconds + TRUST, 5.0)
    scene.until(14.0).run()
    assert 0 < max(seen) < 300, "200 units in 1.4 s"


@pytest.mark.parametrize("cut", [1.5, 1.8, 2.3])
def test_a_move_after_a_cut_at_rest_or_near_the_goal_is_as_slow_as_was_asked(cut: float) -> None:
    scene = Scene(positions=[300] * 8)
    scene.at(0.5, Move(1, (390,) * 8, SLOW))
    scene.at(cut, lambda: scene.stage.do("servo power off"))
    scene.at(cut + 0.3, lambda: scene.stage.do("servo power on"))
    scene.at(cut + 0.8, Move(2, (900,) * 8, SLOW))
    seen = watched(scene, cut + 0.82, 1.5)
    scene.until(14.0).run()
    assert 0 < max(seen) < FASTEST


def test_a_sequence_does_not_go_on_by_itself_when_power_is_back() -> None:
    scene = Scene(positions=[300] * 8)
    steps = (Step((300,) * 8, 2.0, "A"), Step((500,) * 8, 2.0, "B"))
    scene.at(0.5, Move(1, (300,) * 8, (100,) * 8)).at(1.5, Play(2, steps, 0))
    scene.at(5.8, lambda: scene.stage.do("servo power off"))
    scene.at(7.3, lambda: scene.stage.do("servo power on")).until(20.0)
    scene.run()
    [ended] = scene.of(PlayEnded)
    assert ended.why is Ending.MISSED
    assert not [when for when in scene.when(Moving) if when > 7.3]
    [error] = [one.error for one in scene.of(Outcome) if one.id == 2]
    assert "off its goal" in str(error)
    assert "does not go on by itself" in str(error)


def test_a_position_that_cannot_be_read_once_ends_no_sequence() -> None:
    scene = Scene(positions=[300] * 8)
    steps = (Step((300,) * 8, 0.6), Step((400,) * 8, 0.6))
    scene.at(0.5, Move(1, (300,) * 8, (100,) * 8)).at(1.5, Play(2, steps, 3))
    scene.at(2.3, lambda: scene.stage.do("servo 2 lose position 1")).until(12.0)
    scene.run()
    assert [ended.why for ended in scene.of(PlayEnded)] == [Ending.DONE]
