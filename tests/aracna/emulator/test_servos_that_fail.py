"""Servos that are dead, blocked, without power, or miss a question."""

import pytest

from tests.support.aracna import AracnaStage

SPEEDS = b".v50,50,50,50,50,50,50,50\n"
HELD = b".v50,50,50,50,50,50,50,50\r\n"
GOALS = b".c520,520,520,520,520,520,520,520\n"
FAR = b".c740,740,740,740,740,740,740,740\n"
ARRIVED = b".c740,740,740,740,740,740,740,740\r\n"


@pytest.fixture
def stage() -> AracnaStage:
    return AracnaStage(margin=0)


def test_a_dead_servo_has_no_speed(stage: AracnaStage) -> None:
    stage.do("servo 3 dead")
    assert stage.ask(SPEEDS) == b".v50,50,50,-1,50,50,50,50\r\n"
    stage.do("servo 3 alive")
    assert stage.speeds == (50, 50, 50, 0, 50, 50, 50, 50)


def test_a_dead_servo_stops_the_answer_in_mid_line_for_ever(stage: AracnaStage) -> None:
    stage.do("servo 3 dead")
    assert stage.ask(GOALS, 600) == b".c520,520,520,"


def test_the_answer_goes_on_when_the_servo_is_back(stage: AracnaStage) -> None:
    stage.do("servo 3 dead")
    stage.ask(GOALS, 60)
    stage.do("servo 3 alive")
    assert stage.ask(b"") == b"512,520,520,520,520\r\n"  # it has never heard of the goal
    assert stage.ask(b".q\n") == b".q1,8\r\n"


def test_a_servo_that_dies_in_mid_motion_arrives_when_it_is_back(stage: AracnaStage) -> None:
    stage.ask(SPEEDS)
    stage.line.send(FAR)
    stage.line.advance(1)
    stage.do("servo 3 dead")
    stopped = stage.positions[3]
    stage.line.advance(30)
    assert stage.line.receive() == b".c740,740,740,"
    assert stage.positions[3] == stopped
    assert 600 < stopped < 700
    stage.do("servo 3 alive")
    assert stage.ask(b"") == b"740,740,740,740,740\r\n"


def test_only_a_reset_helps_where_the_servo_stays_dead(stage: AracnaStage) -> None:
    stage.do("servo 0 dead")
    assert stage.ask(GOALS, 60) == b".c"
    stage.do("reset")
    assert stage.ask(b".q\n") == b".h\r\n.q1,8\r\n"


def test_a_blocked_servo_stays_moving_until_it_is_free(stage: AracnaStage) -> None:
    stage.do("servo 6 block")
    assert stage.ask(FAR, 60) == b".c740,740,740,740,740,740,"
    assert stage.line.servos[6].moving
    assert stage.positions[6] == 512
    stage.do("servo 6 free")
    assert stage.ask(b"") == b"740,740\r\n"


def test_a_servo_under_a_full_load_stands(stage: AracnaStage) -> None:
    stage.do("servo 6 load 1")
    assert stage.ask(FAR, 60).count(b",") == 6
    stage.do("servo 6 load 0.9")
    assert stage.ask(b"") == b"740,740\r\n"


def test_a_blocked_servo_that_is_where_it_should_be_holds_up_nothing(stage: AracnaStage) -> None:
    stage.ask(FAR)
    stage.do("servo 6 block")
    assert stage.ask(FAR) == ARRIVED


def test_without_servo_power_positions_hang_after_their_letter(stage: AracnaStage) -> None:
    stage.do("servo power off")
    assert stage.ask(SPEEDS) == b".v-1,-1,-1,-1,-1,-1,-1,-1\r\n"
    assert stage.ask(GOALS, 60) == b".c"
    stage.do("servo power on")
    assert stage.ask(b"") == b"512,512,512,512,512,512,512,512\r\n"


def test_one_lost_position_shows_as_minus_one(stage: AracnaStage) -> None:
    stage.do("servo 4 lose position")
    assert stage.ask(GOALS) == b".c520,520,520,520,-1,520,520,520\r\n"
    assert stage.ask(GOALS) == b".c520,520,520,520,520,520,520,520\r\n"


def test_one_lost_moving_flag_only_takes_another_question(stage: AracnaStage) -> None:
    stage.do("servo 4 lose moving")
    assert stage.ask(GOALS) == b".c520,520,520,520,520,520,520,520\r\n"


def test_one_lost_speed_shows_as_minus_one_though_it_is_set(stage: AracnaStage) -> None:
    stage.do("servo 4 lose speed")
    assert stage.ask(SPEEDS) == b".v50,50,50,50,-1,50,50,50\r\n"
    assert stage.speeds == (50,) * 8
    assert stage.ask(SPEEDS) == HELD


def test_a_refused_speed_shows_the_one_before(stage: AracnaStage) -> None:
    stage.ask(SPEEDS)
    assert stage.ask(b".v1024,9999,50,50,50,50,50,0\n") == b".v50,50,50,50,50,50,50,0\r\n"


def test_a_new_speed_acts_on_the_next_motion(stage: AracnaStage) -> None:
    stage.ask(SPEEDS)
    assert stage.ask(FAR, 1).startswith(b".c")
    assert stage.ask(b"", 3) == ARRIVED[2:]
