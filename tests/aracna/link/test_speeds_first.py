"""No motion goes out at a speed, or to a place, that nobody wants: the session sees to it."""

import re

import pytest

from tests.aracna.link.scene import Scene
from trex_gui.aracna.link.messages import (
    Drag,
    DragDropped,
    Ending,
    Halt,
    Move,
    Moved,
    Moving,
    Play,
    PlayEnded,
    SetLimits,
    SetSpeeds,
    SpeedsHeld,
    Step,
    StepBegun,
    Stuck,
)
from trex_gui.link.messages import Outcome

HERE = (512,) * 8
THERE = (600,) * 8
SLOW = (30,) * 8
FAST = (700,) * 8


def lines(scene: Scene, letter: str) -> list[str]:
    """Return the commands of a letter that were sent, values that are all the same as one."""
    sent = bytes(scene.stage.transport.sent).decode().splitlines()
    return [re.sub(r"^(\d+)(,\1)+$", r"\1", line[2:]) for line in sent if line[1:2] == letter]


def errors(scene: Scene) -> dict[int, str]:
    return {one.id: "" if one.error is None else str(one.error) for one in scene.of(Outcome)}


# --- Speeds before every motion -------------------------------------------------------------


def test_servos_without_power_are_not_moved_and_with_power_go_as_slowly_as_was_asked() -> None:
    scene = Scene().at(0.1, lambda: scene.stage.do("servo power off"))
    scene.at(0.2, SetSpeeds(1, SLOW)).at(0.5, Move(2, THERE, SLOW))
    scene.at(2.0, lambda: scene.stage.do("servo power on")).at(2.1, Move(3, THERE, SLOW))
    scene.until(8.0).run()
    assert "servos have power" in errors(scene)[2]
    assert errors(scene)[3] == ""
    [moved] = scene.of(Moved)
    assert moved.seconds > 1.2, "88 units at 30 are 1.29 s"
    assert [held.held for held in scene.of(SpeedsHeld)] == [(-1,) * 8, (-1,) * 8, SLOW]


def test_a_motor_that_does_not_take_its_speed_is_named_and_none_is_moved() -> None:
    scene = Scene().at(0.1, lambda: scene.stage.do("servo 3 dead"))
    scene.at(0.2, Move(1, THERE, SLOW)).at(1.0, Drag(THERE, SLOW)).until(3.0)
    scene.run()
    assert errors(scene)[1] == "Motor 3 did not take its speed of 30, it does not answer."
    [dropped] = scene.of(DragDropped)
    assert str(dropped.error) == errors(scene)[1]
    assert not lines(scene, "c")


@pytest.mark.parametrize("lost", ["line drop 5", "line drop 5 sent"])
def test_speeds_whose_answer_is_lost_move_nothing(lost: str) -> None:
    scene = Scene().at(0.2, lambda: scene.stage.do(lost)).at(0.2, Move(1, THERE, SLOW))
    scene.at(6.0, Move(2, THERE, SLOW)).until(10.0)
    scene.run()
    assert errors(scene)[1]
    assert errors(scene)[2] == ""
    assert len(scene.of(Moving)) == 1
    assert scene.when(Moving)[0] > 6.0


def test_speeds_that_are_known_to_be_held_are_not_sent_again() -> None:
    scene = Scene().at(0.2, Move(1, THERE, FAST)).at(1.5, Move(2, HERE, FAST))
    scene.at(3.0, Drag(THERE, FAST)).until(5.0)
    scene.run()
    assert lines(scene, "v") == ["700", "700"], "before a move, and not again for a drag behind it"
    assert lines(scene, "c") == ["600", "512", "600"]


@pytest.mark.parametrize(
    "fault", ["servo 2 lose position", "line drop 11", "reset", "power cycle", "line mute on"]
)
def test_after_a_fault_speeds_are_sent_anew(fault: str) -> None:
    scene = Scene().at(0.2, Move(1, THERE, FAST)).at(4.0, lambda: scene.stage.do(fault))
    scene.at(4.0, Move(2, HERE, FAST)).at(13.0, lambda: scene.stage.do("line mute off"))
    scene.at(17.0, Move(3, THERE, FAST)).until(20.0)
    scene.run()
    assert lines(scene, "v")[-1] == "700"
    assert len(lines(scene, "v")) >= 2
    assert scene.when(SpeedsHeld)[-1] > 17.0
    assert scene.of(Moved)[-1].goals == THERE


def test_after_a_servo_was_waited_for_speeds_are_sent_anew() -> None:
    scene = Scene().at(0.2, Move(1, HERE, FAST)).at(1.1, Move(2, THERE, FAST))
    scene.at(1.18, lambda: scene.stage.do("servo 3 dead"))
    scene.at(8.0, lambda: scene.stage.do("servo 3 alive"))
    scene.at(9.0, Move(3, HERE, FAST)).until(11.0)
    scene.run()
    assert len(scene.of(Stuck)) == 1
    assert scene.when(SpeedsHeld)[-1] > 9.0
    assert scene.of(Moved)[-1].goals == HERE


def test_a_halt_while_the_speeds_are_on_their_way_sends_no_motion() -> None:
    scene = Scene().at(0.2, Move(1, THERE, SLOW)).at(0.21, Halt())
    scene.at(1.0, Drag(THERE, FAST)).at(1.01, Halt()).until(3.0)
    scene.run()
    assert lines(scene, "v") == ["30", "700"]
    assert not lines(scene, "c")
    assert "Halted" in errors(scene)[1]


def test_a_step_whose_speeds_are_not_taken_ends_what_is_played() -> None:
    scene = Scene().at(0.1, Move(1, HERE, FAST))
    scene.at(2.0, lambda: scene.stage.do("servo 5 dead")).at(2.0, Play(2, (Step(THERE, 1.0),), 0))
    scene.until(5.0).run()
    assert [ended.why for ended in scene.of(PlayEnded)] == [Ending.SPEEDS]
    assert "Motor 5 did not take its speed" in errors(scene)[2]
    assert lines(scene, "c") == ["512"]


def test_servos_that_were_without_power_meanwhile_are_given_their_speed_again() -> None:
    scene = Scene().at(0.2, Move(1, HERE, SLOW))
    scene.at(4.0, lambda: scene.stage.do("servo power off"))
    scene.at(5.0, lambda: scene.stage.do("servo power on"))
    scene.at(6.5, Move(2, THERE, SLOW)).until(9.5).run()
    assert lines(scene, "v") == ["30", "30"]
    assert errors(scene) == {1: "", 2: ""}
    assert scene.of(Moved)[-1].seconds > 1.2, "88 units at 30 are 1.29 s"


# --- The newest wish ------------------------------------------------------------------------


def test_the_speed_that_was_chosen_last_holds_for_the_next_motion() -> None:
    scene = Scene().at(0.2, Move(1, HERE, FAST)).at(3.0, Move(2, THERE, (100,) * 8))
    scene.at(3.15, Drag(HERE, (100,) * 8))
    scene.at(3.2, SetSpeeds(3, FAST)).at(3.2, SetSpeeds(4, (20,) * 8)).until(8.0)
    scene.run()
    assert lines(scene, "v") == ["700", "100", "20"]
    assert lines(scene, "c") == ["512", "600", "512"]
    assert scene.of(Moved)[-1].seconds > 1.8, "86 units at 20 are 1.89 s"
    assert "chosen since" in errors(scene)[3]
    assert errors(scene)[4] == ""


def test_a_newer_move_takes_the_place_of_an_older_drag() -> None:
    scene = Scene().at(0.2, Move(1, THERE, SLOW)).at(0.5, Drag((300,) * 8, SLOW))
    scene.at(0.6, Move(2, HERE, SLOW)).until(6.0)
    scene.run()
    assert lines(scene, "c") == ["600", "512"]


# --- Limits ---------------------------------------------------------------------------------


def test_the_newest_limits_count_for_moves_drags_and_steps_that_were_asked_for_before() -> None:
    scene = Scene().at(0.1, Move(1, HERE, FAST)).at(3.0, SetLimits(((520, 550),) * 8))
    scene.at(3.1, Move(2, THERE, FAST)).at(5.0, Drag(HERE, FAST))
    scene.at(7.0, Play(3, (Step((530,) * 8, 0.5), Step((545,) * 8, 0.5)), rounds=0))
    scene.on(
        lambda report: isinstance(report, StepBegun) and report.round == 2,
        SetLimits(((535, 540),) * 8),
    )
    scene.until(12.0).run()
    sent = lines(scene, "c")
    assert sent[:3] == ["512", "550", "520"]
    assert sent[3:7] == ["530", "545"] * 2
    assert sent[8:12] == ["540", "535"] * 2


def test_limits_that_cannot_be_are_not_taken() -> None:
    scene = Scene().at(0.1, SetLimits(((400, 500),) * 8)).at(0.2, SetLimits(((500, 400),) * 8))
    scene.at(0.3, Move(1, THERE, FAST)).until(4.0)
    scene.run()
    assert lines(scene, "c") == ["500"]
