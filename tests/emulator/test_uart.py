"""Bytes in and out, as the documents print them."""

from collections.abc import Iterator

import pytest
from hypothesis import given
from hypothesis import strategies as st

from trex_gui.emulator.channels import Signal
from trex_gui.emulator.eeprom import Eeprom
from trex_gui.emulator.firmware import Board
from trex_gui.emulator.motors import Direction
from trex_gui.emulator.uart import RECEIVE_BUFFER, Reply, SerialPort, remainder
from trex_gui.protocol.calibration import Calibration
from trex_gui.protocol.flags import InputSource, UartError

FORWARD, REVERSE, BRAKE = Direction.FORWARD, Direction.REVERSE, Direction.BRAKE

NO_REPLY = ""


def replies(port: SerialPort, packet: bytes) -> Iterator[Reply]:
    for byte in packet:
        reply = port.feed(byte)
        if reply is not None:
            yield reply


def ask(port: SerialPort, packet: str) -> str:
    """Send one packet and return what is answered, waiting for a write."""
    answers = list(replies(port, bytes.fromhex(packet)))
    for answer in answers:
        port.board.advance(answer.delay)
        assert port.resume() is None
    return b"".join(answer.data for answer in answers).hex(" ").upper()


def errors(port: SerialPort) -> UartError:
    return port.board.serial.take_uart_errors()


@pytest.fixture
def crc_port() -> SerialPort:
    eeprom = Eeprom()
    eeprom.write("uart_settings", 0x25)
    return SerialPort(Board(eeprom=eeprom))


class TestChecksum:
    @pytest.mark.parametrize(
        ("packet", "crc"),
        [
            ("86 1F", 0x07),
            ("81", 0x48),
            ("F0 7F", 0x4D),
            ("AF 00 07 55 2A", 0x47),
            ("80 07 06 1F", 0x0B),
        ],
    )
    def test_known_packets(self, packet: str, crc: int) -> None:
        assert remainder(bytes.fromhex(packet), 0x89) == crc

    @given(data=st.binary(max_size=30), polynomial=st.integers(0x80, 0xFF))
    def test_it_has_seven_bits_and_divides_the_packet(self, data: bytes, polynomial: int) -> None:
        crc = remainder(data, polynomial)
        assert 0 <= crc <= 0x7F
        whole = int.from_bytes(data) << 7 | crc
        while (excess := whole.bit_length() - 8) >= 0:
            whole ^= polynomial << excess
        assert whole == 0

    def test_requests_and_answers_carry_it(self, crc_port: SerialPort) -> None:
        assert ask(crc_port, "81 48") == "54 52 65 58 31 2E 32 32"
        assert ask(crc_port, "82 53") == "72 5D"
        assert not errors(crc_port)

    def test_expanded_packets_are_covered_from_their_first_byte(self, crc_port: SerialPort) -> None:
        assert len(ask(crc_port, "80 07 06 1F 0B").split()) == 11

    def test_a_wrong_one_discards_the_packet(self, crc_port: SerialPort) -> None:
        assert ask(crc_port, "F0 7F 4C") == NO_REPLY
        assert crc_port.board.aux.speed == 0
        assert errors(crc_port) == UartError.CRC
        ask(crc_port, "F0 7F 4D")
        assert crc_port.board.aux.speed == 127

    def test_another_polynomial_is_another_checksum(self) -> None:
        eeprom = Eeprom()
        eeprom.write("uart_settings", 0x25)
        eeprom.write("crc7_polynomial", 0x15)
        port = SerialPort(Board(eeprom=eeprom))
        ask(port, "F0 7F 4D")
        assert errors(port) == UartError.CRC
        packet = bytes.fromhex("F0 7F")
        ask(port, (packet + bytes([remainder(packet, 0x95)])).hex())
        assert port.board.aux.speed == 127

    def test_the_null_command_has_none(self, crc_port: SerialPort) -> None:
        assert ask(crc_port, "FF") == NO_REPLY
        assert not errors(crc_port)


class TestQueries:
    @pytest.mark.parametrize(
        ("model", "firmware", "signature"),
        [("trex", "1.0", b"TReX1.0"), ("trex", "1.2", b"TReX1.2"), ("trexjr", "1.2", b"TReXJr1.2")],
    )
    def test_the_signature(self, model: str, firmware: str, signature: bytes) -> None:
        port = SerialPort(Board(model, firmware))
        assert port.feed(0x81) == Reply(signature)

    def test_raw_channels_as_the_documentation_shows_them(self, port: SerialPort) -> None:
        for channel, text in ((1, "3637"), (2, "invalid"), (5, "2715")):
            port.board.connect(channel, Signal.parse(text, InputSource.RC))
        # The documentation reads 9B 0A as 2716; it is 2715.
        assert ask(port, "86 13") == "35 0E FF FF 9B 0A"

    def test_both_protocols_say_the_same(self, port: SerialPort) -> None:
        assert ask(port, "80 07 06 1F") == ask(port, "86 1F") != NO_REPLY

    def test_remapped_channels_have_a_sign_bit(self, port: SerialPort) -> None:
        for channel, text in ((1, "2500us"), (2, "500us"), (3, "1550us")):
            port.board.connect(channel, Signal.parse(text, InputSource.RC))
        assert ask(port, "87 1F") == "7F FF 05 00 00"
        assert ask(port, "87 02") == "FF"

    @pytest.mark.parametrize("command", ["86 00", "87 00"])
    def test_no_channel_is_no_answer(
        self, port: SerialPort, crc_port: SerialPort, command: str
    ) -> None:
        assert ask(port, command) == NO_REPLY
        crc = remainder(bytes.fromhex(command), 0x89)
        assert ask(crc_port, f"{command} {crc:02X}") == NO_REPLY
        assert not errors(port) | errors(crc_port)

    def test_the_mode_and_who_controls(self, port: SerialPort) -> None:
        assert (ask(port, "82"), ask(port, "83")) == ("72", "01")
        rc = SerialPort(Board(mode="rc"))
        assert (ask(rc, "82"), ask(rc, "83")) == ("52", "00")
        assert ask(SerialPort(Board(mode="analog")), "82") == "41"

    def test_status_and_errors_clear_when_read(self, port: SerialPort) -> None:
        port.board.set_fault(1, fault=True)
        port.board.set_fault(1, fault=False)
        port.feed_error(UartError.FRAMING)
        assert (ask(port, "84"), ask(port, "84")) == ("11", "00")
        assert (ask(port, "85"), ask(port, "85")) == ("10", "00")

    def test_currents_in_counts(self, port: SerialPort) -> None:
        port.board.force_current(1, 8.25)
        port.board.force_current(2, 30.0)
        assert (ask(port, "8D"), ask(port, "8E"), ask(port, "8F")) == ("37", "C8", "37 C8")

    def test_calibrations_are_plain_words(self, port: SerialPort) -> None:
        assert ask(port, "90") == ask(port, "94") == "C4 09 A6 0E 88 13 4B 00"
        port.board.eeprom.write_calibration(InputSource.RC, 2, Calibration(2600, 3660, 4700, 300))
        assert ask(port, "91") == "28 0A 4C 0E 5C 12 2C 01"
        assert ask(port, "95") == "02"

    def test_every_parameter_can_be_asked_for(self, port: SerialPort) -> None:
        for spec in port.board.memory.parameters.readable:
            assert ask(port, f"9F {spec.number:02X}") == f"{spec.default:02X}"


class TestWrites:
    def test_a_parameter_is_answered_when_it_is_stored(self, port: SerialPort) -> None:
        (reply,) = replies(port, bytes.fromhex("AF 07 0F 55 2A"))
        assert reply.data == b"\x00"
        assert reply.delay == pytest.approx(0.004)
        assert port.board.memory.get(0x07) == 0
        port.board.advance(reply.delay)
        assert port.board.memory.get(0x07) == 15

    def test_a_calibration_value_comes_in_two_times_seven_bits(self, port: SerialPort) -> None:
        packet = bytes.fromhex("A1 28 14 4C 1C 5C 24 2C 02 55 2A")
        (reply,) = replies(port, packet)
        assert reply.delay == pytest.approx(0.032)
        port.board.advance(reply.delay)
        assert port.board.calibration(2) == Calibration(2600, 3660, 4700, 300)

    @pytest.mark.parametrize(
        ("packet", "code"),
        [
            ("AF 18 00 55 2A", "01"),
            ("AF 08 02 55 2A", "02"),
            ("AF 7F 00 55 2A", "02"),
            ("A0 01 00 01 00 01 00 00 00 55 2A", "02"),
        ],
    )
    def test_a_refusal_comes_at_once(self, port: SerialPort, packet: str, code: str) -> None:
        assert port.board.now == 0
        assert ask(port, packet) == code
        assert port.board.now == 0

    @pytest.mark.parametrize("packet", ["AF 07 0F 55 2A", "A0 00 00 01 00 02 00 00 00 55 2A"])
    def test_outside_serial_mode_they_are_refused(self, packet: str) -> None:
        assert ask(SerialPort(Board(mode="rc")), packet) == "03"

    @pytest.mark.parametrize(
        "packet",
        [
            "AF 07 0F 55 2B",
            "AF 07 0F 2A 55",
            "A0 00 00 01 00 02 00 00 00 55 00",
        ],
    )
    def test_wrong_format_bytes_get_no_answer(self, port: SerialPort, packet: str) -> None:
        assert ask(port, packet) == NO_REPLY
        assert errors(port) == UartError.FORMAT
        assert port.board.memory.get(0x07) == 0

    def test_a_new_device_number_counts_at_once(self, port: SerialPort) -> None:
        assert ask(port, "AF 00 09 55 2A") == "00"
        assert ask(port, "80 07 02") == NO_REPLY
        assert ask(port, "80 09 02") == "72"

    def test_the_response_delay_holds_every_answer_back(self, port: SerialPort) -> None:
        ask(port, "AF 17 01 55 2A")
        reply = port.feed(0x82)
        assert reply is not None
        assert reply.delay == pytest.approx(0.001)

    def test_what_comes_while_it_writes_waits(self, port: SerialPort) -> None:
        (reply,) = replies(port, bytes.fromhex("AF 07 0F 55 2A 9F 07 82"))
        port.board.advance(reply.delay)
        assert port.resume() == Reply(b"\x0f")
        assert port.resume() == Reply(b"r")
        assert port.resume() is None
        assert port.feed(0x82) == Reply(b"r")

    def test_more_than_the_buffer_holds_is_an_overrun(self, port: SerialPort) -> None:
        list(replies(port, bytes.fromhex("AF 07 0F 55 2A")))
        assert list(replies(port, b"\xff" * RECEIVE_BUFFER)) == []
        assert not errors(port)
        port.feed(0x82)
        assert errors(port) == UartError.READ_OVERRUN
        port.board.advance(0.004)
        assert port.resume() is None


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
    def test_one_motor(
        self,
        port: SerialPort,
        packet: str,
        number: int,
        direction: Direction,
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
    def test_both_motors(
        self, port: SerialPort, command: int, immediate: bool, first: int, second: int
    ) -> None:
        ask(port, bytes([command | second << 2 | first, 11, 22]).hex())
        motors = port.board.motors
        wanted = [Direction.from_bits(first), Direction.from_bits(second)]
        assert [motor.target_direction for motor in motors] == wanted
        assert [motor.target_speed for motor in motors] == [11, 22]
        assert ([motor.speed for motor in motors] == [11, 22]) == immediate

    @pytest.mark.parametrize("packet", ["F0 7F", "80 07 70 7F"])
    def test_the_auxiliary_motor_goes_to_full_speed(self, port: SerialPort, packet: str) -> None:
        assert ask(port, packet) == NO_REPLY
        assert port.board.aux.speed == 127

    def test_the_auxiliary_motor_accelerates(self, port: SerialPort) -> None:
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
    def test_a_command_that_does_not_exist(self, port: SerialPort, command: int) -> None:
        assert ask(port, f"{command:02X}") == NO_REPLY
        assert errors(port) == UartError.FORMAT
        assert ask(port, f"80 07 {command & 0x7F:02X}") == NO_REPLY
        assert errors(port) == UartError.FORMAT

    def test_a_command_byte_inside_a_packet_begins_a_new_one(self, port: SerialPort) -> None:
        assert ask(port, "C2 82") == "72"
        assert errors(port) == UartError.FORMAT
        assert port.board.motors[0].speed == 127  # shut down: full brake
        assert port.board.motors[0].direction is BRAKE

    def test_a_data_byte_without_a_packet(self, port: SerialPort) -> None:
        assert ask(port, "12") == NO_REPLY
        assert errors(port) == UartError.FORMAT

    @pytest.mark.parametrize("packet", ["86 20", "87 7F", "9F 18", "9F 7F"])
    def test_an_illogical_data_byte(self, port: SerialPort, packet: str) -> None:
        assert ask(port, packet) == NO_REPLY
        assert errors(port) == UartError.FORMAT

    @pytest.mark.parametrize("packet", ["FF", "FF FF FF", "80 07 7F"])
    def test_the_null_command_does_nothing(self, port: SerialPort, packet: str) -> None:
        assert ask(port, packet) == NO_REPLY
        assert not errors(port)

    def test_packets_for_others_are_passed_over_in_silence(self, port: SerialPort) -> None:
        assert ask(port, "80 08 06 1F 80 01 2F 7B 01 55 2A 80 03 04 02 01 40") == NO_REPLY
        assert not errors(port)
        assert ask(port, "82") == "72"
        assert not errors(port)
        assert port.board.show()["counters"]["packets_for_others"] == 3

    def test_a_bad_byte_loses_its_packet(self, port: SerialPort) -> None:
        port.feed(0xF0)
        port.feed_error(UartError.PARITY)
        assert errors(port) == UartError.PARITY
        assert port.feed(0x7F) is None
        assert errors(port) == UartError.FORMAT
        assert port.board.aux.speed == 0

    def test_a_board_without_power_hears_nothing(self, port: SerialPort) -> None:
        port.board.power_off()
        assert ask(port, "81") == NO_REPLY
        port.feed_error(UartError.FRAMING)
        port.board.power_on()
        assert not errors(port)

    def test_a_power_cycle_forgets_half_a_packet(self, port: SerialPort) -> None:
        port.feed(0xF0)
        port.board.power_cycle()
        port.feed(0x7F)
        assert port.board.aux.speed == 0
        assert errors(port) == UartError.FORMAT


class TestJunk:
    @given(junk=st.binary(max_size=200), settings=st.sampled_from([0x05, 0x25]))
    def test_after_any_junk_a_good_packet_is_answered(self, junk: bytes, settings: int) -> None:
        eeprom = Eeprom()
        eeprom.write("uart_settings", settings)
        port = SerialPort(Board(eeprom=eeprom))
        for reply in replies(port, junk):
            port.board.advance(reply.delay)
            again = port.resume()
            while again is not None:
                port.board.advance(again.delay)
                again = port.resume()
        port.feed(0xFF)
        good = "81" if settings == 0x05 else "81 48"
        answer = bytes.fromhex(ask(port, good))
        assert answer[:7] == b"TReX1.2"

    @given(junk=st.binary(max_size=300), mode=st.sampled_from(["serial", "rc", "analog"]))
    def test_whatever_comes_the_board_stays_sane(self, junk: bytes, mode: str) -> None:
        board = Board(mode=mode)
        port = SerialPort(board)
        for byte in junk:
            port.feed(byte)
            board.advance(0.0005)
            port.resume()
        shown = board.show()
        assert all(0 <= motor["speed"] <= 127 for motor in shown["motors"])
        if mode != "serial":
            assert shown["parameters"] == Board().show()["parameters"]
