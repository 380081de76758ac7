"""Settings files that are opened and saved, with and without a board."""

from collections.abc import Iterator
from pathlib import Path

import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QDialog, QDialogButtonBox, QListView, QMessageBox
from shiboken6 import isValid

from tests.support.bad_files import BAD_FILES
from tests.support.keyboard import check_keyboard
from tests.support.pages.settings import ComparisonDialog, SettingsFiles, answer_questions
from tests.support.simulator import SimulatedDevice
from tests.support.window import LEFT, WindowDriver

ROVER = """product: TReX
serial_timeout: 5
motor_mode: 0
motor1_acceleration: 7
rc_channel_2: {minimum: 2600, neutral: 3700, maximum: 4900, deadband: 60}
"""
BAD = [bad for bad in BAD_FILES if bad.name in {"unknown", "latin", "empty", "binary", "huge"}]
"""One file of each kind. `model/settings/test_document.py` reads all files."""

ANALOG = "analog_channel_1: {minimum: 10, neutral: 500, maximum: 1000, deadband: 9}\n"


@pytest.fixture
def files(connected_window: WindowDriver) -> SettingsFiles:
    return SettingsFiles(connected_window)


def test_load_dialog_compares_the_file_with_the_board(
    connected_window: WindowDriver, files: SettingsFiles, tmp_path: Path
) -> None:
    window, device = connected_window, connected_window.device
    saved = tmp_path / "board.txt"
    files.save(saved)
    assert saved.read_text(encoding="utf-8").startswith("product: TReX\n")
    dialog = files.load(saved)
    assert "28 parameters: 0 will change, 28 match" in dialog.text("comparisonSummary")
    assert "5 calibrations: 0 will change, 5 match" in dialog.text("comparisonSummary")
    assert not dialog.is_enabled("takeChangesButton")

    dialog = files.load(tmp_path / "rover.txt", ROVER)
    assert "The file is for a TReX, and the board is a TReX 1.2." in dialog.text("loadCaption")
    summary = "3 parameters: 2 will change, 1 match; 1 calibration: 1 will change"
    assert summary in dialog.text("comparisonSummary")
    assert "therefore unchanged" in dialog.findings()[-1]
    assert "Load 3 changes" in dialog.button_text()
    assert any("24 of 27 parameters are missing" in text for text in dialog.findings())
    assert device.draft.pending == 0

    dialog.tick_all(False)
    assert not dialog.is_enabled("takeChangesButton")
    device.parameters.edit("motor_mode", 1)
    assert "3 parameters: 3 will change, 0 match" in dialog.text("comparisonSummary")
    assert "Load 1 change" in dialog.button_text()

    window.disconnect()
    window.wait_for_text("bannerText", "rover.txt was not loaded: the board is no longer connected")
    assert files.load_dialogs() == []


def test_checked_rows_become_edits(
    connected_window: WindowDriver,
    files: SettingsFiles,
    quick_simulator: SimulatedDevice,
    tmp_path: Path,
) -> None:
    window, device = connected_window, connected_window.device
    dialog = files.load(tmp_path / "rover.txt", ROVER)
    dialog.toggle("Motor 1 Acceleration")
    with window.qtbot.waitSignal(files.files.staged):
        dialog.click("takeChangesButton")
    assert "2 changes are pending" in window.text("bannerText")
    assert window.window.pages.currentWidget().objectName() == "parametersPageArea"
    assert quick_simulator.show()["parameters"]["serial_timeout"] == 0
    window.trigger("undo")
    assert device.draft.pending == 0, "loading is one step"
    window.trigger("redo")
    window.apply()
    parameters = quick_simulator.show()["parameters"]
    assert (parameters["serial_timeout"], parameters["motor1_acceleration"]) == (5, 0)
    stored = device.calibrations.stored(2)
    assert stored is not None
    assert (stored.minimum, stored.deadband) == (2600, 60)


def test_file_that_reverts_all_edits_leaves_nothing_to_write(
    connected_window: WindowDriver, files: SettingsFiles, tmp_path: Path
) -> None:
    window, device = connected_window, connected_window.device
    saved = tmp_path / "board.txt"
    files.save(saved)
    device.parameters.edit("motor_mode", 1)
    dialog = files.load(saved)
    assert "Load 1 change" in dialog.button_text()
    dialog.click("takeChangesButton")
    assert device.draft.pending == 0
    assert window.text("bannerText") == "board.txt: Nothing to write."


def test_invalid_files_change_nothing_and_findings_name_lines(
    connected_window: WindowDriver, files: SettingsFiles, tmp_path: Path
) -> None:
    path = tmp_path / "bad.txt"
    for bad in BAD:
        path.write_bytes(bad.data)
        files.files.open_file(path)
        connected_window.wait_for_files()
        if bad.is_text:
            dialog = files.load_dialog()
            assert "Nothing was changed" in dialog.text("loadTrouble"), bad.name
            line = "" if bad.line is None else f"Line {bad.line}: "
            assert any(
                text.startswith(line) and bad.words.lower() in text.lower()
                for text in dialog.findings()
            ), bad.name
            assert not dialog.is_enabled("takeChangesButton"), bad.name
            dialog.root.close()
        else:
            assert files.load_dialogs() == [], bad.name
            assert "bad.txt was not opened" in connected_window.text("bannerText"), bad.name
            assert bad.words in connected_window.text("bannerText"), bad.name
        assert connected_window.device.draft.pending == 0, bad.name

    files.files.open_file(tmp_path / "nowhere.txt")
    connected_window.wait_for_files()
    assert "nowhere.txt was not opened" in connected_window.text("bannerText")


JUNIOR = """# small rover
product: TReX Jr
motor1_current_limit: 60  # measured
serial_timeout: 5
rc_channel_2: {minimum: 2600, neutral: 3700, maximum: 4900, deadband: 60}
"""


def test_file_of_another_model_is_converted_when_opened(
    connected_window: WindowDriver, files: SettingsFiles, tmp_path: Path
) -> None:
    window, device = connected_window, connected_window.device
    path = tmp_path / "junior.txt"
    dialog = files.load(path, JUNIOR)
    assert dialog.text("loadCaption").startswith(
        "The file is for a TReX Jr, and the board is a TReX 1.2."
    )
    assert dialog.findings()[1:3] == [
        "For a TReX 1.2: 2 carried over, 1 changed, 0 left out.",
        "Motor 1 Current Limit: 4.8 A. The same value in steps of 0.3 A: 60 becomes 16.",
    ]
    check_keyboard(dialog.root)
    dialog.click("takeChangesButton")
    assert dict(device.parameters.values.pending) == {
        "motor1_current_limit": 16,
        "serial_timeout": 5,
    }
    assert device.draft.pending == 3

    files.files.edit_file(path)
    window.wait_for_files()
    editor = files.editor()
    editor.action("Convert").trigger()
    convert = ComparisonDialog(editor.find(QDialog, "convertDialog"), window.qtbot)
    check_keyboard(convert.root)
    assert convert.combo("convertBoard").currentText() == "TReX, firmware 1.2"
    box = convert.combo("convertBoard")
    for text in ("TReX Jr, firmware 1.0", "TReX, firmware 1.2"):
        box.setCurrentIndex(box.findText(text))
        box.activated.emit(box.currentIndex())
        assert text.replace(", firmware", "") in convert.text("comparisonSummary")
    (limit,) = convert.rows()
    assert limit[:3] == ["Motor 1 Current Limit", "4.8 A", "4.8 A"]
    assert limit[4].startswith("The same value in steps of 0.3 A")
    convert.click("convertButton")
    old, new = files.files.editors
    assert new.document.name == "junior_trex.txt"
    assert "# small rover" in new.document.text
    assert "motor1_current_limit: 16  # measured" in new.document.text
    assert old.document.text == JUNIOR == path.read_text(encoding="utf-8")
    files.files.close_all()


def test_editor_compares_with_board_and_sends_to_board(
    connected_window: WindowDriver,
    files: SettingsFiles,
    quick_simulator: SimulatedDevice,
    tmp_path: Path,
) -> None:
    window = connected_window
    path = tmp_path / "rover.txt"
    path.write_text("product: TReX\nserial_timeout: 0\n", encoding="utf-8")
    files.files.edit_file(path)
    window.wait_for_files()
    editor = files.editor()
    editor.editor.compare_with_board()
    comparison = ComparisonDialog(editor.find(QDialog, "compareDialog"), window.qtbot)
    assert "1 match" in comparison.text("comparisonSummary")
    window.device.parameters.edit("serial_timeout", 5)
    comparison.wait_for_text("comparisonSummary", "0 match")
    window.device.draft.discard_edits()

    editor.edit("serial_timeout", 9)
    editor.action("Send").trigger()
    dialog = files.load_dialog()
    assert not dialog.has("editFileButton")
    dialog.click("takeChangesButton")
    window.apply()
    assert quick_simulator.show()["parameters"]["serial_timeout"] == 9
    assert path.read_text(encoding="utf-8") == "product: TReX\nserial_timeout: 0\n"
    window.disconnect()
    assert not editor.action("Send").isEnabled()
    files.files.close_all()


def test_saving_keeps_comments_and_asks_before_replacing(
    connected_window: WindowDriver,
    files: SettingsFiles,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    path = tmp_path / "rover.txt"
    text = f"product: TReX\n# my rover\nserial_timeout: 9  # for the bench\n{ANALOG}"
    path.write_text(text, encoding="utf-8")
    connected_window.device.parameters.edit("serial_timeout", 5)
    files.save(path)
    after = path.read_text(encoding="utf-8")
    assert after.startswith(text.replace("9  # for", "5  # for"))
    assert "motor_mode: 0" in after
    message = "Calibrations that the board does not currently report remain in the file: analog."
    assert message in connected_window.text("bannerText")

    for text in ("Dear diary\n", "product: TReX Jr\n"):
        path.write_text(text, encoding="utf-8")
        questions = answer_questions(monkeypatch, QMessageBox.StandardButton.Cancel)
        files.save(path)
        assert "Replace it?" in questions[0], text
        assert path.read_text(encoding="utf-8") == text
        answer_questions(monkeypatch, QMessageBox.StandardButton.Yes)
        files.save(path)
        assert "motor_mode: 0" in path.read_text(encoding="utf-8"), text


TEXT = "product: TReX\n# my rover\nserial_timeout: 5  # 0.5 s\n"
BEGINNINGS = (
    ("Factory defaults of a TReX Jr, firmware 1.1", "motor_mode", 0),
    ("Sample: A tank: two tracks, driven by radio with one stick", "parabolic_channels", 3),
)


@pytest.fixture
def offline(window: WindowDriver) -> Iterator[SettingsFiles]:
    offline = SettingsFiles(window)
    yield offline
    offline.files.close_all()


@pytest.fixture
def rover(tmp_path: Path) -> Path:
    path = tmp_path / "rover.txt"
    path.write_text(TEXT, encoding="utf-8")
    return path


def test_each_file_is_opened_once_and_closed(
    window: WindowDriver, offline: SettingsFiles, rover: Path, tmp_path: Path
) -> None:
    assert window.action("open").isEnabled()
    offline.files.open_file(rover)
    window.wait_for_files()
    editor = offline.editor()
    assert editor.root.isVisible()
    assert editor.document.text == TEXT
    assert not editor.action("Send").isEnabled()
    offline.files.open_file(rover)
    window.wait_for_files()
    assert len(offline.files.editors) == 1, "the file is open already"

    other = tmp_path / "other.txt"
    other.write_text(TEXT, encoding="utf-8")
    offline.files.open_file(other)
    window.wait_for_files()
    assert len(offline.files.editors) == 2
    editor.action("Close").trigger()
    window.wait(lambda: not isValid(editor.root))
    assert [each.document.name for each in offline.files.editors] == ["other.txt"]


def test_new_file_starts_with_chosen_settings(
    window: WindowDriver, offline: SettingsFiles, tmp_path: Path
) -> None:
    for beginning, key, value in BEGINNINGS:
        window.trigger("new")
        dialog = window.dialog("newSettingsDialog")
        beginnings = dialog.find(QListView, "beginningsList")
        model, exact = beginnings.model(), Qt.MatchFlag.MatchExactly
        (index,) = model.match(model.index(0, 0), Qt.ItemDataRole.DisplayRole, beginning, -1, exact)
        beginnings.setCurrentIndex(index)
        box = dialog.find_only(QDialogButtonBox)
        QTest.mouseClick(box.button(QDialogButtonBox.StandardButton.Ok), LEFT)
        editor = offline.editor()
        assert editor.document.draft.parameters.values.value_of(key) == value, beginning
        assert not editor.root.isWindowModified()
        editor.editor.save_to(tmp_path / "mine.txt")
        window.wait_for_files()
        assert editor.root.windowTitle().startswith("mine.txt")
        offline.files.close_all()
        window.wait(lambda: not window.has("newSettingsDialog"))


def test_closing_the_program_asks_about_unsaved_files(
    window: WindowDriver, offline: SettingsFiles, rover: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    offline.files.open_file(rover)
    window.wait_for_files()
    editor = offline.editor()
    editor.edit("serial_timeout", 15)
    questions = answer_questions(monkeypatch, QMessageBox.StandardButton.Cancel)
    assert not window.window.close()
    assert "rover.txt has changes that are not saved" in questions[0]
    assert editor.root.isVisible()
    answer_questions(monkeypatch, QMessageBox.StandardButton.Discard)
    assert window.window.close()
    assert not offline.files.editors
    assert rover.read_text(encoding="utf-8") == TEXT


def test_apply_and_undo_shortcuts_work_only_in_main_window(window: WindowDriver) -> None:
    """Undo affects only its own window, but Esc stops the motors in every window."""
    for key, context in (
        ("apply", Qt.ShortcutContext.WindowShortcut),
        ("undo", Qt.ShortcutContext.WindowShortcut),
        ("stop", Qt.ShortcutContext.ApplicationShortcut),
    ):
        assert window.action(key).shortcutContext() is context, key
