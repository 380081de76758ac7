"""Calibrations on the wire, and what remapping makes of raw counts."""

import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from tests.support.matrix import examples
from trex_gui.core.errors import BadRequest
from trex_gui.devices.trex.protocol.calibration import (
    DEFAULT_CALIBRATION,
    Calibration,
    CalibrationKey,
    encode_14_bits,
    remap,
)
from trex_gui.devices.trex.protocol.commands import GetRawChannels
from trex_gui.devices.trex.protocol.flags import InputSource

modest = examples(50)
TYPICAL = Calibration(2500, 3750, 5000, 75)

coded = st.integers(0, 0x3FFF)
any_calibration = st.builds(Calibration, coded, coded, coded, coded)
raw_counts = st.integers(0, 0xFFFF)


@st.composite
def calibrations(draw: st.DrawFn) -> Calibration:
    """Calibrations that the board takes, often with a deadband that leaves something."""
    minimum, neutral, maximum = sorted((draw(coded), draw(coded), draw(coded)))
    assume(minimum < maximum)
    return Calibration(minimum, neutral, maximum, draw(st.integers(0, 200) | coded))


@pytest.mark.parametrize(
    ("value", "data"),
    [
        (0, "00 00"),
        (127, "7f 00"),
        (128, "00 01"),
        (512, "00 04"),
        (1023, "7f 07"),
        (3750, "26 1d"),
        (16383, "7f 7f"),
    ],
)
def test_14_bit_value_is_sent_low_seven_bits_first(value: int, data: str) -> None:
    assert encode_14_bits(value) == bytes.fromhex(data)


def test_14_bit_values_round_trip() -> None:
    assert all(
        Calibration.from_data(4 * encode_14_bits(value)).neutral == value for value in range(16384)
    )


@pytest.mark.parametrize("value", [-1, 16384, 65535])
def test_value_beyond_14_bits_is_rejected_with_limits(value: int) -> None:
    with pytest.raises(BadRequest, match=f"0 to 16383, not {value}"):
        encode_14_bits(value)


def test_wire_order_is_minimum_neutral_maximum_deadband() -> None:
    assert Calibration(1, 2, 3, 4).encode() == bytes.fromhex("01 00 02 00 03 00 04 00")


def test_reply_is_decoded_low_byte_first() -> None:
    reply = bytes.fromhex("c4 09 a6 0e 88 13 4b 00")
    assert Calibration.from_reply(reply) == TYPICAL


@modest
@given(calibration=any_calibration | calibrations())
def test_only_unordered_calibrations_are_rejected(calibration: Calibration) -> None:
    allowed = (
        calibration.minimum <= calibration.neutral
        and calibration.neutral <= calibration.maximum
        and calibration.minimum < calibration.maximum
    )
    assert (calibration.problem() is None) is allowed
    if allowed:
        assert len(calibration.encode()) == 8
    else:
        with pytest.raises(BadRequest, match="calibration: "):
            calibration.encode()


@pytest.mark.parametrize(
    ("calibration", "sentence"),
    [
        (Calibration(4000, 3750, 5000, 75), "minimum 4000 is above neutral 3750"),
        (Calibration(2500, 5001, 5000, 75), "neutral 5001 is above maximum 5000"),
        (Calibration(3750, 3750, 3750, 75), "minimum and maximum are both 3750"),
        (Calibration(-1, 3750, 5000, 75), "minimum is -1; .*0 to 16383"),
        (Calibration(2500, 3750, 16384, 75), "maximum is 16384; .*0 to 16383"),
        (Calibration(2500, 3750, 5000, 16384), "deadband is 16384; .*0 to 16383"),
        (Calibration(2500, 3750, 5000, -1), "deadband is -1; .*0 to 16383"),
    ],
)
def test_rejected_calibration_names_the_problem(calibration: Calibration, sentence: str) -> None:
    with pytest.raises(BadRequest, match=sentence):
        calibration.encode()


@pytest.mark.parametrize(
    "calibration",
    [
        Calibration(2500, 2500, 5000, 75),
        Calibration(2500, 5000, 5000, 75),
        Calibration(0, 0, 1, 0),
        Calibration(0, 0, 16383, 16383),
    ],
)
def test_neutral_may_equal_minimum_or_maximum(calibration: Calibration) -> None:
    assert calibration.problem() is None


def test_default_rc_calibration_spans_1_to_2_ms() -> None:
    assert DEFAULT_CALIBRATION[InputSource.RC] == Calibration(2500, 3750, 5000, 75)


def test_default_analog_calibration_spans_0_to_5_v() -> None:
    assert DEFAULT_CALIBRATION[InputSource.ANALOG] == Calibration(0, 512, 1023, 20)


@pytest.mark.parametrize(
    ("raw", "output"),
    [
        (3750, 0),
        (3825, 0),
        (3675, 0),
        (3826, 0),  # 127 * 1 / 1175 rounded down
        (3835, 1),  # 127 * 10 / 1175 = 1.08
        (4413, 63),  # 127 * 588 / 1175 = 63.55
        (4999, 126),
        (5000, 127),
        (6250, 127),
        (3087, -63),
        (2501, -126),
        (2500, -127),
        (1250, -127),
    ],
)
def test_typical_channel_is_remapped_linearly(raw: int, output: int) -> None:
    assert remap(raw, TYPICAL) == output


@pytest.mark.parametrize(
    ("raw", "output"), [(3825, 0), (4413, 31), (4999, 126), (5000, 127), (3087, -31)]
)
def test_parabolic_channel_is_remapped_quadratically(raw: int, output: int) -> None:
    assert remap(raw, TYPICAL, parabolic=True) == output


def test_side_narrower_than_deadband_jumps_from_0_to_full() -> None:
    narrow = Calibration(1000, 2000, 2050, 100)
    assert [remap(raw, narrow) for raw in (2050, 2100, 2101)] == [0, 0, 127]


def test_ignored_channel_gives_0() -> None:
    assert remap(5000, TYPICAL, ignored=True) == 0


def test_channel_without_signal_gives_0() -> None:
    assert remap(None, TYPICAL) == 0


def test_invalid_pulse_reported_by_board_gives_0() -> None:
    raw = GetRawChannels(0x01).parse(bytes.fromhex("ff ff"))[1]
    assert remap(raw, TYPICAL) == 0


@modest
@given(
    raw=st.none() | raw_counts | st.integers(),
    calibration=any_calibration,
    parabolic=st.booleans(),
    reversed_=st.booleans(),
    ignored=st.booleans(),
)
def test_remapped_output_never_exceeds_127(
    raw: int | None, calibration: Calibration, parabolic: bool, reversed_: bool, ignored: bool
) -> None:
    output = remap(raw, calibration, parabolic=parabolic, reversed_=reversed_, ignored=ignored)
    assert -127 <= output <= 127


@modest
@given(
    calibration=calibrations(),
    # 0xFFFF is no count: it says that there is none.
    counts=st.lists(raw_counts.filter(lambda count: count != 0xFFFF), min_size=2, max_size=8),
    parabolic=st.booleans(),
)
def test_higher_count_never_gives_lower_output(
    calibration: Calibration, counts: list[int], parabolic: bool
) -> None:
    outputs = [remap(raw, calibration, parabolic=parabolic) for raw in sorted(counts)]
    assert outputs == sorted(outputs)


@modest
@given(calibration=calibrations(), beyond=st.integers(0, 5000), parabolic=st.booleans())
def test_output_is_full_at_maximum_and_above(
    calibration: Calibration, beyond: int, parabolic: bool
) -> None:
    raw = calibration.maximum + beyond
    assume(raw - calibration.neutral > calibration.deadband)
    assert remap(raw, calibration, parabolic=parabolic) == 127


@modest
@given(calibration=calibrations(), beyond=st.integers(0, 5000), parabolic=st.booleans())
def test_output_is_full_reverse_at_minimum_and_below(
    calibration: Calibration, beyond: int, parabolic: bool
) -> None:
    raw = calibration.minimum - beyond
    assume(calibration.neutral - raw > calibration.deadband)
    assert remap(raw, calibration, parabolic=parabolic) == -127


@modest
@given(calibration=calibrations(), part=st.floats(-1, 1), parabolic=st.booleans())
def test_output_is_0_within_deadband(
    calibration: Calibration, part: float, parabolic: bool
) -> None:
    raw = calibration.neutral + int(part * calibration.deadband)
    assert remap(raw, calibration, parabolic=parabolic) == 0


@modest
@given(raw=raw_counts, calibration=any_calibration | calibrations(), parabolic=st.booleans())
def test_reversed_channel_gives_negated_output(
    raw: int, calibration: Calibration, parabolic: bool
) -> None:
    ahead = remap(raw, calibration, parabolic=parabolic)
    assert remap(raw, calibration, parabolic=parabolic, reversed_=True) == -ahead


@modest
@given(raw=raw_counts, calibration=any_calibration | calibrations())
def test_parabolic_output_never_exceeds_linear_output(raw: int, calibration: Calibration) -> None:
    linear, parabolic = remap(raw, calibration), remap(raw, calibration, parabolic=True)
    assert abs(parabolic) <= abs(linear)
    assert linear * parabolic >= 0


@pytest.mark.parametrize("key", CalibrationKey)
def test_calibration_key_is_made_of_source_and_channel(key: CalibrationKey) -> None:
    assert CalibrationKey.of(key.source, key.channel) is key
    assert key.label.lower().replace(" ", "_") == key


def test_calibration_key_of_unknown_channel_is_rejected() -> None:
    with pytest.raises(ValueError, match="rc_channel_6"):
        CalibrationKey.of(InputSource.RC, 6)
