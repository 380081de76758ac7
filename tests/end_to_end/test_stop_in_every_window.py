"""Windows that may cover the main one stop the motors with the mouse, too."""

from pathlib import Path

from PySide6.QtGui import QAccessible
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QAbstractButton, QPushButton, QWidget

from tests.devices.trex.recording.samples import an_hour, write
from tests.support.pages.motors import BRAKE, MotorsPage
from tests.support.program import trex
from tests.support.simulator import SimulatedDevice
from tests.support.window import LEFT, WidgetDriver, WindowDriver
from trex_gui.core.files import save
from trex_gui.devices.trex.settings.writer import write_settings
from trex_gui.ui.devices.connection import ConnectionState


def open_playback(window: WindowDriver, folder: Path) -> QWidget:
    write(folder / "a.trexrec", list(an_hour(5)))
    trex(window.program).workspace.recordings.open_file(folder / "a.trexrec")
    window.wait_for_files()
    (playback,) = trex(window.program).workspace.recordings.windows
    return playback


def open_editor(window: WindowDriver, folder: Path) -> QWidget:
    shown = window.device.draft.shown
    assert shown is not None
    save(folder / "a.txt", write_settings(shown))
    files = trex(window.program).workspace.files
    files.edit_file(folder / "a.txt")
    window.wait_for_files()
    return files.editors[-1]


def open_history(window: WindowDriver, folder: Path) -> QWidget:
    window.trigger("history")
    return window.dialog("historyDialog").root


def open_review(window: WindowDriver, folder: Path) -> QWidget:
    window.device.parameters.edit("serial_timeout", 9)
    window.trigger("apply")
    return window.find(QWidget, "reviewDialog")


def open_defaults(window: WindowDriver, folder: Path) -> QWidget:
    window.trigger("defaults")
    return window.find(QWidget, "defaultsDialog")


def open_bench(window: WindowDriver, folder: Path) -> QWidget:
    window.trigger("bench")
    return window.find(QWidget, "benchDialog")


def stop_button(window: WidgetDriver) -> QPushButton:
    buttons = window.find_all(QPushButton)
    (button,) = (each for each in buttons if each.objectName().endswith("StopButton"))
    return button


def spoken(button: QAbstractButton) -> str:
    return QAccessible.queryAccessibleInterface(button).text(QAccessible.Text.Name)


def test_stop_button_of_every_window_stops_motors(
    connected_window: WindowDriver, quick_simulator: SimulatedDevice, tmp_path: Path
) -> None:
    page = MotorsPage(connected_window, quick_simulator)
    page.motors.lockout = 0
    page.motors.accelerate = False
    assert spoken(page.button("stopButton")) == "Stop motors"
    opened: list[tuple[QWidget, QPushButton]] = []
    for open_window in (
        open_playback,
        open_editor,
        open_history,
        open_review,
        open_defaults,
        open_bench,
    ):
        case = open_window.__name__
        window = open_window(page, tmp_path)
        page.wait(window.isVisible)
        button = stop_button(WidgetDriver(window, page.qtbot))
        assert spoken(button) == "Stop motors", case
        page.motors.arm()
        page.motors.set_speed(1, 60)
        page.wait_for_targets(("forward", 60), None, case)
        QTest.mousePress(button, LEFT)
        page.wait_for_targets(BRAKE, BRAKE, case)
        page.wait(lambda: quick_simulator.show()["motors"][0]["direction"] == "brake")
        assert not page.is_armed(), case
        QTest.mouseRelease(button, LEFT)
        opened.append((window, button))

    page.device.disconnect_line()
    page.wait(lambda: page.device.link is ConnectionState.DISCONNECTED)
    for window, button in opened:
        assert not button.isEnabled(), window.objectName()
        window.close()
