"""Servos that are dead, blocked or without power, or miss a request."""

import pytest

from tests.support.aracna import AracnaStage

SPEEDS = b".v50,50,50,50,50,50,50,50\n"
HELD = b".v50,50,50,50,50,50,50,50\r\n"
GOALS = b".c520,520,520,520,520,520,520,520\n"
FAR = b".c740,740,740,740,740,740,740,740\n"
ARRIVED = b".c740,740,740,740,740,740,740,740\r\n"


def test_dead_servo_reports_and_accepts_no_speed(stage: AracnaStage) -> None:
    stage.do("servo 3 dead")
    assert stage.request(SPEEDS) == b".v50,50,50,-1,50,50,50,50\r\n"
    stage.do("servo 3 alive")
    assert stage.speeds == (50, 50, 50, 0, 50, 50, 50, 50)


def test_dead_servo_stalls_reply_in_mid_line_until_it_recovers(stage: AracnaStage) -> None:
    stage.do("servo 3 dead")
    assert stage.request(GOALS, 60) == b".c520,520,520,"
    stage.do("servo 3 alive")
    assert stage.request(b"") == b"512,520,520,520,520\r\n"  # the servo has not received the goal
    assert stage.request(b".q\n") == b".q1,8\r\n"


def test_servo_failing_in_motion_arrives_after_recovery(stage: AracnaStage) -> None:
    stage.request(SPEEDS)
    stage.line.send(FAR)
    stage.line.advance(1)
    stage.do("servo 3 dead")
    stopped = stage.positions[3]
    stage.line.advance(30)
    assert stage.line.receive() == b".c740,740,740,"
    assert stage.positions[3] == stopped
    assert 600 < stopped < 700
    stage.do("servo 3 alive")
    assert stage.request(b"") == b"740,740,740,740,740\r\n"


def test_reset_ends_reply_stalled_by_dead_servo(stage: AracnaStage) -> None:
    stage.do("servo 0 dead")
    assert stage.request(GOALS, 20) == b".c"
    stage.do("reset")
    assert stage.request(b".q\n") == b".h\r\n.q1,8\r\n"


@pytest.mark.parametrize(("hindered", "freed"), [("block", "free"), ("load 1", "load 0.9")])
def test_held_servo_stays_moving_until_freed(stage: AracnaStage, hindered: str, freed: str) -> None:
    stage.do(f"servo 6 {hindered}")
    assert stage.request(FAR, 20) == b".c740,740,740,740,740,740,"
    assert stage.line.servos[6].moving
    assert stage.positions[6] == 512
    stage.do(f"servo 6 {freed}")
    assert stage.request(b"") == b"740,740\r\n"


def test_blocked_servo_at_goal_delays_nothing(stage: AracnaStage) -> None:
    stage.request(FAR)
    stage.do("servo 6 block")
    assert stage.request(FAR) == ARRIVED


def test_reply_stalls_after_letter_without_servo_power(stage: AracnaStage) -> None:
    stage.do("servo power off")
    assert stage.request(SPEEDS) == b".v-1,-1,-1,-1,-1,-1,-1,-1\r\n"
    assert stage.request(GOALS, 20) == b".c"
    stage.do("servo power on")
    assert stage.request(b"") == b"512,512,512,512,512,512,512,512\r\n"


def test_lost_position_reads_as_minus_one_and_lost_moving_flag_as_arrived(
    stage: AracnaStage,
) -> None:
    stage.do("servo 4 lose position")
    assert stage.request(GOALS) == b".c520,520,520,520,-1,520,520,520\r\n"
    stage.do("servo 4 lose moving")
    assert stage.request(GOALS) == b".c520,520,520,520,520,520,520,520\r\n"


def test_lost_speed_reads_as_minus_one_though_set(stage: AracnaStage) -> None:
    stage.do("servo 4 lose speed")
    assert stage.request(SPEEDS) == b".v50,50,50,50,-1,50,50,50\r\n"
    assert stage.speeds == (50,) * 8
    assert stage.request(SPEEDS) == HELD
