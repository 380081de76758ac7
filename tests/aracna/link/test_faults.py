"""What goes wrong in mid-command: restarts, servos that die, lines that are cut, silence."""

import pytest

from tests.aracna.link.scene import Scene
from trex_gui.aracna.link.client import ASK_AGAIN
from trex_gui.aracna.link.messages import (
    Connected,
    Counted,
    Drag,
    DragDropped,
    Ending,
    Move,
    Moved,
    Moving,
    Passed,
    Play,
    PlayEnded,
    Restarted,
    SetSpeeds,
    Silent,
    SpeedsHeld,
    Step,
    Stuck,
)
from trex_gui.aracna.link.presence import BOOT
from trex_gui.aracna.link.refusals import STUCK
from trex_gui.link.messages import Closed, Outcome
from trex_gui.protocol.errors import BadReply, NoReply

HERE = (512,) * 8
THERE = (600,) * 8
SLOW = (100,) * 8
STEPS = (Step(THERE, 0.6), Step(HERE, 0.6))


def moving_at(report: object) -> bool:
    return isinstance(report, Moving)


# --- Restarts -------------------------------------------------------------------------------


def _assert_goes_on_after_a_restart(scene: Scene, *, voided: bool) -> None:
    [restarted] = scene.of(Restarted)
    assert restarted.voided is voided
    again = scene.of(Connected)[1]
    assert again.restarted
    wait = scene.when(Connected)[1] - scene.when(Restarted)[0]
    assert BOOT <= wait < BOOT + 0.2
    assert scene.line.station.firmware.boots == 2  # no second one, of what was sent too early
    assert not scene.of(Silent)


def test_a_restart_while_idle_is_told_and_the_robot_asked_anew() -> None:
    scene = Scene().at(1.0, lambda: scene.stage.do("reset")).until(4.0)
    scene.run()
    _assert_goes_on_after_a_restart(scene, voided=False)


@pytest.mark.parametrize("delay", [0.0005, 0.005, 0.02, 0.04])
def test_a_restart_during_a_v_voids_it(delay: float) -> None:
    scene = Scene().at(0.5, SetSpeeds(1, SLOW))
    scene.at(0.5 + delay, lambda: scene.stage.do("reset")).at(4.0, SetSpeeds(2, SLOW)).until(5.0)
    scene.run()
    _assert_goes_on_after_a_restart(scene, voided=True)
    outcomes = {outcome.id: outcome for outcome in scene.of(Outcome)}
    assert "restarted" in str(outcomes[1].error)
    assert outcomes[2].error is None


@pytest.mark.parametrize("delay", [0.0005, 0.012, 0.1, 0.38])
def test_a_restart_during_a_c_voids_it_while_the_servos_go_on(delay: float) -> None:
    scene = Scene().at(0.2, SetSpeeds(9, SLOW)).at(0.5, Move(1, THERE)).at(0.5, Move(2, HERE))
    scene.at(0.5, Drag(HERE)).at(0.5 + delay, lambda: scene.stage.do("reset")).until(5.0)
    scene.run()
    _assert_goes_on_after_a_restart(scene, voided=True)
    outcomes = {outcome.id: outcome.error for outcome in scene.of(Outcome)}
    assert "restarted" in str(outcomes[1])
    assert "restarted" in str(outcomes[2])
    assert not scene.of(Moved)
    assert len(scene.of(Moving)) == 1  # nothing moves by itself afterwards
    if delay > 0.01:
        assert scene.stage.positions == (598,) * 8


@pytest.mark.parametrize("delay", [0.0, 0.03, 0.3, 0.7, 1.0, 1.7])
def test_a_restart_ends_what_is_played(delay: float) -> None:
    scene = Scene().at(0.5, Play(1, STEPS, rounds=0))
    scene.at(0.52 + delay, lambda: scene.stage.do("reset")).until(6.0)
    scene.run()
    _assert_goes_on_after_a_restart(scene, voided=True)
    [ended] = scene.of(PlayEnded)
    assert ended.why is Ending.RESTARTED
    [outcome] = scene.of(Outcome)
    assert "restarted" in str(outcome.error)
    sent_last = max([0.0, *scene.when(Moving)])
    assert sent_last <= scene.when(Restarted)[0]


def test_a_restart_while_opening_only_delays_it() -> None:
    scene = Scene(booted=False).at(0.7, lambda: scene.stage.do("reset")).until(5.0)
    scene.run()
    assert scene.kinds == ["Connected", "Closed"]
    assert not scene.of(Connected)[0].restarted


def test_restarts_one_after_the_other_are_waited_out() -> None:
    scene = Scene()
    for time in (1.0, 1.6, 2.2, 2.8):
        scene.at(time, lambda: scene.stage.do("reset"))
    scene.until(6.0).run()
    assert len(scene.of(Restarted)) == 4
    assert len(scene.of(Connected)) == 2
    assert scene.line.station.firmware.boots == 5


def test_a_boot_loader_after_a_restart_is_waited_for() -> None:
    scene = Scene(boot_loader=3.0).at(1.0, lambda: scene.stage.do("reset")).until(9.0)
    scene.run()
    assert [connected.restarted for connected in scene.of(Connected)][1:] == [True]
    assert scene.line.station.firmware.boots == 2


# --- Servos that fail -----------------------------------------------------------------------


def _stuck_scene() -> Scene:
    scene = Scene().at(0.2, SetSpeeds(1, SLOW)).at(0.4, Move(2, HERE)).at(0.6, Move(3, THERE))
    return scene.at(0.8, lambda: scene.stage.do("servo 3 dead"))


def test_a_servo_that_dies_in_mid_motion_is_named_once_and_nothing_sent_but_questions() -> None:
    scene = _stuck_scene()
    scene.at(8.0, Move(4, HERE)).until(60.0)
    scene.run()
    [stuck] = scene.of(Stuck)
    assert stuck.motor == 3
    # 88 units at 100 a quarter longer, a second, and what the wire may take
    assert scene.when(Stuck)[0] - scene.when(Moving)[1] == pytest.approx(
        88 / 228 * 1.25 + 1.0, abs=0.06
    )
    assert scene.of(Passed)[-1].present == (598,) * 3
    assert not scene.of(Silent)
    behind = bytes(scene.stage.transport.sent).split(b".c" + b"600," * 7 + b"600\n")[1]
    assert behind == b".q\n" * behind.count(b".q\n")
    assert 1 < behind.count(b".q\n") <= 2 + 60 / ASK_AGAIN
    outcomes = {outcome.id: outcome.error for outcome in scene.of(Outcome)}
    assert outcomes[3] is not None  # closed before this was done
    assert outcomes[4] is not None


def test_a_servo_that_comes_back_ends_the_move_after_all_and_begins_nothing_by_itself() -> None:
    scene = _stuck_scene()
    scene.at(0.9, Move(4, HERE)).at(0.9, Drag((400,) * 8))  # both wait
    scene.at(3.0, Drag((410,) * 8)).at(3.1, Move(5, HERE)).at(3.2, Play(6, STEPS))
    scene.at(9.0, lambda: scene.stage.do("servo 3 alive"))
    scene.at(10.5, Move(7, HERE)).until(14.0)
    scene.run()
    assert len(scene.of(Stuck)) == 1
    assert [moved.present[3] for moved in scene.of(Moved)] == [512, 598, 514]
    assert scene.when(Moving)[2] > 10.4, "only what was asked for after the robot had answered"
    outcomes = {outcome.id: outcome.error for outcome in scene.of(Outcome)}
    assert [number for number, error in outcomes.items() if error is None] == [1, 2, 3, 7]
    assert {str(outcomes[number]) for number in (4, 5, 6)} == {STUCK}
    assert [dropped.goals for dropped in scene.of(DragDropped)] == [(410,) * 8]
    assert not scene.of(Silent)


def test_a_dead_servo_is_told_by_its_speed() -> None:
    scene = Scene().at(0.1, lambda: scene.stage.do("servo 5 dead")).at(0.2, SetSpeeds(1, SLOW))
    scene.until(1.0).run()
    [held] = scene.of(SpeedsHeld)
    assert held.held == (100,) * 5 + (-1,) + (100,) * 2


def test_a_position_that_could_not_be_read_is_told_and_not_taken_for_one() -> None:
    scene = Scene().at(0.1, SetSpeeds(3, SLOW))
    scene.at(0.2, lambda: scene.stage.do("servo 2 lose position"))
    scene.at(0.3, Move(1, THERE)).at(2.0, Move(2, HERE)).until(6.0)
    scene.run()
    assert scene.of(Moved)[0].present[2] == -1
    assert scene.of(Moving)[1].starts[2] is None
    assert scene.of(Moving)[1].expected == pytest.approx(512 / 228)


@pytest.mark.parametrize("load", [0.1, 0.19])
def test_a_servo_that_is_a_little_slow_is_not_called_stuck(load: float) -> None:
    scene = Scene(positions=(0,) * 8).at(0.1, SetSpeeds(1, SLOW)).at(0.2, Move(2, (0,) * 8))
    scene.at(0.4, lambda: scene.stage.do(f"servo 7 load {load}")).at(0.5, Move(3, (1000,) * 8))
    scene.until(10.0).run()
    assert len(scene.of(Moved)) == 2
    assert not scene.of(Stuck)


def test_what_is_played_ends_where_a_motor_is_stuck() -> None:
    scene = Scene().at(0.2, Play(1, STEPS, rounds=0))
    scene.at(4.0, lambda: scene.stage.do("servo 6 block"))
    scene.at(12.0, lambda: scene.stage.do("servo 6 free")).until(14.0)
    scene.run()
    assert [ended.why for ended in scene.of(PlayEnded)] == [Ending.STUCK]
    assert scene.of(Stuck)[0].motor == 6
    assert "motor 6" in str(scene.of(Outcome)[0].error)
    assert scene.when(Moving)[-1] < scene.when(Stuck)[0]
    reports = [report for report in scene.reports if not isinstance(report, Counted)]
    assert isinstance(reports[-2], Moved)  # told after all


# --- A line that damages --------------------------------------------------------------------


@pytest.mark.parametrize("lost", [1, 2, 3, 20, 33, 34])
def test_a_reply_that_is_cut_in_the_middle_is_no_reply_and_the_next_command_is_answered(
    lost: int,
) -> None:
    scene = Scene().at(0.2, SetSpeeds(1, SLOW)).at(0.5, Move(2, THERE))
    scene.at(0.7, lambda: scene.stage.do(f"line drop {lost}")).at(7.0, Move(3, HERE)).until(14.0)
    scene.run()
    outcomes = {outcome.id: outcome.error for outcome in scene.of(Outcome)}
    assert outcomes[3] is None
    if outcomes[2] is not None:
        assert isinstance(outcomes[2], NoReply | BadReply)
    assert scene.of(Moved)[-1].goals == HERE
    assert scene.line.station.firmware.boots == 1


def test_a_v_whose_answer_is_damaged_is_lost_in_a_second_and_the_robot_is_still_there() -> None:
    scene = Scene().at(0.5, lambda: scene.stage.do("line drop 5")).at(0.5, SetSpeeds(1, SLOW))
    scene.at(3.0, SetSpeeds(2, SLOW)).until(4.0)
    scene.run()
    first, second = scene.of(Outcome)
    assert isinstance(first.error, BadReply)
    assert second.error is None
    assert scene.when(Outcome)[0] == pytest.approx(1.5, abs=0.1)
    assert not scene.of(Silent)


@pytest.mark.parametrize("dropped", [1, 2, 4, 11, 33, 34])
def test_bytes_that_get_lost_on_the_way_to_the_robot_end_in_an_error_and_it_goes_on(
    dropped: int,
) -> None:
    scene = Scene().at(0.2, SetSpeeds(9, SLOW)).at(0.5, Move(8, HERE))
    scene.at(0.7, lambda: scene.stage.do(f"line drop {dropped} sent"))
    scene.at(0.7, Move(1, THERE)).at(12.0, Move(2, HERE)).until(16.0)
    scene.run()
    outcomes = {outcome.id: outcome.error for outcome in scene.of(Outcome)}
    assert set(outcomes) == {1, 2, 8, 9}
    assert outcomes[2] is None
    assert scene.of(Moved)[-1].goals == HERE


@pytest.mark.parametrize("seed", range(6))
def test_noise_never_ends_a_session_nor_leaves_a_request_without_an_outcome(seed: int) -> None:
    scene = Scene(seed=seed).at(0.2, SetSpeeds(99, SLOW))
    scene.at(0.4, lambda: scene.stage.do("line noise 0.02"))
    for number in range(20):
        scene.at(0.5 + number * 2, Move(number, THERE if number % 2 else HERE))
    scene.at(41.0, lambda: scene.stage.do("line noise 0"))
    for servo in scene.line.servos:
        servo.speed = 500
    scene.at(60.0, lambda: None).until(61.0)
    scene.run()
    assert scene.reports[-1].error is None  # type: ignore[union-attr]  # it is Closed
    assert sorted(one.id for one in scene.of(Outcome)) == [*range(20), 99]


def test_a_robot_that_is_mute_from_the_middle_of_a_motion_on_is_called_silent() -> None:
    scene = Scene().at(0.2, SetSpeeds(1, SLOW)).at(0.4, Move(2, HERE)).at(0.6, Move(3, THERE))
    scene.at(0.6, lambda: scene.stage.do("line mute on"))
    scene.at(12.0, lambda: scene.stage.do("line mute off")).until(16.0)
    scene.run()
    assert scene.of(Stuck)[0].motor is None
    assert len(scene.of(Silent)) == 1
    assert len(scene.of(Connected)) == 2
    assert isinstance({one.id: one.error for one in scene.of(Outcome)}[3], NoReply)
    assert scene.line.station.firmware.boots == 1


def test_a_second_servo_that_dies_is_named_too() -> None:
    scene = _stuck_scene()
    scene.at(6.0, lambda: scene.stage.do("servo 5 dead"))
    scene.at(8.0, lambda: scene.stage.do("servo 3 alive")).until(20.0)
    scene.run()
    assert [stuck.motor for stuck in scene.of(Stuck)] == [3, 5]


def test_a_line_that_was_cut_in_mid_answer_is_free_again_once_the_robot_answers() -> None:
    scene = Scene()
    scene.at(0.5, Move(1, (500, 300, *(400,) * 6), (30,) * 8))
    scene.at(2.0, lambda: scene.stage.do("line mute on"))
    scene.at(30.0, lambda: scene.stage.do("line mute off"))
    scene.at(40.0, Move(2, (450,) * 8, (30,) * 8)).until(50.0)
    scene.run()
    outcomes = {outcome.id: outcome.error for outcome in scene.of(Outcome)}
    assert outcomes[1] is not None
    assert outcomes[2] is None


def test_move_sent_right_after_a_lost_reply_is_done() -> None:
    """It waits until the robot answers `.q`, and is not refused as if the robot were stuck."""
    scene = Scene().at(0.2, SetSpeeds(1, SLOW)).at(0.4, Move(2, HERE)).at(0.6, Move(3, THERE))
    scene.at(0.7, lambda: scene.stage.do("line cut 8"))
    scene.on(lambda report: isinstance(report, Moved) and -1 in report.present, Move(4, HERE))
    scene.until(10.0).run()
    assert len(scene.of(Stuck)) == 1
    outcomes = {outcome.id: outcome.error for outcome in scene.of(Outcome)}
    assert outcomes[3] is not None
    assert outcomes[4] is None
    assert not scene.of(Silent)


def test_speeds_that_are_asked_for_while_it_is_stuck_are_not_sent_later() -> None:
    scene = _stuck_scene()
    scene.at(5.0, SetSpeeds(9, (0,) * 8))
    scene.at(30.0, lambda: scene.stage.do("servo 3 alive")).until(40.0)
    scene.run()
    outcomes = {outcome.id: outcome.error for outcome in scene.of(Outcome)}
    assert str(outcomes[9]) == STUCK
    assert (0,) * 8 not in [held.wanted for held in scene.of(SpeedsHeld)]


def test_after_a_sequence_the_speeds_are_those_that_were_asked_for_before_it() -> None:
    scene = Scene()
    scene.at(0.5, Move(1, HERE, SLOW)).at(1.0, Move(2, (400,) * 8, SLOW))
    scene.at(1.1, SetSpeeds(3, (20,) * 8)).at(1.15, Play(4, (Step((420,) * 8, 1.0),))).until(10.0)
    scene.run()
    assert scene.stage.speeds == (20,) * 8


def test_a_board_that_only_ever_says_that_it_starts_is_given_up() -> None:
    scene = Scene()
    scene.stage.do("power off")
    for turn in range(40):
        scene.at(3.0 * turn, lambda: scene.line.inject(b".h\r\n"))
    scene.until(120.0).run()
    [closed] = scene.of(Closed)
    assert "starts again and again" in str(closed.error)
    assert scene.when(Closed)[0] < 20.0
