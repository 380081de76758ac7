"""Every focusable widget, table and plot has an accessible name."""

from pathlib import Path

from PySide6.QtWidgets import QWidget

from tests.devices.trex.recording.samples import an_hour, write
from tests.support.accessible_names import assert_named, is_part, takes_part
from tests.support.program import trex
from tests.support.simulator import SimulatedDevice
from tests.support.window import WindowDriver
from trex_gui.devices.trex.views.pages.motors.gamepad_panel import GamepadPanel
from trex_gui.ui.frame.find_dialog import FindDialog


def test_window_has_accessible_names_with_and_without_board(
    window: WindowDriver, quick_simulator: SimulatedDevice
) -> None:
    pages = window.window.pages
    for index in range(pages.count()):
        pages.setCurrentIndex(index)
    window.find(GamepadPanel, "gamepadPanel")
    assert_named(window.root)

    window.trigger("find")
    find = window.find(FindDialog, "findDialog")
    assert_named(find)
    find.close()

    window.connect(quick_simulator.url)
    for index in range(pages.count()):
        pages.setCurrentIndex(index)
    window.trigger("bench")
    bench = window.dialog("benchDialog")
    for plot in ("benchCurrents", "benchSpeeds"):
        viewport = bench.find(QWidget, plot)
        assert takes_part(viewport)
        assert not is_part(viewport)
    assert_named(window.root)  # with the windows that belong to it
    bench.root.close()


def test_recording_window_has_accessible_names(window: WindowDriver, tmp_path: Path) -> None:
    write(tmp_path / "minute.trexrec", list(an_hour(60)))
    trex(window.program).workspace.recordings.open_file(tmp_path / "minute.trexrec")
    window.wait_for_files()
    recording = trex(window.program).workspace.recordings.windows[0]
    window.wait(lambda: recording.playback.is_loaded)
    assert_named(recording)
    recording.close()
