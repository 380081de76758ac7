"""Windows that may cover the main window, each opened like a user does."""

from pathlib import Path

from PySide6.QtWidgets import QApplication, QPushButton, QWidget

from tests.devices.trex.recording.samples import drive_records, write
from tests.support.program import trex
from tests.support.window import WindowDriver
from trex_gui.core.files import save
from trex_gui.devices.trex.settings.writer import write_settings


def open_playback(window: WindowDriver, folder: Path) -> QWidget:
    write(folder / "a.trexrec", list(drive_records(5)))
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


def open_bench(window: WindowDriver, folder: Path) -> QWidget:
    window.trigger("bench")
    return window.find(QWidget, "benchDialog")


def open_plot(window: WindowDriver, folder: Path) -> QWidget:
    window.trigger("plot")
    (plot,) = (each for each in QApplication.topLevelWidgets() if each.objectName() == "plotWindow")
    return plot


def open_setup(window: WindowDriver, folder: Path) -> QWidget:
    window.trigger("setup")
    return window.find(QWidget, "setupDialog")


def stop_button(window: QWidget) -> QPushButton:
    """Return the stop button of a window that may cover the main window."""
    buttons = window.findChildren(QPushButton)
    (button,) = (each for each in buttons if each.objectName().endswith("StopButton"))
    return button


WINDOWS_WITH_STOP = (
    open_playback,
    open_editor,
    open_history,
    open_review,
    open_bench,
    open_setup,
    open_plot,
)
