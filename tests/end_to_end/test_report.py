"""Report for support, from the menu and after an error or a crash."""

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
from tests.support.pages.motors import is_stopped
from tests.support.simulator import SimulatedDevice
from tests.support.window import WidgetDriver, WindowDriver
from trex_gui.core.log_file import ProgramLog, log_file


def test_report_is_shown_before_it_is_saved(
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


def test_error_stops_motors_and_offers_report_with_its_traceback(
    connected_window: WindowDriver,
    quick_simulator: SimulatedDevice,
    qtbot: QtBot,
    qapp: QApplication,
) -> None:
    window = connected_window
    program_log = ProgramLog(log_file())
    try:
        with watched(window.program, qtbot, qapp) as causes:
            window.motors.arm()
            window.motors.set_speed(1, 60)
            window.wait(lambda: quick_simulator.show()["motors"][0]["speed"] == 60)
            causes.raise_in_slot()
            window.wait_for_text("bannerText", "Internal error (ValueError), so the motors were")
            assert is_stopped(quick_simulator)
    finally:
        assert program_log.close()
    window.disconnect()
    window.connect(quick_simulator.url)
    window.click("bannerReport")
    text = read(window.dialog("reportDialog"), "program.txt")
    assert "CRITICAL trex_gui.supervisor: uncaught exception\nTraceback" in text
    assert "ValueError: on purpose\n" in text
    assert "INFO trex_gui.ui.log: ⚠ Internal error (ValueError), so the motors were" in text


_SCRIPT = """
import os, signal, sys
from PySide6.QtCore import QCoreApplication, Qt, QTimer
from PySide6.QtWidgets import QApplication, QLabel
from trex_gui import app, composition
build = composition.build

def built(*_):
    assert QApplication.testAttribute(Qt.ApplicationAttribute.AA_DontUseNativeDialogs)
    program = build()
    assert "pyqtgraph" not in sys.modules

    def look():
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
        look() if is_ready else QTimer.singleShot(20, wait)

    program.report_last_run = report_last_run
    return program

composition.build = built
sys.exit(app.main([]))
"""


_FAILING_SCRIPT = """
import sys
from trex_gui import app, composition
composition.build = lambda *_: 1 / 0
app.main([])
"""


@pytest.mark.realtime
def test_error_at_the_start_is_in_the_log() -> None:
    done = subprocess.run(
        [sys.executable, "-c", _FAILING_SCRIPT],
        cwd=ROOT,
        capture_output=True,
        text=True,
        check=False,
        timeout=60,
    )
    assert done.returncode == 1
    assert done.stderr.count("ZeroDivisionError: division by zero") == 1
    text = log_file().read_text(encoding="utf-8")
    assert "CRITICAL trex_gui.app: the program cannot continue\nTraceback" in text
    assert "ZeroDivisionError: division by zero\n" in text
    assert text.endswith("ended with exit code 1\n")


@pytest.mark.realtime
def test_crash_is_reported_at_the_next_start(tmp_path: Path) -> None:
    """The new process uses Qt file dialogs and loads its plots early."""

    def banner_of(what: str) -> str:
        command = [sys.executable, "-c", _SCRIPT, what]
        environment = {"XDG_CONFIG_HOME": str(tmp_path)}
        done = subprocess.run(
            command,
            cwd=ROOT,
            env={**os.environ, **environment},
            capture_output=True,
            text=True,
            check=False,
            timeout=60,
        )
        return done.stdout.strip()

    assert banner_of("crash") == ""
    assert "did not end properly last time" in banner_of("end")
