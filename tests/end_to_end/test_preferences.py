"""Preferences, languages and recent files, in the whole window."""

import os
import subprocess
import sys
from pathlib import Path

import pytest
from PySide6.QtCore import QPoint, QRect, QSettings, QSize, Qt
from PySide6.QtGui import QAction, QScreen
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QMenu

from tests.devices.trex.recording.samples import an_hour, write
from tests.support.program import trex
from tests.support.simulator import SimulatedDevice
from tests.support.window import WindowDriver
from trex_gui.core.resource_files import resource
from trex_gui.ui.theme.theme import FONT_SIZES, theme
from trex_gui.ui.translations import chosen_language

SMALL = QSize(1024, 600)
FRAME = QSize(16, 48)


def test_windows_fit_a_small_screen_in_large_fonts(
    monkeypatch: pytest.MonkeyPatch, window: WindowDriver
) -> None:
    monkeypatch.setattr(QScreen, "availableGeometry", lambda _: QRect(QPoint(), SMALL))
    QTest.keyClick(window.window, Qt.Key.Key_Comma, Qt.KeyboardModifier.ControlModifier)
    dialog = window.dialog("preferencesDialog")
    for kind, stop in (("trex", "stopButton"), ("aracna", "aracnaStopButton")):
        dialog.select("fontSizeBox", 150)
        window.connect_to_demo(kind)
        window.program.complete()  # each page counts
        if kind == "trex":
            window.device.parameters.edit("serial_timeout", 15)
            window.motors.arm()
        for percent in (150, *FONT_SIZES[::5]):
            dialog.select("fontSizeBox", percent)
            window.wait_for_files()
            for widget in (window.window, dialog.root):
                # At 175 % the panel of the simulated device has to be closed for it.
                least = widget.minimumSizeHint().width() if percent < 175 else 0
                case = f"{kind}, {percent} %: {widget.objectName()} needs {least}"
                assert least <= SMALL.width() - FRAME.width(), case
                height = widget.minimumSizeHint().height()
                assert height <= SMALL.height() - FRAME.height(), case
            button = window.button(stop)
            assert button.height() >= button.fontMetrics().height()
        window.press_escape()
        window.device.draft.discard_edits()
        window.disconnect()
    assert theme().font_size == FONT_SIZES[-1]


@pytest.mark.parametrize("saved", [2, "1", "channels"])
def test_page_of_the_last_session_is_shown_again(
    saved: int | str, request: pytest.FixtureRequest
) -> None:
    QSettings().setValue("trex/page", saved)  # 2 was the calibration, which is on that page now
    window: WindowDriver = request.getfixturevalue("window")
    assert window.has("channelsPage")
    window.open_page("motorsPage")
    assert QSettings().value("trex/page") == "motors"


def recent(window: WindowDriver) -> list[QAction]:
    (menu,) = (menu for menu in window.find_all(QMenu) if menu.title() == "Recent &files")
    return [action for action in menu.actions() if action.toolTip().startswith("/")]


def choose_recent(window: WindowDriver, name: str) -> None:
    next(action for action in recent(window) if name in action.text()).trigger()
    window.wait_for_files()


def test_recent_files_open_again(window: WindowDriver, tmp_path: Path) -> None:
    sample = next(iter(sorted(resource("samples").glob("*.txt"))))
    settings, recording = tmp_path / "robot.txt", tmp_path / "run.trexrec"
    settings.write_bytes(sample.read_bytes())
    write(recording, list(an_hour(2)))
    assert recent(window) == []

    workspace = trex(window.program).workspace
    window.window.files.open_file(settings)
    workspace.recordings.open_file(recording)
    window.wait_for_files()
    assert [action.toolTip() for action in recent(window)] == [str(recording), str(settings)]
    for opened in (*workspace.files.editors, *workspace.recordings.windows):
        opened.close()

    choose_recent(window, "robot.txt")
    choose_recent(window, "run.trexrec")
    (editor,), (playback,) = workspace.files.editors, workspace.recordings.windows
    assert editor.document.path == settings
    assert playback.player.path == recording
    editor.close()
    playback.close()

    settings.unlink()
    choose_recent(window, "robot.txt")
    assert "no longer there" in window.text("bannerText")
    assert [action.toolTip() for action in recent(window)] == [str(recording)]

    window.connect_to_demo("aracna")
    choose_recent(window, "run.trexrec")
    assert "disconnect, then open it again" in window.text("bannerText")
    assert not window.window.help_dialog


_REOPEN = """
import sys
from trex_gui import app
from trex_gui.ui.translations import select_language

begin, languages = app.begin, iter(["de"])

def begin_and_choose(program, arguments):
    def connected():
        window, manager = program.window, program.device_manager
        print(window.menuBar().actions()[0].text(), manager.current.port.url, flush=True)
        language = next(languages, None)
        if language is None:
            program.end()
        else:
            select_language(language)
            window.reopen()
    program.device_manager.when_connected(connected)
    begin(program, arguments)

app.begin = begin_and_choose
sys.exit(app.main(["--port", sys.argv[1]]))
"""


def choose(window: WindowDriver, code: str) -> None:
    window.trigger("preferences")
    dialog = window.dialog("preferencesDialog")
    dialog.select("languageBox", code)


def test_same_language_leaves_window_open_and_another_opens_it_again(
    connected_window: WindowDriver,
) -> None:
    window, port = connected_window, connected_window.program.device_manager.current.port
    choose(window, "system")
    assert window.window.isVisible()
    assert not window.window.reopens

    window.motors.arm()
    window.device.parameters.edit("serial_timeout", 15)
    choose(window, "fr")
    window.wait(lambda: window.has("keepAndClose"))
    assert not window.window.reopens, "edits are asked about before"
    window.click("keepAndClose")
    window.wait(lambda: window.window.reopens)
    assert chosen_language() == "fr"
    assert window.window.port_to_reopen == port
    assert not window.device.motors.armed


def test_window_that_stays_open_is_not_opened_again(connected_window: WindowDriver) -> None:
    window = connected_window
    window.device.parameters.edit("serial_timeout", 15)
    choose(window, "de")
    window.wait(lambda: window.has("keepAndClose"))
    window.device.draft.discard_edits()
    window.wait(lambda: not window.has("keepAndClose"))
    assert window.window.isVisible()
    window.window.close()
    assert not window.window.reopens


@pytest.mark.realtime
def test_program_opens_again_in_another_language(
    simulator: SimulatedDevice, tmp_path: Path
) -> None:
    done = subprocess.run(
        [sys.executable, "-c", _REOPEN, simulator.url],
        env={**os.environ, "XDG_CONFIG_HOME": str(tmp_path)},  # remembers the language
        capture_output=True,
        text=True,
        timeout=50,
        check=False,
    )
    assert done.returncode == 0, done.stderr
    titles = [line.split() for line in done.stdout.splitlines()]
    assert titles == [[title, simulator.url] for title in ("&File", "&Datei")]
