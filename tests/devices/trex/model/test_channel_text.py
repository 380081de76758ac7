"""Sentences about one channel."""

import pytest

from trex_gui.core.errors import NoReply
from trex_gui.devices.trex.model.channel_text import (
    beyond_input,
    concern,
    function_text,
    learned_text,
    source_instructions,
    write_failure,
    wrong_order,
)
from trex_gui.devices.trex.protocol.calibration import Calibration
from trex_gui.devices.trex.protocol.errors import Rejected, ResultCode
from trex_gui.devices.trex.protocol.flags import InputSource, Mode

USUAL = Calibration(2500, 3750, 5000, 75)


def test_rc_mode_text_names_function_of_each_channel() -> None:
    said = [
        function_text(channel, Mode.RC, joint=False, ignored=False) for channel in (1, 2, 3, 4, 5)
    ]
    for words, expected in zip(
        said, ("motor 1", "motor 2", "auxiliary", "flip", "override"), strict=True
    ):
        assert expected in words
    assert "mix jumper" in said[0]


def test_known_mix_jumper_state_is_described() -> None:
    said = {
        (channel, mixed): function_text(channel, Mode.RC, joint=False, ignored=False, mixed=mixed)
        for channel in (1, 2, 3)
        for mixed in (True, False)
    }
    assert said[1, True] == "Channel 1 steers: it moves both motors (the mix jumper is on)."
    assert said[1, False] == "Channel 1 drives motor 1 (the mix jumper is off)."
    assert "forward and back (the mix jumper is on)" in said[2, True]
    assert "motor 2 (the mix jumper is off)" in said[2, False]
    assert said[3, True] == said[3, False]
    assert "joint" in function_text(1, Mode.RC, joint=True, ignored=False, mixed=True)


def test_serial_mode_text_says_channel_does_not_drive() -> None:
    said = function_text(2, Mode.SERIAL_RC, joint=False, ignored=False, mixed=False)
    assert said == (
        "Read only; does not drive. In RC and analog mode it drives motor 2 (the mix jumper is "
        "off)."
    )


def test_override_takes_motors_from_channels_and_names_channel_5() -> None:
    said = [
        function_text(channel, Mode.RC, joint=False, ignored=False, overridden=True)
        for channel in (1, 2, 3, 4, 5)
    ]
    assert [
        text.startswith("Does not drive now: serial commands override it.") for text in said
    ] == [
        *(True, True, True),
        *(False, False),
    ]
    assert said[4].startswith("On now. It is the override switch")


def test_reversed_channel_is_described_as_reversed_unless_it_is_ignored() -> None:
    for ignored in (False, True):
        said = function_text(1, Mode.RC, joint=False, ignored=ignored, is_reversed=True)
        assert ("reversed" in said) is not ignored


def test_joint_mode_text_says_channel_2_has_no_motor() -> None:
    assert "has no motor" in function_text(2, Mode.RC, joint=True, ignored=False)
    assert "both drivers" in function_text(1, Mode.ANALOG, joint=True, ignored=False)
    assert "flip" in function_text(4, Mode.RC, joint=True, ignored=False)


def test_ignored_channel_is_described_as_held() -> None:
    assert "at neutral" in function_text(1, Mode.RC, joint=False, ignored=True)
    assert "held off" in function_text(5, Mode.SERIAL_RC, joint=False, ignored=True)


def test_switch_channel_text_contains_its_threshold() -> None:
    words = function_text(4, Mode.RC, joint=False, ignored=False, switches_at="below 1250 µs")
    assert "while the input is below 1250 µs" in words


def test_input_source_instruction_depends_on_mode() -> None:
    assert "Channel Input Source" in source_instructions(InputSource.ANALOG, Mode.SERIAL_RC)
    assert "mode jumper to analog" in source_instructions(InputSource.ANALOG, Mode.RC)
    assert "mode jumper to RC" in source_instructions(InputSource.RC, Mode.ANALOG)


def test_result_codes_of_board_are_explained() -> None:
    bad = write_failure(Rejected("Calibration of channel 2", ResultCode.BAD_VALUE))
    assert "code 2" in bad
    assert "minimum is not above neutral" in bad
    mode = write_failure(Rejected("Calibration of channel 2", ResultCode.NOT_SERIAL_MODE))
    assert "code 3" in mode
    assert "mode jumper" in mode
    assert write_failure(NoReply("no reply")) == "no reply."


def test_wrong_calibration_order_is_described_in_units() -> None:
    rc = InputSource.RC
    assert wrong_order(USUAL, rc) == ""
    assert "Minimum (1600 µs)" in wrong_order(Calibration(4000, 3750, 5000, 75), rc)
    assert "Maximum (1200 µs)" in wrong_order(Calibration(2500, 3750, 3000, 75), rc)
    assert "both be 2.50 V" in wrong_order(Calibration(512, 512, 512, 0), InputSource.ANALOG)


def test_deadband_reaching_minimum_is_a_concern() -> None:
    assert concern(USUAL, InputSource.RC) == ""
    assert "reaches minimum" in concern(Calibration(3700, 3750, 5000, 75), InputSource.RC)


@pytest.mark.parametrize(
    ("calibration", "source", "words"),
    [
        (Calibration(2500, 3750, 15000, 75), InputSource.RC, "Maximum (6000 µs) is beyond"),
        (Calibration(250, 3750, 5000, 75), InputSource.RC, "Minimum (100 µs) is beyond"),
        (
            Calibration(1249, 3750, 6251, 75),
            InputSource.RC,
            "Minimum (499.6 µs) and maximum (2500.4 µs) are beyond",
        ),
        (Calibration(100, 512, 1100, 20), InputSource.ANALOG, "Maximum (5.376 V) is beyond"),
        (Calibration(2500, 7000, 9000, 75), InputSource.RC, "Neutral (2800 µs) is beyond"),
    ],
)
def test_calibration_beyond_input_range_is_a_concern(
    calibration: Calibration, source: InputSource, words: str
) -> None:
    said = concern(calibration, source)
    assert said.startswith(words)
    assert said == beyond_input(calibration, source)
    assert ("a pulse is 500 µs to 2500 µs" in said) is (source is InputSource.RC)
    assert ("a voltage is 0.00 V to 5.00 V" in said) is (source is InputSource.ANALOG)


def test_ends_of_input_range_are_no_concern() -> None:
    assert concern(Calibration(1250, 3750, 6250, 75), InputSource.RC) == ""
    assert concern(Calibration(0, 512, 1023, 20), InputSource.ANALOG) == ""


def test_learned_text_names_own_or_factory_calibration() -> None:
    assert "of its own" in learned_text(True)
    assert "factory" in learned_text(False)
