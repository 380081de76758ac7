"""Preferences, languages and recent files in the window."""

from pathlib import Path

import pytest
from PySide6.QtCore import QPoint, QRect, QSize, Qt
from PySide6.QtGui import QAction, QScreen
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QMenu

from tests.devices.trex.recording.samples import drive_records, write
from tests.support.program import trex
from tests.support.window import WindowDriver
from trex_gui.core.resource_files import resource
from trex_gui.ui.theme.theme import FONT_SIZES, theme

SMALL = QSize(1024, 600)
FRAME = QSize(16, 48)


def test_windows_with_large_fonts_fit_a_small_screen(
    monkeypatch: pytest.MonkeyPatch, window: WindowDriver
) -> None:
    monkeypatch.setattr(QScreen, "availableGeometry", lambda _: QRect(QPoint(), SMALL))
    QTest.keyClick(window.window, Qt.Key.Key_Comma, Qt.KeyboardModifier.ControlModifier)
    dialog = window.dialog("preferencesDialog")
    for kind, stop in (("trex", "stopButton"), ("aracna", "aracnaStopButton")):
        dialog.select("fontSizeBox", 150)
        window.connect_to_demo(kind)
        window.program.complete()  # the sizes of all pages matter
        if kind == "trex":
            window.device.parameters.edit("serial_timeout", 15)
            window.motors.arm()
        for percent in (150, *FONT_SIZES[::5]):
            dialog.select("fontSizeBox", percent)
            window.wait_for_files()
            for widget in (window.window, dialog.root):
                # At 175 %, the panel of the simulated device must be closed.
                min_width = widget.minimumSizeHint().width() if percent < 175 else 0
                case = f"{kind}, {percent} %: {widget.objectName()} needs {min_width}"
                assert min_width <= SMALL.width() - FRAME.width(), case
                height = widget.minimumSizeHint().height()
                assert height <= SMALL.height() - FRAME.height(), case
            button = window.button(stop)
            assert button.height() >= button.fontMetrics().height()
        window.press_escape()
        window.device.draft.discard_edits()
        window.disconnect()
    assert theme().font_size == FONT_SIZES[-1]


def recent(window: WindowDriver) -> list[QAction]:
    (menu,) = (menu for menu in window.find_all(QMenu) if menu.title() == "Recent &files")
    return [action for action in menu.actions() if action.toolTip().startswith("/")]


def open_recent(window: WindowDriver, name: str) -> None:
    next(action for action in recent(window) if name in action.text()).trigger()
    window.wait_for_files()


def test_recent_files_open_again(window: WindowDriver, tmp_path: Path) -> None:
    sample = next(iter(sorted(resource("samples").glob("*.txt"))))
    settings, recording = tmp_path / "robot.txt", tmp_path / "run.trexrec"
    settings.write_bytes(sample.read_bytes())
    write(recording, list(drive_records(2)))
    assert recent(window) == []

    workspace = trex(window.program).workspace
    window.window.files.open_file(settings)
    workspace.recordings.open_file(recording)
    window.wait_for_files()
    assert [action.toolTip() for action in recent(window)] == [str(recording), str(settings)]
    for opened in (*workspace.files.editors, *workspace.recordings.windows):
        opened.close()

    open_recent(window, "robot.txt")
    open_recent(window, "run.trexrec")
    (editor,), (playback,) = workspace.files.editors, workspace.recordings.windows
    assert editor.document.path == settings
    assert playback.player.path == recording
    editor.close()
    playback.close()

    settings.unlink()
    open_recent(window, "robot.txt")
    assert "no longer exists" in window.text("bannerText")
    assert [action.toolTip() for action in recent(window)] == [str(recording)]

    poses = tmp_path / "walk & turn.ppr"
    poses.write_text("low = [1, 2, 3, 4, 5, 6, 7, 8]\n")
    window.window.files.recent.add("aracna", "poses", poses)
    open_recent(window, "walk && turn")
    window.wait_for_text("bannerText", "walk & turn.ppr was opened.")

    window.connect_to_demo("aracna")
    open_recent(window, "run.trexrec")
    assert "disconnect, then open it again" in window.text("bannerText")
