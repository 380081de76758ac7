"""The report for support, from the menu to the file."""

import zipfile
from pathlib import Path

import pytest
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QFileDialog, QListWidget, QPlainTextEdit

from tests.support.keyboard import check_keyboard
from tests.support.simulator import SimulatedDevice
from tests.support.window import WindowDriver


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
    window.wait(lambda: window.device.board.errors.uncleared)
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
    assert "\nMotors: Motor 1 has no drive" in contents["status.txt"]
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
