"""A gamepad in a person's hands, and what the motors are asked to do."""

from collections.abc import Iterator
from dataclasses import replace

import pytest
from PySide6.QtCore import QCoreApplication, QEvent
from pytestqt.qtbot import QtBot

from tests.support.pads import PAD, HeldPads
from trex_gui.gamepad.pilot import Waits
from trex_gui.gamepad.profile import Axis
from trex_gui.model.device import Device
from trex_gui.model.driving.gamepad import HOLDER, Gamepad
from trex_gui.protocol.calibration import FULL_SCALE

HOLD, STOP = 4, 1
X, Y = 0, 1
OTHER = replace(PAD, ident=2, guid="b" * 32, name="Other pad")


class Hands:
    """A gamepad, armed motors, and a wait until what was done has been seen."""

    def __init__(self, qtbot: QtBot) -> None:
        self.qtbot = qtbot
        self.device = Device()
        self.motors = self.device.motors
        self.motors.lockout = 0
        self.motors.allow(True)
        self.pads = HeldPads(PAD)
        self.gamepad = Gamepad(self.device, self.pads)
        self.stops: list[str] = []
        self.motors.stop_requested.connect(self._on_stop)

    def _on_stop(self) -> None:
        self.stops.append(self.motors.stop_reason)

    def arm(self) -> None:
        self.motors.arm()
        self.wait_for("Hold")

    def wait_for(self, words: str) -> None:
        self.qtbot.waitUntil(lambda: words in self.gamepad.text)

    def speeds(self) -> tuple[int | None, int | None]:
        first, second = self.motors.drive(1), self.motors.drive(2)
        return (first.signed if first else None, second.signed if second else None)

    def wait_for_speeds(self, left: int | None, right: int | None) -> None:
        self.qtbot.waitUntil(lambda: self.speeds() == (left, right))

    def seen(self, axis: int) -> float | None:
        """Where the gamepad was read to have this axis."""
        state = self.gamepad.state
        return None if state is None else state.axes[axis]

    def go(self) -> None:
        """Drive forward as fast as it goes."""
        self.pads.press(HOLD)
        self.wait_for("Driving")
        self.pads.move(Y, -1.0)
        self.wait_for_speeds(FULL_SCALE, FULL_SCALE)


@pytest.fixture
def hands(qtbot: QtBot) -> Iterator[Hands]:
    hands = Hands(qtbot)
    hands.gamepad.switch_on()
    hands.arm()
    yield hands
    hands.gamepad.switch_off()


def brakes(hands: Hands) -> bool:
    return all(
        (drive := hands.motors.drive(motor)) is not None and drive.is_brake for motor in (1, 2)
    )


def test_holding_the_button_and_moving_the_stick_drives(hands: Hands) -> None:
    hands.go()
    assert hands.motors.holder == HOLDER
    assert hands.gamepad.drives


def test_turning_makes_the_left_motor_faster(hands: Hands) -> None:
    hands.pads.press(HOLD)
    hands.pads.move(X, 1.0)
    hands.wait_for_speeds(FULL_SCALE, -FULL_SCALE)


def test_letting_go_of_the_button_brakes_and_leaves_the_motors_armed(hands: Hands) -> None:
    hands.go()
    hands.pads.release(HOLD)
    hands.qtbot.waitUntil(lambda: brakes(hands))
    assert hands.motors.armed
    assert not hands.motors.holder


def test_the_ceiling_is_what_a_full_stick_means(hands: Hands) -> None:
    hands.motors.set_ceiling(40)
    hands.pads.press(HOLD)
    hands.pads.move(Y, 1.0)
    hands.wait_for_speeds(-40, -40)


def test_a_ceiling_raised_under_a_stick_that_is_held_makes_nothing_faster(hands: Hands) -> None:
    hands.motors.set_ceiling(40)
    hands.pads.press(HOLD)
    hands.pads.move(Y, 1.0)
    hands.wait_for_speeds(-40, -40)
    hands.motors.set_ceiling(FULL_SCALE)
    hands.qtbot.wait(100)  # it is read and says the same all the time
    assert hands.speeds() == (-40, -40)
    hands.pads.release(HOLD)
    hands.qtbot.waitUntil(lambda: brakes(hands))
    hands.pads.move(Y, 0.0)
    hands.qtbot.waitUntil(lambda: hands.seen(Y) == 0.0)
    hands.pads.press(HOLD)
    hands.pads.move(Y, 1.0)
    hands.wait_for_speeds(-FULL_SCALE, -FULL_SCALE)


def test_linked_motors_do_the_same_and_do_not_turn(hands: Hands) -> None:
    hands.motors.set_linked(True)
    hands.pads.press(HOLD)
    hands.pads.move(X, 1.0)
    hands.pads.move(Y, -1.0)
    hands.wait_for_speeds(FULL_SCALE, FULL_SCALE)


def test_a_button_that_was_down_before_run_motor_drives_nothing(hands: Hands) -> None:
    hands.motors.stop()
    hands.pads.press(HOLD)
    hands.pads.move(Y, -1.0)
    hands.wait_for("Press Run motor")
    hands.motors.arm()
    hands.wait_for("Let go")
    assert hands.speeds() == (None, None)
    assert not hands.motors.holder


def test_a_stick_that_was_never_at_rest_drives_nothing(hands: Hands) -> None:
    hands.motors.stop()
    hands.pads.move(Y, 0.6)
    hands.motors.arm()
    hands.pads.press(HOLD)
    hands.wait_for("Let go of the sticks")
    assert hands.speeds() == (None, None)


def test_a_gamepad_that_vanishes_while_it_drives_stops_the_motors(hands: Hands) -> None:
    hands.go()
    hands.pads.unplug(PAD)
    hands.wait_for("has gone")
    assert hands.stops == ["The gamepad “Test pad” has gone."]
    assert not hands.motors.armed


def test_a_gamepad_that_can_no_longer_be_read_stops_the_motors_though_it_is_still_there(
    hands: Hands, monkeypatch: pytest.MonkeyPatch
) -> None:
    hands.go()
    monkeypatch.setattr(hands.pads, "read", lambda _pad: None)
    hands.wait_for("has gone")
    assert hands.stops == ["The gamepad “Test pad” has gone."]
    assert not hands.motors.armed
    assert hands.gamepad.pads == (PAD,)
    changes: list[str] = []
    hands.gamepad.changed.connect(lambda: changes.append(hands.gamepad.text))
    hands.qtbot.wait(100)
    assert changes == [], "it is not tried again and again"


def test_the_next_gamepad_does_not_take_over_by_itself(hands: Hands) -> None:
    hands.go()
    hands.pads.plug_in(OTHER)
    hands.pads.move(Y, -1.0, OTHER)
    hands.pads.press(HOLD, OTHER)
    hands.pads.unplug(PAD)
    hands.qtbot.waitUntil(lambda: hands.gamepad.pad == OTHER)
    assert not hands.motors.armed
    assert hands.stops == ["The gamepad “Test pad” has gone."]


def test_one_that_comes_back_has_to_be_armed_and_held_anew(hands: Hands) -> None:
    hands.go()
    hands.pads.unplug(PAD)
    hands.wait_for("has gone")
    again = replace(PAD, ident=7)
    hands.pads.plug_in(again)
    hands.pads.press(HOLD, again)
    hands.wait_for("Press Run motor")
    hands.motors.arm()
    hands.wait_for("Let go")
    assert not hands.motors.holder


def test_its_stop_button_stops_even_what_another_control_drives(hands: Hands) -> None:
    hands.motors.hold("pad")
    hands.motors.set_speed(1, 50, "pad")
    hands.pads.press(STOP)
    hands.qtbot.waitUntil(lambda: not hands.motors.armed)
    assert hands.stops == [""]


def test_its_stop_button_works_while_nobody_attends(hands: Hands) -> None:
    hands.gamepad.attend("Another page is open.")
    hands.pads.press(STOP)
    hands.qtbot.waitUntil(lambda: not hands.motors.armed)


def test_when_nobody_attends_any_more_the_motors_stop_and_it_says_why(hands: Hands) -> None:
    hands.go()
    hands.gamepad.attend("The window is not in front.")
    assert hands.stops == ["The window is not in front."]
    assert hands.gamepad.text == "The window is not in front."


def test_while_nobody_attends_it_drives_nothing(hands: Hands) -> None:
    hands.gamepad.attend("Another page is open.")
    hands.pads.press(HOLD)
    hands.qtbot.waitUntil(lambda: hands.gamepad.ask.waits is Waits.RELEASE)
    hands.pads.release(HOLD)
    hands.qtbot.waitUntil(lambda: hands.gamepad.ask.waits is Waits.HOLD)
    hands.pads.press(HOLD)
    hands.pads.move(Y, -1.0)
    hands.qtbot.waitUntil(lambda: hands.gamepad.ask.drives)
    assert hands.speeds() == (None, None)
    hands.gamepad.attend("")
    hands.wait_for("Let go of the sticks")
    assert hands.speeds() == (None, None)


def test_another_control_that_is_held_is_not_disturbed_and_not_followed(hands: Hands) -> None:
    hands.motors.hold("pad")
    hands.motors.set_speed(1, 30, "pad")
    hands.pads.press(HOLD)
    hands.pads.move(Y, -1.0)
    hands.wait_for("Another control drives")
    assert hands.motors.holder == "pad"
    hands.motors.let_go("pad")
    hands.pads.move(Y, 0.0)
    hands.wait_for("Let go of button")
    assert not hands.motors.holder


def test_switching_off_while_it_drives_stops_the_motors(hands: Hands) -> None:
    hands.go()
    hands.gamepad.switch_off()
    assert hands.stops == ["Driving with a gamepad was switched off."]
    assert not hands.pads.is_open
    assert hands.gamepad.text == ""


def test_what_its_parts_are_for_is_remembered_for_its_kind(hands: Hands) -> None:
    profile = replace(hands.gamepad.profile, second=Axis(3), hold=5, dead_zone=0.2)
    hands.gamepad.set_profile(profile)
    hands.gamepad.switch_off()
    later = Gamepad(hands.device, HeldPads(PAD, OTHER))
    later.switch_on()
    assert later.profile == profile
    later.choose(OTHER)
    assert later.profile != profile
    later.switch_off()


def test_the_kind_that_was_chosen_last_is_chosen_again(hands: Hands) -> None:
    hands.pads.plug_in(OTHER)
    hands.qtbot.waitUntil(lambda: OTHER in hands.gamepad.pads)
    hands.gamepad.choose(OTHER)
    hands.gamepad.switch_off()
    hands.gamepad.switch_on()
    assert hands.gamepad.pad == OTHER


def test_setting_it_up_anew_while_it_drives_stops_the_motors(hands: Hands) -> None:
    hands.go()
    hands.gamepad.set_profile(replace(hands.gamepad.profile, expo=1.0))
    assert hands.stops == ["The gamepad was set up anew."]


def test_what_was_remembered_but_does_not_fit_is_not_used(hands: Hands) -> None:
    hands.gamepad.set_profile(replace(hands.gamepad.profile, first=Axis(9)))
    hands.gamepad.switch_off()
    hands.gamepad.switch_on()
    assert hands.gamepad.profile.first == Axis(Y, inverted=True)


def test_where_gamepads_cannot_be_read_it_says_what_helps(qtbot: QtBot) -> None:
    gamepad = Gamepad(Device(), HeldPads(failure="Install it with …"))
    gamepad.switch_on()
    assert not gamepad.on
    assert gamepad.text == gamepad.failure == "Install it with …"


def test_nothing_is_read_before_it_is_switched_on(qtbot: QtBot) -> None:
    pads = HeldPads(PAD)
    gamepad = Gamepad(Device(), pads)
    assert not pads.is_open
    assert gamepad.text == ""


def test_without_a_gamepad_it_says_so_and_takes_the_first_that_comes(qtbot: QtBot) -> None:
    pads = HeldPads()
    gamepad = Gamepad(Device(), pads)
    gamepad.switch_on()
    assert "No gamepad is there" in gamepad.text
    pads.plug_in(PAD)
    qtbot.waitUntil(lambda: gamepad.pad == PAD)
    gamepad.switch_off()


def test_one_whose_page_is_gone_reads_nothing_any_more(qtbot: QtBot) -> None:
    pads = HeldPads(PAD)
    gamepad = Gamepad(Device(), pads)
    gamepad.switch_on()
    assert pads.is_open
    gamepad.deleteLater()
    QCoreApplication.sendPostedEvents(None, QEvent.Type.DeferredDelete)
    assert not pads.is_open
