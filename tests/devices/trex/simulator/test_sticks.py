"""Sticks that drive, safe-start before it, and the channel that hands control over."""

import pytest

from tests.devices.trex.simulator.ports import SETTLED
from trex_gui.devices.trex.simulator.channels import Signal
from trex_gui.devices.trex.simulator.firmware import Board
from trex_gui.devices.trex.simulator.memory import Eeprom
from trex_gui.devices.trex.simulator.motors import MotorDirection

FORWARD, REVERSE, BRAKE = MotorDirection.FORWARD, MotorDirection.REVERSE, MotorDirection.BRAKE

PULSES = 0.03
"""Seconds in which every input has had its pulse and the motors have been updated."""


def put(board: Board, channel: int, text: str) -> None:
    board.channels.signals[channel] = Signal.parse(text, board.channels.source)


def waits(board: Board) -> bool:
    return board.sticks.safe_start


class TestChannelControl:
    @pytest.mark.parametrize("text", ["invalid", "1300us"])
    def test_safe_start_waits_while_required_channel_is_unsafe(self, text: str) -> None:
        board = Board(mode="rc")
        put(board, 1, text)
        board.power_cycle()
        for _ in range(400):
            board.advance(0.0025)
            assert waits(board)
            assert board.motors[1].direction is BRAKE
            assert board.aux.speed == 0

    @pytest.mark.parametrize("kind", ["silent", "1500us lost 0.6"])
    def test_late_signal_does_not_end_safe_start_with_moved_stick(self, kind: str) -> None:
        for seed in range(20):
            board = Board(mode="rc", seed=seed)
            put(board, 1, kind)
            put(board, 2, "1900us")
            board.advance(SETTLED)
            put(board, 1, "1500us")
            board.advance(1)
            assert waits(board)
            assert board.motors[1].direction is BRAKE

    def test_sticks_drive_motors_with_their_ramps(self) -> None:
        eeprom = Eeprom()
        eeprom.write("motor1_acceleration", 50)
        board = Board(mode="rc", eeprom=eeprom)
        board.advance(SETTLED)
        put(board, 1, "1000us")
        put(board, 3, "2000us")
        speeds = []
        for _ in range(10):
            board.advance(0.01)
            speeds.append(board.motors[0].speed)
        driven = [speed for speed in speeds if speed != 127]  # full brake until the pulse
        assert driven == list(range(5, 5 * len(driven) + 5, 5))
        assert len(driven) >= 8
        assert board.motors[0].direction is REVERSE
        assert board.aux.speed == 127

    def test_deadband_applies_configured_brake(self) -> None:
        eeprom = Eeprom()
        eeprom.write("motor1_deadband_brake_pwm", 33)
        board = Board(mode="rc", eeprom=eeprom)
        board.advance(SETTLED)
        assert (board.motors[0].direction, board.motors[0].speed) == (BRAKE, 33)

    def test_analog_mode_reads_voltages(self) -> None:
        board = Board(mode="analog")
        board.advance(SETTLED)
        assert not waits(board)
        put(board, 1, "5V")
        assert board.motors[0].direction is BRAKE
        board.advance(0.03)
        assert (board.motors[0].direction, board.motors[0].speed) == (FORWARD, 127)

    @pytest.mark.parametrize("mode", ["rc", "analog"])
    def test_motors_wait_after_power_up_until_channels_are_known(self, mode: str) -> None:
        board = Board(mode=mode)
        board.advance(0.09)
        assert waits(board)
        assert board.motors[0].direction is BRAKE
        board.advance(SETTLED)
        assert not waits(board)


class TestSerialOverride:
    def test_serial_override_stops_motor_without_setpoint(self, rc: Board) -> None:
        put(rc, 1, "2000us")
        rc.advance(0.05)
        assert (rc.motors[0].direction, rc.motors[0].speed) == (FORWARD, 127)
        put(rc, 5, "1000us")
        rc.advance(PULSES)
        assert (rc.motors[0].direction, rc.motors[0].speed) == (BRAKE, 127)
