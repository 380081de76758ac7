"""Commands 0xA0-0xA4 and 0xAF: what they carry, and what the board answers."""

import pytest

from trex_gui.core.errors import BadReply, BadRequest
from trex_gui.devices.trex.protocol.calibration import Calibration
from trex_gui.devices.trex.protocol.commands import Command, SetCalibration, SetParameter
from trex_gui.devices.trex.protocol.errors import ResultCode

TYPICAL = Calibration(2500, 3750, 5000, 75)
WRITES: list[Command[ResultCode]] = [SetParameter(7, 5), SetCalibration(1, TYPICAL)]


@pytest.mark.parametrize(
    ("code", "meaning"),
    [
        (0, ResultCode.OK),
        (1, ResultCode.BAD_PARAMETER),
        (2, ResultCode.BAD_VALUE),
        (3, ResultCode.NOT_SERIAL_MODE),
    ],
)
def test_parameter_write_reply_is_a_result_code(code: int, meaning: ResultCode) -> None:
    assert SetParameter(7, 5).parse(bytes([code])) is meaning


@pytest.mark.parametrize(
    ("code", "meaning"),
    [(0, ResultCode.OK), (2, ResultCode.BAD_VALUE), (3, ResultCode.NOT_SERIAL_MODE)],
)
def test_calibration_write_reply_is_a_result_code(code: int, meaning: ResultCode) -> None:
    assert SetCalibration(1, TYPICAL).parse(bytes([code])) is meaning


@pytest.mark.parametrize("command", WRITES)
@pytest.mark.parametrize("code", [4, 0x55, 0xFF])
def test_unknown_result_code_is_rejected(command: Command[ResultCode], code: int) -> None:
    with pytest.raises(BadReply, match="not a TReX result code"):
        command.parse(bytes([code]))


def test_parameter_write_may_take_50_ms() -> None:
    assert SetParameter(7, 5).seconds_to_answer == pytest.approx(0.05)


def test_calibration_write_may_take_100_ms() -> None:
    assert SetCalibration(1, TYPICAL).seconds_to_answer == pytest.approx(0.1)


@pytest.mark.parametrize(
    ("command", "sentence"),
    [
        (SetParameter(128, 0), "parameter number is 0 to 127, not 128"),
        (SetParameter(-1, 0), "parameter number is 0 to 127, not -1"),
        (SetParameter(0, 128), "parameter value is 0 to 127, not 128"),
        (SetParameter(0, -1), "parameter value is 0 to 127, not -1"),
    ],
)
def test_invalid_data_byte_is_rejected_by_name(command: SetParameter, sentence: str) -> None:
    with pytest.raises(BadRequest, match=sentence):
        command.data()


@pytest.mark.parametrize("channel", [-1, 0, 6])
def test_channel_number_beyond_1_to_5_is_rejected(channel: int) -> None:
    with pytest.raises(BadRequest, match=f"channels are numbered 1 to 5, not {channel}"):
        _ = SetCalibration(channel, TYPICAL).opcode


@pytest.mark.parametrize("ending", ["2A 55", "55 55", "2A 2A", "00 00"])
def test_wrong_format_bytes_are_rejected(ending: str) -> None:
    with pytest.raises(BadRequest, match=f"ends in 55 2A, not {ending}$"):
        SetParameter.from_packet(0xAF, bytes.fromhex("07 05" + ending))
