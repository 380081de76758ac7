"""What the test of the sticks sees of one channel, and why safe-start would hold the motors."""

import pytest

from trex_gui.devices.trex.model.learning.stick_tests import (
    StickTest,
    idle_side,
)
from trex_gui.devices.trex.protocol.calibration import FULL_SCALE, Calibration


def stick_held_at(*phases: tuple[int, int]) -> StickTest:
    """Feed channel 1 an output for so many samples, phase by phase, 50 samples a second."""
    test = StickTest(1)
    step = 0
    for output, samples in phases:
        for _ in range(samples):
            test.feed(step / 50, output)
            step += 1
    return test


def switch_held_at(*phases: tuple[bool, int]) -> StickTest:
    """Feed a switch that is active or not for so many samples, phase by phase."""
    test = StickTest(4)
    for active, samples in phases:
        for _ in range(samples):
            test.feed(0.0, FULL_SCALE, switched=active)
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
    assert stick_held_at((0, 1)).text.endswith(": forward (+127) and reverse (−127).")
    assert stick_held_at((127, 3)).text.endswith(": reverse (−127).")
    assert stick_held_at((-127, 3)).text.endswith(": forward (+127).")


def test_stick_passes_after_both_ends_and_rest() -> None:
    both = (127, 3), (-127, 3)
    assert stick_held_at(*both, (40, 1)).text.endswith("but it is +40.")
    assert stick_held_at(*both, (0, 5)).text == "Full output reached. Let it rest for a moment."
    at_rest = stick_held_at(*both, (0, 30))
    assert at_rest.passed
    assert at_rest.text == "Good."


# --- Throttles --------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("calibration", "side"),
    [(Calibration(2500, 2750, 4700, 75), -1), (Calibration(2800, 4750, 5000, 75), 1)],
)
def test_throttle_is_idle_on_its_shorter_side(calibration: Calibration, side: int) -> None:
    assert idle_side(calibration, reversed_=False) == side
    assert idle_side(calibration, reversed_=True) == -side


# --- Switches ---------------------------------------------------------------------------


def test_switch_result_prompts_to_move_before_any_position() -> None:
    assert switch_held_at((True, 2)).text == "Move the switch to all its positions."


@pytest.mark.parametrize("active", [False, True])
def test_switch_position_counts_after_three_samples(*, active: bool) -> None:
    seen = switch_held_at((active, 3))
    assert (seen.on, seen.off) == (active, not active)
    assert seen.text.startswith(f"Only {'on' if active else 'off'} was seen.")


def test_switch_passes_once_both_positions_were_seen() -> None:
    assert switch_held_at((False, 3), (True, 3)).passed
    assert not switch_held_at((False, 3), (True, 2)).passed
