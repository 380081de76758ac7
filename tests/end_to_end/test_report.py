"""Report for support: from the menu, after an error, after a crash."""

import os
import subprocess
import sys
import zipfile
from pathlib import Path

import pytest
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QApplication, QFileDialog, QListWidget, QPlainTextEdit
from pytestqt.qtbot import QtBot

from tests.support.causes import watched
from tests.support.keyboard import check_keyboard
from tests.support.simulator import SimulatedDevice
from tests.support.window import WidgetDriver, WindowDriver
from trex_gui.core.log_file import ProgramLog, log_file


def test_saved_report_contains_what_was_shown(
    window: WindowDriver,
    simulator: SimulatedDevice,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr("getpass.getuser", lambda: "marybell")
    window.connect(simulator.url)
    window.device.parameters.edit("serial_timeout", 15)
    window.device.notifier.error.emit("Something about marybell.")
    simulator.do("fault 1 on")
    errors = window.device.board.errors
    window.wait(lambda: any(entry.count for entry in errors.occurred))
    window.trigger("report")
    dialog = window.dialog("reportDialog")
    files = dialog.find(QListWidget, "reportFiles")
    dialog.wait(lambda: files.count() > 0)
    assert files.sizeHintForColumn(0) <= files.viewport().width(), "no name is cut"
    names = [files.item(row).text().split()[0] for row in range(files.count())]
    expected = ["versions.txt", "ports.txt", "status.txt", "settings.txt", "settings_edited.txt"]
    assert [name for name in names if name != "guardian.txt"] == [
        *expected,
        "log.txt",
        "traffic.txt",
    ]
    shown = dialog.find(QPlainTextEdit, "reportText").toPlainText
    contents = {}
    for row, name in enumerate(names):
        files.setCurrentRow(row)
        contents[name] = shown()
    assert "Something about <user>." in contents["log.txt"]
    assert "marybell" not in "".join(contents.values())
    assert "Board: TReX 1.2, device 7" in contents["status.txt"]
    assert "\nPackets: compact\nRequests: " in contents["status.txt"]
    assert "\nMotor 1 fault: " in contents["status.txt"]
    assert "\nMotors: Motor 1 is off" in contents["status.txt"]
    assert "\nArmed: no, may be moving: no\n" in contents["status.txt"]
    assert "serial_timeout: 0" in contents["settings.txt"]
    assert "serial_timeout: 15" in contents["settings_edited.txt"]
    assert "get signature → TReX 1.2" in contents["traffic.txt"]
    check_keyboard(dialog.root)

    files.item(names.index("log.txt")).setCheckState(Qt.CheckState.Unchecked)
    path = tmp_path / "report.zip"
    monkeypatch.setattr(QFileDialog, "getSaveFileName", lambda *_: (str(path), ""))
    with window.qtbot.waitSignal(window.device.notifier.info):
        dialog.click("reportSave")
    assert not dialog.root.isVisible()
    with zipfile.ZipFile(path) as archive:
        saved = {name: archive.read(name).decode() for name in archive.namelist()}
    del contents["log.txt"]
    assert saved == contents


ROOT = Path(__file__).parents[2]


def read(dialog: WidgetDriver, name: str) -> str:
    """Return the shown text of a file in the report."""
    files = dialog.find(QListWidget, "reportFiles")
    dialog.wait(lambda: files.count() > 0)
    names = [files.item(row).text().split()[0] for row in range(files.count())]
    files.setCurrentRow(names.index(name))
    return dialog.find(QPlainTextEdit, "reportText").toPlainText()


def test_error_offers_a_report_with_its_traceback(
    window: WindowDriver, quick_simulator: SimulatedDevice, qtbot: QtBot, qapp: QApplication
) -> None:
    program_log = ProgramLog(log_file())
    try:
        with watched(window.program, qtbot, qapp) as causes:
            causes.raise_in_slot()
            window.wait_for_text("bannerText", "Internal error (ValueError).")
    finally:
        assert program_log.close()
    window.connect(quick_simulator.url)
    window.click("bannerReport")
    text = read(window.dialog("reportDialog"), "program.txt")
    assert "CRITICAL trex_gui.supervisor: uncaught exception\nTraceback" in text
    assert "ValueError: on purpose\n" in text
    assert "INFO trex_gui.ui.log: ⚠ Internal error (ValueError)." in text


_SCRIPT = """
import os, signal, sys
from PySide6.QtCore import QCoreApplication, Qt, QTimer
from PySide6.QtWidgets import QApplication, QLabel
from trex_gui import app, composition
build = composition.build

def build_and_report(*_):
    assert QApplication.testAttribute(Qt.ApplicationAttribute.AA_DontUseNativeDialogs)
    program = build()
    assert "pyqtgraph" not in sys.modules

    def show():
        print(program.window.findChild(QLabel, "bannerText").text(), flush=True)
        if sys.argv[1] == "crash":
            os.kill(os.getpid(), signal.SIGTERM if os.name == "nt" else signal.SIGKILL)
        program.end()

    report = program.report_last_run
    def report_last_run(**found):
        report(**found)
        QTimer.singleShot(0, wait)

    def wait():
        from trex_gui.ui.files import background
        is_ready = "pyqtgraph" in sys.modules and not background
        show() if is_ready else QTimer.singleShot(20, wait)

    program.report_last_run = report_last_run
    return program

composition.build = build_and_report
sys.exit(app.main([]))
"""


_FAILING_SCRIPT = """
import sys
from trex_gui import app, composition
composition.build = lambda *_: 1 / 0
app.main([])
"""


def run_script(
    script: str, *arguments: str, **environment: str
) -> "subprocess.CompletedProcess[str]":
    return subprocess.run(
        [sys.executable, "-c", script, *arguments],
        cwd=ROOT,
        env={**os.environ, **environment},
        capture_output=True,
        text=True,
        check=False,
        timeout=60,
    )


@pytest.mark.realtime
def test_error_at_the_start_is_logged() -> None:
    process = run_script(_FAILING_SCRIPT)
    assert process.returncode == 1
    assert process.stderr.count("ZeroDivisionError: division by zero") == 1
    text = log_file().read_text(encoding="utf-8")
    assert "CRITICAL trex_gui.app: the program cannot continue\nTraceback" in text
    assert "ZeroDivisionError: division by zero\n" in text
    assert text.endswith("ended with exit code 1\n")


@pytest.mark.realtime
def test_crash_is_reported_at_the_next_start(tmp_path: Path) -> None:
    """Also, file dialogs are Qt's own, and plots are loaded after the start."""

    def banner_after(action: str) -> str:
        return run_script(_SCRIPT, action, XDG_CONFIG_HOME=str(tmp_path)).stdout.strip()

    assert banner_after("crash") == ""
    assert "did not end properly last time" in banner_after("end")
