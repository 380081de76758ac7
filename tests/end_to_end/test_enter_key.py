"""Enter and Space press the button that has the focus, in every window."""

from collections.abc import Iterable
from contextlib import nullcontext
from pathlib import Path

import pytest
from PySide6.QtCore import QCoreApplication, QSignalBlocker, Qt, SignalInstance
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QAbstractButton, QDialog, QWidget

from tests.support.pages.every_dialog import every_aracna_window, every_trex_window
from tests.support.window import WindowDriver
from trex_gui.ui.widgets.builders import RedButton

ENTER, SPACE = Qt.Key.Key_Return, Qt.Key.Key_Space


FOCUSED = {
    # The primary button.
    "aboutBox": "OK",
    "armDialog": "writeAndArmButton",
    "convertDialog": "convertButton",
    "defaultsDialog": "takeDefaultsButton",  # reviewed before it is written
    "findDialog": "findStartButton",
    "learnDialog": "learnNextButton",
    "lineSettingsDialog": "OK",
    "loadSettingsDialog": "takeChangesButton",
    "reportDialog": "reportSave",
    "reviewDialog": "writeButton",
    "setupDialog": "setupNextButton",
    # The safe one.
    "benchDialog": "benchStopButton",
    "compareDialog": "closeCompareButton",
    "gamepadDialog": "gamepadCloseButton",
    "powerCycleDialog": "powerCycleCloseButton",
    "preferencesDialog": "preferencesClose",
    # What has to be typed, selected or read first.
    "helpDialog": "helpText",
    "historyDialog": "snapshotSearch",
    "newSettingsDialog": "beginningsList",
    "numberDialog": "newNumberField",
    "wireDialog": "wireField",
    # The first control: the primary button is disabled at the board of this test.
    "applyToBoardsDialog": "boardsToWrite",
    "checkBoardDialog": "qt_tabwidget_tabbar",
}
"""What has the focus in each dialog when it opens."""


def name_of(widget: QWidget | None) -> str:
    text = widget.text() if isinstance(widget, QAbstractButton) else ""
    return (widget.objectName() if widget is not None else "") or text.replace("&", "")


class Walk:
    """Presses each button once with either key; only red ones act.

    Attributes:
        pressed: the buttons, also of windows that were closed since.
        deaf: buttons that a key does not press, or that do not stop, with their window.
        focused: what has the focus in a dialog when it opens, by the name of the dialog.
    """

    def __init__(self, stopped: SignalInstance) -> None:
        """`stopped` is emitted at each stop."""
        self.pressed: set[QAbstractButton] = set()
        self.deaf: list[str] = []
        self.focused: dict[str, str] = {}
        self._stops = 0
        stopped.connect(self._count_stop)

    def _count_stop(self) -> None:
        self._stops += 1

    def through(self, windows: Iterable[QWidget]) -> None:
        for window in windows:
            window.activateWindow()
            QCoreApplication.processEvents()
            if isinstance(window, QDialog) and window.objectName() not in self.focused:
                self.focused[window.objectName()] = name_of(window.focusWidget())
            for button in window.findChildren(QAbstractButton):
                if button.window() is window and self._is_new(button):
                    self._press(button)

    def _is_new(self, button: QAbstractButton) -> bool:
        return (
            button not in self.pressed
            and button.isVisible()
            and button.isEnabled()
            and bool(button.focusPolicy() & Qt.FocusPolicy.TabFocus)
        )

    def _press(self, button: QAbstractButton) -> None:
        self.pressed.add(button)
        is_red = isinstance(button, RedButton)
        with nullcontext() if is_red else QSignalBlocker(button):
            button.setFocus()
            for key in (ENTER, SPACE):
                before = self._stops
                QTest.keyPress(button, key)
                is_pressed = button.hasFocus() and button.isDown()
                if not is_pressed or self._stops != before + is_red:
                    where = button.window().objectName()
                    self.deaf.append(f"{where}: {name_of(button)} {key.name}")
                button.setDown(False)
                QTest.keyRelease(button, key)


def test_enter_and_space_press_every_button_with_the_focus(
    window: WindowDriver, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    walk = Walk(window.motors.stop_requested)
    walk.through(every_trex_window(window, tmp_path, monkeypatch))
    assert walk.deaf == []
    assert len(walk.pressed) >= 170
    assert walk.focused == FOCUSED


def test_enter_and_space_press_every_button_of_an_aracna(
    window: WindowDriver, tmp_path: Path
) -> None:
    walk = Walk(window.robot.halted)
    walk.through(every_aracna_window(window, tmp_path))
    assert walk.deaf == []
    assert len(walk.pressed) >= 50


def test_board_reset_needs_a_press_of_its_own(connected_window: WindowDriver) -> None:
    connected_window.trigger("defaults")
    dialog = connected_window.dialog("defaultsDialog")
    dialog.root.activateWindow()
    dialog.button("boardResetButton").setFocus()
    for _ in range(2):
        QTest.keyClick(dialog.root.windowHandle(), ENTER)
    assert not dialog.root.isVisible()
    assert not connected_window.device.writer.running
    assert not connected_window.device.draft.reset_pending
