"""With a slow disk the window remains responsive, and no data is lost."""

import errno
import os
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest
from PySide6.QtWidgets import QFileDialog, QMessageBox

from tests.support.pages.settings import (
    ReviewDialog,
    SettingsEditorWindow,
    SettingsFiles,
    answer_questions,
)
from tests.support.program import trex
from tests.support.slow_disk import SECONDS, SlowDisk
from tests.support.virtual_devices import VirtualSimulator
from tests.support.window import WindowDriver
from trex_gui.core.code import Language
from trex_gui.core.files import data_folder
from trex_gui.ui.runtime import now


@pytest.fixture
def disk(monkeypatch: pytest.MonkeyPatch, window: WindowDriver) -> Iterator[SlowDisk]:
    disk = SlowDisk(monkeypatch)
    yield disk
    device = window.device
    window.wait(lambda: device.records.files.is_idle and device.edit_backup.files.is_idle)
    assert disk.stalls == []


def stored(simulator: VirtualSimulator) -> int:
    return int(simulator.show()["parameters"]["serial_timeout"])


# --- The snapshot before Apply ----------------------------------------------------------


@pytest.fixture
def review(connected_window: WindowDriver, disk: SlowDisk) -> ReviewDialog:
    """Review after *Write*, while the snapshot is being saved."""
    del disk
    review = ReviewDialog(connected_window)
    connected_window.device.parameters.edit("serial_timeout", 15)
    review.open()
    review.click("writeButton")
    return review


def test_apply_starts_once_the_snapshot_is_saved(
    connected_window: WindowDriver, review: ReviewDialog, quick_simulator: VirtualSimulator
) -> None:
    device, start = connected_window.device, now()
    review.wait(lambda: now() > start + SECONDS / 2)
    assert device.writer.running
    assert "Nothing has been written yet" in review.head
    assert not connected_window.is_enabled("applyButton")
    assert stored(quick_simulator) == 0
    review.wait_for_text("reviewHead", "written and verified")
    assert now() >= start + SECONDS
    assert stored(quick_simulator) == 15
    (snapshot,) = device.writer.history.folder.iterdir()
    assert "serial_timeout: 0 " in snapshot.read_text(encoding="utf-8")


def test_apply_can_be_cancelled_while_snapshot_is_saved(
    connected_window: WindowDriver, review: ReviewDialog, quick_simulator: VirtualSimulator
) -> None:
    device = connected_window.device
    assert review.button("reviewCloseButton").text() == "Cancel"
    review.close()
    assert not device.writer.running
    review.wait_for_files()
    assert stored(quick_simulator) == 0
    assert device.parameters.values.pending == (("serial_timeout", 15),)
    review.write()
    assert stored(quick_simulator) == 15


@pytest.mark.parametrize("fault", ["line mute on", "line unplug"])
def test_board_lost_during_snapshot_is_not_written(
    connected_window: WindowDriver,
    review: ReviewDialog,
    quick_simulator: VirtualSimulator,
    fault: str,
) -> None:
    device, start = connected_window.device, now()
    quick_simulator.do(fault)
    review.wait(lambda: not device.writer.running)
    assert now() < start + SECONDS, "writing ends before the snapshot is saved"
    assert review.button("reviewCloseButton").text() == "Close"
    quick_simulator.do("line mute off" if "mute" in fault else "line plug")
    review.wait_for_files()
    assert stored(quick_simulator) == 0
    assert device.draft.pending == 1


def test_settings_changed_during_snapshot_are_not_overwritten(
    connected_window: WindowDriver, review: ReviewDialog, quick_simulator: VirtualSimulator
) -> None:
    quick_simulator.do("eeprom motor1_acceleration 9")
    connected_window.device.reload()
    review.wait_for_text("reviewHead", "settings read from the board have changed")
    review.wait_for_files()
    assert stored(quick_simulator) == 0


# --- Settings files ---------------------------------------------------------------------

ROVER = "product: TReX\nserial_timeout: 5\n"


@pytest.fixture
def editor(window: WindowDriver, tmp_path: Path, disk: SlowDisk) -> Iterator[SettingsEditorWindow]:
    """Editor of a settings file with an unsaved edit."""
    del disk
    path = tmp_path / "rover.txt"
    path.write_text(ROVER, encoding="utf-8")
    files = SettingsFiles(window)
    files.files.edit_file(path)
    window.wait_for_files()
    editor = files.editor()
    editor.edit("serial_timeout", 9)
    yield editor
    files.files.close_all()  # without a prompt, even after a failure


def text_of(editor: SettingsEditorWindow) -> str:
    path = editor.document.path
    assert path is not None
    return path.read_text(encoding="utf-8")


def test_save_to_other_path_overtakes_a_save(editor: SettingsEditorWindow, tmp_path: Path) -> None:
    other = tmp_path / "other.txt"
    editor.action("Save").trigger()  # reads the file first, so it ends later
    editor.editor.save_to(other)
    editor.wait_for_files()
    assert "serial_timeout: 9" in other.read_text(encoding="utf-8")
    assert editor.document.path == other


def test_editor_is_closed_after_it_was_saved(
    editor: SettingsEditorWindow, monkeypatch: pytest.MonkeyPatch
) -> None:
    answer_questions(monkeypatch, QMessageBox.StandardButton.Save)
    path = editor.document.path
    assert path is not None
    assert not editor.editor.close()
    questions = answer_questions(monkeypatch, QMessageBox.StandardButton.Cancel)
    assert not editor.editor.close()
    assert "is still being saved" in questions[0]
    editor.wait(lambda: not editor.editor.isVisible())
    assert "serial_timeout: 9" in path.read_text(encoding="utf-8")


def test_editor_stays_open_after_a_failed_save(
    editor: SettingsEditorWindow, monkeypatch: pytest.MonkeyPatch
) -> None:
    def fail(_handle: int) -> None:
        raise OSError(errno.ENOSPC, "No space left on device")

    monkeypatch.setattr(os, "fsync", fail)
    answer_questions(monkeypatch, QMessageBox.StandardButton.Save)
    assert not editor.editor.close()
    editor.wait_for_text("bannerText", "No space left")
    assert editor.editor.isVisible()
    assert editor.document.modified
    assert text_of(editor) == ROVER
    answer_questions(monkeypatch, QMessageBox.StandardButton.Discard)
    assert editor.editor.close()


def test_program_closes_once_its_files_are_saved(
    window: WindowDriver, editor: SettingsEditorWindow, monkeypatch: pytest.MonkeyPatch
) -> None:
    answer_questions(monkeypatch, QMessageBox.StandardButton.Save)
    path = editor.document.path
    assert path is not None
    assert not window.window.close()
    assert window.window.isVisible()
    window.wait(lambda: not window.window.isVisible())
    assert "serial_timeout: 9" in path.read_text(encoding="utf-8")


def test_settings_of_the_board_are_saved_before_the_program_closes(
    connected_window: WindowDriver,
    disk: SlowDisk,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    window, path = connected_window, tmp_path / "board.txt"
    path.write_text(ROVER, encoding="utf-8")
    window.device.parameters.edit("serial_timeout", 9)
    monkeypatch.setattr(QFileDialog, "getSaveFileName", lambda *_: (str(path), ""))
    assert not window.window.close()
    window.click("saveAndClose")
    assert window.window.isVisible()
    window.device.parameters.edit("serial_timeout", 15)
    window.wait_for_text("bannerText", "were saved in")
    assert "serial_timeout: 9" in path.read_text(encoding="utf-8")
    assert window.window.isVisible(), "the setting was edited meanwhile"
    window.click("saveAndClose")
    window.wait(lambda: not window.window.isVisible())
    assert "serial_timeout: 15" in path.read_text(encoding="utf-8")
    assert disk.stalls == []


# --- Other files ------------------------------------------------------------------------


def test_thread_of_the_window_saves_no_file(
    connected_window: WindowDriver, disk: SlowDisk, tmp_path: Path
) -> None:
    window, workspace = connected_window, trex(connected_window.program).workspace
    recorder = workspace.recordings.recorder
    saves: dict[str, Callable[[Path], object]] = {
        "code.py": lambda path: workspace.files.saver.export_file(path, Language.PYTHON),
        "board.txt": workspace.files.saver.save_file,
        "a.trexrec": recorder.start,
    }
    for name, save in saves.items():
        save(tmp_path / name)
    window.device.parameters.edit("serial_timeout", 9)  # saved for the next start
    window.wait(lambda: all((tmp_path / name).exists() for name in saves))
    window.wait(lambda: any((data_folder() / "edits").glob("*.txt")))
    recorder.stop()
    window.wait(lambda: not recorder.recording)
    window.trigger("history")
    window.wait_for_files()
    assert disk.stalls == []
