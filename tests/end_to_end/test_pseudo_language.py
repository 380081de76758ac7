"""Every page and dialog in a longer, accented language: what is not translated, and what is cut."""

import re
from collections.abc import Callable, Iterator
from functools import partial
from pathlib import Path

import pytest
from PySide6.QtCore import QCoreApplication, QPoint, QRect, QSettings, QSize, Qt
from PySide6.QtGui import QAction, QScreen
from PySide6.QtWidgets import (
    QApplication,
    QCheckBox,
    QComboBox,
    QDialog,
    QFileDialog,
    QGroupBox,
    QHeaderView,
    QLabel,
    QMessageBox,
    QPushButton,
    QRadioButton,
    QScrollArea,
    QSpinBox,
    QTabBar,
    QTableWidget,
    QTabWidget,
    QWidget,
)
from pytestqt.qtbot import QtBot

from tests.devices.trex.bench.runs import run_of
from tests.support.pages.every_window import WINDOWS_WITH_STOP, open_bench, open_editor, open_plot
from tests.support.program import aracna, trex
from tests.support.pseudo_language import (
    BEGIN,
    PseudoTranslator,
    cut_texts,
    shown_texts,
    untranslated,
)
from tests.support.scripts import load_script
from tests.support.window import WindowDriver
from trex_gui.core.translation import use_translations
from trex_gui.devices.trex.bench.files import to_csv
from trex_gui.devices.trex.bench.run import End
from trex_gui.devices.trex.protocol.flags import CHANNELS
from trex_gui.devices.trex.views.arm_dialog import ArmDialog
from trex_gui.devices.trex.views.bench.dialog import BenchDialog
from trex_gui.devices.trex.views.pages.parameters.filters import ParameterFilter
from trex_gui.devices.trex.views.pages.parameters.view import ParameterView
from trex_gui.devices.trex.views.settings_editor.window import SettingsEditor
from trex_gui.devices.trex.views.tour import SETUP_STEPS
from trex_gui.ui.frame import preferences_dialog
from trex_gui.ui.plotting.layout_button import LayoutButton
from trex_gui.ui.runtime import runtime
from trex_gui.ui.theme import theme as theme_module
from trex_gui.ui.theme.theme import theme
from trex_gui.ui.translations import CONTEXT

DIALOGS = (
    "test_sticks", "find", "check_board", "preferences", "report", "new", "power",
    "number", "to_boards",
)  # fmt: skip


class Findings:
    """What was found so far, each once."""

    def __init__(self) -> None:
        self.untranslated: dict[str, str] = {}
        self.cut: set[str] = set()
        self.dialogs: set[str] = set()

    def look(self, window: QWidget) -> None:
        for _ in range(3):  # a layout may ask for another one
            QCoreApplication.processEvents()
        for where, text in shown_texts(window):
            self.look_at_text(where, text)
        self.dialogs |= {type(window).__name__, window.objectName()}
        self.cut.update(f"{window.objectName()}: {cut}" for cut in cut_texts(window))

    def show(self, dialog: QDialog) -> int:
        """Look at a dialog, in place of waiting until it is closed."""
        dialog.show()
        self.look(dialog)
        dialog.close()
        return 0

    def show_about(self, parent: QWidget, title: str, text: str) -> None:
        box = QMessageBox(QMessageBox.Icon.Information, title, text, parent=parent)
        box.setObjectName("aboutBox")
        self.show(box)

    def look_at_dialogs(self, window: QWidget, why: str = "") -> None:
        """Look at the dialogs of a window that are open, and close them."""
        shown = [each for each in window.findChildren(QDialog) if each.isVisible()]
        assert shown, why
        for dialog in shown:
            self.show(dialog)

    def look_at_text(self, where: str, text: str) -> None:
        if rest := untranslated(text):
            self.untranslated.setdefault(rest, where)

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


BAD_SETTINGS = (
    "product: TReX\nfirmware: 1.2\nserial_timeot: 5\nmotor_mode: joint\nserial_timeout: 500\n"
    "motor1_acceleration: 127\nrc_channel_1: [1]\nmotor_mode: 1"
)
BAD_LAYOUT = "version = 2\n"
QT_OF_OURS = {"newSettingsDialog", "aboutBox"}
"""Dialogs of classes of Qt that the program fills."""


def own_dialogs() -> set[str]:
    """Return the names of the program's classes of dialogs."""
    made = re.compile(r"^class (\w+)\((?:Q|Reused)Dialog\b", re.MULTILINE)
    texts = (
        path.read_text("utf-8")
        for path in sorted(load_script("translations").PROGRAM.rglob("*.py"))
    )
    return {name for text in texts for name in made.findall(text)} - {"ReusedDialog"}


def look_at_files(window: WindowDriver, found: Findings, folder: Path) -> None:
    """Look at what can be done with a settings file, and at files with errors."""
    files, recordings = (
        trex(window.program).workspace.files,
        trex(window.program).workspace.recordings,
    )
    editor = open_editor(window, folder)
    assert isinstance(editor, SettingsEditor)
    for show in (editor.convert, editor.compare_with_board):
        show()
        window.wait_for_files()
        found.look_at_dialogs(editor)
    editor.close()
    (folder / "bad.txt").write_text(BAD_SETTINGS, "utf-8")
    files.edit_file(folder / "bad.txt")
    window.wait_for_files()
    found.look_at_tabs(files.editors[-1], files.editors[-1].tabs)
    files.editors[-1].close()
    files.open_file(folder / "a.txt")
    window.wait_for_files()
    found.look_at_dialogs(window.window)
    recordings.open_file(folder / "bad.txt")
    window.wait_for_files()
    assert BEGIN in window.text("bannerText")
    found.look(window.window)
    found.look_at_text("recording", window.text("bannerText"))
    plot = open_plot(window, folder)
    (folder / "bad.toml").write_text(BAD_LAYOUT, "utf-8")
    (layout,) = plot.findChildren(LayoutButton)
    layout.open(folder / "bad.toml")
    window.wait_for_files()
    found.look(plot)
    plot.close()


def open_wire_dialog(window: WindowDriver) -> None:
    page = window.open_page("parametersPage")
    view = page.find(ParameterView, "parametersView")
    rows = view.model()
    assert isinstance(rows, ParameterFilter)
    view.setCurrentIndex(rows.index_of("ignored_channels"))
    page.find(QAction, "tryParameter").setEnabled(True)
    page.find(QAction, "tryParameter").trigger()


def look_at_learning(window: WindowDriver, found: Findings) -> None:
    """Look at each page of the dialog, as long as the sticks are moved."""
    sticks = trex(window.program).controller.demo_board
    window.trigger("learn")
    learn = window.dialog("learnDialog")
    learn.wait(lambda: learn.has("learnRestPage") and learn.is_enabled("learnNextButton"))
    found.look(learn.root)
    learn.click("learnNextButton")
    learn.wait(lambda: learn.has("learnTravelPage"))
    for microseconds in (1850, 1150, 1500):
        for channel in CHANNELS:
            sticks.hold_stick(channel, microseconds)
        runtime().sleep(1.2)
        found.look(learn.root)
    learn.click("learnNextButton")
    learn.wait(lambda: learn.has("learnReviewPage"))
    found.look(learn.root)
    learn.click("learnCancelButton")


def look_at_setup(window: WindowDriver, found: Findings) -> None:
    """Look at each step of the assistant."""
    window.trigger("setup")
    setup, steps = window.dialog("setupDialog"), 1
    found.look(setup.root)
    while setup.has("setupNextButton") and setup.is_enabled("setupNextButton"):
        setup.click("setupNextButton")
        runtime().sleep(0.3)
        found.look(setup.root)
        steps += 1
    assert steps == len(SETUP_STEPS)
    setup.root.close()


def look_at_bench(window: WindowDriver, found: Findings, folder: Path) -> None:
    """Look at a bench test that has ended, and at one that was aborted."""
    bench = open_bench(window, folder)
    assert isinstance(bench, BenchDialog)
    readings = [(seconds / 10, 1.0 + seconds % 3) for seconds in range(20)]
    for name, end in (("complete", End.COMPLETE), ("aborted", End.ABORTED)):
        path = folder / f"{name}.csv"
        path.write_text(to_csv(run_of(readings, end=end)), "utf-8")
        bench.files.open(path)
        window.wait_for_files()
        found.look(bench)
    bench.close()


def test_trex(pseudo_window: WindowDriver, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    window, found = pseudo_window, Findings()
    monkeypatch.setattr(QMessageBox, "about", found.show_about)
    monkeypatch.setattr(
        QFileDialog, "getOpenFileName", lambda *_, **__: (str(tmp_path / "a.txt"), "")
    )
    found.look_at_tabs(window.window, window.window.pages)
    window.trigger("line")
    found.look_at_dialogs(window.window, "line")
    window.trigger("about")
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
    look_at_files(window, found, tmp_path)
    look_at_learning(window, found)
    look_at_setup(window, found)
    look_at_bench(window, found, tmp_path)
    for key in DIALOGS:
        window.action(key).setEnabled(True)  # whatever the board would need it for
        window.trigger(key)
        window.wait_for_files()
        runtime().sleep(0.3)
        found.look_at_dialogs(window.window, key)
    window.trigger("help")
    found.show(window.help)
    open_wire_dialog(window)
    found.look_at_dialogs(window.window)
    ArmDialog(window.device, window.window.tr("Writing …"), 0.5, window.window).open()
    found.look_at_dialogs(window.window)
    set_up = window.open_page("motorsPage").button("gamepadSetUpButton")
    set_up.setEnabled(True)  # without a gamepad
    set_up.click()
    found.look_at_dialogs(window.window)
    assert not (own_dialogs() | QT_OF_OURS) - found.dialogs
    check(found)


def test_aracna(pseudo_window: WindowDriver, tmp_path: Path) -> None:
    window, found = pseudo_window, Findings()
    window.program.device_manager.switch_to("aracna", lambda: None)
    found.look(window.window)
    window.connect_to_demo("aracna")
    found.look_at_tabs(window.window, window.window.pages)
    (tmp_path / "bad.ppr").write_text("pose a 1 2\n", "utf-8")
    for open_file in aracna(window.program).workspace.openers.values():
        open_file(tmp_path / "bad.ppr")
        window.wait_for_files()
        assert BEGIN in window.text("bannerText")
        found.look(window.window)
    check(found)
