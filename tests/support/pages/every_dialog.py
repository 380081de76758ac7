"""Every page, window and dialog of the program, opened one after the other."""

import re
from collections.abc import Iterator
from pathlib import Path

import pytest
from PySide6.QtWidgets import QCheckBox, QDialog, QFileDialog, QLineEdit, QTabWidget, QWidget

from tests.devices.trex.bench.runs import run_of
from tests.support.pages.every_window import WINDOWS_WITH_STOP, open_bench, open_editor
from tests.support.program import aracna, trex
from tests.support.scripts import load_script
from tests.support.window import WindowDriver
from trex_gui.core.translation import tr
from trex_gui.devices.trex.bench.files import to_csv
from trex_gui.devices.trex.bench.run import End
from trex_gui.devices.trex.protocol.flags import CHANNELS
from trex_gui.devices.trex.serve.robots import Robots
from trex_gui.devices.trex.views.bench.dialog import BenchDialog
from trex_gui.devices.trex.views.motor_controls import ArmDialog
from trex_gui.devices.trex.views.settings_editor.window import SettingsEditor
from trex_gui.devices.trex.views.tour import SETUP_STEPS
from trex_gui.ui.runtime import runtime

DIALOGS = (
    "test_sticks", "find", "check_board", "preferences", "report", "new", "power",
    "number", "to_boards", "group", "defaults", "robots",
)  # fmt: skip
"""Menu entries that open a dialog."""

ROBOT = {
    "name": "7", "url": "10.0.0.7", "board": "TReX 1.2", "responds": False, "driver": None,
    "problems": ["UART error"],
}  # fmt: skip
BAD_SETTINGS = (
    "product: TReX\nfirmware: 1.2\nserial_timeot: 5\nmotor_mode: joint\nserial_timeout: 500\n"
    "motor1_acceleration: 127\nrc_channel_1: [1]\nmotor_mode: 1"
)
FILLED_QT_DIALOGS = {"newSettingsDialog"}
"""Dialogs of Qt's own classes."""


def own_dialogs() -> set[str]:
    """Return the names of the program's dialog classes."""
    pattern = re.compile(r"^class (\w+)\((?:Q|Reused)Dialog\b", re.MULTILINE)
    texts = (
        path.read_text("utf-8")
        for path in sorted(load_script("translations").PROGRAM.rglob("*.py"))
    )
    return {name for text in texts for name in pattern.findall(text)} - {"ReusedDialog"}


def every_trex_window(
    window: WindowDriver, folder: Path, monkeypatch: pytest.MonkeyPatch
) -> Iterator[QWidget]:
    """Yield the main window at each page, then every other window and dialog.

    A window with several pages is yielded once for each page, then closed. At the end, fails if a
    dialog class was never opened.
    """
    seen: set[str] = set()
    for shown in _trex_windows(window, folder, monkeypatch):
        seen |= {type(shown).__name__, shown.objectName()}
        yield shown
    assert not (own_dialogs() | FILLED_QT_DIALOGS) - seen


def _trex_windows(
    window: WindowDriver, folder: Path, monkeypatch: pytest.MonkeyPatch
) -> Iterator[QWidget]:
    choice = (str(folder / "a.txt"), "")
    monkeypatch.setattr(QFileDialog, "getOpenFileName", lambda *_, **__: choice)
    yield from _pages(window)
    window.trigger("line")
    yield from _dialogs(window.window, "line")
    window.connect_to_demo()
    window.device.parameters.edit("serial_timeout", 15)
    yield from _pages(window)
    for open_window in WINDOWS_WITH_STOP:
        shown = open_window(window, folder)
        window.wait(shown.isVisible)
        yield shown
        for tabs in shown.findChildren(QTabWidget):
            yield from _tabs(shown, tabs)
        shown.close()
    window.device.draft.discard_edits()
    yield from _files(window, folder)
    yield from _learning(window)
    yield from _setup(window)
    yield from _bench(window, folder)
    yield from _provision(window, folder)
    monkeypatch.setattr(Robots, "find", lambda _: [ROBOT])
    for key in DIALOGS:
        window.action(key).setEnabled(True)  # even if the board does not support it
        window.trigger(key)
        window.wait_for_files()
        runtime().sleep(0.3)
        yield from _dialogs(window.window, key)
    window.trigger("help")
    yield window.help
    window.help.close()
    ArmDialog(window.device, tr("Writing …"), 0.5, window.window).open()
    yield from _dialogs(window.window, "arm")
    button = window.open_page("motorsPage").button("gamepadSetUpButton")
    button.setEnabled(True)  # without a gamepad
    button.click()
    yield from _dialogs(window.window, "gamepad")


def every_aracna_window(window: WindowDriver, folder: Path) -> Iterator[QWidget]:
    """Yield the main window at each page of an Aracna, then after opening invalid files."""
    window.program.device_manager.switch_to("aracna", lambda: None)
    yield from _pages(window)
    window.connect_to_demo("aracna")
    yield from _pages(window)
    (folder / "bad.ppr").write_text("pose a 1 2\n", "utf-8")
    for open_file in aracna(window.program).workspace.openers.values():
        open_file(folder / "bad.ppr")
        window.wait_for_files()
        assert window.has("banner")
        yield window.window


def _pages(window: WindowDriver) -> Iterator[QWidget]:
    for _ in window.each_page():
        runtime().sleep(0.3)
        yield window.window


def _tabs(window: QWidget, tabs: QTabWidget) -> Iterator[QWidget]:
    for index in range(tabs.count()):
        tabs.setCurrentIndex(index)
        runtime().sleep(0.3)
        yield window


def _dialogs(window: QWidget, case: str) -> Iterator[QDialog]:
    """Yield the open dialogs of a window. Close each afterwards."""
    shown = [each for each in window.findChildren(QDialog) if each.isVisible()]
    assert shown, case
    for dialog in shown:
        yield dialog
        dialog.close()


def _files(window: WindowDriver, folder: Path) -> Iterator[QWidget]:
    """Yield the dialogs of a settings file, then windows with invalid files."""
    workspace = trex(window.program).workspace
    files, recordings = workspace.files, workspace.recordings
    editor = open_editor(window, folder)
    assert isinstance(editor, SettingsEditor)
    for show in (editor.convert, editor.compare_with_board):
        show()
        window.wait_for_files()
        yield from _dialogs(editor, show.__name__)
    editor.close()
    (folder / "bad.txt").write_text(BAD_SETTINGS, "utf-8")
    files.edit_file(folder / "bad.txt")
    window.wait_for_files()
    yield from _tabs(files.editors[-1], files.editors[-1].tabs)
    files.editors[-1].close()
    (folder / "other.txt").write_text("product: TReX\nserial_timeout: 5\n", "utf-8")
    files.open_file(folder / "other.txt")
    window.wait_for_files()
    yield from _dialogs(window.window, "settings file")
    recordings.open_file(folder / "bad.txt")
    window.wait_for_files()
    assert window.has("banner")
    yield window.window


def _learning(window: WindowDriver) -> Iterator[QWidget]:
    """Yield each page of the dialog while the sticks move."""
    board = trex(window.program).controller.demo_board
    window.trigger("learn")
    learn = window.dialog("learnDialog")
    learn.wait(lambda: learn.has("learnRestPage") and learn.is_enabled("learnNextButton"))
    yield learn.root
    learn.click("learnNextButton")
    learn.wait(lambda: learn.has("learnTravelPage"))
    for microseconds in (1850, 1150, 1500):
        for channel in CHANNELS:
            board.hold_stick(channel, microseconds)
        runtime().sleep(1.2)
        yield learn.root
    learn.click("learnNextButton")
    learn.wait(lambda: learn.has("learnReviewPage"))
    yield learn.root
    learn.click("learnCloseButton")


def _setup(window: WindowDriver) -> Iterator[QWidget]:
    """Yield each step of the assistant."""
    window.trigger("setup")
    setup = window.dialog("setupDialog")
    yield setup.root
    for _ in SETUP_STEPS[1:]:
        setup.click("setupNextButton")
        runtime().sleep(0.3)
        yield setup.root
    setup.root.close()


def _provision(window: WindowDriver, folder: Path) -> Iterator[QWidget]:
    """Yield each page while the board is set up as the first of several."""
    (folder / "profile.txt").write_text("product: TReX\nmotor1_acceleration: 20\n", "utf-8")
    window.trigger("provision")
    dialog = window.dialog("provisionDialog")
    yield dialog.root
    for name in ("profile.txt", "record.csv"):
        field = f"provision{name.split('.')[0].title()}"
        dialog.find(QLineEdit, field).setText(str(folder / name))
    dialog.find(QCheckBox, "provisionMotors").setChecked(True)
    for page in ("provisionBoardPage", "provisionMotorsPage", "provisionWiring"):
        dialog.wait(lambda: dialog.is_enabled("provisionNextButton"))
        dialog.click("provisionNextButton")
        dialog.wait(lambda: dialog.has(page))  # noqa: B023 - called within the loop
        yield dialog.root
    dialog.click("provisionCloseButton")


def _bench(window: WindowDriver, folder: Path) -> Iterator[QWidget]:
    """Yield the dialog with a complete bench test, then with an aborted test."""
    bench = open_bench(window, folder)
    assert isinstance(bench, BenchDialog)
    readings = [(seconds / 10, 1.0 + seconds % 3) for seconds in range(20)]
    for name, end in (("complete", End.COMPLETE), ("aborted", End.ABORTED)):
        path = folder / f"{name}.csv"
        path.write_text(to_csv(run_of(readings, end=end)), "utf-8")
        bench.open_run(path)
        window.wait_for_files()
        yield bench
    bench.close()
