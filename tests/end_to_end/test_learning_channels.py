"""A person learns the channels of a simulated board through the wizard's own widgets."""

import sys
from collections.abc import Callable
from typing import Any

import pytest
from PySide6.QtCore import QCoreApplication, Qt
from PySide6.QtGui import QAction
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QAbstractButton, QCheckBox, QDialog, QLabel, QSpinBox
from pytestqt.qtbot import QtBot

from tests.support.people import Person, Stick
from tests.support.simulator import SimulatorProcess
from trex_gui.link.settings import LinkSettings
from trex_gui.model.device import Link
from trex_gui.protocol.flags import InputSource
from trex_gui.views.pages.calibration.page import CalibrationPage
from trex_gui.window import Program

pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="needs pseudo-terminals")

ANALOG = InputSource.ANALOG
WORN = Stick(rest=1523, low=1090, high=1905, noise=2, lost=0.02)


class Wizard:
    """The window with its wizard, the board, and somebody with a transmitter."""

    def __init__(self, program: Program, simulator: SimulatorProcess, qtbot: QtBot) -> None:
        self.program = program
        self.device = program.device
        self.simulator = simulator
        self.qtbot = qtbot
        self.person = Person(simulator, {})
        self.device.connect_to(LinkSettings(simulator.url))
        self.wait(lambda: self.device.link is Link.UP)
        self.before = self.stored()

    def wait(self, condition: Callable[[], bool], timeout: int = 10_000) -> None:
        self.qtbot.waitUntil(condition, timeout=timeout)

    @property
    def dialog(self) -> QDialog:
        found = self.program.window.findChild(QDialog, "learnDialog")
        assert found is not None
        return found

    def button(self, name: str) -> QAbstractButton:
        found = self.program.window.findChild(QAbstractButton, name)
        assert found is not None, name
        return found

    def can_press(self, name: str) -> bool:
        return self.button(name).isVisible() and self.button(name).isEnabled()

    def press(self, name: str) -> None:
        self.wait(lambda: self.can_press(name))
        # Buttons that come and go are laid out with the next events: nobody clicks sooner.
        QCoreApplication.sendPostedEvents()
        QTest.mouseClick(self.button(name), Qt.MouseButton.LeftButton)

    def text(self, name: str) -> str:
        label = self.dialog.findChild(QLabel, name)
        return "" if label is None else label.text()

    def until_text(self, name: str, words: str, timeout: int = 10_000) -> None:
        try:
            self.wait(lambda: words in self.text(name), timeout)
        except self.qtbot.TimeoutError:
            found = {label.objectName(): label.text() for label in self.dialog.findChildren(QLabel)}
            pytest.fail(f"{name} does not say {words!r}: {found}")

    def stored(self) -> dict[str, Any]:
        """Everything that the board keeps."""
        found: dict[str, Any] = self.simulator.show()["parameters"]
        return found

    def sit_down(self, sticks: dict[int, Stick]) -> None:
        self.person = Person(self.simulator, sticks)

    def choose(self, name: str) -> None:
        action = self.program.window.findChild(QAction, f"{name}Action")
        assert action is not None
        assert action.isEnabled()
        action.trigger()

    def begin(self, *channels: int) -> None:
        """Ask for learning, as the Calibration page does."""
        page = self.program.window.findChild(CalibrationPage)
        assert page is not None
        page.learn_requested.emit(channels)

    def to_rest(self, *channels: int) -> None:
        self.begin(*channels)
        self.until_text("learnHead", "Let go of every stick")

    def to_travel(self, *channels: int) -> None:
        self.to_rest(*channels)
        self.press("learnNextButton")
        self.until_text("learnHead", "forward or right first")

    def hold(self) -> None:
        """Wait for as many measurements as make an end, on a busy computer too."""
        inputs = self.device.telemetry.inputs
        start = float(inputs.times[-1])
        self.wait(lambda: float(inputs.times[-1]) > start + 0.4)
        before = self.device.telemetry.samples
        self.wait(lambda: self.device.telemetry.samples > before + 60)

    def push(self, *positions: float) -> None:
        """Hold every stick somewhere, one place after the other, then let go."""
        for position in positions:
            for channel in self.person.sticks:
                self.person.put(channel, position)
            self.hold()
        self.person.let_go()
        self.hold()

    def to_review(self, *channels: int) -> None:
        self.to_travel(*channels)
        self.push(1, -1)
        self.press("learnNextButton")
        self.wait(lambda: self.button("learnTakeButton").isVisible())

    def take_and_write(self) -> None:
        self.press("learnTakeButton")
        assert not self.dialog.isVisible()
        self.press("writeButton")
        self.wait(lambda: self.device.pending == 0 and not self.device.applying)

    def assert_learned(self, channel: int) -> None:
        """The ends within 1 % of the travel and 5 deviations, the rest within 1.5 of the truth."""
        found = self.device.calibrations.stored(channel)
        assert found is not None
        stick = self.person.sticks[channel]
        low, rest, high = stick.truth()
        noise = max(1.0, stick.noise * stick.source.counts_per_unit)
        bound = 0.01 * (high - low) + 5 * noise
        assert 0 < found.minimum - low <= bound
        assert 0 < high - found.maximum <= bound
        assert abs(found.neutral - rest) <= 1.5 * noise

    def assert_nothing_changed(self) -> None:
        assert self.stored() == self.before
        assert self.device.pending == 0


@pytest.fixture
def wizard(program: Program, quick_simulator: SimulatorProcess, qtbot: QtBot) -> Wizard:
    return Wizard(program, quick_simulator, qtbot)


# --- Good cases -------------------------------------------------------------------------


@pytest.mark.parametrize(
    "stick",
    [
        Stick(),
        WORN,
        Stick(rest=1440, low=900, high=2100, noise=1),
        Stick(rest=1500, low=1300, high=1700, noise=0.5),
    ],
    ids=["clean", "worn", "trimmed", "limited"],
)
def test_a_stick_is_learned_within_its_bounds(wizard: Wizard, stick: Stick) -> None:
    wizard.sit_down({1: stick})
    wizard.to_review(1)
    assert wizard.text("learnProblem1") == ""
    wizard.assert_nothing_changed()
    wizard.take_and_write()
    wizard.assert_learned(1)
    assert wizard.stored()["reversed_channels"] == 0


def test_all_channels_are_learned_in_one_pass(wizard: Wizard) -> None:
    wizard.sit_down(
        {
            1: WORN,
            2: Stick(rest=1480, low=1050, high=1950, noise=1, forward_is_down=True),
            3: Stick(rest=1100, low=1100, high=1900),
            4: Stick(rest=1900, low=1100, high=1900, forward_is_down=True),
            5: Stick(rest=1100, low=1100, high=1900),
        }
    )
    wizard.choose("learn")
    wizard.until_text("learnHead", "Let go of every stick")
    wizard.press("learnNextButton")
    wizard.until_text("learnHead", "forward or right first")
    wizard.push(1, -1)
    wizard.press("learnNextButton")
    wizard.wait(lambda: wizard.button("learnTakeButton").isVisible())
    boxes = [wizard.button(f"learnReversed{channel}").isChecked() for channel in range(1, 6)]
    assert boxes == [False, True, False, False, True]
    wizard.take_and_write()
    wizard.assert_learned(1)
    wizard.assert_learned(2)
    assert wizard.stored()["reversed_channels"] == 0b10010
    assert len(wizard.device.history.snapshots()) == 1
    # The test follows by itself.
    wizard.until_text("learnHead", "Push every stick")
    wizard.push(1, -1)
    for channel in range(1, 6):
        wizard.until_text(f"learnTest{channel}", "Good.")
    wizard.until_text("learnHead", "Everything is as it should be")
    wizard.until_text("learnSafeStart", "would let the motors go")
    wizard.press("learnCancelButton")
    assert not wizard.dialog.isVisible()


def test_what_is_unticked_or_changed_is_taken_as_the_person_wants(wizard: Wizard) -> None:
    wizard.sit_down({1: Stick(), 2: WORN})
    wizard.to_review(1, 2)
    box = wizard.dialog.findChild(QCheckBox, "learnInclude1")
    assert box is not None
    box.click()
    editor = wizard.dialog.findChild(QSpinBox, "learnDeadbandEdit2")
    assert editor is not None
    editor.setValue(3)
    assert "motor would creep" in wizard.text("learnProblem2")
    editor.setValue(100)
    assert wizard.text("learnProblem2") == ""
    wizard.take_and_write()
    second = wizard.device.calibrations.stored(2)
    assert second is not None
    assert second.deadband == 100
    assert wizard.stored().get("rc_channel_1") == wizard.before.get("rc_channel_1")
    wizard.until_text("learnHead", "Push every stick")


def test_values_in_a_wrong_order_cannot_be_taken(wizard: Wizard) -> None:
    wizard.sit_down({1: Stick()})
    wizard.to_review(1)
    editor = wizard.dialog.findChild(QSpinBox, "learnMinimumEdit1")
    assert editor is not None
    editor.setValue(4000)
    assert "would not take this: minimum 4000 is above neutral" in wizard.text("learnProblem1")
    assert not wizard.can_press("learnTakeButton")


def test_joysticks_are_learned_in_volts(
    program: Program, start_simulator: Callable[..., SimulatorProcess], qtbot: QtBot
) -> None:
    simulator = start_simulator("--unpaced")
    wizard = Wizard(program, simulator, qtbot)
    wizard.device.parameters.edit("channel_input_source", 1)
    wizard.device.apply()
    wizard.wait(lambda: wizard.device.pending == 0 and not wizard.device.applying)
    simulator.do("power cycle")
    wizard.wait(lambda: wizard.device.calibrations.source is ANALOG)
    wizard.wait(lambda: wizard.device.link is Link.UP)
    wizard.sit_down({1: Stick(rest=2.45, low=0.6, high=4.4, noise=0.01, source=ANALOG)})
    wizard.to_review(1)
    wizard.take_and_write()
    wizard.assert_learned(1)
    wizard.until_text("learnHead", "Push every stick")


# --- Bad cases --------------------------------------------------------------------------


def test_no_signal_is_said_within_a_second(wizard: Wizard) -> None:
    wizard.sit_down({2: Stick(connected=False)})
    wizard.hold()
    wizard.to_rest(2)
    wizard.until_text("learnProblem2", "Is the transmitter on", timeout=1500)
    wizard.press("learnNextButton")
    wizard.until_text("learnHead", "No channel rests")
    assert not wizard.can_press("learnNextButton")


def test_a_stick_that_twitches_while_it_is_sampled_is_said_and_sampled_again(
    wizard: Wizard,
) -> None:
    wizard.sit_down({1: Stick()})
    wizard.to_rest(1)
    wizard.press("learnNextButton")
    wizard.until_text("learnHead", "Sampling")
    wizard.qtbot.wait(300)
    wizard.person.put(1, 0.4)
    wizard.until_text("learnProblem1", "It moved while it was sampled", timeout=2500)
    wizard.until_text("learnHead", "No channel rests")
    wizard.person.let_go()
    wizard.hold()
    wizard.press("learnAgainButton")
    wizard.until_text("learnHead", "forward or right first")


def test_lost_pulses_are_said(wizard: Wizard) -> None:
    wizard.sit_down({1: Stick(lost=0.75)})
    wizard.to_rest(1)
    wizard.press("learnNextButton")
    wizard.wait(lambda: wizard.can_press("learnAgainButton"))
    assert "valid pulse" in wizard.text("learnProblem1")


def test_noise_above_every_deadband_is_said(wizard: Wizard) -> None:
    wizard.sit_down({1: Stick(noise=60)})
    wizard.to_rest(1)
    wizard.press("learnNextButton")
    wizard.until_text("learnHead", "No channel rests")
    assert "a deadband that holds it still" in wizard.text("learnProblem1")


@pytest.mark.parametrize(
    ("stick", "positions", "words"),
    [
        (Stick(), (0,), "It never moved"),
        (Stick(low=1450, high=1550), (1, -1), "It went only 50 µs from its rest"),
        (Stick(), (1,), "It went one way only, never below its rest"),
        (Stick(low=1440), (1, -1), "The end below is only 60 µs from its rest"),
    ],
    ids=["never moves", "too little", "one direction", "end too near"],
)
def test_a_travel_that_is_no_good_is_said(
    wizard: Wizard, stick: Stick, positions: tuple[float, ...], words: str
) -> None:
    wizard.sit_down({1: stick})
    wizard.to_travel(1)
    wizard.push(*positions)
    wizard.press("learnNextButton")
    wizard.until_text("learnProblem1", words)
    assert not wizard.can_press("learnTakeButton")
    wizard.press("learnCancelButton")
    wizard.assert_nothing_changed()


def test_a_rest_beside_the_ends_is_said(wizard: Wizard) -> None:
    wizard.sit_down({1: Stick()})
    wizard.to_rest(1)
    wizard.press("learnNextButton")
    wizard.until_text("learnHead", "forward or right first")
    wizard.sit_down({1: Stick(rest=1700, low=1650, high=2000)})
    wizard.hold()
    wizard.press("learnAgainButton")
    wizard.push(1, -1)
    wizard.press("learnNextButton")
    wizard.until_text("learnProblem1", "is not between the ends")


# --- Cancelled, and interrupted ---------------------------------------------------------

STEPS = ("to_rest", "to_travel", "to_review")


@pytest.mark.parametrize("step", STEPS)
@pytest.mark.parametrize("by", ["button", "esc", "window"])
def test_cancel_leaves_the_board_as_it_was(wizard: Wizard, step: str, by: str) -> None:
    wizard.sit_down({1: WORN})
    getattr(wizard, step)(1)
    if by == "button":
        wizard.press("learnCancelButton")
    elif by == "esc":
        QTest.keyClick(wizard.dialog, Qt.Key.Key_Escape)
    else:
        wizard.dialog.close()
    assert not wizard.dialog.isVisible()
    wizard.assert_nothing_changed()
    assert wizard.device.history.snapshots() == ()


@pytest.mark.parametrize("step", STEPS)
def test_a_plug_that_is_pulled_is_said_and_nothing_was_changed(
    program: Program, simulator: SimulatorProcess, qtbot: QtBot, step: str
) -> None:
    wizard = Wizard(program, simulator, qtbot)
    wizard.sit_down({1: WORN})
    getattr(wizard, step)(1)
    simulator.do("line unplug")
    wizard.until_text("learnHead", "Nothing was changed")
    assert not wizard.can_press("learnTakeButton")
    assert not wizard.can_press("learnNextButton")
    wizard.assert_nothing_changed()


def test_a_board_that_falls_silent_is_said_and_can_be_begun_again(wizard: Wizard) -> None:
    wizard.sit_down({1: WORN})
    wizard.to_travel(1)
    wizard.simulator.do("line mute on")
    wizard.until_text("learnHead", "has stopped answering", timeout=5000)
    wizard.simulator.do("line mute off")
    wizard.wait(lambda: wizard.device.link is Link.UP)
    wizard.press("learnAgainButton")
    wizard.until_text("learnHead", "Let go of every stick")


def test_motors_that_run_are_braked_first(wizard: Wizard) -> None:
    wizard.device.motors.arm()
    wizard.device.motors.set_speed(1, 60)
    wizard.wait(lambda: wizard.simulator.show()["motors"][0]["speed"] == 60)
    wizard.to_rest(1)
    motors = wizard.simulator.show()["motors"]
    assert [motor["target_direction"] for motor in motors] == ["brake", "brake"]
    assert not wizard.device.motors.armed


def test_without_a_proved_stop_it_goes_no_further(wizard: Wizard) -> None:
    wizard.device.motors.arm()
    wizard.device.motors.set_speed(1, 60)
    wizard.wait(lambda: wizard.simulator.show()["motors"][0]["speed"] == 60)
    wizard.simulator.do("line mute on")
    wizard.begin(1)
    wizard.wait(lambda: wizard.button("learnAgainButton").isVisible())
    assert wizard.text("learnHead") not in {"", "Stopping the motors."}
    assert not wizard.can_press("learnNextButton")
    assert not wizard.can_press("learnTakeButton")
    wizard.simulator.do("line mute off")
    wizard.wait(lambda: wizard.device.link is Link.UP)


def test_the_red_button_can_be_pressed_meanwhile(wizard: Wizard) -> None:
    wizard.to_rest(1)
    assert not wizard.dialog.isModal()
    wizard.press("stopButton")
    wizard.until_text("learnHead", "Let go of every stick")


@pytest.mark.parametrize("action", ["learn", "test_sticks"])
def test_where_sticks_drive_motors_it_does_not_begin(wizard: Wizard, action: str) -> None:
    wizard.simulator.do("jumper mode rc")
    wizard.simulator.do("power cycle")
    wizard.wait(lambda: wizard.device.state is not None and not wizard.device.state.mode.is_serial)
    wizard.choose(action)
    wizard.until_text("learnHead", "take the mode jumper off")
    wizard.simulator.do("jumper mode serial")
    wizard.simulator.do("power cycle")
    wizard.wait(lambda: wizard.device.state is not None and wizard.device.state.mode.is_serial)


def test_a_stick_that_does_not_reach_its_end_is_said_by_the_test(wizard: Wizard) -> None:
    wizard.sit_down({1: Stick(low=1050, high=2010), 2: Stick(rest=1600)})
    wizard.choose("test_sticks")
    wizard.until_text("learnHead", "Push every stick")
    wizard.push(1, -1)
    assert wizard.text("learnTest1") == "Full output not reached yet: reverse (−127)."
    wizard.until_text("learnTest2", "at rest it must give 0")
    wizard.until_text("learnSafeStart", "channel 2 gives +")
