"""Every page and dialog in a longer, accented language: what is not translated, and what is cut."""

from collections.abc import Callable, Iterator
from functools import partial
from pathlib import Path

import pytest
from PySide6.QtCore import QCoreApplication, QPoint, QRect, QSettings, QSize, Qt
from PySide6.QtGui import QScreen
from PySide6.QtWidgets import (
    QApplication,
    QCheckBox,
    QComboBox,
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
    shown_texts,
    untranslated,
)
from tests.support.window import WindowDriver
from trex_gui.core.translation import use_translations
from trex_gui.ui.frame import preferences_dialog
from trex_gui.ui.theme import theme as theme_module
from trex_gui.ui.theme.theme import theme
from trex_gui.ui.translations import CONTEXT


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


@pytest.fixture(
    params=[(100, (1366, 728)), pytest.param((200, (3840, 2080)), marks=pytest.mark.slow)],
    ids=["100 %", "200 %"],
)
def pseudo_window(
    request: pytest.FixtureRequest, qapp: QApplication, monkeypatch: pytest.MonkeyPatch
) -> Iterator[WindowDriver]:
    """The window in the language of these tests, at a font size and on a screen."""
    percent, screen = request.param
    available = QRect(QPoint(), QSize(*screen))
    monkeypatch.setattr(QScreen, "availableGeometry", lambda _: available)
    for module in (preferences_dialog, theme_module):
        monkeypatch.setattr(module, "FONT_SIZES", (100, 200))
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


def spin_box() -> QSpinBox:
    made = QSpinBox()
    made.setSpecialValueText(TOO_LONG)
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
        spin_box,
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


def test_text_beside_the_view_of_a_page_is_found(qtbot: QtBot) -> None:
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


def test_trex(pseudo_window: WindowDriver, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    found = Findings()
    for shown in every_trex_window(pseudo_window, tmp_path, monkeypatch):
        found.look(shown)
    check(found)


def test_aracna(pseudo_window: WindowDriver, tmp_path: Path) -> None:
    found = Findings()
    for shown in every_aracna_window(pseudo_window, tmp_path):
        found.look(shown)
    check(found)
