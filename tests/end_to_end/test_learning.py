"""Calibration of a simulated board's channels, by learning or by dragging.

`test_learning_dialog.py` and `test_channels_page.py` of the views show the details.
"""

from collections.abc import Callable

import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QDialog

from tests.support.keyboard import check_keyboard
from tests.support.pages.learning import LearningDialog
from tests.support.simulator import SimulatedDevice
from tests.support.transmitter import Stick
from tests.support.window import WindowDriver
from trex_gui.devices.trex.protocol.flags import CHANNELS
from trex_gui.devices.trex.views.steps import Steps


@pytest.fixture
def learning(connected_window: WindowDriver, quick_simulator: SimulatedDevice) -> LearningDialog:
    window = connected_window
    dialog = window.dialog("learnDialog").root
    assert isinstance(dialog, Steps)
    return LearningDialog(dialog, window.device, quick_simulator, window.qtbot)


def test_all_channels_are_learned_and_tested(
    connected_window: WindowDriver, learning: LearningDialog
) -> None:
    learning.use(
        {
            1: Stick(rest=1523, low=1090, high=1905, noise=2, lost=0.02),
            2: Stick(rest=1480, low=1050, high=1950, noise=1, forward_is_down=True),
            3: Stick(rest=1100, low=1100, high=1900),
            4: Stick(rest=1900, low=1100, high=1900, forward_is_down=True),
            5: Stick(rest=1100, low=1100, high=1900),
        }
    )
    connected_window.trigger("learn")
    learning.wait_for_note("Release every stick")
    check_keyboard(learning.dialog)
    learning.dialog.activateWindow()
    learning.wait(lambda: learning.button("learnNextButton").hasFocus())
    for _ in range(2):  # the first press disables Next, and must not move the focus to Cancel
        QTest.keyClick(learning.dialog.windowHandle(), Qt.Key.Key_Return)
    learning.wait_for_note("forward or right first")
    check_keyboard(learning.dialog)
    learning.push(1, -1)
    learning.finish_travel()
    check_keyboard(learning.dialog)
    boxes = [learning.button(f"learnReversed{channel}").isChecked() for channel in CHANNELS]
    assert boxes == [False, True, False, False, True]
    assert [learning.problem(channel) for channel in CHANNELS] == [""] * 5
    learning.assert_nothing_changed()

    learning.click("learnNextButton")
    assert not learning.dialog.isVisible()
    connected_window.click("writeButton")
    # The test starts automatically.
    learning.wait_for_note("Push every stick")
    check_keyboard(learning.dialog)
    assert not connected_window.find(QDialog, "reviewDialog").isVisible(), (
        "the review closes after writing"
    )
    assert learning.device.draft.pending == 0
    for channel in CHANNELS:
        learning.assert_learned(channel)
    assert learning.stored()["parameters"]["reversed_channels"] == 0b10010
    assert len(learning.device.writer.history.snapshots()) == 1

    learning.push(1, -1)
    for channel in CHANNELS:
        learning.wait_for_text(f"learnTest{channel}", "Good.")
    learning.wait_for_note("Every channel works as it should")
    learning.click("learnCloseButton")
    assert not learning.dialog.isVisible()


def test_learned_values_remain_when_the_dialog_is_reopened(
    connected_window: WindowDriver, learning: LearningDialog
) -> None:
    learning.use({1: Stick()})
    learning.go_to_review(1)
    page = connected_window.open_page("channelsPage")
    ways_to_open: dict[str, Callable[[], None]] = {
        "page": lambda: page.click("learnButton"),
        "learn": lambda: connected_window.trigger("learn"),
        "test": lambda: connected_window.trigger("test_sticks"),
    }
    for name, reopen in ways_to_open.items():
        reopen()
        learning.hold()
        assert learning.has("learnReviewPage"), name
    learning.assert_nothing_changed()
