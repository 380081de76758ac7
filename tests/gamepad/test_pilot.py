"""Setpoints of a gamepad, step by step."""

from dataclasses import replace

import pytest

from trex_gui.gamepad.pads import PadState
from trex_gui.gamepad.profile import Axis, DriveCondition, GamepadProfile, Pilot, Style

PROFILE = GamepadProfile(dead_zone=0.1, expo=0.0)
HOLD, STOP = 4, 1


def shows(x: float = 0.0, y: float = 0.0, *, down: tuple[int, ...] = ()) -> PadState:
    return PadState((x, y), tuple(number in down for number in range(8)))


def test_stick_never_centred_does_not_drive() -> None:
    pilot = Pilot(PROFILE)
    pilot.update(shows(y=-0.8))
    ask = pilot.update(shows(y=-0.8, down=(HOLD,)))
    assert (ask.forward, ask.drives, ask.waits_for) == (0, False, DriveCondition.REST)


def test_driving_requires_both_axes_centred_first() -> None:
    pilot = Pilot(PROFILE)
    pilot.update(shows(x=0.5))
    ask = pilot.update(shows(x=0.5, y=-1.0, down=(HOLD,)))
    assert ask.turn == 0
    assert not ask.drives


def test_hold_button_must_be_pressed_after_arming() -> None:
    pilot = Pilot(PROFILE)
    pilot.update(shows())
    pilot.update(shows(down=(HOLD,)))
    pilot.reset()
    assert pilot.update(shows(down=(HOLD,))).waits_for is DriveCondition.RELEASE
    assert pilot.update(shows()).waits_for is DriveCondition.HOLD
    assert pilot.update(shows(y=-1.0, down=(HOLD,))).drives


def test_stick_up_drives_forward_and_stick_right_turns_right() -> None:
    pilot = Pilot(PROFILE)
    pilot.update(shows())
    ask = pilot.update(shows(x=1.0, y=-1.0, down=(HOLD,)))
    assert ask.forward == pytest.approx(1)
    assert ask.turn == pytest.approx(1)


def test_releasing_hold_button_stops_driving() -> None:
    pilot = Pilot(PROFILE)
    pilot.update(shows())
    assert pilot.update(shows(y=-1.0, down=(HOLD,))).drives
    assert pilot.update(shows(y=-1.0)).waits_for is DriveCondition.HOLD


def test_stick_alone_drives_without_hold_button() -> None:
    pilot = Pilot(replace(PROFILE, hold=None))
    assert pilot.update(shows()).waits_for is DriveCondition.MOVE
    assert pilot.update(shows(y=-0.5)).drives
    assert not pilot.update(shows(y=-0.05)).drives


def test_stop_button_acts_once_per_press() -> None:
    pilot = Pilot(PROFILE)
    assert pilot.update(shows(down=(STOP,))).stop
    pilot.reset()
    assert not pilot.update(shows(down=(STOP,))).stop
    pilot.update(shows())
    assert pilot.update(shows(down=(STOP,))).stop


def test_tank_style_maps_each_axis_to_one_motor() -> None:
    pilot = Pilot(replace(PROFILE, style=Style.TANK, first=Axis(1, True), second=Axis(0, True)))
    pilot.update(shows())
    ask = pilot.update(shows(y=-1.0, down=(HOLD,)))
    assert ask.forward + ask.turn == pytest.approx(1)
    assert ask.forward == ask.turn


def test_missing_axis_gives_zero_setpoint() -> None:
    pilot = Pilot(replace(PROFILE, first=Axis(7)))
    pilot.update(shows())
    assert pilot.update(shows(y=-1.0, down=(HOLD,))).forward == 0
