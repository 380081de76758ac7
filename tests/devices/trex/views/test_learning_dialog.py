"""The dialog that learns channels, by itself, on a simulated board."""

from collections.abc import Iterator
from dataclasses import replace
from functools import partial

import pytest
from PySide6.QtWidgets import QCheckBox, QLabel, QProgressBar, QSpinBox, QTabBar, QWidget
from pytestqt.qtbot import QtBot

from tests.support.pages.learning import LearningDialog, learning_dialog
from tests.support.simulator import SimulatedDevice
from tests.support.transmitter import Stick
from tests.support.window import WidgetDriver
from trex_gui.devices.trex.calibration.channel_curve import ChannelCurve
from trex_gui.devices.trex.protocol.flags import CHANNELS, InputSource
from trex_gui.devices.trex.protocol.line_settings import LineSettings
from trex_gui.devices.trex.views.bars import ChannelBar
from trex_gui.devices.trex.views.learning.live_pages import ChannelRows
from trex_gui.devices.trex.views.pages.calibration.curve_plot import CurvePlot
from trex_gui.ui.devices.connection import ConnectionState
from trex_gui.ui.theme.theme import theme
from trex_gui.ui.widgets.labels import Note
from trex_gui.ui.widgets.scroll_box import ScrollBox

THROTTLE = Stick(rest=1100, low=1100, high=1900)


@pytest.fixture
def learning(quick_simulator: SimulatedDevice, qtbot: QtBot) -> Iterator[LearningDialog]:
    with learning_dialog(quick_simulator, qtbot) as dialog:
        yield dialog


# --- The rest positions -----------------------------------------------------------------


def test_rest_position_of_a_held_stick_can_be_corrected(learning: LearningDialog) -> None:
    learning.use({1: Stick()})
    learning.transmitter.put(1, 0.2)
    learning.wait(lambda: learning.device.telemetry.raw_of(1) == 4000)
    learning.go_to_review(1)
    words = "After release it rests at 1500 µs, not at 1600 µs"
    assert words in learning.problem(1)
    assert learning.button("learnUseRest1").text() == "Use 1500 µs &as neutral"

    learning.click("learnUseRest1")
    assert learning.problem(1) == ""
    assert not learning.has("learnUseRest1")
    learning.use_and_apply()
    learning.assert_learned(1)


# --- The ends ---------------------------------------------------------------------------


def test_problem_of_each_travel_is_shown(learning: LearningDialog) -> None:
    learning.use({1: Stick(low=1500, high=1500), 2: Stick(low=1500)})
    learning.go_to_travel(1, 2)
    learning.push(1, -1)
    learning.finish_travel()
    assert "It never moved" in learning.problem(1)
    assert "It went one way only" in learning.problem(2)
    assert "Nothing was learned" in learning.head
    assert not learning.can_click("learnUseButton")
    tip = learning.button("learnUseButton").toolTip()
    assert tip == "Nothing was learned, so there are no values to use."
    learning.assert_nothing_changed()


def test_ends_are_marked_when_they_are_reached(learning: LearningDialog) -> None:
    learning.use({1: Stick(), 3: THROTTLE})
    learning.go_to_travel(1, 3)
    learning.hold()
    low, high = (learning.find(QWidget, f"learnEnd{end}1") for end in ("Down", "Up"))
    assert low.isVisible()
    assert high.isVisible()
    assert low.accessibleName() == "low end: not reached yet"
    assert list(learning.bar(1).marks) == ["neutral"]

    places = low.x(), high.x()
    learning.push(1)
    learning.wait_for_text("learnTravel1", "High end reached")
    assert high.accessibleName() == "high end: reached"
    assert low.accessibleName() == "low end: not reached yet"
    assert list(learning.bar(1).marks) == ["neutral", "max"]
    assert (low.x(), high.x()) == places
    low_end_of_throttle = learning.find(QWidget, "learnEndDown3")
    assert low_end_of_throttle.accessibleName() == "low end: not needed"
    assert list(learning.bar(3).marks) == ["neutral", "max"]

    learning.push(-1)
    learning.wait_for_text("learnTravel1", "Both ends reached")
    assert list(learning.bar(1).marks) == ["min", "neutral", "max"]
    learning.click("learnBackButton")
    learning.wait_for_head("Release every stick")


def test_buttons_say_what_they_do_in_each_step(learning: LearningDialog) -> None:
    learning.use({1: Stick(), 2: Stick(connected=False)})
    again, take = learning.button("learnAgainButton"), learning.button("learnUseButton")
    learning.start_learning(1, 2)
    assert not again.isVisible()
    bars = learning.find_all(QProgressBar)
    assert not [bar for bar in bars if bar.isVisible()]

    learning.click("learnNextButton")
    learning.wait_for_head("Not every channel is at rest")
    assert again.text() == "Sample &again"
    learning.sample_rest()
    assert again.text() == "&Forget these ends"
    assert "rest positions are kept" in again.toolTip()

    learning.push(1, -1)
    learning.finish_travel()
    assert again.text() == "&Start over"
    assert again.toolTip()
    assert "Nothing is written yet" in take.toolTip()
    learning.find(QCheckBox, "learnInclude1").click()
    learning.wait_for_head("No channel is selected")
    assert not take.isEnabled()
    assert take.toolTip() == "No channel is selected."


def test_slow_line_needs_ends_to_be_held(simulator: SimulatedDevice, qtbot: QtBot) -> None:
    simulator.do("eeprom uart_settings 0")
    simulator.do("power cycle")
    with learning_dialog(simulator, qtbot, LineSettings(1200)) as learning:
        learning.use({1: Stick()})
        learning.go_to_travel(1)
        learning.wait_for_head("this line (1200 baud) carries only")
        assert "Hold each end until its check mark appears" in learning.head


def test_joystick_is_learned_in_volts(quick_simulator: SimulatedDevice, qtbot: QtBot) -> None:
    quick_simulator.do("eeprom channel_input_source 1")
    quick_simulator.do("power cycle")
    with learning_dialog(quick_simulator, qtbot) as learning:
        source = InputSource.ANALOG
        assert learning.device.calibrations.source is source
        learning.use({1: Stick(rest=2.45, low=0.6, high=4.4, noise=0.01, source=source)})
        quick_simulator.do("channel 2 silent")
        learning.hold()
        learning.go_to_review(1, 2)
        assert learning.problem(1) == ""
        problem = learning.problem(2)
        assert "Nothing moves on this input: it stays at 0.00 V" in problem
        assert "Either nothing is connected to it" in problem
        assert "or what is connected was not moved" in problem

        learning.use_and_apply()
        learning.assert_learned(1)
        learning.wait_for_head("Push every stick")
        assert learning.stored()["learned"]["analog"] == 1


# --- The review -------------------------------------------------------------------------


def test_review_compares_values_with_stored_ones(learning: LearningDialog) -> None:
    """What is only edited counts as neither."""
    device = learning.device
    stored = device.calibrations.stored(1)
    assert stored is not None
    device.calibrations.edit(1, replace(stored, neutral=3900))
    for key, value in {
        "reversed_channels": 1,
        "serial_timeout": 9,
        "motor1_acceleration": 9,
    }.items():
        device.parameters.edit(key, value)
    learning.use({1: Stick(rest=1520), 2: Stick(forward_is_down=True)})
    learning.go_to_review(1, 2)
    texts = [label.text() for label in learning.find_all(QLabel)]
    assert any("was 1500 µs (3750)" in text for text in texts)
    assert texts.count("was not reversed") == 2
    assert "This replaces a pending edit" in learning.text("learnReasons1")
    edits = learning.text("learnEarlierEdits")
    assert edits == "2 earlier pending edits will be written, too."

    assert "so that full output is reliably reached" in learning.text("learnCommonReasons")
    for channel in (1, 2):
        assert "reliably reached" not in learning.text(f"learnReasons{channel}")
        assert "exactly the same place" not in learning.text(f"learnReasons{channel}")
    reversal = learning.find(QLabel, "learnReversal2")
    assert "reversed is suggested" in reversal.text()
    assert reversal.font().bold()
    assert learning.stored() == learning.stored_before


def test_review_shows_the_curve_before_and_after(learning: LearningDialog) -> None:
    learning.use({1: Stick(), 2: Stick(rest=1480, low=1050, high=1950, forward_is_down=True)})
    learning.go_to_review(1, 2)
    plot = learning.find(CurvePlot, "learnCurve")

    def shown() -> ChannelCurve:
        assert plot.curve is not None
        return plot.curve

    assert not shown().reversed_
    assert learning.text("learnReversal1") == ""
    learning.find(QTabBar, "learnChannelTabs").setCurrentIndex(1)
    assert shown().reversed_
    assert shown().calibration.neutral == 3700
    assert learning.text("learnCurveBefore") == "as it was"

    learning.transmitter.put(2, -1)
    learning.wait(lambda: plot.dot == (4875, -127))
    assert "output proposed −127, as it was +113" in learning.text("learnCurveLive")

    maximum = learning.find(QSpinBox, "learnMaximumEdit2")
    maximum.setValue(4700)
    assert shown().calibration.maximum == 4700
    plot.edited.emit(replace(shown().calibration, maximum=4600))
    assert maximum.value() == 4600
    learning.button("learnReversed2").click()
    assert not shown().reversed_

    maximum.setValue(3000)  # which the board would not take
    learning.wait(lambda: plot.curve is None)
    learning.wait_for_head("would reject the values of channel 2")
    learning.assert_nothing_changed()


# --- Low screens ------------------------------------------------------------------------


def test_every_step_fits_a_low_screen(learning: LearningDialog) -> None:
    """With a font of twice the size, too."""
    learning.use({channel: Stick() for channel in CHANNELS})

    def assert_fits(step: str) -> None:
        least = learning.dialog.minimumSizeHint()
        assert least.width() <= 900, (step, factor)
        assert least.height() <= 480, (step, factor)

    for factor in (1, 2):
        learning.scale_font(factor)
        learning.start_learning(*CHANNELS)
        assert_fits("rest")
        learning.sample_rest()
        assert_fits("travel")
        learning.push(1, -1)
        learning.finish_travel()
        assert_fits("review")
        learning.click("learnCancelButton")
        learning.start_test(*CHANNELS)
        assert_fits("test")
        learning.dialog.resize(900, 480)
        learning.push(1, -1)
        boxes = learning.find_all(ScrollBox)
        assert [box.isVisible() for box in boxes] == [True]
        learning.click("learnCancelButton")


def test_whole_row_is_visible_on_the_lowest_screen(learning: LearningDialog) -> None:
    """With a font of twice the size, too."""
    dialog = learning.dialog
    learning.use({channel: Stick(connected=False) for channel in CHANNELS})
    for factor in (1, 2):
        learning.scale_font(factor)
        learning.start_learning(*CHANNELS)
        learning.click("learnNextButton")
        learning.wait_for_head("No channel is at rest")
        for width in (dialog.minimumSizeHint().width(), 900):
            dialog.resize(width, dialog.minimumSizeHint().height())
            assert_whole = partial(assert_rows_are_whole, learning, factor, width)
            learning.qtbot.waitUntil(assert_whole, timeout=1000)  # the layout settles
        learning.click("learnCancelButton")


def assert_rows_are_whole(learning: LearningDialog, factor: int, width: int) -> None:
    case = f"font {factor} times, {width} pixels wide"
    box = learning.find_only(ScrollBox)
    page = box.widget()
    assert isinstance(page, ChannelRows)
    for bar in WidgetDriver(page, learning.qtbot).find_all(ChannelBar):
        assert bar.height() >= bar.sizeHint().height(), case
    below = 0
    for channel in CHANNELS:
        bar, problem = learning.bar(channel), learning.find(Note, f"learnProblem{channel}")
        assert problem.text(), case
        assert problem.height() >= problem.heightForWidth(problem.width()), case
        assert problem.x() + problem.contentsMargins().left() == bar.x() + bar.inset, case
        assert bar.y() >= below, case
        below = problem.geometry().bottom()
    words, first = learning.find(QLabel, "learnNeutral1"), learning.find(Note, "learnProblem1")
    seen = box.viewport().height()
    assert words.mapTo(page, words.rect().bottomLeft()).y() < seen, case
    assert width < 900 or first.geometry().bottom() < seen, case


# --- Stops and lost lines ---------------------------------------------------------------


def test_current_after_the_stop_has_to_be_checked(learning: LearningDialog) -> None:
    learning.simulator.do("current 1 4.5")  # as another controller on the line would have it
    learning.dialog.learn((1,))
    learning.wait_for_head("but motor 1 draws 4.5 A. Check the motors")
    assert learning.button("learnNextButton").text() == "The motors are stopped: co&ntinue"
    assert not learning.can_click("learnUseButton")

    learning.simulator.do("current 1 auto")
    learning.click("learnAgainButton")
    assert "Stopping the motors" in learning.head
    learning.wait_for_head("Release every stick")
    assert learning.button("learnNextButton").text() == "&Next"


def test_unplugging_ends_each_step_and_changes_nothing(learning: LearningDialog) -> None:
    learning.use({1: Stick(rest=1523, low=1090, high=1905, noise=2, lost=0.02)})
    settings = learning.device.settings
    assert settings is not None
    for step, reason in (
        (learning.start_learning, "The connection to the board was lost. Nothing was changed"),
        (learning.go_to_travel, "The connection to the board was lost. Nothing was changed"),
        (learning.go_to_review, "The connection to the board was lost. Nothing was changed"),
        (learning.start_test, "The connection to the board was lost. The test has ended"),
    ):
        step(1)
        learning.simulator.do("line unplug")
        learning.wait_for_head(reason)
        assert not learning.can_click("learnUseButton"), step
        assert not learning.can_click("learnNextButton"), step
        learning.click("learnAgainButton")
        learning.wait_for_head("Connect to a board first")
        learning.click("learnCancelButton")
        assert not learning.dialog.isVisible()
        learning.assert_nothing_changed()

        learning.simulator.do("line plug")
        learning.device.connect_to(settings)
        learning.wait(lambda: learning.device.link is ConnectionState.CONNECTED)


# --- The test of the sticks ------------------------------------------------------------


def test_stick_test_says_what_holds_the_motors(learning: LearningDialog) -> None:
    learning.use({1: Stick()})
    learning.simulator.do("channel 2 1600us")
    learning.start_test(1)
    learning.push(1, -1)
    learning.wait_for_text("learnTest1", "Good.")
    learning.wait_for_head("The tested channels are good. But in RC mode the motors would not")
    assert "Channel 2 is " in learning.head
    note = learning.find(Note, "learnSafeStart")
    assert "would hold the motors now. Channel 2 is " in note.text()
    assert note.palette().color(note.foregroundRole()) == theme().color("warning")

    learning.simulator.do("channel 2 1500us")
    learning.wait_for_head("Everything is as it should be.")
    assert "would release the motors" in note.text()
    assert note.palette().color(note.foregroundRole()) == theme().color("window_text")

    learning.transmitter.put(1, 0.3)
    learning.wait_for_text("learnTest1", "Release it: at rest the output must be 0")
    learning.wait_for_head("Push every stick")
    learning.simulator.do("channel 1 silent")
    learning.wait_for_text("learnTest1", "No signal.")
    assert "Everything" not in learning.head
    learning.assert_nothing_changed()


def test_channel_failing_the_test_can_be_learned_again(learning: LearningDialog) -> None:
    learning.use({1: Stick(rest=1600), 2: Stick(low=1050, high=2010)})
    learning.start_test(1, 2)
    learning.push(1, -1)
    learning.wait_for_text("learnTest1", "at rest the output must be 0")
    learning.wait_for_text("learnSafeStart", "Channel 1 is ")
    assert learning.text("learnTest2") == "Full output not reached yet: reverse (−127)."

    learning.use({1: Stick(), 2: Stick(low=1050, high=2010)})
    learning.push(1, -1)
    learning.wait_for_text("learnTest1", "Good.")
    assert learning.button("learnChannelAgainButton").text() == "&Learn channel 2 again"
    learning.click("learnChannelAgainButton")
    learning.wait_for_head("Release every stick")
    bars = learning.find_all(ChannelBar)
    assert [bar.accessibleName()[-1] for bar in bars] == ["2"]


def test_stick_test_does_not_start_while_motors_are_armed(learning: LearningDialog) -> None:
    motors = learning.device.motors
    learning.use({1: Stick()})
    for deadband in (80, 90):
        learning.go_to_review(1)
        learning.set_value("Deadband", 1, deadband)
        learning.click("learnUseButton")
        motors.arm()
        motors.set_speed(1, 40)
        learning.apply()
        learning.wait_for_head("The test does not start by itself")
        assert learning.dialog.isVisible()
        assert not learning.can_click("learnAgainButton")
        assert motors.armed
        if deadband == 80:
            learning.click("learnCancelButton")
            assert not learning.dialog.isVisible()
            assert motors.armed

    learning.click("learnTestButton")
    learning.wait_for_head("Push every stick")
    assert not motors.armed


def test_stick_test_continues_after_a_short_power_cycle(learning: LearningDialog) -> None:
    """The cycle is too short for the program to miss the board."""
    sticks = {1: Stick(), 2: Stick(), 3: Stick()}
    learning.use(sticks)
    learning.start_test(*sticks)
    learning.simulator.do("power cycle")
    learning.push(1, -1)
    for channel in sticks:
        learning.wait_for_text(f"learnTest{channel}", "Good.")
    assert learning.device.link is ConnectionState.CONNECTED
    learning.assert_nothing_changed()
