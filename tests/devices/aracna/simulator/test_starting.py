"""Power-up and restart of the board."""

import pytest

from tests.support.aracna import AracnaHarness

HELLO = b".h\r\n"
VERSION = b".q1,8\r\n"
SPEEDS = b".v50,50,50,50,50,50,50,50\n"
GOALS = b".c800,800,800,800,800,800,800,800\n"


def test_board_sends_hello_then_reads_nothing_for_a_second() -> None:
    harness = AracnaHarness(booted=False)
    assert harness.line.read(4, 1) == HELLO
    assert harness.now == pytest.approx(0.001, abs=0.0005)
    harness.line.send(b".q\n")
    assert harness.line.read(len(VERSION), 2) == VERSION
    assert harness.now == pytest.approx(1.003, abs=0.002)


def test_led_blinks_during_boot_then_turns_off() -> None:
    harness = AracnaHarness(booted=False)
    seen = []
    while harness.now < 1.1:
        harness.line.advance(0.05)
        seen.append(harness.line.station.firmware.led)
    assert True in seen[:19]
    assert False in seen[:19]
    assert seen[-1] is False


def test_boot_loader_delays_hello() -> None:
    harness = AracnaHarness(booted=False, boot_loader=2.0)
    assert harness.line.read(4, 1.9) == b""
    assert harness.line.read(4, 0.2) == HELLO


def test_servos_keep_moving_during_board_reset(harness: AracnaHarness) -> None:
    harness.request(SPEEDS)
    harness.line.send(GOALS)
    harness.line.advance(1)
    before = harness.positions
    harness.do("reset")
    harness.line.advance(0.5)
    assert all(now > then for now, then in zip(harness.positions, before, strict=True))
    harness.line.advance(5)
    assert harness.positions == (800,) * 8
    assert harness.line.receive() == b".c" + HELLO
    assert harness.speeds == (50,) * 8
    assert all(servo.torque for servo in harness.line.servos)


def test_restart_by_invalid_line_turns_led_off_and_keeps_servo_settings(
    harness: AracnaHarness,
) -> None:
    harness.request(SPEEDS)
    harness.request(GOALS, 10)
    harness.request(b".l1\n")
    harness.request(b".c\n")
    assert harness.request(b".l\n") == b".l0\r\n"
    assert (harness.speeds, harness.goals) == ((50,) * 8, (800,) * 8)


def test_unpowered_servos_lose_all_but_position(harness: AracnaHarness) -> None:
    harness.request(SPEEDS)
    harness.line.send(GOALS)
    harness.line.advance(1)
    harness.do("servo power off")
    stopped = harness.positions
    harness.line.advance(1)
    harness.do("servo power on")
    harness.line.advance(1)
    assert harness.positions == stopped
    assert 512 < stopped[0] < 800
    assert harness.speeds == (0,) * 8
    assert not any(servo.torque for servo in harness.line.servos)


def test_reset_truncates_reply(harness: AracnaHarness) -> None:
    harness.line.send(b".q\n")
    assert harness.line.read(3, 1) == b".q1"
    harness.line.advance(harness.line.byte_time / 2)  # within a byte
    harness.do("reset")
    assert harness.request(b"") == HELLO


def test_reset_discards_partial_line(harness: AracnaHarness) -> None:
    harness.request(b".c500,")
    harness.do("reset")
    harness.line.advance(1.1)
    harness.line.receive()
    assert harness.request(b".q\n") == VERSION


def test_unpowered_board_is_silent_and_boots_with_hello(harness: AracnaHarness) -> None:
    harness.request(SPEEDS)
    harness.do("power off")
    assert harness.request(b".q\n") == b""
    harness.do("power on")
    assert harness.request(b"") == HELLO
    assert harness.request(b".q\n") == VERSION
    assert harness.speeds == (0,) * 8


def test_power_on_while_powered_does_not_restart_board(harness: AracnaHarness) -> None:
    harness.do("power on")
    assert harness.request(b".q\n") == VERSION
    assert harness.line.station.firmware.boots == 1
