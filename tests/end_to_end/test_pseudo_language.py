"""Every page and dialog in a longer, accented language: what is not translated, and what is cut."""

from collections.abc import Callable, Iterator
from functools import partial
from pathlib import Path

import pytest
from PySide6.QtCore import QCoreApplication, QPoint, QRect, QSettings, QSize
from PySide6.QtGui import QScreen
from PySide6.QtWidgets import (
    QApplication,
    QCheckBox,
    QComboBox,
    QDialog,
    QGroupBox,
    QHeaderView,
    QLabel,
    QPushButton,
    QRadioButton,
    QTabBar,
    QTableWidget,
    QTabWidget,
    QWidget,
)
from pytestqt.qtbot import QtBot

from tests.support.pages.every_window import WINDOWS_WITH_STOP
from tests.support.pseudo_language import PseudoTranslator, cut_texts, shown_texts, untranslated
from tests.support.window import WindowDriver
from trex_gui.core.translation import use_translations
from trex_gui.ui.runtime import runtime
from trex_gui.ui.theme.theme import theme
from trex_gui.ui.translations import CONTEXT

DIALOGS = ("learn", "test_sticks", "find", "check_board", "preferences", "report", "help")


class Findings:
    """What was found so far, each once."""

    def __init__(self) -> None:
        self.untranslated: dict[str, str] = {}
        self.cut: set[str] = set()

    def look(self, window: QWidget) -> None:
        for _ in range(3):  # a layout may ask for another one
            QCoreApplication.processEvents()
        for where, text in shown_texts(window):
            if rest := untranslated(text):
                self.untranslated.setdefault(rest, where)
        self.cut.update(f"{window.objectName()}: {cut}" for cut in cut_texts(window))

    def look_at_tabs(self, window: QWidget, tabs: QTabWidget) -> None:
        for index in range(tabs.count()):
            tabs.setCurrentIndex(index)
            runtime().sleep(0.3)
            self.look(window)


@pytest.fixture(params=[(100, (1366, 728)), (200, (3840, 2080))], ids=["100 %", "200 %"])
def pseudo_window(
    request: pytest.FixtureRequest, qapp: QApplication, monkeypatch: pytest.MonkeyPatch
) -> Iterator[WindowDriver]:
    """The window in the language of these tests, at a font size and on a screen."""
    percent, screen = request.param
    available = QRect(QPoint(), QSize(*screen))
    monkeypatch.setattr(QScreen, "availableGeometry", lambda _: available)
    monkeypatch.setattr("trex_gui.ui.theme.theme.FONT_SIZES", (100, 200))
    QSettings().setValue("window/font_size", percent)
    translator = PseudoTranslator()
    qapp.installTranslator(translator)
    use_translations(partial(QCoreApplication.translate, CONTEXT))  # forgets English texts
    window: WindowDriver = request.getfixturevalue("window")
    assert theme().font_size == percent
    yield window
    qapp.removeTranslator(translator)
    use_translations(partial(QCoreApplication.translate, CONTEXT))


def check(found: Findings) -> None:
    lines = [f"not translated, {where}: {text!r}" for text, where in found.untranslated.items()]
    lines += [f"cut, {cut}" for cut in sorted(found.cut)]
    assert not lines, "\n".join(lines)


TOO_LONG = "more than there is room for"


def label(*, wraps: bool) -> QLabel:
    made = QLabel(TOO_LONG)
    made.setWordWrap(wraps)
    return made


def group_box() -> QGroupBox:
    return QGroupBox(TOO_LONG)


def combo_box() -> QComboBox:
    made = QComboBox()
    made.addItem(TOO_LONG)
    return made


def tabs() -> QTabBar:
    made = QTabBar()
    made.addTab(TOO_LONG)
    made.setUsesScrollButtons(False)
    return made


def table() -> QTableWidget:
    made = QTableWidget(0, 1)
    made.setHorizontalHeaderLabels([TOO_LONG])
    made.horizontalHeader().setSectionResizeMode(QHeaderView.ResizeMode.Stretch)
    return made


@pytest.mark.parametrize(
    "make",
    [
        partial(label, wraps=False),
        partial(label, wraps=True),
        partial(QPushButton, TOO_LONG),
        partial(QCheckBox, TOO_LONG),
        partial(QRadioButton, TOO_LONG),
        combo_box,
        group_box,
        tabs,
        table,
    ],
)
def test_cut_text_is_found(qtbot: QtBot, make: Callable[[], QWidget]) -> None:
    window, widget = QWidget(), make()
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


def test_trex(pseudo_window: WindowDriver, tmp_path: Path) -> None:
    window, found = pseudo_window, Findings()
    found.look_at_tabs(window.window, window.window.pages)
    window.connect_to_demo()
    window.device.parameters.edit("serial_timeout", 15)
    found.look_at_tabs(window.window, window.window.pages)
    for open_window in WINDOWS_WITH_STOP:
        shown = open_window(window, tmp_path)
        window.wait(shown.isVisible)
        found.look(shown)
        for tabs in shown.findChildren(QTabWidget):
            found.look_at_tabs(shown, tabs)
        shown.close()
    window.device.draft.discard_edits()
    for key in DIALOGS:
        window.trigger(key)
        runtime().sleep(0.3)
        for dialog in window.find_all(QDialog):
            if dialog.isVisible():
                found.look(dialog)
                dialog.close()
    check(found)


def test_aracna(pseudo_window: WindowDriver) -> None:
    window, found = pseudo_window, Findings()
    window.program.device_manager.switch_to("aracna", lambda: None)
    found.look(window.window)
    window.connect_to_demo("aracna")
    found.look_at_tabs(window.window, window.window.pages)
    check(found)
