"""Servos that are dead or blocked, have no power, or do not reply once."""

import pytest

from tests.support.aracna import AracnaHarness

SPEEDS = b".v50,50,50,50,50,50,50,50\n"
HELD = b".v50,50,50,50,50,50,50,50\r\n"
GOALS = b".c520,520,520,520,520,520,520,520\n"
FAR_GOALS = b".c740,740,740,740,740,740,740,740\n"
ARRIVED = b".c740,740,740,740,740,740,740,740\r\n"


def test_dead_servo_neither_reports_nor_accepts_a_speed(harness: AracnaHarness) -> None:
    harness.do("servo 3 dead")
    assert harness.request(SPEEDS) == b".v50,50,50,-1,50,50,50,50\r\n"
    harness.do("servo 3 alive")
    assert harness.speeds == (50, 50, 50, 0, 50, 50, 50, 50)


def test_dead_servo_stalls_reply_in_mid_line_until_it_recovers(harness: AracnaHarness) -> None:
    harness.do("servo 3 dead")
    assert harness.request(GOALS, 60) == b".c520,520,520,"
    harness.do("servo 3 alive")
    assert harness.request(b"") == b"512,520,520,520,520\r\n"  # the servo has not received the goal
    assert harness.request(b".q\n") == b".q1,8\r\n"


def test_servo_failing_in_motion_arrives_after_recovery(harness: AracnaHarness) -> None:
    harness.request(SPEEDS)
    harness.line.send(FAR_GOALS)
    harness.line.advance(1)
    harness.do("servo 3 dead")
    stopped = harness.positions[3]
    harness.line.advance(30)
    assert harness.line.receive() == b".c740,740,740,"
    assert harness.positions[3] == stopped
    assert 600 < stopped < 700
    harness.do("servo 3 alive")
    assert harness.request(b"") == b"740,740,740,740,740\r\n"


@pytest.mark.parametrize(("hindrance", "release"), [("block", "free"), ("load 1", "load 0.9")])
def test_held_servo_stays_moving_until_freed(
    harness: AracnaHarness, hindrance: str, release: str
) -> None:
    harness.do(f"servo 6 {hindrance}")
    assert harness.request(FAR_GOALS, 20) == b".c740,740,740,740,740,740,"
    assert harness.line.servos[6].moving
    assert harness.positions[6] == 512
    harness.do(f"servo 6 {release}")
    assert harness.request(b"") == b"740,740\r\n"


def test_blocked_servo_at_goal_delays_nothing(harness: AracnaHarness) -> None:
    harness.request(FAR_GOALS)
    harness.do("servo 6 block")
    assert harness.request(FAR_GOALS) == ARRIVED


def test_reply_stalls_after_letter_without_servo_power(harness: AracnaHarness) -> None:
    harness.do("servo power off")
    assert harness.request(SPEEDS) == b".v-1,-1,-1,-1,-1,-1,-1,-1\r\n"
    assert harness.request(GOALS, 20) == b".c"
    harness.do("servo power on")
    assert harness.request(b"") == b"512,512,512,512,512,512,512,512\r\n"


def test_lost_position_reads_as_minus_one_and_lost_moving_flag_as_arrived(
    harness: AracnaHarness,
) -> None:
    harness.do("servo 4 lose position")
    assert harness.request(GOALS) == b".c520,520,520,520,-1,520,520,520\r\n"
    harness.do("servo 4 lose moving")
    assert harness.request(GOALS) == b".c520,520,520,520,520,520,520,520\r\n"


def test_lost_speed_reads_as_minus_one_though_set(harness: AracnaHarness) -> None:
    harness.do("servo 4 lose speed")
    assert harness.request(SPEEDS) == b".v50,50,50,50,-1,50,50,50\r\n"
    assert harness.speeds == (50,) * 8
    assert harness.request(SPEEDS) == HELD
