"""Checksums, queries and writes, as the documents print them."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from tests.devices.trex.simulator.ports import (
    NO_REPLY,
    a_board,
    answer,
    ask,
    errors,
    feed,
    pass_pause,
)
from trex_gui.core.simulator.sampling import ReceiveError
from trex_gui.devices.trex.protocol.calibration import Calibration
from trex_gui.devices.trex.protocol.flags import InputSource, UartError
from trex_gui.devices.trex.simulator.channels import Signal
from trex_gui.devices.trex.simulator.firmware import Board
from trex_gui.devices.trex.simulator.uart import SerialPort, remainder

PULSES = 0.025
"""Seconds in which every input has had its pulse."""


@pytest.fixture
def crc_port() -> SerialPort:
    return SerialPort(a_board(settings=0x25))


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
    def test_checksums_of_known_packets_are_correct(self, packet: str, crc: int) -> None:
        assert remainder(bytes.fromhex(packet), 0x89) == crc

    @given(data=st.binary(max_size=30), polynomial=st.integers(0x80, 0xFF))
    def test_checksum_has_seven_bits_and_divides_packet(self, data: bytes, polynomial: int) -> None:
        crc = remainder(data, polynomial)
        assert 0 <= crc <= 0x7F
        whole = int.from_bytes(data) << 7 | crc
        while (excess := whole.bit_length() - 8) >= 0:
            whole ^= polynomial << excess
        assert whole == 0

    def test_requests_and_replies_carry_checksum(self, crc_port: SerialPort) -> None:
        assert ask(crc_port, "81 48") == "54 52 65 58 31 2E 32 32"
        assert ask(crc_port, "82 53") == "72 5D"
        assert not errors(crc_port)

    def test_checksum_covers_expanded_packet_from_first_byte(self, crc_port: SerialPort) -> None:
        assert len(ask(crc_port, "80 07 06 1F 0B").split()) == 11

    def test_wrong_checksum_discards_packet(self, crc_port: SerialPort) -> None:
        assert ask(crc_port, "F0 7F 4C") == NO_REPLY
        assert crc_port.board.aux.speed == 0
        assert errors(crc_port) == UartError.CRC
        ask(crc_port, "F0 7F 4D")
        assert crc_port.board.aux.speed == 127

    def test_checksum_uses_configured_polynomial(self) -> None:
        port = SerialPort(a_board(settings=0x25, crc7_polynomial=0x15))
        ask(port, "F0 7F 4D")
        assert errors(port) == UartError.CRC
        packet = bytes.fromhex("F0 7F")
        ask(port, (packet + bytes([remainder(packet, 0x95)])).hex())
        assert port.board.aux.speed == 127

    def test_null_command_has_no_checksum(self, crc_port: SerialPort) -> None:
        assert ask(crc_port, "FF") == NO_REPLY
        assert not errors(crc_port)


class TestQueries:
    @pytest.mark.parametrize(
        ("model", "firmware", "signature"),
        [("trex", "1.0", b"TReX1.0"), ("trex", "1.2", b"TReX1.2"), ("trexjr", "1.2", b"TReXJr1.2")],
    )
    def test_signature_names_model_and_firmware(
        self, model: str, firmware: str, signature: bytes
    ) -> None:
        port = SerialPort(Board(model, firmware))
        assert ask(port, "81") == signature.hex(" ").upper()

    def test_raw_channels_match_documented_example(self, port: SerialPort) -> None:
        for channel, text in ((1, "3637"), (2, "invalid"), (5, "2715")):
            port.board.channels.signals[channel] = Signal.parse(text, InputSource.RC)
        assert ask(port, "86 13") == "FF FF FF FF FF FF"
        port.board.advance(PULSES)
        # The documentation reads 9B 0A as 2716; it is 2715.
        assert ask(port, "86 13") == "35 0E FF FF 9B 0A"

    def test_compact_and_expanded_replies_are_equal(self, port: SerialPort) -> None:
        port.board.advance(PULSES)
        assert ask(port, "80 07 06 1F") == ask(port, "86 1F") != NO_REPLY

    def test_remapped_channels_have_a_sign_bit(self, port: SerialPort) -> None:
        for channel, text in ((1, "2500us"), (2, "500us"), (3, "1550us")):
            port.board.channels.signals[channel] = Signal.parse(text, InputSource.RC)
        assert ask(port, "87 1F") == "00 00 00 00 00"
        port.board.advance(PULSES)
        assert ask(port, "87 1F") == "7F FF 05 00 00"
        assert ask(port, "87 02") == "FF"

    @pytest.mark.parametrize("command", ["86 00", "87 00"])
    def test_query_for_no_channel_gets_no_reply(
        self, port: SerialPort, crc_port: SerialPort, command: str
    ) -> None:
        assert ask(port, command) == NO_REPLY
        crc = remainder(bytes.fromhex(command), 0x89)
        assert ask(crc_port, f"{command} {crc:02X}") == NO_REPLY
        assert not errors(port) | errors(crc_port)

    def test_mode_and_control_source_are_reported(self, port: SerialPort) -> None:
        assert (ask(port, "82"), ask(port, "83")) == ("72", "01")
        rc = SerialPort(Board(mode="rc"))
        assert (ask(rc, "82"), ask(rc, "83")) == ("52", "00")
        assert ask(SerialPort(Board(mode="analog")), "82") == "41"

    def test_status_and_errors_clear_when_read(self, port: SerialPort) -> None:
        port.board.set_fault(1, fault=True)
        port.board.set_fault(1, fault=False)
        port.feed_error(ReceiveError.FRAMING)
        assert (ask(port, "84"), ask(port, "84")) == ("11", "00")
        assert (ask(port, "85"), ask(port, "85")) == ("10", "00")

    def test_currents_are_reported_in_counts(self, port: SerialPort) -> None:
        port.board.force_current(1, 8.25)
        port.board.force_current(2, 30.0)
        assert (ask(port, "8D"), ask(port, "8E"), ask(port, "8F")) == ("37", "C8", "37 C8")

    def test_calibrations_are_sent_as_16_bit_words(self, port: SerialPort) -> None:
        assert ask(port, "90") == ask(port, "94") == "C4 09 A6 0E 88 13 4B 00"
        port.board.eeprom.write_calibration(InputSource.RC, 2, Calibration(2600, 3660, 4700, 300))
        assert ask(port, "91") == "28 0A 4C 0E 5C 12 2C 01"
        assert ask(port, "95") == "02"

    def test_every_parameter_can_be_read(self, port: SerialPort) -> None:
        for spec in port.board.memory.parameters.readable:
            assert ask(port, f"9F {spec.number:02X}") == f"{spec.default:02X}"


class TestWrites:
    def test_parameter_write_is_acknowledged_when_stored(self, port: SerialPort) -> None:
        feed(port, "AF 07 0F 55 2A")
        assert port.pause == pytest.approx(0.004)
        assert answer(port) == NO_REPLY
        port.board.advance(0.0039)
        assert port.board.memory.get(0x07) == 0
        port.board.advance(0.0001)
        assert port.board.memory.get(0x07) == 15
        port.resume()
        assert answer(port) == "00"

    def test_calibration_value_is_received_as_two_7_bit_bytes(self, port: SerialPort) -> None:
        feed(port, "A1 28 14 4C 1C 5C 24 2C 02 55 2A")
        assert port.pause == pytest.approx(0.032)
        pass_pause(port)
        assert answer(port) == "00"
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
    def test_rejection_is_sent_at_once(self, port: SerialPort, packet: str, code: str) -> None:
        assert port.board.now == 0
        assert ask(port, packet) == code
        assert port.board.now == 0

    @pytest.mark.parametrize("packet", ["AF 07 0F 55 2A", "A0 00 00 01 00 02 00 00 00 55 2A"])
    def test_writes_are_rejected_outside_serial_mode(self, packet: str) -> None:
        assert ask(SerialPort(Board(mode="rc")), packet) == "03"

    @pytest.mark.parametrize(
        "packet",
        [
            "AF 07 0F 55 2B",
            "AF 07 0F 2A 55",
            "A0 00 00 01 00 02 00 00 00 55 00",
        ],
    )
    def test_wrong_format_bytes_get_no_reply(self, port: SerialPort, packet: str) -> None:
        assert ask(port, packet) == NO_REPLY
        assert errors(port) == UartError.FORMAT
        assert port.board.memory.get(0x07) == 0

    def test_new_device_number_takes_effect_at_once(self, port: SerialPort) -> None:
        assert ask(port, "AF 00 09 55 2A") == "00"
        assert ask(port, "80 07 02") == NO_REPLY
        assert ask(port, "80 09 02") == "72"
