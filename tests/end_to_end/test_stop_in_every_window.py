"""Windows that may cover the main one stop the motors with the mouse, too."""

from collections.abc import Callable
from pathlib import Path

import pytest
from PySide6.QtCore import Qt
from PySide6.QtGui import QAccessible, QAction
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QPushButton, QWidget
from pytestqt.qtbot import QtBot

from tests.recording.samples import an_hour, write
from tests.support.simulator import SimulatedDevice
from trex_gui.link.settings import LinkSettings
from trex_gui.model.device import Link
from trex_gui.settings.files import save
from trex_gui.settings.writer import write_settings
from trex_gui.window import Program


def _action(program: Program, key: str) -> None:
    action = program.window.findChild(QAction, f"{key}Action")
    assert action is not None, key
    action.trigger()


def _child(program: Program, name: str) -> QWidget:
    dialog = program.window.findChild(QWidget, name)
    assert dialog is not None
    return dialog


def playback(program: Program, folder: Path) -> QWidget:
    write(folder / "a.trexrec", list(an_hour(5)))
    program.desk.recordings.open_file(folder / "a.trexrec")
    (window,) = program.desk.recordings.windows
    return window


def editor(program: Program, folder: Path) -> QWidget:
    shown = program.device.draft.shown
    assert shown is not None
    save(folder / "a.txt", write_settings(shown))
    window = program.desk.files.edit_file(folder / "a.txt")
    assert window is not None
    return window


def history(program: Program, folder: Path) -> QWidget:
    _action(program, "history")
    return _child(program, "historyDialog")


def review(program: Program, folder: Path) -> QWidget:
    program.device.parameters.edit("serial_timeout", 9)
    _action(program, "apply")
    return _child(program, "reviewDialog")


def defaults(program: Program, folder: Path) -> QWidget:
    _action(program, "defaults")
    return _child(program, "defaultsDialog")


def bench(program: Program, folder: Path) -> QWidget:
    _action(program, "bench")
    return _child(program, "benchDialog")


WINDOWS = [playback, editor, history, review, defaults, bench]


def stop_button(window: QWidget) -> QPushButton:
    (button,) = (
        button
        for button in window.findChildren(QPushButton)
        if button.objectName().endswith("StopButton")
    )
    return button


def spoken(button: QPushButton) -> str:
    return QAccessible.queryAccessibleInterface(button).text(QAccessible.Text.Name)


@pytest.mark.parametrize("opened", WINDOWS, ids=lambda opened: opened.__name__)
def test_the_red_button_of_a_window_stops_the_motors(
    opened: Callable[[Program, Path], QWidget],
    program: Program,
    quick_simulator: SimulatedDevice,
    tmp_path: Path,
    qtbot: QtBot,
) -> None:
    device = program.device
    device.connect_to(LinkSettings(quick_simulator.url))
    qtbot.waitUntil(lambda: device.link is Link.UP, timeout=10_000)
    window = opened(program, tmp_path)
    qtbot.waitUntil(window.isVisible)
    button = stop_button(window)
    main = program.window.findChild(QPushButton, "stopButton")
    assert main is not None
    assert spoken(button) == spoken(main) == "Stop motor"
    device.motors.accelerate = False

    def motor() -> dict[str, object]:
        motors = quick_simulator.show()["motors"]
        found: dict[str, object] = motors[0]
        return found

    def turns() -> bool:
        if not device.motors.armed:  # also after a stop because the window was slow
            device.motors.arm()
            device.motors.set_speed(1, 60)
        return motor()["target_speed"] == 60

    qtbot.waitUntil(turns, timeout=20_000)
    QTest.mousePress(button, Qt.MouseButton.LeftButton)
    qtbot.waitUntil(lambda: motor()["direction"] == "brake", timeout=10_000)
    assert not device.motors.armed
    QTest.mouseRelease(button, Qt.MouseButton.LeftButton)
    device.disconnect_line()
    qtbot.waitUntil(lambda: device.link is Link.NONE, timeout=10_000)
    assert not button.isEnabled()
    device.discard_edits()
    window.close()
