"""Power-up and restart of the board."""

import pytest

from tests.support.aracna import AracnaStage

HELLO = b".h\r\n"
VERSION = b".q1,8\r\n"
SPEEDS = b".v50,50,50,50,50,50,50,50\n"
GOALS = b".c800,800,800,800,800,800,800,800\n"


def test_board_sends_hello_then_ignores_host_for_a_second() -> None:
    stage = AracnaStage(booted=False)
    assert stage.line.read(4, 1) == HELLO
    assert stage.now == pytest.approx(0.001, abs=0.0005)
    stage.line.send(b".q\n")
    assert stage.line.read(len(VERSION), 2) == VERSION
    assert stage.now == pytest.approx(1.003, abs=0.002)


def test_led_blinks_during_boot_then_turns_off() -> None:
    stage = AracnaStage(booted=False)
    seen = []
    while stage.now < 1.1:
        stage.line.advance(0.05)
        seen.append(stage.line.station.firmware.led)
    assert True in seen[:19]
    assert False in seen[:19]
    assert seen[-1] is False


def test_boot_loader_delays_hello() -> None:
    stage = AracnaStage(booted=False, boot_loader=2.0)
    assert stage.line.read(4, 1.9) == b""
    assert stage.line.read(4, 0.2) == HELLO


def test_led_is_off_after_restart(stage: AracnaStage) -> None:
    stage.request(b".l1\n")
    stage.request(b".c\n")
    assert stage.request(b".l\n") == b".l0\r\n"


def test_servos_keep_moving_during_board_reset(stage: AracnaStage) -> None:
    stage.request(SPEEDS)
    stage.line.send(GOALS)
    stage.line.advance(1)
    before = stage.positions
    stage.do("reset")
    stage.line.advance(0.5)
    assert all(now > then for now, then in zip(stage.positions, before, strict=True))
    stage.line.advance(5)
    assert stage.positions == (800,) * 8
    assert stage.line.receive() == b".c" + HELLO
    assert stage.speeds == (50,) * 8
    assert all(servo.torque for servo in stage.line.servos)


def test_restart_by_invalid_line_keeps_servo_settings(stage: AracnaStage) -> None:
    stage.request(SPEEDS)
    stage.request(GOALS, 10)
    stage.request(b".c\n")
    assert (stage.speeds, stage.goals) == ((50,) * 8, (800,) * 8)


def test_unpowered_servos_lose_all_but_position(stage: AracnaStage) -> None:
    stage.request(SPEEDS)
    stage.line.send(GOALS)
    stage.line.advance(1)
    stage.do("servo power off")
    stopped = stage.positions
    stage.line.advance(1)
    stage.do("servo power on")
    stage.line.advance(1)
    assert stage.positions == stopped
    assert 512 < stopped[0] < 800
    assert stage.speeds == (0,) * 8
    assert not any(servo.torque for servo in stage.line.servos)


def test_reset_truncates_reply(stage: AracnaStage) -> None:
    stage.line.send(b".q\n")
    assert stage.line.read(3, 1) == b".q1"
    stage.line.advance(stage.line.byte_time / 2)  # within a byte
    stage.do("reset")
    assert stage.request(b"") == HELLO


def test_reset_discards_partial_line(stage: AracnaStage) -> None:
    stage.request(b".c500,")
    stage.do("reset")
    stage.line.advance(1.1)
    stage.line.receive()
    assert stage.request(b".q\n") == VERSION


def test_unpowered_board_is_silent_and_boots_with_hello(stage: AracnaStage) -> None:
    stage.request(SPEEDS)
    stage.do("power off")
    assert stage.request(b".q\n") == b""
    stage.do("power on")
    assert stage.request(b"") == HELLO
    assert stage.request(b".q\n") == VERSION
    assert stage.speeds == (0,) * 8


def test_power_on_while_powered_does_not_restart_board(stage: AracnaStage) -> None:
    stage.do("power on")
    assert stage.request(b".q\n") == VERSION
    assert stage.line.station.firmware.boots == 1
