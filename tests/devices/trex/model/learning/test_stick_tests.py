"""Test of sticks with the stored calibrations."""

from collections.abc import Callable, Iterator

import pytest
from pytestqt.qtbot import QtBot

from tests.support.simulator import SimulatedDevice
from trex_gui.devices.trex.calibration.channel_curve import ChannelCurve
from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.model.learning.stick_tests import StickTest, StickTests, idle_side
from trex_gui.devices.trex.protocol.calibration import FULL_SCALE, Calibration
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.ui.devices.connection import ConnectionState

THROTTLE = Calibration(minimum=2600, neutral=2750, maximum=4730, deadband=75)
"""Learned from a stick that rests at 1100 µs; below that is trim only."""

CENTRE = 3750
EXACT = ChannelCurve(Calibration(CENTRE - FULL_SCALE, CENTRE, CENTRE + FULL_SCALE, 0))
"""A count more is one more at the output."""

REST = {1: 1500.0, 2: 1500.0, 3: 1500.0, 4: 1500.0, 5: 1900.0}


class Sticks:
    """Inputs in µs. `None` is no signal."""

    def __init__(self, device: Device, *numbers: int) -> None:
        self.tests = StickTests(device, numbers)
        self._seconds = 0.0
        self._held: dict[int, float | None] = dict(REST)

    def hold(self, channel: int | None = None, where: float | None = 1500.0) -> None:
        """Hold a channel at a position for 0.6 s, or only wait."""
        if channel is not None:
            self._held[channel] = where
        counts = [None if us is None else round(us * 2.5) for us in self._held.values()]
        for _ in range(30):
            self._seconds += 0.02
            self.tests.feed(self._seconds, counts)

    def push(self, channel: int) -> None:
        """Push a stick to both ends, then release it."""
        for where in (2000.0, 1000.0, REST[channel]):
            self.hold(channel, where)

    def passed(self) -> bool:
        return self.tests.passed

    def text(self, channel: int) -> str:
        return next(test.text for test in self.tests.tests if test.number == channel)


@pytest.fixture
def connect(qtbot: QtBot, quick_simulator: SimulatedDevice) -> Iterator[Callable[..., Device]]:
    device = Device()

    def connect(*lines: str) -> Device:
        for line in lines:
            quick_simulator.do(line)
        if lines:
            quick_simulator.do("power cycle")
        device.connect_to(ConnectionSettings(quick_simulator.url))
        qtbot.waitUntil(lambda: device.link is ConnectionState.CONNECTED)
        return device

    yield connect
    qtbot.waitUntil(device.shut_down)


@pytest.fixture
def sticks(connect: Callable[..., Device]) -> Callable[..., Sticks]:
    return lambda *numbers: Sticks(connect(), *numbers)


# --- A throttle -------------------------------------------------------------------------


def test_throttle_passes_with_full_output_on_its_travel_side() -> None:
    test = StickTest(3)
    for step, microseconds in enumerate([1040] * 30 + [1100] * 40):
        test.feed(step / 50, round(2.5 * microseconds), ChannelCurve(THROTTLE))
    assert not test.reverse
    assert not test.passed
    assert test.text == "Full output not reached yet. Push the stick all the way."
    for step, microseconds in enumerate([1895] * 30 + [1100] * 40):
        test.feed(2 + step / 50, round(2.5 * microseconds), ChannelCurve(THROTTLE))
    assert test.forward
    assert test.passed


def test_centered_throttle_passes_on_either_side() -> None:
    even = ChannelCurve(Calibration(2500, 3750, 5000, 75))
    assert idle_side(even) == 0
    test = StickTest(3)
    for step, count in enumerate([2500] * 5 + [3750] * 40):
        test.feed(step / 50, count, even)
    assert test.passed


def test_uneven_stick_passes_with_both_ends() -> None:
    test = StickTest(1)
    for step, count in enumerate([2600] * 5 + [4730] * 5 + [2750] * 40):
        test.feed(step / 50, count, ChannelCurve(THROTTLE))
    assert test.passed


# --- Present state ----------------------------------------------------------------------


def test_passed_channel_held_off_neutral_fails_until_released(
    sticks: Callable[..., Sticks],
) -> None:
    inputs = sticks(1)
    inputs.push(1)
    assert inputs.text(1) == "Good."
    assert inputs.passed()
    inputs.hold(1, 1650)
    assert inputs.text(1).startswith(
        "Full output reached. Release the stick: at rest the output must"
    )
    assert not inputs.passed()
    inputs.hold(1, 1500)
    assert inputs.passed()


@pytest.mark.parametrize("channel", [1, 4])
def test_passed_channel_fails_when_its_signal_is_lost(
    sticks: Callable[..., Sticks], channel: int
) -> None:
    inputs = sticks(channel)
    inputs.push(channel)
    assert inputs.passed()
    inputs.hold(channel, None)
    assert inputs.text(channel) == "No signal."
    assert not inputs.passed()


def test_safe_start_of_another_channel_blocks_passing(
    sticks: Callable[..., Sticks],
) -> None:
    inputs = sticks(1)
    inputs.hold(2, 1600)
    inputs.push(1)
    assert inputs.text(1) == "Good."
    assert inputs.tests.channels_passed
    assert not inputs.passed()
    assert inputs.tests.safe_start_reasons == "Channel 2 is 100 µs above neutral."
    inputs.hold(2, 1500)
    assert inputs.passed()


# --- Ignored channels -------------------------------------------------------------------


def test_ignored_channel_is_named_and_not_counted(connect: Callable[..., Device]) -> None:
    inputs = Sticks(connect("eeprom ignored_channels 2"), 1, 2)
    inputs.hold()
    assert inputs.text(2).startswith("Ignored: the board holds this channel at neutral.")
    inputs.push(2)
    assert not inputs.passed()
    inputs.push(1)
    assert inputs.passed()


def test_stick_test_of_only_ignored_channels_never_passes(connect: Callable[..., Device]) -> None:
    inputs = Sticks(connect("eeprom ignored_channels 1"), 1)
    inputs.push(1)
    assert inputs.tests.all_ignored
    assert not inputs.passed()


def test_single_wild_pulses_are_no_position_of_the_switch() -> None:
    test = StickTest(5)
    for number in range(60):
        test.feed(number * 0.02, CENTRE - (FULL_SCALE if number % 10 == 9 else 0), EXACT)
    assert (test.off, test.on) == (True, False)
    for number in range(60, 63):
        test.feed(number * 0.02, CENTRE - FULL_SCALE, EXACT)
    assert test.on
    assert test.passed


# --- One channel ------------------------------------------------------------------------


def stick_held_at(*phases: tuple[int, int]) -> StickTest:
    """Feed outputs of channel 1 in phases, at 50 samples a second."""
    test = StickTest(1)
    step = 0
    for output, samples in phases:
        for _ in range(samples):
            test.feed(step / 50, CENTRE + output, EXACT)
            step += 1
    return test


def switch_held_at(*phases: tuple[bool, int]) -> StickTest:
    """Feed positions of a switch in phases, at 50 samples a second."""
    test = StickTest(4)
    for active, samples in phases:
        for _ in range(samples):
            test.feed(0.0, CENTRE + (-FULL_SCALE if active else FULL_SCALE), EXACT)
    return test


def test_result_before_first_sample_reports_no_signal() -> None:
    before = StickTest(4)
    assert not any((before.on, before.off, before.is_at_rest, before.forward, before.reverse))
    assert before.text == "No signal."


# --- Sticks -----------------------------------------------------------------------------


@pytest.mark.parametrize(("output", "end"), [(127, "forward"), (-127, "reverse")])
def test_end_is_reached_when_three_samples_agree(output: int, end: str) -> None:
    passed_by = stick_held_at((output, 2), (0, 1), (output, 2))
    assert not passed_by.forward
    assert not passed_by.reverse
    held = stick_held_at((output, 3))
    assert (held.forward, held.reverse) == (end == "forward", end == "reverse")


def test_stick_result_names_missing_ends() -> None:
    assert stick_held_at((0, 1)).text.endswith(": forward 127, reverse 127.")
    assert stick_held_at((127, 3)).text.endswith(": reverse 127.")
    assert stick_held_at((-127, 3)).text.endswith(": forward 127.")


def test_stick_passes_after_both_ends_and_rest() -> None:
    both = (127, 3), (-127, 3)
    assert stick_held_at(*both, (40, 1)).text.endswith("but it is +40.")
    resting = "Full output reached. Let the stick rest for a moment."
    assert stick_held_at(*both, (0, 5)).text == resting
    at_rest = stick_held_at(*both, (0, 30))
    assert at_rest.passed
    assert at_rest.text == "Good."


# --- Throttles --------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("calibration", "side"),
    [(Calibration(2500, 2750, 4700, 75), -1), (Calibration(2800, 4750, 5000, 75), 1)],
)
def test_throttle_is_idle_on_its_shorter_side(calibration: Calibration, side: int) -> None:
    assert idle_side(ChannelCurve(calibration)) == side
    assert idle_side(ChannelCurve(calibration, reversed_=True)) == -side


# --- Switches ---------------------------------------------------------------------------


def test_switch_passes_after_both_positions_were_held() -> None:
    assert switch_held_at((True, 2)).text == "Move the switch to all its positions."
    for active in (False, True):
        seen = switch_held_at((active, 3))
        assert (seen.on, seen.off) == (active, not active)
        assert seen.text.startswith(f"Only {'on' if active else 'off'} was detected.")
    assert switch_held_at((False, 3), (True, 3)).passed
    assert not switch_held_at((False, 3), (True, 2)).passed
