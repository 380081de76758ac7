"""Calibrations on the wire, and remapping of raw counts."""

import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from tests.devices.trex.oracle import remapping as oracle
from tests.support.matrix import examples
from trex_gui.core.errors import BadRequest
from trex_gui.devices.trex.protocol.calibration import (
    CALIBRATION_FIELDS,
    DEFAULT_CALIBRATION,
    Calibration,
    CalibrationKey,
    encode_14_bits,
    remap,
)
from trex_gui.devices.trex.protocol.flags import InputSource

few_examples = examples(50)
TYPICAL = Calibration(2500, 3750, 5000, 75)

fourteen_bits = st.integers(0, 0x3FFF)
any_calibration = st.builds(Calibration, fourteen_bits, fourteen_bits, fourteen_bits, fourteen_bits)


@st.composite
def calibrations(draw: st.DrawFn) -> Calibration:
    """Return a calibration that the board accepts, often with a small deadband."""
    minimum, neutral, maximum = sorted(
        (draw(fourteen_bits), draw(fourteen_bits), draw(fourteen_bits))
    )
    assume(minimum < maximum)
    return Calibration(minimum, neutral, maximum, draw(st.integers(0, 200) | fourteen_bits))


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


def test_wire_order_is_minimum_neutral_maximum_deadband() -> None:
    assert Calibration(1, 2, 3, 4).encode() == bytes.fromhex("01 00 02 00 03 00 04 00")


@few_examples
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


@pytest.mark.parametrize(
    ("raw", "output", "parabolic"),
    [
        (3825, 0, 0),
        (3826, 0, 0),  # 127 * 1 / 1175 rounded down
        (3835, 1, 0),  # 127 * 10 / 1175 = 1.08
        (4413, 63, 31),  # 127 * 588 / 1175 = 63.55
        (4999, 126, 126),
        (5000, 127, 127),
        (3087, -63, -31),
        (2500, -127, -127),
    ],
)
def test_channel_is_remapped_linearly_or_quadratically(
    raw: int, output: int, parabolic: int
) -> None:
    assert (remap(raw, TYPICAL), remap(raw, TYPICAL, parabolic=True)) == (output, parabolic)


@few_examples
@given(
    calibration=any_calibration | calibrations(),
    raw=st.sampled_from([None, oracle.INVALID]) | st.integers(0, oracle.INVALID),
    field=st.sampled_from(CALIBRATION_FIELDS),
    offset=st.none() | st.integers(-1, 1),
    parabolic=st.booleans(),
    reversed_=st.booleans(),
    ignored=st.booleans(),
)
def test_remapping_matches_oracle_everywhere_and_at_corners(
    calibration: Calibration,
    raw: int | None,
    field: str,
    offset: int | None,
    parabolic: bool,
    reversed_: bool,
    ignored: bool,
) -> None:
    if offset is not None:
        corner = getattr(calibration, field) + calibration.neutral * (field == "deadband")
        raw = max(0, corner + offset)
    values = oracle.Calibration(*(getattr(calibration, name) for name in CALIBRATION_FIELDS))
    assert remap(
        raw, calibration, parabolic=parabolic, reversed_=reversed_, ignored=ignored
    ) == oracle.remapped(
        oracle.INVALID if raw is None else raw,
        values,
        parabolic=parabolic,
        reverse=reversed_,
        ignored=ignored,
    )


@pytest.mark.parametrize("key", CalibrationKey)
def test_calibration_key_consists_of_source_and_channel(key: CalibrationKey) -> None:
    assert CalibrationKey.of(key.source, key.channel) is key
    assert key.label.lower().replace(" ", "_") == key


def test_calibration_key_of_unknown_channel_is_rejected() -> None:
    with pytest.raises(ValueError, match="rc_channel_6"):
        CalibrationKey.of(InputSource.RC, 6)


def test_factory_calibrations_match_documentation() -> None:
    assert {
        InputSource.RC: Calibration(2500, 3750, 5000, 75),
        InputSource.ANALOG: Calibration(0, 512, 1023, 20),
    } == DEFAULT_CALIBRATION
