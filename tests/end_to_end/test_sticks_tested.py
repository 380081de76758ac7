"""What a person reads and can press in the wizard: in the test of the sticks and before it."""

import sys

import pytest
from PySide6.QtWidgets import QCheckBox, QLabel, QProgressBar, QWidget
from pytestqt.qtbot import QtBot

from tests.end_to_end.test_learning_channels import Wizard
from tests.support.people import Stick
from tests.support.simulator import SimulatedDevice
from trex_gui.views.learning.channel_rows import ChannelRows
from trex_gui.views.learning.dialog import LearnDialog
from trex_gui.views.theme import theme
from trex_gui.views.widgets.channel_bar import ChannelBar
from trex_gui.views.widgets.note import Note
from trex_gui.views.widgets.scroll_box import ScrollBox
from trex_gui.window import Program

pytestmark = [
    pytest.mark.skipif(sys.platform == "win32", reason="needs pseudo-terminals"),
    pytest.mark.timeout(240),
]


@pytest.fixture
def wizard(program: Program, quick_simulator: SimulatedDevice, qtbot: QtBot) -> Wizard:
    return Wizard(program, quick_simulator, qtbot)


def begin_test(wizard: Wizard, *channels: int) -> None:
    """Learn, take and write; the test of these channels follows."""
    wizard.to_review(*channels)
    wizard.take_and_write()
    wizard.until_text("learnHead", "Push every stick")


def bar_of(wizard: Wizard, channel: int) -> ChannelBar:
    bars = wizard.dialog.findChildren(ChannelBar)
    return next(bar for bar in bars if bar.accessibleName().endswith(f"channel {channel}"))


def end_of(wizard: Wizard, way: str, channel: int) -> QWidget:
    found = wizard.dialog.findChild(QWidget, f"learnEnd{way}{channel}")
    assert found is not None
    return found


# --- The test ---------------------------------------------------------------------------


def test_a_channel_outside_the_test_that_holds_the_motors_stands_in_the_head(
    wizard: Wizard,
) -> None:
    wizard.sit_down({1: Stick()})
    wizard.simulator.do("channel 2 1600us")
    begin_test(wizard, 1)
    wizard.push(1, -1)
    wizard.until_text("learnTest1", "Good.")
    wizard.until_text("learnHead", "What was tested is good. But in RC mode the motors would not")
    assert "channel 2 gives +" in wizard.text("learnHead")
    note = wizard.dialog.findChild(Note, "learnSafeStart")
    assert note is not None
    assert "would hold the motors now: channel 2 gives +" in note.text()
    assert note.palette().color(note.foregroundRole()) == theme().color("warning")
    wizard.simulator.do("channel 2 1500us")
    wizard.until_text("learnHead", "Everything is as it should be.")
    assert note.palette().color(note.foregroundRole()) == theme().color("window_text")


def test_a_signal_that_is_lost_after_the_test_takes_back_that_all_is_good(wizard: Wizard) -> None:
    wizard.sit_down({1: Stick()})
    begin_test(wizard, 1)
    wizard.push(1, -1)
    wizard.until_text("learnHead", "Everything is as it should be.")
    wizard.person.put(1, 0.3)
    wizard.until_text("learnTest1", "Let go: at rest it must give 0")
    wizard.until_text("learnHead", "Push every stick")
    wizard.simulator.do("channel 1 silent")
    wizard.until_text("learnTest1", "No signal comes in.")
    assert "Everything" not in wizard.text("learnHead")


def test_a_test_of_an_ignored_channel_says_that_there_is_nothing_to_test(wizard: Wizard) -> None:
    wizard.device.parameters.edit("ignored_channels", 0b1)
    wizard.device.apply()
    wizard.wait(lambda: wizard.device.pending == 0 and not wizard.device.applying)
    dialog = wizard.dialog
    assert isinstance(dialog, LearnDialog)
    dialog.test((1,))
    wizard.until_text("learnTest1", "Ignored: the board holds it at neutral.")
    wizard.until_text("learnHead", "There is nothing to test")


def test_a_channel_that_fails_the_test_can_be_learned_again_from_there(wizard: Wizard) -> None:
    wizard.sit_down({1: Stick(), 2: Stick(low=1200)})
    wizard.choose("test_sticks")
    wizard.until_text("learnHead", "Push every stick")
    wizard.push(1, -1)
    wizard.until_text("learnTest1", "Good.")
    assert wizard.button("learnChannelAgainButton").text() == "Learn channel 2 again"
    wizard.press("learnChannelAgainButton")
    wizard.until_text("learnHead", "Let go of every stick")
    assert {bar.accessibleName()[-1] for bar in wizard.dialog.findChildren(ChannelBar)} == {"2"}


def test_while_the_motors_are_armed_a_test_is_only_offered(wizard: Wizard) -> None:
    wizard.sit_down({1: Stick()})
    wizard.to_review(1)
    wizard.press("learnTakeButton")
    motors = wizard.device.motors
    motors.arm()
    motors.set_speed(1, 40)
    wizard.press("writeButton")
    wizard.until_text("learnHead", "The test does not start by itself")
    assert motors.armed
    assert wizard.dialog.isVisible()
    assert not wizard.can_press("learnAgainButton")
    wizard.press("learnTestButton")
    wizard.until_text("learnHead", "Push every stick")
    assert not motors.armed


def test_an_offered_test_that_is_not_wanted_is_closed_and_the_motors_go_on(wizard: Wizard) -> None:
    wizard.sit_down({1: Stick()})
    wizard.to_review(1)
    wizard.press("learnTakeButton")
    wizard.device.motors.arm()
    wizard.press("writeButton")
    wizard.until_text("learnHead", "The test does not start by itself")
    wizard.press("learnCancelButton")
    assert not wizard.dialog.isVisible()
    assert wizard.device.motors.armed
    wizard.device.motors.stop()


# --- The steps before -------------------------------------------------------------------


def test_asking_for_learning_again_keeps_what_is_under_review(wizard: Wizard) -> None:
    wizard.sit_down({1: Stick()})
    wizard.to_review(1)
    wizard.begin(1)
    wizard.qtbot.wait(50)
    assert wizard.can_press("learnTakeButton")
    wizard.choose("learn")
    wizard.qtbot.wait(50)
    assert wizard.can_press("learnTakeButton")
    wizard.choose("test_sticks")
    wizard.qtbot.wait(50)
    assert wizard.can_press("learnTakeButton")
    wizard.assert_nothing_changed()


def test_ends_are_named_before_they_are_reached_and_marked_only_then(wizard: Wizard) -> None:
    wizard.sit_down({1: Stick(), 3: Stick(rest=1100, low=1100, high=1900)})
    wizard.to_travel(1, 3)
    wizard.hold()
    low, high = end_of(wizard, "Down", 1), end_of(wizard, "Up", 1)
    assert low.isVisible()
    assert high.isVisible()
    assert low.accessibleName() == "low end: not reached yet"
    assert list(bar_of(wizard, 1).marks) == ["neutral"]
    places = low.x(), high.x()
    wizard.push(1)
    wizard.until_text("learnTravel1", "High end reached")
    assert high.accessibleName() == "high end: reached"
    assert low.accessibleName() == "low end: not reached yet"
    assert list(bar_of(wizard, 1).marks) == ["neutral", "max"]
    assert (low.x(), high.x()) == places
    assert end_of(wizard, "Down", 3).accessibleName() == "low end: not needed"
    assert list(bar_of(wizard, 3).marks) == ["neutral", "max"]
    wizard.push(-1)
    wizard.until_text("learnTravel1", "Both ends reached")
    assert list(bar_of(wizard, 1).marks) == ["min", "neutral", "max"]


def test_no_empty_bar_of_progress_stands_about(wizard: Wizard) -> None:
    wizard.to_rest(1)
    assert not [bar for bar in wizard.dialog.findChildren(QProgressBar) if bar.isVisible()]


def test_what_again_would_do_is_named_for_each_step(wizard: Wizard) -> None:
    wizard.sit_down({1: Stick(), 2: Stick(connected=False)})
    again = wizard.button("learnAgainButton")
    wizard.to_rest(1, 2)
    assert not again.isVisible()
    wizard.press("learnNextButton")
    wizard.until_text("learnHead", "Not every channel rests")
    assert again.text() == "Sample again"
    wizard.press("learnNextButton")
    wizard.until_text("learnHead", "forward or right first")
    assert again.text() == "Forget these ends"
    assert "rest positions are kept" in again.toolTip()
    wizard.push(1, -1)
    wizard.press("learnNextButton")
    wizard.wait(lambda: wizard.button("learnTakeButton").isVisible())
    assert again.text() == "Start over"
    assert again.toolTip()


def test_values_that_cannot_be_taken_say_why(wizard: Wizard) -> None:
    wizard.sit_down({1: Stick()})
    wizard.to_review(1)
    take = wizard.button("learnTakeButton")
    assert "Nothing is written yet" in take.toolTip()
    box = wizard.dialog.findChild(QCheckBox, "learnInclude1")
    assert box is not None
    box.click()
    wizard.until_text("learnHead", "No channel is ticked")
    assert not take.isEnabled()
    assert take.toolTip() == "No channel is ticked."
    wizard.press("learnBackButton")
    wizard.until_text("learnHead", "forward or right first")
    wizard.press("learnAgainButton")
    wizard.hold()
    wizard.press("learnNextButton")
    wizard.until_text("learnHead", "Nothing was learned")
    assert take.toolTip() == "Nothing was learned, so there is nothing to take."


@pytest.mark.parametrize("factor", [1.0, 2.0])
def test_on_the_lowest_screen_a_whole_row_is_in_sight_and_nothing_is_cut(
    wizard: Wizard, factor: float
) -> None:
    dialog = wizard.dialog
    font = dialog.font()
    font.setPointSizeF(font.pointSizeF() * factor)
    dialog.setFont(font)
    wizard.sit_down({channel: Stick(connected=False) for channel in range(1, 6)})
    wizard.to_rest(1, 2, 3, 4, 5)
    wizard.press("learnNextButton")
    wizard.until_text("learnHead", "No channel rests")
    for width in (dialog.minimumSizeHint().width(), 900):
        dialog.resize(width, dialog.minimumSizeHint().height())
        wizard.qtbot.wait(50)
        (box,) = dialog.findChildren(ScrollBox)
        page = box.widget()
        assert isinstance(page, ChannelRows)
        for bar in page.findChildren(ChannelBar):
            assert bar.height() >= bar.sizeHint().height()
        below = None
        for channel in range(1, 6):
            bar, problem = bar_of(wizard, channel), page.findChild(Note, f"learnProblem{channel}")
            assert problem is not None
            assert problem.text()
            assert problem.height() >= problem.heightForWidth(problem.width())
            assert problem.x() + problem.contentsMargins().left() == bar.x() + bar.inset
            assert below is None or bar.y() >= below
            below = problem.geometry().bottom()
        words = page.findChild(QLabel, "learnNeutral1")
        first = page.findChild(Note, "learnProblem1")
        assert words is not None
        assert first is not None
        seen = box.viewport().height()
        assert words.mapTo(page, words.rect().bottomLeft()).y() < seen
        assert width < 900 or first.geometry().bottom() < seen
