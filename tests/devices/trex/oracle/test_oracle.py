"""The oracle against every example that the documents give, and the rules that have none."""

import pytest

from tests.devices.trex.oracle.device import Oracle, Status, table
from tests.devices.trex.oracle.framing import UartError, remainder
from tests.devices.trex.oracle.remapping import (
    RC_DEFAULT,
    Calibration,
    coded,
    motors,
    remapped,
    switched_on,
)

CRC_ON = {"uart_settings": 0x25}


def ask(oracle: Oracle, stream: str) -> str:
    """Everything that the board answers to this, both as the guide prints bytes."""
    return b"".join(oracle.feed(byte) for byte in bytes.fromhex(stream)).hex(" ")


def with_crc(packet: str, polynomial: int = 0x89) -> str:
    return f"{packet} {remainder(bytes.fromhex(packet), polynomial):02x}"


@pytest.mark.parametrize(
    ("packet", "crc"),
    [
        ("86 1f", 0x07),
        ("81", 0x48),
        ("f0 7f", 0x4D),
        ("af 00 07 55 2a", 0x47),
        ("80 07 06 1f", 0x0B),
    ],
)
def test_printed_packets_have_their_printed_crc(packet: str, crc: int) -> None:
    assert remainder(bytes.fromhex(packet), 0x89) == crc


def test_packet_with_crc_divides_without_remainder() -> None:
    for polynomial in range(0x80, 0x100):
        packet = bytes.fromhex("86 1f")
        whole = int.from_bytes(packet) << 7 | remainder(packet, polynomial)
        for shift in range(whole.bit_length() - 8, -1, -1):
            if whole >> (shift + 7) & 1:
                whole ^= polynomial << shift
        assert whole == 0


@pytest.mark.parametrize(
    ("model", "firmware", "signature"),
    [
        ("trex", "1.0", "54 52 65 58 31 2e 30"),
        ("trexjr", "1.2", "54 52 65 58 4a 72 31 2e 32"),
    ],
)
@pytest.mark.parametrize("packet", ["81", "80 07 01"])
def test_signature_matches_model_and_firmware(
    model: str, firmware: str, signature: str, packet: str
) -> None:
    assert ask(Oracle(model, firmware), packet) == signature


@pytest.mark.parametrize(
    ("mode", "source", "letter"),
    [
        ("rc", 0, "R"),
        ("rc", 1, "R"),
        ("analog", 0, "A"),
        ("analog", 1, "A"),
        ("serial", 0, "r"),
        ("serial", 1, "a"),
    ],
)
def test_mode_letter_matches_jumper_and_input_source(mode: str, source: int, letter: str) -> None:
    oracle = Oracle(mode=mode, parameters={"channel_input_source": source})
    assert bytes.fromhex(ask(oracle, "82")) == letter.encode()


def test_printed_channel_values_are_reproduced() -> None:
    # The guide prints 2716 beside these bytes; 0x0A9B is 2715.
    oracle = Oracle(raw=(3637, None, 3750, 3750, 2715))
    assert ask(oracle, "86 13") == "35 0e ff ff 9b 0a"
    assert ask(oracle, "80 07 06 13") == "35 0e ff ff 9b 0a"
    assert not ask(oracle, "86 00")
    assert oracle.uart_errors == 0


def test_mask_beyond_five_channels_is_a_format_error() -> None:
    oracle = Oracle()
    assert not ask(oracle, "86 20 87 3f")
    assert oracle.uart_errors == UartError.FORMAT


class TestErrors:
    def test_errors_are_latched_until_read(self) -> None:
        oracle = Oracle()
        assert ask(oracle, "bb 84 84 85 85") == "01 00 40 00"

    @pytest.mark.parametrize(
        "stream",
        ["88", "8c", "96", "9e", "a5", "ae", "b0", "bf", "f2", "fe", "80 07 00", "86 84", "2a"],
    )
    def test_invalid_stream_is_a_format_error(self, stream: str) -> None:
        oracle = Oracle()
        ask(oracle, stream)
        assert oracle.uart_errors == UartError.FORMAT

    def test_interrupting_byte_starts_new_packet(self) -> None:
        assert ask(Oracle(), "af 00 82 85") == "72 40"

    @pytest.mark.parametrize("stream", ["ff", "ff ff", "80 07 7f", "80 03 06 1f", "80 03 0b 7f 00"])
    def test_null_commands_and_foreign_packets_cause_no_error(self, stream: str) -> None:
        oracle = Oracle()
        assert not ask(oracle, stream)
        assert oracle.uart_errors == 0
        assert oracle.status == 0

    def test_packet_for_other_device_ends_at_next_command(self) -> None:
        oracle = Oracle()
        assert ask(oracle, "80 08 06 82") == "72"
        assert oracle.uart_errors == 0

    def test_silence_causes_serial_timeout_if_enabled(self) -> None:
        oracle = Oracle(parameters={"serial_timeout": 5})
        oracle.pause(10)
        assert oracle.uart_errors == 0  # inferred: nothing has been received yet
        ask(oracle, "82")
        oracle.pause(0.45)
        assert oracle.uart_errors == 0
        oracle.pause(0.1)
        assert oracle.uart_errors == UartError.TIMEOUT
        assert oracle.status == Status.UART_ERROR

    def test_silence_causes_no_timeout_without_serial_control(self) -> None:
        oracle = Oracle(mode="rc", parameters={"serial_timeout": 5})
        ask(oracle, "82")
        oracle.pause(10)
        assert oracle.uart_errors == 0


class TestCrc:
    def test_crc_follows_packets_and_replies(self) -> None:
        assert ask(Oracle(parameters=CRC_ON), with_crc("82")) == with_crc("72")

    def test_wrong_crc_discards_packet(self) -> None:
        oracle = Oracle(parameters=CRC_ON)
        assert not ask(oracle, "82 00")
        assert oracle.uart_errors == UartError.CRC

    def test_crc_is_checked_before_contents(self) -> None:
        oracle = Oracle(parameters=CRC_ON)
        assert not ask(oracle, "86 7f 00")
        assert oracle.uart_errors == UartError.CRC

    def test_crc_covers_device_number(self) -> None:
        oracle = Oracle(parameters=CRC_ON)
        assert ask(oracle, "80 07 06 1f 0b")
        assert oracle.uart_errors == 0

    def test_command_byte_instead_of_crc_interrupts_packet(self) -> None:
        oracle = Oracle(parameters=CRC_ON)
        assert ask(oracle, f"82 {with_crc('82')}") == with_crc("72")
        assert oracle.uart_errors == UartError.FORMAT

    def test_crc_uses_configured_polynomial(self) -> None:
        oracle = Oracle(parameters=CRC_ON | {"crc7_polynomial": 0x65})
        assert ask(oracle, with_crc("82", 0xE5)) == with_crc("72", 0xE5)

    def test_null_command_has_no_crc(self) -> None:
        oracle = Oracle(parameters=CRC_ON)
        assert ask(oracle, f"ff {with_crc('82')}") == with_crc("72")
        assert oracle.uart_errors == 0

    @pytest.mark.parametrize("settings", [0x05, 0x45, 0x65])
    def test_crc_is_off_with_parity_or_no_detection(self, settings: int) -> None:
        assert ask(Oracle(parameters={"uart_settings": settings}), "82") == "72"

    def test_crc_takes_effect_at_next_power_cycle(self) -> None:
        oracle = Oracle()
        assert ask(oracle, "af 7e 25 55 2a 82 9f 7e") == "00 72 25"
        oracle.power_cycle()
        assert ask(oracle, with_crc("82")) == with_crc("72")


class TestParameters:
    @pytest.mark.parametrize(
        ("packet", "reply"),
        [
            ("af 07 05 55 2a", "00"),
            ("80 07 2f 7b 01 55 2a", "00"),
            ("af 18 00 55 2a", "01"),
            ("af 7a 00 55 2a", "01"),
            ("af 7b 02 55 2a", "02"),
            ("af 7e 0b 55 2a", "02"),
            ("af 7e 7a 55 2a", "00"),
            ("af 7e 7b 55 2a", "02"),
            ("af 7f 7e 55 2a", "02"),
            ("af 7f 7f 55 2a", "00"),
            ("af 07 05 55 2b", ""),
            ("af 18 00 2a 55", ""),
        ],
    )
    def test_parameter_write_returns_expected_result_code(self, packet: str, reply: str) -> None:
        oracle = Oracle()
        assert ask(oracle, packet) == reply
        assert oracle.uart_errors == (0 if reply else UartError.FORMAT)

    @pytest.mark.parametrize("packet", ["af 07 05 55 2a", "af 18 00 55 2a", "af 7b 02 55 2a"])
    def test_parameters_are_writable_only_in_serial_mode(self, packet: str) -> None:
        assert ask(Oracle(mode="rc"), packet) == "03"

    def test_pending_parameters_read_back_before_taking_effect(self) -> None:
        oracle = Oracle()
        assert ask(oracle, "af 7c 01 55 2a 9f 7c 82 af 02 1f 55 2a 9f 02") == "00 01 72 00 1f"
        oracle.power_cycle()
        assert ask(oracle, "9f 7c 82 9f 02") == "01 61 1f"

    def test_device_number_takes_effect_at_once(self) -> None:
        oracle = Oracle()
        assert ask(oracle, "af 00 09 55 2a 80 07 02 80 09 02") == "00 72"

    @pytest.mark.parametrize(("firmware", "reply"), [("1.0", "01"), ("1.1", "01"), ("1.2", "00")])
    def test_response_delay_exists_since_firmware_1_2(self, firmware: str, reply: str) -> None:
        oracle = Oracle(firmware=firmware)
        assert ask(oracle, "af 17 01 55 2a") == reply
        assert ask(oracle, "9f 17") == ("01" if reply == "00" else "")

    @pytest.mark.parametrize("number", [0x18, 0x7A, 0x7F])
    def test_unknown_parameters_cannot_be_read(self, number: int) -> None:
        oracle = Oracle()
        assert not ask(oracle, f"9f {number:02x}")
        assert oracle.uart_errors == UartError.FORMAT

    def test_factory_reset_takes_effect_at_next_power_cycle(self) -> None:
        oracle = Oracle()
        calibrated = "a0 00 00 64 00 48 01 05 00 55 2a"
        assert ask(oracle, f"af 00 09 55 2a {calibrated} af 7f 7f 55 2a 9f 00") == "00 00 00 09"
        oracle.power_cycle()
        assert ask(oracle, "9f 00 90") == "07 00 00 64 00 c8 00 05 00"
        ask(oracle, "af 00 09 55 2a")
        oracle.power_cycle()
        assert ask(oracle, "9f 00") == "09"

    def test_parameters_start_with_their_defaults(self) -> None:
        for model in ("trex", "trexjr"):
            for known in table(model, "1.2").values():
                if known.default is not None:
                    assert ask(Oracle(model), f"9f {known.number:02x}") == f"{known.default:02x}"


class TestCalibration:
    def test_calibration_starts_with_defaults(self) -> None:
        assert ask(Oracle(), "90") == "c4 09 a6 0e 88 13 4b 00"
        assert ask(Oracle(mode="analog"), "94 95") == "00 00 00 02 ff 03 14 00 00"

    def test_calibration_is_written_seven_bits_a_byte(self) -> None:
        oracle = Oracle()
        assert ask(oracle, "a1 48 0f 26 1d 04 2b 4b 00 55 2a") == "00"
        assert ask(oracle, "91 95") == "c8 07 a6 0e 84 15 4b 00 02"

    @pytest.mark.parametrize(
        ("values", "reply"),
        [
            ("01 00 01 00 01 00 00 00", "02"),
            ("02 00 01 00 03 00 00 00", "02"),
            ("01 00 04 00 03 00 00 00", "02"),
            ("01 00 01 00 02 00 7f 7f", "00"),
            ("01 00 02 00 02 00 00 00", "00"),
        ],
    )
    def test_calibration_write_requires_ascending_values(self, values: str, reply: str) -> None:
        assert ask(Oracle(), f"a0 {values} 55 2a") == reply
        assert ask(Oracle(mode="analog"), f"a0 {values} 55 2a") == "03"
        assert not ask(Oracle(), f"a0 {values} 55 2b")

    def test_calibrations_of_both_sources_are_separate(self) -> None:
        oracle = Oracle()
        ask(oracle, "a0 01 00 02 00 03 00 00 00 55 2a af 7c 01 55 2a")
        assert ask(oracle, "95") == "01"
        oracle.power_cycle()
        assert ask(oracle, "95") == "00"


class TestRemap:
    @pytest.mark.parametrize(
        ("raw", "linear", "parabolic"),
        [
            (0xFFFF, 0, 0),
            (0, -127, -127),
            (2500, -127, -127),
            (2501, -126, -126),
            (3674, 0, 0),
            (3675, 0, 0),
            (3825, 0, 0),
            (4412, 63, 31),
            (4999, 126, 126),
            (5000, 127, 127),
            (6250, 127, 127),
        ],
    )
    def test_remapped_values_match_each_region(self, raw: int, linear: int, parabolic: int) -> None:
        assert remapped(raw, RC_DEFAULT) == linear
        assert remapped(raw, RC_DEFAULT, reverse=True) == -linear
        assert remapped(raw, RC_DEFAULT, parabolic=True) == parabolic
        assert remapped(raw, RC_DEFAULT, ignored=True) == 0

    def test_side_within_deadband_jumps_from_0_to_full(self) -> None:
        calibration = Calibration(1000, 1000, 2000, 1500)
        assert [remapped(raw, calibration) for raw in (0, 999, 1000, 2000, 2500)] == [0] * 5
        assert remapped(2501, calibration) == 127

    def test_sign_is_bit_7(self) -> None:
        assert [coded(value) for value in (127, 1, 0, -1, -127)] == [127, 1, 0, 0x81, 0xFF]

    def test_mixing_and_flipping_set_motor_speeds(self) -> None:
        assert motors(20, 100, mix=False, joint=False, flip=False) == (20, 100)
        assert motors(20, 100, mix=True, joint=False, flip=False) == (120, 80)
        assert motors(100, 100, mix=True, joint=False, flip=False) == (127, 0)
        assert motors(20, 100, mix=False, joint=False, flip=True) == (-100, -20)
        assert motors(20, 100, mix=True, joint=True, flip=True) == (-20, 100)

    @pytest.mark.parametrize(
        ("raw", "plain", "reverse"),
        [(3124, True, False), (3125, False, False), (4375, False, False), (4376, False, True)],
    )
    def test_switch_channels_switch_beyond_half_way(
        self, raw: int, plain: bool, reverse: bool
    ) -> None:
        assert switched_on(raw, RC_DEFAULT) is plain
        assert switched_on(raw, RC_DEFAULT, reverse=True) is reverse
        assert not switched_on(raw, RC_DEFAULT, ignored=True)

    def test_channel_5_gives_control_to_serial(self) -> None:
        rest = (3750,) * 4
        assert ask(Oracle(), "83") == "01"
        assert ask(Oracle(mode="rc", raw=(*rest, 3750)), "83") == "00"
        assert ask(Oracle(mode="rc", raw=(*rest, 2500)), "83") == "01"
        assert ask(Oracle(mode="rc", raw=(*rest, None)), "83") == "00"
