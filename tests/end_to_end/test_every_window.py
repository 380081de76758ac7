"""Every page and dialog, in a pseudo-language and by keyboard.

Finds untranslated and cut texts, windows that are too large for the screen, and focused buttons
that Enter or Space does not press.
"""

from collections.abc import Callable, Iterator
from contextlib import nullcontext
from functools import partial
from pathlib import Path

import pytest
from PySide6.QtCore import (
    QCoreApplication,
    QPoint,
    QRect,
    QSettings,
    QSignalBlocker,
    QSize,
    Qt,
    SignalInstance,
)
from PySide6.QtGui import QScreen
from PySide6.QtTest import QTest
from PySide6.QtWidgets import (
    QAbstractButton,
    QApplication,
    QCheckBox,
    QComboBox,
    QDialog,
    QGroupBox,
    QHeaderView,
    QLabel,
    QPushButton,
    QRadioButton,
    QScrollArea,
    QSpinBox,
    QTabBar,
    QTableWidget,
    QWidget,
)
from pytestqt.qtbot import QtBot

from tests.support.pages.every_dialog import every_aracna_window, every_trex_window
from tests.support.pseudo_language import (
    PseudoTranslator,
    cut_texts,
    pseudo,
    shown_texts,
    untranslated,
)
from tests.support.window import WindowDriver
from trex_gui.core.translation import use_translations
from trex_gui.ui.frame import preferences_dialog
from trex_gui.ui.theme import theme as theme_module
from trex_gui.ui.theme.theme import theme
from trex_gui.ui.translations import CONTEXT
from trex_gui.ui.widgets.behaviour import RedButton

ENTER, SPACE = Qt.Key.Key_Return, Qt.Key.Key_Space
FRAME = QSize(16, 48)

FOCUSED = {
    # The primary button.
    "armDialog": "writeAndArmButton",
    "convertDialog": "convertButton",
    "findDialog": "findStartButton",
    "learnDialog": "learnNextButton",
    "lineSettingsDialog": pseudo("OK"),
    "loadSettingsDialog": "takeChangesButton",
    "reportDialog": "reportSave",
    "reviewDialog": "writeButton",
    "setupDialog": "setupNextButton",
    # The safe button.
    "benchDialog": "benchStopButton",
    "compareDialog": "closeCompareButton",
    "gamepadDialog": "gamepadCloseButton",
    "powerCycleDialog": "powerCycleCloseButton",
    "preferencesDialog": "preferencesClose",
    # Where the user types, selects or reads first.
    "helpDialog": "helpText",
    "historyDialog": "snapshotSearch",
    "newSettingsDialog": "beginningsList",
    "numberDialog": "newNumberField",
    "provisionDialog": "provisionProfile",
    "robotsDialog": "robotsTable",
    "groupDialog": "joinBoards",
    "applyToBoardsDialog": "closeBoardsButton",  # nothing can be written in this test
    # The first control, because the primary button is disabled with this board.
    "checkDialog": "checkNextButton",
}
"""Focused widget of each dialog when it opens."""


def name_of(widget: QWidget | None) -> str:
    text = widget.text() if isinstance(widget, QAbstractButton) else ""
    return (widget.objectName() if widget is not None else "") or text.replace("&", "")


class ButtonPresser:
    """Presses each button once with each key. Only stop buttons have an effect.

    Attributes:
        pressed: pressed buttons, also of closed windows.
        failed: buttons that a key does not press, and stop buttons that do not stop.
        focused: name of each dialog → name of its focused widget when it opens.
    """

    def __init__(self, stopped: SignalInstance) -> None:
        """`stopped` is emitted at each stop."""
        self.pressed: set[QAbstractButton] = set()
        self.failed: list[str] = []
        self.focused: dict[str, str] = {}
        self._stops = 0
        stopped.connect(self._count_stop)

    def _count_stop(self) -> None:
        self._stops += 1

    def press_all(self, window: QWidget) -> None:
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
                    self.failed.append(f"{where}: {name_of(button)} {key.name}")
                button.setDown(False)
                QTest.keyRelease(button, key)


class Findings:
    """Untranslated and cut texts of the checked windows."""

    def __init__(self) -> None:
        self.untranslated: dict[str, str] = {}
        self.cut: set[str] = set()

    def check(self, window: QWidget) -> None:
        for _ in range(3):  # a layout may request another layout
            QCoreApplication.processEvents()
        for where, text in shown_texts(window):
            if part := untranslated(text):
                self.untranslated.setdefault(part, where)
        self.cut.update(f"{window.objectName()}: {cut}" for cut in cut_texts(window))
        screen, min_size = window.screen().availableGeometry(), window.minimumSizeHint() + FRAME
        if not (
            screen.contains(window.frameGeometry())
            and min_size == min_size.boundedTo(screen.size())
        ):
            self.cut.add(f"{window.objectName()}: larger than the screen, at least {min_size}")


@pytest.fixture(
    params=[(100, (1366, 728)), pytest.param((200, (3840, 2080)), marks=pytest.mark.slow)],
    ids=["100 %", "200 %"],
)
def pseudo_window(
    request: pytest.FixtureRequest, qapp: QApplication, monkeypatch: pytest.MonkeyPatch
) -> Iterator[WindowDriver]:
    """Window in the pseudo-language, with a font size and a screen size."""
    percent, screen = request.param
    available = QRect(QPoint(), QSize(*screen))
    monkeypatch.setattr(QScreen, "availableGeometry", lambda _: available)
    for module in (preferences_dialog, theme_module):
        monkeypatch.setattr(module, "FONT_SIZES", (100, 200))
    QSettings().setValue("window/font_size", percent)
    translator = PseudoTranslator()
    qapp.installTranslator(translator)
    use_translations(
        partial(QCoreApplication.translate, CONTEXT)
    )  # also clears cached English texts
    window: WindowDriver = request.getfixturevalue("window")
    assert theme().font_size == percent
    yield window
    qapp.removeTranslator(translator)
    use_translations(partial(QCoreApplication.translate, CONTEXT))


def report(findings: Findings) -> None:
    lines = [f"not translated, {where}: {text!r}" for text, where in findings.untranslated.items()]
    lines += [f"cut, {cut}" for cut in sorted(findings.cut)]
    assert not lines, "\n".join(lines)


TOO_LONG = "more text than there is space for"


def label(*, wraps: bool) -> QLabel:
    label = QLabel(TOO_LONG)
    label.setWordWrap(wraps)
    return label


def combo_box() -> QComboBox:
    box = QComboBox()
    box.addItem(TOO_LONG)
    return box


def spin_box() -> QSpinBox:
    box = QSpinBox()
    box.setSpecialValueText(TOO_LONG)
    return box


def tabs() -> QTabBar:
    bar = QTabBar()
    bar.addTab(TOO_LONG)
    bar.setUsesScrollButtons(False)
    return bar


def table() -> QTableWidget:
    table = QTableWidget(0, 1)
    table.setHorizontalHeaderLabels([TOO_LONG])
    table.horizontalHeader().setSectionResizeMode(QHeaderView.ResizeMode.Stretch)
    return table


@pytest.mark.parametrize(
    "create",
    [
        partial(label, wraps=False),
        partial(label, wraps=True),
        partial(QPushButton, TOO_LONG),
        partial(QCheckBox, TOO_LONG),
        partial(QRadioButton, TOO_LONG),
        combo_box,
        spin_box,
        partial(QGroupBox, TOO_LONG),
        tabs,
        table,
    ],
)
def test_cut_text_is_found(qtbot: QtBot, create: Callable[[], QWidget]) -> None:
    window, widget = QWidget(), create()
    qtbot.addWidget(window)
    widget.setParent(window)
    window.resize(600, 300)
    widget.resize(400, 100)
    window.show()
    QCoreApplication.processEvents()
    assert not list(cut_texts(window))
    widget.resize(60, 20)
    QCoreApplication.processEvents()
    assert any(TOO_LONG in cut for cut in cut_texts(window))
    widget.setGeometry(500, 0, 400, 100)
    QCoreApplication.processEvents()
    assert any(TOO_LONG in cut for cut in cut_texts(window))


def test_text_outside_the_viewport_of_a_page_is_found(qtbot: QtBot) -> None:
    window, area = QWidget(), QScrollArea()
    qtbot.addWidget(window)
    area.setParent(window)
    area.setWidget(label(wraps=False))
    window.resize(600, 300)
    area.resize(400, 100)
    window.show()
    QCoreApplication.processEvents()
    assert not list(cut_texts(window))
    area.resize(60, 100)
    QCoreApplication.processEvents()
    assert any("scrolls sideways" in cut for cut in cut_texts(window))
    area.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
    QCoreApplication.processEvents()
    assert any(TOO_LONG in cut for cut in cut_texts(window))


@pytest.mark.timeout(120)
def test_trex_windows_are_translated_uncut_and_work_by_keyboard(
    pseudo_window: WindowDriver, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    findings, presser = Findings(), ButtonPresser(pseudo_window.motors.stop_requested)
    for shown in every_trex_window(pseudo_window, tmp_path, monkeypatch):
        findings.check(shown)
        presser.press_all(shown)
    report(findings)
    assert presser.failed == []
    assert len(presser.pressed) >= 170
    assert presser.focused == FOCUSED


def test_aracna_windows_are_translated_uncut_and_work_by_keyboard(
    pseudo_window: WindowDriver, tmp_path: Path
) -> None:
    findings, presser = Findings(), ButtonPresser(pseudo_window.robot.halted)
    for shown in every_aracna_window(pseudo_window, tmp_path):
        findings.check(shown)
        presser.press_all(shown)
    report(findings)
    assert presser.failed == []
    assert len(presser.pressed) >= 50
