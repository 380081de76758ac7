"""Motor commands, packets that break the rules, and junk."""

import pytest

from tests.devices.trex.simulator.ports import NO_REPLY, ask, errors
from trex_gui.core.simulator.sampling import ReceiveError
from trex_gui.devices.trex.protocol.flags import UartError
from trex_gui.devices.trex.simulator.control import report
from trex_gui.devices.trex.simulator.motors import MotorDirection
from trex_gui.devices.trex.simulator.uart import SerialPort

FORWARD, REVERSE, BRAKE = MotorDirection.FORWARD, MotorDirection.REVERSE, MotorDirection.BRAKE


class TestMotorCommands:
    @pytest.mark.parametrize(
        ("packet", "number", "direction", "speed", "immediate"),
        [
            ("C0 40", 1, BRAKE, 0x40, True),
            ("C1 40", 1, REVERSE, 0x40, True),
            ("C2 7F", 1, FORWARD, 0x7F, True),
            ("C3 01", 1, BRAKE, 0x01, True),
            ("C5 40", 1, REVERSE, 0x40, False),
            ("C6 40", 1, FORWARD, 0x40, False),
            ("C9 40", 2, REVERSE, 0x40, True),
            ("CA 40", 2, FORWARD, 0x40, True),
            ("CC 33", 2, BRAKE, 0x33, False),
            ("CE 40", 2, FORWARD, 0x40, False),
        ],
    )
    def test_command_sets_one_motor(
        self,
        port: SerialPort,
        packet: str,
        number: int,
        direction: MotorDirection,
        speed: int,
        immediate: bool,
    ) -> None:
        port.board.advance(0.001)
        assert ask(port, packet) == NO_REPLY
        motor, other = port.board.motors[number - 1], port.board.motors[2 - number]
        assert (motor.target_direction, motor.target_speed) == (direction, speed)
        assert (other.target_direction, other.target_speed) == (BRAKE, 0)
        assert ((motor.direction, motor.speed) == (direction, speed)) == immediate
        port.board.advance(0.01)
        assert (motor.direction, motor.speed) == (direction, speed)

    @pytest.mark.parametrize(("command", "immediate"), [(0xD0, True), (0xE0, False)])
    @pytest.mark.parametrize("first", range(4))
    @pytest.mark.parametrize("second", range(4))
    def test_command_sets_both_motors(
        self, port: SerialPort, command: int, immediate: bool, first: int, second: int
    ) -> None:
        ask(port, bytes([command | second << 2 | first, 11, 22]).hex())
        motors = port.board.motors
        wanted = [MotorDirection.from_bits(first), MotorDirection.from_bits(second)]
        assert [motor.target_direction for motor in motors] == wanted
        assert [motor.target_speed for motor in motors] == [11, 22]
        assert ([motor.speed for motor in motors] == [11, 22]) == immediate

    @pytest.mark.parametrize("packet", ["F0 7F", "80 07 70 7F"])
    def test_auxiliary_motor_command_sets_full_speed(self, port: SerialPort, packet: str) -> None:
        assert ask(port, packet) == NO_REPLY
        assert port.board.aux.speed == 127

    def test_auxiliary_motor_accelerates(self, port: SerialPort) -> None:
        ask(port, "AF 10 0A 55 2A")
        ask(port, "F1 7F")
        port.board.advance(0.1)
        assert 8 <= port.board.aux.speed <= 10


class TestFormat:
    @pytest.mark.parametrize(
        "command",
        sorted(
            {0x88, 0x8C, 0x96, 0x9E, 0xA5, 0xAE, 0xB0, 0xBF, 0xF2, 0xFE},
        ),
    )
    def test_unknown_command_latches_format_error(self, port: SerialPort, command: int) -> None:
        assert ask(port, f"{command:02X}") == NO_REPLY
        assert errors(port) == UartError.FORMAT
        assert ask(port, f"80 07 {command & 0x7F:02X}") == NO_REPLY
        assert errors(port) == UartError.FORMAT

    def test_command_byte_inside_packet_begins_new_packet(self, port: SerialPort) -> None:
        assert ask(port, "C2 82") == "72"
        assert errors(port) == UartError.FORMAT
        assert port.board.motors[0].speed == 127  # shut down: full brake
        assert port.board.motors[0].direction is BRAKE

    def test_data_byte_without_packet_latches_format_error(self, port: SerialPort) -> None:
        assert ask(port, "12") == NO_REPLY
        assert errors(port) == UartError.FORMAT

    @pytest.mark.parametrize("packet", ["86 20", "87 7F", "9F 18", "9F 7F"])
    def test_illogical_data_byte_latches_format_error(self, port: SerialPort, packet: str) -> None:
        assert ask(port, packet) == NO_REPLY
        assert errors(port) == UartError.FORMAT

    @pytest.mark.parametrize("packet", ["FF", "FF FF FF", "80 07 7F"])
    def test_null_command_does_nothing(self, port: SerialPort, packet: str) -> None:
        assert ask(port, packet) == NO_REPLY
        assert not errors(port)

    def test_packets_for_other_boards_are_ignored(self, port: SerialPort) -> None:
        assert ask(port, "80 08 06 1F 80 01 2F 7B 01 55 2A 80 03 04 02 01 40") == NO_REPLY
        assert not errors(port)
        assert ask(port, "82") == "72"
        assert not errors(port)
        assert report(port.board)["counters"]["packets_for_others"] == 3

    def test_bad_byte_discards_its_packet(self, port: SerialPort) -> None:
        port.feed(0xF0)
        port.feed_error(ReceiveError.PARITY)
        assert errors(port) == UartError.PARITY
        assert ask(port, "7F") == NO_REPLY
        assert errors(port) == UartError.FORMAT
        assert port.board.aux.speed == 0

    def test_unpowered_board_ignores_packets(self, port: SerialPort) -> None:
        port.board.power_off()
        assert ask(port, "81") == NO_REPLY
        port.feed_error(ReceiveError.FRAMING)
        port.board.power_on()
        assert not errors(port)

    def test_power_cycle_discards_half_received_packet(self, port: SerialPort) -> None:
        port.feed(0xF0)
        port.board.power_cycle()
        port.feed(0x7F)
        assert port.board.aux.speed == 0
        assert errors(port) == UartError.FORMAT
