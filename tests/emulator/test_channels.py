import pytest
from hypothesis import given
from hypothesis import strategies as st

from trex_gui.emulator.channels import Channels, ChannelSetup, Signal, SignalKind, motor_values
from trex_gui.protocol.calibration import DEFAULT_CALIBRATION
from trex_gui.protocol.flags import CHANNELS, InputSource

RC, ANALOG = InputSource.RC, InputSource.ANALOG
SETUP = ChannelSetup((DEFAULT_CALIBRATION[RC],) * 5)
values = st.integers(-127, 127)


@pytest.mark.parametrize(
    ("text", "source", "raw"),
    [
        ("1500us", RC, 3750),
        ("1500 µs", RC, 3750),
        ("3637", RC, 3637),
        ("500us", RC, 1250),
        ("2500us", RC, 6250),
        ("499us", RC, None),
        ("2501us", RC, None),
        ("invalid", RC, None),
        ("2.5V", RC, None),
        ("2.5V", ANALOG, 512),
        ("2500mv", ANALOG, 512),
        ("0", ANALOG, 0),
        ("1023", ANALOG, 1023),
        ("5V", ANALOG, 1023),
        ("invalid", ANALOG, 0),
        ("1500us", ANALOG, 77),
        ("rest", RC, 3750),
        ("rest", ANALOG, 512),
    ],
)
def test_what_is_connected_is_measured(text: str, source: InputSource, raw: int | None) -> None:
    channels = Channels(source)
    channels.connect(2, Signal.parse(text, source))
    assert channels.raw[1] == raw


@pytest.mark.parametrize(
    "text", ["", "stick", "5.01V", "-1us", "20000us", "nan", "inf", "1e3", "1500 ms", "2.5.5V"]
)
def test_what_no_input_can_carry_is_refused(text: str) -> None:
    with pytest.raises(ValueError, match=r".+"):
        Signal.parse(text, RC)


@given(counts=st.integers(1250, 6250))
def test_raw_counts_of_pulses_come_back(counts: int) -> None:
    assert Signal.from_counts(counts, RC).measured(RC) == counts


@given(counts=st.integers(0, 1023))
def test_raw_counts_of_voltages_come_back(counts: int) -> None:
    assert Signal.from_counts(counts, ANALOG).measured(ANALOG) == counts


def test_a_silent_channel_keeps_its_value_for_a_tenth_of_a_second() -> None:
    channels = Channels(RC)
    channels.connect(1, Signal.pulses(1200))
    channels.connect(1, Signal(SignalKind.SILENCE))
    channels.advance(0.09)
    assert channels.raw[:1] == (3000,)
    channels.advance(0.02)
    assert channels.raw[:1] == (None,)
    assert channels.silent_for(1) == pytest.approx(0.11)
    channels.connect(1, Signal.pulses(1500))
    assert channels.raw[:1] == (3750,)
    assert channels.silent_for(1) == 0


def test_a_bad_pulse_shows_at_once() -> None:
    channels = Channels(RC)
    channels.connect(4, Signal(SignalKind.BAD_PULSES))
    assert channels.raw == (3750, 3750, 3750, None, 3750)


def test_a_reversed_channel_changes_its_sign_and_an_ignored_one_rests() -> None:
    raw = [4500] * 5
    plain = SETUP.remapped(raw)[0]
    masked = ChannelSetup(SETUP.calibrations, reversed_=0b00010, ignored=0b00100)
    assert masked.remapped(raw) == (plain, -plain, 0, plain, plain)


def test_a_parabolic_channel_is_gentler() -> None:
    raw = [4362] * 5
    gentle = ChannelSetup(SETUP.calibrations, parabolic=0b00001).remapped(raw)
    assert 0 < gentle[0] < gentle[1]


@pytest.mark.parametrize(
    ("raw", "active"), [(None, False), (3750, False), (3126, False), (3124, True), (2500, True)]
)
def test_a_switch_is_active_below_the_middle_of_its_lower_half(
    raw: int | None, active: bool
) -> None:
    assert SETUP.is_switched(5, raw) is active


def test_a_switch_that_is_ignored_or_reversed_obeys_that() -> None:
    assert not ChannelSetup(SETUP.calibrations, ignored=0x10).is_switched(5, 2500)
    turned = ChannelSetup(SETUP.calibrations, reversed_=0x08)
    assert turned.is_switched(4, 5000)
    assert not turned.is_switched(4, 2500)


def test_without_jumper_and_switch_each_channel_has_its_motor() -> None:
    assert motor_values((10, -20), mix=False, flip=False, joint=False) == (10, -20)


def test_mixing_adds_the_turn_to_one_motor_and_takes_it_from_the_other() -> None:
    assert motor_values((30, 100), mix=True, flip=False, joint=False) == (127, 70)
    assert motor_values((127, -127), mix=True, flip=False, joint=False) == (0, -127)


def test_flip_exchanges_and_turns_the_motors() -> None:
    assert motor_values((10, -20), mix=False, flip=True, joint=False) == (20, -10)
    assert motor_values((30, 50), mix=True, flip=True, joint=False) == (-20, -80)


def test_joint_mode_does_not_mix() -> None:
    assert motor_values((10, 50), mix=True, flip=False, joint=True) == (10, 50)
    assert motor_values((10, 50), mix=True, flip=True, joint=True) == (-10, 50)


@given(first=values, second=values, mix=st.booleans(), flip=st.booleans(), joint=st.booleans())
def test_no_motor_is_asked_for_more_than_it_has(
    first: int, second: int, mix: bool, flip: bool, joint: bool
) -> None:
    asked = motor_values((first, second), mix=mix, flip=flip, joint=joint)
    assert all(abs(value) <= 127 for value in asked)


@given(raw=st.lists(st.none() | st.integers(0, 0xFFFE), min_size=5, max_size=5))
def test_whatever_is_measured_is_remapped(raw: list[int | None]) -> None:
    remapped = SETUP.remapped(raw)
    assert len(remapped) == len(CHANNELS)
    assert all(-127 <= value <= 127 for value in remapped)
