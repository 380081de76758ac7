"""What a gamepad asks for, step by step."""

from dataclasses import replace

import pytest

from trex_gui.gamepad.detection import Detection
from trex_gui.gamepad.pads import PadState
from trex_gui.gamepad.pilot import Pilot, Waits
from trex_gui.gamepad.profile import Axis, Profile, Style

PROFILE = Profile(dead_zone=0.1, expo=0.0)
HOLD, STOP = 4, 1


def shows(x: float = 0.0, y: float = 0.0, *, down: tuple[int, ...] = ()) -> PadState:
    return PadState((x, y), tuple(number in down for number in range(8)))


def test_a_stick_that_was_never_at_rest_drives_nothing() -> None:
    pilot = Pilot(PROFILE)
    pilot.take(shows(y=-0.8))
    ask = pilot.take(shows(y=-0.8, down=(HOLD,)))
    assert (ask.forward, ask.drives, ask.waits) == (0, False, Waits.REST)


def test_one_stick_at_rest_does_not_vouch_for_the_other() -> None:
    pilot = Pilot(PROFILE)
    pilot.take(shows(x=0.5))
    ask = pilot.take(shows(x=0.5, y=-1.0, down=(HOLD,)))
    assert ask.turn == 0
    assert not ask.drives


def test_the_button_has_to_go_down_after_the_motors_were_armed() -> None:
    pilot = Pilot(PROFILE)
    pilot.take(shows())
    pilot.take(shows(down=(HOLD,)))
    pilot.begin()
    assert pilot.take(shows(down=(HOLD,))).waits is Waits.RELEASE
    assert pilot.take(shows()).waits is Waits.HOLD
    assert pilot.take(shows(y=-1.0, down=(HOLD,))).drives


def test_up_is_forward_and_right_is_right() -> None:
    pilot = Pilot(PROFILE)
    pilot.take(shows())
    ask = pilot.take(shows(x=1.0, y=-1.0, down=(HOLD,)))
    assert ask.forward == pytest.approx(1)
    assert ask.turn == pytest.approx(1)


def test_letting_go_of_the_button_ends_it_with_the_stick_still_off() -> None:
    pilot = Pilot(PROFILE)
    pilot.take(shows())
    assert pilot.take(shows(y=-1.0, down=(HOLD,))).drives
    assert pilot.take(shows(y=-1.0)).waits is Waits.HOLD


def test_without_a_button_to_hold_a_moved_stick_drives_until_it_is_back() -> None:
    pilot = Pilot(replace(PROFILE, hold=None))
    assert pilot.take(shows()).waits is Waits.MOVE
    assert pilot.take(shows(y=-0.5)).drives
    assert not pilot.take(shows(y=-0.05)).drives


def test_the_stop_button_counts_once_each_time_it_goes_down() -> None:
    pilot = Pilot(PROFILE)
    assert pilot.take(shows(down=(STOP,))).stop
    pilot.begin()
    assert not pilot.take(shows(down=(STOP,))).stop
    pilot.take(shows())
    assert pilot.take(shows(down=(STOP,))).stop


def test_as_a_tank_each_axis_is_a_motor() -> None:
    pilot = Pilot(replace(PROFILE, style=Style.TANK, first=Axis(1, True), second=Axis(0, True)))
    pilot.take(shows())
    ask = pilot.take(shows(y=-1.0, down=(HOLD,)))
    assert ask.forward + ask.turn == pytest.approx(1)
    assert ask.forward == ask.turn


def test_an_axis_that_the_gamepad_lacks_asks_for_nothing() -> None:
    pilot = Pilot(replace(PROFILE, first=Axis(7)))
    pilot.take(shows())
    assert pilot.take(shows(y=-1.0, down=(HOLD,))).forward == 0


def test_the_stick_that_is_meant_is_the_one_that_moves_farthest() -> None:
    detection = Detection(PadState((0.0, 0.1, -1.0), ()))
    assert detection.axis(PadState((0.2, 0.3, -1.0), ())) is None
    assert detection.axis(PadState((0.55, -0.9, -1.0), ())) == Axis(1, inverted=True)


def test_a_trigger_that_rests_at_its_end_is_not_meant_before_it_moves() -> None:
    detection = Detection(PadState((0.0, -1.0), ()))
    assert detection.axis(PadState((0.0, -1.0), ())) is None
    assert detection.axis(PadState((0.0, 0.2), ())) == Axis(1)


def test_a_button_that_was_down_already_is_not_meant() -> None:
    detection = Detection(PadState((), (True, False)))
    assert detection.button(PadState((), (True, False))) is None
    assert detection.button(PadState((), (True, True))) == 1
