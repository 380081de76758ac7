"""Tests of sticks with the stored calibrations."""

from collections.abc import Callable, Iterator

import pytest
from pytestqt.qtbot import QtBot

from tests.devices.trex.model.device_setup import DeviceSetup
from tests.support.simulator import SimulatedDevice
from trex_gui.devices.trex.calibration.channel_curve import ChannelCurve
from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.model.learning.stick_tests import StickTest, StickTests, idle_side
from trex_gui.devices.trex.protocol.calibration import FULL_SCALE, Calibration

THROTTLE = Calibration(minimum=2600, neutral=2750, maximum=4730, deadband=75)
"""Calibration of a stick that rests at 1100 µs. Only the trim gives lower values."""

CENTER = 3750
LINEAR = ChannelCurve(Calibration(CENTER - FULL_SCALE, CENTER, CENTER + FULL_SCALE, 0))
"""Curve whose output is the difference from the centre in counts."""

REST = {1: 1500.0, 2: 1500.0, 3: 1500.0, 4: 1500.0, 5: 1900.0}


class Sticks:
    """Inputs of a stick test, in µs. `None` means no signal."""

    def __init__(self, device: Device, *numbers: int) -> None:
        self.tests = StickTests(device, numbers)
        self._seconds = 0.0
        self._widths: dict[int, float | None] = dict(REST)

    def hold(self, channel: int | None = None, width: float | None = 1500.0) -> None:
        """Hold a channel at a pulse width for 0.6 s. Without a channel, only wait."""
        if channel is not None:
            self._widths[channel] = width
        counts = [None if width is None else round(width * 2.5) for width in self._widths.values()]
        for _ in range(30):
            self._seconds += 0.02
            self.tests.feed(self._seconds, counts)

    def push(self, channel: int) -> None:
        """Push a stick to both ends, then release it."""
        for width in (2000.0, 1000.0, REST[channel]):
            self.hold(channel, width)

    def passed(self) -> bool:
        return self.tests.passed

    def text(self, channel: int) -> str:
        return next(test.text for test in self.tests.tests if test.number == channel)


@pytest.fixture
def connect(qtbot: QtBot, quick_simulator: SimulatedDevice) -> Iterator[Callable[..., Device]]:
    """Return a function that runs control lines and then connects the device."""
    setup = DeviceSetup(qtbot, quick_simulator)

    def connect(*lines: str) -> Device:
        quick_simulator.do(*lines, "power cycle")
        setup.connect()
        return setup.device

    yield connect
    setup.shut_down()


@pytest.fixture
def sticks(connect: Callable[..., Device]) -> Callable[..., Sticks]:
    return lambda *numbers: Sticks(connect(), *numbers)


def stick_test(channel: int, curve: ChannelCurve, *phases: tuple[int, int]) -> StickTest:
    """Return a test of phases (count, number of samples), at 50 samples a second."""
    test = StickTest(channel)
    counts = [count for count, samples in phases for _ in range(samples)]
    for index, count in enumerate(counts):
        test.feed(index / 50, count, curve)
    return test


# --- Throttles --------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("calibration", "side"),
    [(Calibration(2500, 2750, 4700, 75), -1), (Calibration(2800, 4750, 5000, 75), 1)],
)
def test_throttle_is_idle_on_its_shorter_side(calibration: Calibration, side: int) -> None:
    assert idle_side(ChannelCurve(calibration)) == side
    assert idle_side(ChannelCurve(calibration, reversed_=True)) == -side


def test_throttle_passes_with_full_output_on_its_travel_side() -> None:
    trimmed = (2600, 30), (2750, 40)
    test = stick_test(3, ChannelCurve(THROTTLE), *trimmed)
    assert not test.reverse
    assert not test.passed
    assert test.text == "Full output not reached yet. Push the stick all the way."
    test = stick_test(3, ChannelCurve(THROTTLE), *trimmed, (4738, 30), (2750, 40))
    assert test.forward
    assert test.passed


def test_centered_throttle_passes_on_either_side() -> None:
    symmetric = ChannelCurve(Calibration(2500, 3750, 5000, 75))
    assert idle_side(symmetric) == 0
    assert stick_test(3, symmetric, (2500, 5), (3750, 40)).passed


def test_asymmetric_stick_passes_with_both_ends() -> None:
    assert stick_test(1, ChannelCurve(THROTTLE), (2600, 5), (4730, 5), (2750, 40)).passed


# --- Current state ----------------------------------------------------------------------


def test_passed_channel_fails_while_held_off_neutral(sticks: Callable[..., Sticks]) -> None:
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


def test_safe_start_of_another_channel_prevents_passing(sticks: Callable[..., Sticks]) -> None:
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


def test_ignored_channel_is_named_and_need_not_pass(connect: Callable[..., Device]) -> None:
    inputs = Sticks(connect("eeprom ignored_channels 2"), 1, 2)
    inputs.hold()
    assert (
        inputs.text(2)
        == "Ignored: the board holds this channel at neutral. There is nothing to test."
    )
    inputs.push(2)
    assert not inputs.passed()
    inputs.push(1)
    assert inputs.passed()


def test_stick_test_of_only_ignored_channels_never_passes(connect: Callable[..., Device]) -> None:
    inputs = Sticks(connect("eeprom ignored_channels 1"), 1)
    inputs.push(1)
    assert inputs.tests.all_ignored
    assert not inputs.passed()


def test_stick_test_without_samples_reports_no_signal() -> None:
    test = StickTest(4)
    assert not any((test.on, test.off, test.is_at_rest, test.forward, test.reverse))
    assert test.text == "No signal."


# --- Sticks -----------------------------------------------------------------------------


def stick_held_at(*phases: tuple[int, int]) -> StickTest:
    """Return a test of phases (output of channel 1, number of samples)."""
    return stick_test(1, LINEAR, *((CENTER + output, samples) for output, samples in phases))


@pytest.mark.parametrize(("output", "end"), [(127, "forward"), (-127, "reverse")])
def test_end_is_reached_when_three_samples_agree(output: int, end: str) -> None:
    moved = stick_held_at((output, 2), (0, 1), (output, 2))
    assert not moved.forward
    assert not moved.reverse
    held = stick_held_at((output, 3))
    assert (held.forward, held.reverse) == (end == "forward", end == "reverse")


def test_stick_result_names_missing_ends() -> None:
    assert stick_held_at((0, 1)).text.endswith(": forward 127, reverse 127.")
    assert stick_held_at((127, 3)).text.endswith(": reverse 127.")
    assert stick_held_at((-127, 3)).text.endswith(": forward 127.")


def test_stick_passes_after_both_ends_and_rest() -> None:
    both = (127, 3), (-127, 3)
    assert stick_held_at(*both, (40, 1)).text.endswith("but it is +40.")
    assert (
        stick_held_at(*both, (0, 5)).text == "Full output reached. Let the stick rest for a moment."
    )
    at_rest = stick_held_at(*both, (0, 30))
    assert at_rest.passed
    assert at_rest.text == "Good."


# --- Switches ---------------------------------------------------------------------------


def switch_held_at(*phases: tuple[bool, int]) -> StickTest:
    """Return a test of phases (position of channel 4 is active, number of samples)."""
    counts = {True: CENTER - FULL_SCALE, False: CENTER + FULL_SCALE}
    return stick_test(4, LINEAR, *((counts[active], samples) for active, samples in phases))


def test_single_outliers_do_not_operate_the_switch() -> None:
    pulses = ((CENTER, 9), (CENTER - FULL_SCALE, 1)) * 6
    test = stick_test(5, LINEAR, *pulses)
    assert (test.off, test.on) == (True, False)
    test = stick_test(5, LINEAR, *pulses, (CENTER - FULL_SCALE, 3))
    assert test.on
    assert test.passed


def test_switch_passes_after_both_positions_were_held() -> None:
    assert switch_held_at((True, 2)).text == "Move the switch to all its positions."
    for active in (False, True):
        test = switch_held_at((active, 3))
        assert (test.on, test.off) == (active, not active)
        assert test.text.startswith(f"Only {'on' if active else 'off'} was detected.")
    assert switch_held_at((False, 3), (True, 3)).passed
    assert not switch_held_at((False, 3), (True, 2)).passed
