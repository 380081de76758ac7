"""How a line does: what is counted, and how often it is told."""

from itertools import pairwise

from tests.aracna.link.scene import Scene
from trex_gui.aracna.link.counting import INTERVAL
from trex_gui.aracna.link.messages import Connected, Counted, Counters, Move, SetSpeeds

THERE = (520,) * 8


def last(scene: Scene) -> Counters:
    return scene.of(Counted)[-1].counters


def test_what_was_answered_is_counted_and_told_soon_after_connecting() -> None:
    scene = Scene().until(0.5)
    scene.run()
    assert last(scene).answers == last(scene).requests == 1
    assert scene.when(Counted)[0] - scene.when(Connected)[0] < 0.1


def test_what_was_asked_of_a_board_that_was_still_starting_is_not_counted() -> None:
    scene = Scene(booted=False).until(4.0)
    scene.run()
    assert last(scene).silences == last(scene).restarts == 0
    assert last(scene).slowest < 0.1


def test_counts_are_told_once_a_second_at_most_however_much_is_sent() -> None:
    scene = Scene()
    for number in range(40):
        scene.at(1 + number / 10, SetSpeeds(number + 1, (100 + number,) * 8))
    scene.until(6.0)
    scene.run()
    times = scene.when(Counted)
    assert 4 <= len(times) <= 7
    assert all(later - earlier >= INTERVAL for earlier, later in pairwise(times))
    assert last(scene).answers >= 40


def test_where_nothing_is_new_nothing_is_told() -> None:
    scene = Scene().until(1.9)  # before the robot is asked again whether it is there
    scene.run()
    assert len(scene.of(Counted)) == 1


def test_the_slowest_answer_is_that_of_a_servo_setting_and_of_no_motion() -> None:
    scene = Scene(positions=(100,) * 8)
    scene.at(0.5, Move(1, THERE, (100,) * 8)).until(12.0)
    scene.run()
    counters = last(scene)
    assert counters.answers >= 3
    assert 0.02 < counters.slowest < 0.2


def test_a_robot_that_falls_silent_is_counted_as_silent() -> None:
    scene = Scene()
    scene.at(1.0, lambda: scene.stage.do("line mute on")).until(12.0)
    scene.run()
    assert last(scene).silences >= 3
    assert last(scene).damaged == 0


def test_an_answer_that_is_none_is_counted_as_damaged_and_its_line_as_strange() -> None:
    scene = Scene()

    def garble() -> None:
        scene.stage.do("power off")
        scene.line.inject(b".v,what\r\n")

    scene.at(1.0, SetSpeeds(1, (100,) * 8)).at(1.001, garble).until(4.0)
    scene.run()
    assert last(scene).damaged == 1
    assert last(scene).strange >= 1


def test_a_restart_is_counted() -> None:
    scene = Scene()
    scene.at(1.0, lambda: scene.stage.do("reset")).until(5.0)
    scene.run()
    assert last(scene).restarts == 1
