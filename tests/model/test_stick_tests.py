"""What the test of the sticks says about the inputs of a board, with what the board stores."""

import sys
from collections.abc import Callable, Iterator

import pytest
from pytestqt.qtbot import QtBot

from tests.support.simulator import SimulatedDevice
from trex_gui.learning.proof import StickTest, idle_side
from trex_gui.link.settings import LinkSettings
from trex_gui.model.device import Device, Link
from trex_gui.model.stick_tests import StickTests
from trex_gui.protocol.calibration import Calibration, remap

if sys.platform == "win32":
    pytest.skip("has no pseudo-terminals", allow_module_level=True)

THROTTLE = Calibration(minimum=2600, neutral=2750, maximum=4730, deadband=75)
"""Learned from a stick that rests at 1100 µs; below that is trim only."""

REST = {1: 1500.0, 2: 1500.0, 3: 1500.0, 4: 1500.0, 5: 1900.0}


class Sticks:
    """Holds inputs in µs; `None` is no signal."""

    def __init__(self, device: Device, *numbers: int) -> None:
        self.tests = StickTests(device, numbers)
        self._seconds = 0.0
        self._held: dict[int, float | None] = dict(REST)

    def hold(self, channel: int | None = None, where: float | None = 1500.0) -> None:
        """Hold a channel somewhere for 0.6 s, or only wait; the others stay where they are."""
        if channel is not None:
            self._held[channel] = where
        counts = [None if us is None else round(us * 2.5) for us in self._held.values()]
        for _ in range(30):
            self._seconds += 0.02
            self.tests.feed(self._seconds, counts)

    def push(self, channel: int) -> None:
        """Push a stick to both ends, then let go."""
        for where in (2000.0, 1000.0, REST[channel]):
            self.hold(channel, where)

    def passed(self) -> bool:
        return self.tests.passed

    def to_learn_again(self) -> tuple[int, ...]:
        return self.tests.to_learn_again

    def text(self, channel: int) -> str:
        return next(tested.text for tested in self.tests.tested if tested.channel == channel)


@pytest.fixture
def connect(qtbot: QtBot, quick_simulator: SimulatedDevice) -> Iterator[Callable[..., Device]]:
    device = Device()

    def connect(*lines: str) -> Device:
        for line in lines:
            quick_simulator.do(line)
        if lines:
            quick_simulator.do("power cycle")
        device.connect_to(LinkSettings(quick_simulator.url))
        qtbot.waitUntil(lambda: device.link is Link.UP, timeout=30_000)
        return device

    yield connect
    qtbot.waitUntil(device.shut_down)


@pytest.fixture
def sticks(connect: Callable[..., Device]) -> Callable[..., Sticks]:
    return lambda *numbers: Sticks(connect(), *numbers)


# --- A throttle -------------------------------------------------------------------------


@pytest.mark.parametrize("reversed_", [False, True])
def test_the_side_to_which_a_throttle_is_only_trimmed_is_idle(reversed_: bool) -> None:
    trimmed = remap(2600, THROTTLE, reversed_=reversed_)
    assert idle_side(THROTTLE, reversed_=reversed_) == (1 if trimmed > 0 else -1)


def test_full_output_of_a_throttle_counts_on_the_side_that_it_travels() -> None:
    test = StickTest(3)
    idle = idle_side(THROTTLE, reversed_=False)
    for step, microseconds in enumerate([1040] * 30 + [1100] * 40):
        test.feed(step / 50, remap(round(2.5 * microseconds), THROTTLE), idle=idle)
    assert not test.tested.reverse
    assert not test.tested.passed
    assert test.tested.text == "Full output not reached yet. Push it all the way."
    for step, microseconds in enumerate([1895] * 30 + [1100] * 40):
        test.feed(2 + step / 50, remap(round(2.5 * microseconds), THROTTLE), idle=idle)
    assert test.tested.forward
    assert test.tested.passed


def test_a_throttle_with_its_rest_in_the_middle_may_go_either_way() -> None:
    even = Calibration(2500, 3750, 5000, 75)
    assert idle_side(even, reversed_=True) == 0
    test = StickTest(3)
    for step, count in enumerate([2500] * 5 + [3750] * 40):
        test.feed(step / 50, remap(count, even), idle=0)
    assert test.tested.passed


def test_both_sides_of_a_stick_count_however_long_they_are() -> None:
    test = StickTest(1)
    for step, count in enumerate([2600] * 5 + [4730] * 5 + [2750] * 40):
        test.feed(step / 50, remap(count, THROTTLE), idle=-1)
    assert test.tested.passed


# --- Good is what is good now -----------------------------------------------------------


def test_a_channel_that_was_good_and_is_held_away_from_rest_is_not_good(
    sticks: Callable[..., Sticks],
) -> None:
    desk = sticks(1)
    desk.push(1)
    assert desk.text(1) == "Good."
    assert desk.passed()
    desk.hold(1, 1650)
    assert desk.text(1).startswith("Full output reached. Let go: at rest it must give 0")
    assert not desk.passed()
    desk.hold(1, 1500)
    assert desk.passed()


@pytest.mark.parametrize("channel", [1, 4])
def test_a_channel_whose_signal_is_lost_is_not_good_any_more(
    sticks: Callable[..., Sticks], channel: int
) -> None:
    desk = sticks(channel)
    desk.push(channel)
    assert desk.passed()
    desk.hold(channel, None)
    assert desk.text(channel) == "No signal comes in."
    assert not desk.passed()


def test_another_channel_that_holds_the_motors_keeps_the_test_from_passing(
    sticks: Callable[..., Sticks],
) -> None:
    desk = sticks(1)
    desk.hold(2, 1600)
    desk.push(1)
    assert desk.text(1) == "Good."
    assert desk.tests.channels_passed
    assert not desk.passed()
    (reason,) = desk.tests.safe_start_reasons
    assert reason.startswith("channel 2 gives +")
    desk.hold(2, 1500)
    assert desk.passed()


# --- Ignored channels -------------------------------------------------------------------


def test_an_ignored_channel_says_so_and_does_not_count(connect: Callable[..., Device]) -> None:
    desk = Sticks(connect("eeprom ignored_channels 2"), 1, 2)
    desk.hold()
    assert desk.text(2) == "Ignored: the board holds it at neutral. There is nothing to test."
    desk.push(2)
    assert not desk.passed()
    desk.push(1)
    assert desk.passed()
    assert desk.to_learn_again() == ()


def test_where_every_channel_is_ignored_nothing_passes(connect: Callable[..., Device]) -> None:
    desk = Sticks(connect("eeprom ignored_channels 1"), 1)
    desk.push(1)
    assert desk.tests.all_ignored
    assert not desk.passed()


# --- What to learn again ----------------------------------------------------------------


def test_a_channel_that_was_moved_and_is_not_good_is_offered_to_be_learned_again(
    sticks: Callable[..., Sticks],
) -> None:
    desk = sticks(1, 2)
    desk.hold()
    assert desk.to_learn_again() == ()
    desk.hold(2, 1900)
    desk.hold(2, 1500)
    assert desk.to_learn_again() == (2,)
    desk.push(2)
    desk.hold(2, 1700)  # it was good: nothing is wrong with its values
    assert desk.to_learn_again() == ()
