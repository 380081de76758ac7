"""Learning dialog in a window of its own, with a simulated board."""

from collections.abc import Callable, Iterator
from dataclasses import replace

import pytest
from PySide6.QtWidgets import QCheckBox, QLabel, QSpinBox, QTabBar, QWidget
from pytestqt.qtbot import QtBot

from tests.support.pages.learning import LearningDialog, learning_dialog
from tests.support.simulator import SimulatedDevice
from tests.support.transmitter import Stick
from trex_gui.devices.trex.calibration.channel_curve import ChannelCurve
from trex_gui.devices.trex.protocol.flags import CHANNELS
from trex_gui.devices.trex.views.pages.channels.curve_plot import CurvePlot
from trex_gui.ui.devices.connection import ConnectionState
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
    assert "After release the stick rests at 1500 µs, not at 1600 µs" in learning.problem(1)
    assert learning.button("learnUseRest1").text() == "Use 1500 µs &as neutral"

    learning.click("learnUseRest1")
    assert learning.problem(1) == ""
    assert not learning.has("learnUseRest1")
    learning.click("learnNextButton")
    learning.apply()
    learning.assert_learned(1)


# --- The ends ---------------------------------------------------------------------------


def test_ends_are_marked_when_they_are_reached(learning: LearningDialog) -> None:
    learning.use({1: Stick(), 3: THROTTLE})
    learning.go_to_travel(1, 3)
    learning.hold()
    low, high = (learning.find(QWidget, f"learnEnd{end}1") for end in ("Down", "Up"))
    assert low.isVisible()
    assert high.isVisible()
    assert low.toolTip() == "low end: not reached yet"

    positions = low.x(), high.x()
    learning.push(1)
    learning.wait(lambda: high.toolTip() == "high end: reached")
    assert low.toolTip() == "low end: not reached yet"
    assert (low.x(), high.x()) == positions
    assert learning.find(QWidget, "learnEndDown3").toolTip() == "low end: not needed"

    learning.push(-1)
    learning.wait(lambda: low.toolTip() == "low end: reached")
    learning.click("learnBackButton")
    learning.wait_for_note("Release every stick")


def test_button_texts_follow_the_step(learning: LearningDialog) -> None:
    learning.use({1: Stick(), 2: Stick(connected=False)})
    again, next_button = learning.button("learnAgainButton"), learning.button("learnNextButton")
    learning.start_learning(1, 2)
    assert not again.isVisible()

    learning.click("learnNextButton")
    learning.wait_for_note("Not every channel is at rest")
    assert again.text() == "Sample &again"
    learning.sample_rest()
    assert again.text() == "Start this step &again"
    learning.push(1, -1)
    learning.finish_travel()
    assert again.text() == "&Start over"
    assert "Nothing has been written yet" in learning.note
    learning.find(QCheckBox, "learnInclude1").click()
    learning.wait_for_note("No channel is selected")
    assert not next_button.isEnabled()


# --- The review -------------------------------------------------------------------------


def test_review_compares_learned_with_stored_values(learning: LearningDialog) -> None:
    """The comparison ignores pending edits."""
    device = learning.device
    stored = device.calibrations.stored(1)
    assert stored is not None
    device.calibrations.edit(1, replace(stored, neutral=3900))
    edits = {"reversed_channels": 1, "serial_timeout": 9, "motor1_acceleration": 9}
    for key, value in edits.items():
        device.parameters.edit(key, value)
    learning.use({1: Stick(rest=1520), 2: Stick(forward_is_down=True)})
    learning.go_to_review(1, 2)
    texts = [label.text() for label in learning.find_all(QLabel)]
    assert any("was 1500 µs (3750)" in text for text in texts)
    assert texts.count("was not reversed") == 2
    assert "This replaces a pending edit" in learning.text("learnReasons1")
    notice = learning.text("learnEarlierEdits")
    assert notice == "2 earlier pending edits will also be written."

    assert "so that full output is reliably reached" in learning.text("learnCommonReasons")
    for channel in (1, 2):
        assert "reliably reached" not in learning.text(f"learnReasons{channel}")
        assert "exactly the same place" not in learning.text(f"learnReasons{channel}")
    reversal = learning.find(QLabel, "learnReversal2")
    assert "the channel should be reversed" in reversal.text()
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
    learning.assert_nothing_changed()


# --- Low screens ------------------------------------------------------------------------


def test_every_step_fits_a_low_screen(learning: LearningDialog) -> None:
    learning.use({channel: Stick() for channel in CHANNELS})

    def assert_fits(step: str) -> None:
        for factor in (2, 0.5):
            minimum = learning.dialog.minimumSizeHint()
            assert minimum.width() <= 900, step
            assert minimum.height() <= 480, step
            learning.scale_font(factor)

    learning.start_learning(*CHANNELS)
    assert_fits("rest")
    learning.sample_rest()
    assert_fits("travel")
    learning.push(1, -1)
    learning.finish_travel()
    assert_fits("review")
    learning.click("learnCloseButton")
    learning.start_test(*CHANNELS)
    assert_fits("test")
    learning.dialog.resize(900, 480)
    for factor in (2, 0.5):
        learning.push(1, -1)
        boxes = learning.find_all(ScrollBox)
        assert [box.isVisible() for box in boxes] == [True]
        learning.scale_font(factor)


# --- Stops and lost lines ---------------------------------------------------------------


def test_unplugging_ends_learning_and_test_and_changes_nothing(learning: LearningDialog) -> None:
    learning.use({1: Stick()})
    settings = learning.device.settings
    assert settings is not None
    for step, outcome in (
        (learning.start_learning, "Nothing was changed"),
        (learning.start_test, "The test has ended"),
    ):
        step(1)
        learning.simulator.do("line unplug")
        learning.wait_for_note(f"The connection was closed. {outcome}")
        assert not learning.can_click("learnNextButton"), step
        learning.click("learnAgainButton")
        learning.wait_for_note("Connect to a board first")
        learning.click("learnCloseButton")
        assert not learning.dialog.isVisible()
        learning.assert_nothing_changed()

        learning.simulator.do("line plug")
        learning.device.connect_to(settings)
        learning.wait(lambda: learning.device.link is ConnectionState.CONNECTED)


def test_learning_can_be_cancelled_in_each_step(learning: LearningDialog) -> None:
    learning.use({1: Stick()})
    assert not learning.dialog.isModal()
    cases: tuple[tuple[Callable[[int], None], Callable[[], object]], ...] = (
        (learning.start_learning, lambda: learning.click("learnCloseButton")),
        (learning.go_to_travel, learning.dialog.close),
        (learning.go_to_review, learning.press_escape),
    )
    for step, cancel in cases:
        step(1)
        cancel()
        assert not learning.dialog.isVisible(), step
        learning.assert_nothing_changed()
        assert learning.device.writer.history.snapshots() == ()


# --- Stick test -------------------------------------------------------------------------


def test_stick_test_continues_after_a_short_power_cycle(learning: LearningDialog) -> None:
    """The power cycle is too short to be detected."""
    sticks = {1: Stick(), 2: Stick(), 3: Stick()}
    learning.use(sticks)
    learning.start_test(*sticks)
    learning.simulator.do("power cycle")
    learning.push(1, -1)
    for channel in sticks:
        learning.wait_for_text(f"learnTest{channel}", "Good.")
    assert learning.device.link is ConnectionState.CONNECTED
    learning.assert_nothing_changed()
