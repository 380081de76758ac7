"""Setpoints and drive conditions of a gamepad."""

from dataclasses import replace

import pytest

from trex_gui.gamepad.pads import PadState
from trex_gui.gamepad.profile import Axis, DriveCondition, GamepadProfile, Pilot, Style

PROFILE = GamepadProfile(dead_zone=0.1, expo=0.0)
HOLD, STOP = 4, 1  # numbers of buttons


def pad_state(x: float = 0.0, y: float = 0.0, *, down: tuple[int, ...] = ()) -> PadState:
    return PadState((x, y), tuple(number in down for number in range(8)))


def centred_pilot(profile: GamepadProfile = PROFILE) -> Pilot:
    """Return a pilot that has seen both axes at rest."""
    pilot = Pilot(profile)
    pilot.update(pad_state())
    return pilot


def test_stick_that_was_never_centred_does_not_drive() -> None:
    pilot = Pilot(PROFILE)
    pilot.update(pad_state(y=-0.8))
    request = pilot.update(pad_state(y=-0.8, down=(HOLD,)))
    assert (request.forward, request.drives, request.waits_for) == (0, False, DriveCondition.REST)


def test_both_axes_must_be_centred_before_driving() -> None:
    pilot = Pilot(PROFILE)
    pilot.update(pad_state(x=0.5))
    request = pilot.update(pad_state(x=0.5, y=-1.0, down=(HOLD,)))
    assert request.turn == 0
    assert not request.drives


def test_axes_must_be_centred_again_after_reset() -> None:
    pilot = centred_pilot()
    pilot.reset()
    assert pilot.update(pad_state(y=-0.8)).waits_for is DriveCondition.REST


def test_small_deflection_counts_as_centred_without_a_dead_zone() -> None:
    pilot = Pilot(replace(PROFILE, dead_zone=0.0))
    assert pilot.update(pad_state(x=0.06)).waits_for is DriveCondition.REST
    assert pilot.update(pad_state(x=0.04)).waits_for is DriveCondition.HOLD


def test_hold_button_must_be_pressed_after_arming() -> None:
    pilot = centred_pilot()
    pilot.update(pad_state(down=(HOLD,)))
    pilot.reset()
    assert pilot.update(pad_state(down=(HOLD,))).waits_for is DriveCondition.RELEASE
    assert pilot.update(pad_state()).waits_for is DriveCondition.HOLD
    assert pilot.update(pad_state(y=-1.0, down=(HOLD,))).drives


def test_stick_up_drives_forward_and_stick_right_turns_right() -> None:
    pilot = centred_pilot()
    request = pilot.update(pad_state(x=1.0, y=-1.0, down=(HOLD,)))
    assert request.forward == pytest.approx(1)
    assert request.turn == pytest.approx(1)


def test_releasing_hold_button_stops_driving() -> None:
    pilot = centred_pilot()
    assert pilot.update(pad_state(y=-1.0, down=(HOLD,))).drives
    assert pilot.update(pad_state(y=-1.0)).waits_for is DriveCondition.HOLD


def test_stick_drives_alone_if_no_hold_button_is_set() -> None:
    pilot = Pilot(replace(PROFILE, hold=None))
    assert pilot.update(pad_state()).waits_for is DriveCondition.MOVE
    assert pilot.update(pad_state(y=-0.5)).drives
    assert not pilot.update(pad_state(y=-0.05)).drives


def test_stop_button_acts_once_per_press() -> None:
    pilot = Pilot(PROFILE)
    assert pilot.update(pad_state(down=(STOP,))).stop
    pilot.reset()
    assert not pilot.update(pad_state(down=(STOP,))).stop
    pilot.update(pad_state())
    assert pilot.update(pad_state(down=(STOP,))).stop


def test_tank_style_maps_each_axis_to_one_motor() -> None:
    profile = replace(PROFILE, style=Style.TANK, first=Axis(1, True), second=Axis(0, True))
    pilot = centred_pilot(profile)
    for state, motors in (
        (pad_state(y=-1.0, down=(HOLD,)), (1, 0)),
        (pad_state(x=-1.0, down=(HOLD,)), (0, 1)),
    ):
        request = pilot.update(state)
        left, right = request.forward + request.turn, request.forward - request.turn
        assert (left, right) == pytest.approx(motors)


def test_missing_axis_gives_zero_setpoint() -> None:
    pilot = centred_pilot(replace(PROFILE, first=Axis(7)))
    assert pilot.update(pad_state(y=-1.0, down=(HOLD,))).forward == 0
