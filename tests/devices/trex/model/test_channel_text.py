"""Texts about a channel."""

from typing import Any

import pytest

from trex_gui.core.errors import NoReply
from trex_gui.devices.trex.calibration.channel_curve import ChannelCurve
from trex_gui.devices.trex.model.channel_text import (
    calibration_warning,
    function_text,
    source_instructions,
    unreachable_warning,
    write_failure,
    wrong_order,
)
from trex_gui.devices.trex.protocol.calibration import Calibration
from trex_gui.devices.trex.protocol.errors import Rejected, ResultCode
from trex_gui.devices.trex.protocol.flags import InputSource, Mode

CALIBRATION = Calibration(2500, 3750, 5000, 75)


@pytest.mark.parametrize(
    ("channel", "mode", "state", "words"),
    [
        (1, Mode.RC, {}, "Channel 1 drives motor 1, or steers when the mix jumper is on."),
        (3, Mode.RC, {}, "auxiliary"),
        (1, Mode.RC, {"mixed": True}, "steers with both motors (the mix jumper is on)"),
        (1, Mode.RC, {"mixed": False}, "drives motor 1 (the mix jumper is off)"),
        (2, Mode.RC, {"mixed": True}, "forward and back (the mix jumper is on)"),
        (2, Mode.RC, {"mixed": False}, "motor 2 (the mix jumper is off)"),
        (3, Mode.RC, {"mixed": True}, "Channel 3 drives the auxiliary motor"),
        (2, Mode.SERIAL_RC, {"mixed": False}, "In RC and analog mode"),
        (1, Mode.ANALOG, {"joint": True, "mixed": True}, "both drivers power (joint mode"),
        (2, Mode.RC, {"joint": True}, "has no motor"),
        (4, Mode.RC, {"joint": True}, "flip"),
        (1, Mode.RC, {"ignored": True, "reversed_": True}, "at neutral, whatever its input."),
        (5, Mode.SERIAL_RC, {"ignored": True}, "stays off"),
        (1, Mode.RC, {"reversed_": True}, "; it is reversed."),
        (4, Mode.RC, {}, "while the input is below about 1250 µs (inferred)"),
        (5, Mode.RC, {"reversed_": True}, "while the input is above about 1750 µs (inferred)"),
    ],
)
def test_function_text_describes_the_channel(
    channel: int, mode: Mode, state: dict[str, Any], words: str
) -> None:
    options = {"joint": False} | {key: state[key] for key in ("joint", "mixed") if key in state}
    curve = ChannelCurve(CALIBRATION, **{key: state[key] for key in state.keys() - options.keys()})
    assert words in function_text(channel, mode, curve, InputSource.RC, **options)


def test_override_is_reported_with_channel_5() -> None:
    texts = [
        function_text(channel, Mode.RC, None, InputSource.RC, joint=False, overridden=True)
        for channel in (1, 2, 3, 4, 5)
    ]
    beginning = "Has no effect now: serial commands override it."
    assert [text.startswith(beginning) for text in texts] == [True] * 3 + [False] * 2
    assert texts[4].startswith("On now. It is the override switch")


def test_input_source_instruction_depends_on_the_mode() -> None:
    assert "Channel Input Source" in source_instructions(InputSource.ANALOG, Mode.SERIAL_RC)
    assert "mode jumper to analog" in source_instructions(InputSource.ANALOG, Mode.RC)
    assert "mode jumper to RC" in source_instructions(InputSource.RC, Mode.ANALOG)


def test_result_codes_of_the_board_are_explained() -> None:
    value = write_failure(Rejected("Calibration of channel 2", ResultCode.BAD_VALUE))
    assert "code 2" in value
    assert "minimum is not above neutral" in value
    mode = write_failure(Rejected("Calibration of channel 2", ResultCode.NOT_SERIAL_MODE))
    assert "code 3" in mode
    assert "mode jumper" in mode
    assert write_failure(NoReply("no reply")) == "no reply."


def test_wrong_calibration_order_is_described_in_units() -> None:
    rc = InputSource.RC
    assert wrong_order(CALIBRATION, rc) == ""
    assert "minimum 1600 µs" in wrong_order(Calibration(4000, 3750, 5000, 75), rc)
    assert "maximum 1200 µs" in wrong_order(Calibration(2500, 3750, 3000, 75), rc)
    assert "both 2.50 V" in wrong_order(Calibration(512, 512, 512, 0), InputSource.ANALOG)


def test_calibration_within_the_input_range_causes_no_warning() -> None:
    assert calibration_warning(CALIBRATION, InputSource.RC) == ""
    assert calibration_warning(Calibration(1250, 3750, 6250, 75), InputSource.RC) == ""
    assert calibration_warning(Calibration(0, 512, 1023, 20), InputSource.ANALOG) == ""


def test_deadband_that_reaches_an_end_causes_a_warning() -> None:
    calibration = Calibration(3700, 3750, 5000, 75)
    assert "reaches minimum" in calibration_warning(calibration, InputSource.RC)


@pytest.mark.parametrize(
    ("calibration", "source", "words"),
    [
        (Calibration(2500, 3750, 15000, 75), InputSource.RC, "Maximum (6000 µs) is outside"),
        (Calibration(250, 3750, 5000, 75), InputSource.RC, "Minimum (100 µs) is outside"),
        (Calibration(1249, 3750, 6251, 75), InputSource.RC, "Minimum (499.6 µs) is outside"),
        (Calibration(100, 512, 1100, 20), InputSource.ANALOG, "Maximum (5.376 V) is outside"),
        (Calibration(2500, 7000, 9000, 75), InputSource.RC, "Neutral (2800 µs) is outside"),
    ],
)
def test_calibration_beyond_input_range_causes_a_warning(
    calibration: Calibration, source: InputSource, words: str
) -> None:
    text = calibration_warning(calibration, source)
    assert text.startswith(words)
    assert text == unreachable_warning(calibration, source)
    assert ("Pulses range from 500 µs to 2500 µs." in text) is (source is InputSource.RC)
    assert ("Voltages range from 0.00 V to 5.00 V." in text) is (source is InputSource.ANALOG)
