"""A person opens and saves settings files; the board is simulated, in a process of its own."""

from pathlib import Path

import pytest
from PySide6.QtCore import Qt
from PySide6.QtGui import QAction
from PySide6.QtTest import QTest
from PySide6.QtWidgets import (
    QDialog,
    QLabel,
    QMessageBox,
    QPushButton,
    QTableView,
    QTableWidget,
    QWidget,
)
from pytestqt.qtbot import QtBot
from shiboken6 import isValid

from tests.support.bad_files import BAD_FILES, BadFile
from tests.support.simulator import SimulatedDevice, StartSimulator
from trex_gui.export.language import Language
from trex_gui.link.settings import LinkSettings
from trex_gui.model.device import Link
from trex_gui.protocol.calibration import Calibration
from trex_gui.window import Program


@pytest.fixture
def simulator(quick_simulator: SimulatedDevice) -> SimulatedDevice:
    return quick_simulator


@pytest.fixture
def connected(program: Program, qtbot: QtBot, simulator: SimulatedDevice) -> Program:
    program.device.connect_to(LinkSettings(simulator.url))
    qtbot.waitUntil(lambda: program.device.link is Link.UP)
    return program


def banner(program: Program) -> str:
    return label(program.window, "bannerText")


def dialog(program: Program) -> QDialog:
    found = [d for d in program.window.findChildren(QDialog, "loadSettingsDialog") if d.isVisible()]
    assert len(found) == 1
    return found[0]


def offered(program: Program, path: Path, text: str | bytes) -> QDialog:
    """Write a file, open it, and return what is shown of it."""
    path.write_bytes(text if isinstance(text, bytes) else text.encode())
    program.desk.files.open_file(path)
    return dialog(program)


def label(parent: QWidget, name: str) -> str:
    found = parent.findChild(QLabel, name)
    assert found is not None
    return found.text()


def button(parent: QWidget, name: str) -> QPushButton:
    found = parent.findChild(QPushButton, name)
    assert found is not None
    return found


def take(shown: QDialog) -> None:
    QTest.mouseClick(button(shown, "takeChangesButton"), Qt.MouseButton.LeftButton)


def findings(shown: QDialog) -> list[tuple[str, str]]:
    """Line and words of each row."""
    table = shown.findChild(QTableWidget, "findingsTable")
    assert table is not None
    cells = [[table.item(row, column) for column in (1, 3)] for row in range(table.rowCount())]
    return [(line.text(), words.text()) for line, words in cells if line and words]


ROVER = """product: TReX
serial_timeout: 5
motor_mode: 0
motor1_acceleration: 7
rc_channel_2: {minimum: 2600, neutral: 3700, maximum: 4900, deadband: 60}
"""


def test_what_was_saved_opens_as_no_change(connected: Program, tmp_path: Path) -> None:
    path = tmp_path / "board.txt"
    connected.desk.files.save_file(path)
    assert path.read_text(encoding="utf-8").startswith("product: TReX\n")
    connected.desk.files.open_file(path)
    summary = label(dialog(connected), "comparisonSummary")
    assert "28 parameters: 0 will change, 28 match" in summary
    assert "5 calibrations: 0 will change, 5 match" in summary
    assert not button(dialog(connected), "takeChangesButton").isEnabled()
    assert connected.device.pending == 0


def test_a_file_shows_what_it_would_change_before_anything_does(
    connected: Program, tmp_path: Path
) -> None:
    shown = offered(connected, tmp_path / "rover.txt", ROVER)
    assert "rover.txt: settings for a TReX." in label(shown, "loadHead")
    summary = label(shown, "comparisonSummary")
    assert "3 parameters: 2 will change, 1 match; 1 calibration: 1 will change" in summary
    assert "stay as they are" in label(shown, "loadFoot")
    assert "Make 3 changes edits" in button(shown, "takeChangesButton").text().replace("&", "")
    assert any("24 of 27 parameters are missing" in words for _, words in findings(shown))
    assert connected.device.pending == 0


def test_ticked_rows_become_edits_and_apply_writes_just_them(
    connected: Program, qtbot: QtBot, simulator: SimulatedDevice, tmp_path: Path
) -> None:
    shown = offered(connected, tmp_path / "rover.txt", ROVER)
    view = shown.findChild(QTableView, "comparisonTable")
    assert view is not None
    index = view.model().index(1, 0)
    assert index.data() == "Motor 1 Acceleration"
    view.model().setData(index, Qt.CheckState.Unchecked.value, Qt.ItemDataRole.CheckStateRole)
    with qtbot.waitSignal(connected.desk.files.staged):
        take(shown)
    assert "2 changes are edits now" in banner(connected)
    assert connected.window.pages.currentWidget().objectName() == "parametersPageArea"
    assert simulator.show()["parameters"]["serial_timeout"] == 0
    connected.device.apply()
    qtbot.waitUntil(lambda: connected.device.pending == 0)
    parameters = simulator.show()["parameters"]
    assert (parameters["serial_timeout"], parameters["motor1_acceleration"]) == (5, 0)
    stored = connected.device.calibrations.stored(2)
    assert stored is not None
    assert (stored.minimum, stored.deadband) == (2600, 60)


def test_an_editor_sends_what_it_shows_to_the_board(
    connected: Program, qtbot: QtBot, simulator: SimulatedDevice, tmp_path: Path
) -> None:
    path = tmp_path / "rover.txt"
    path.write_text(ROVER, encoding="utf-8")
    editor = connected.desk.files.edit_file(path)
    assert editor is not None
    editor.document.draft.parameters.edit("serial_timeout", 9)
    send = editor.findChild(QAction, "editorSendAction")
    assert send is not None
    send.trigger()
    shown = dialog(connected)
    assert not button(shown, "editFileButton").isVisible()
    take(shown)
    connected.device.apply()
    qtbot.waitUntil(lambda: connected.device.pending == 0)
    assert simulator.show()["parameters"]["serial_timeout"] == 9
    assert path.read_text(encoding="utf-8") == ROVER
    connected.connector.disconnect_port()
    qtbot.waitUntil(lambda: connected.device.link is Link.NONE)
    assert not send.isEnabled()
    editor.close_at_once()


def test_an_editor_compares_with_the_board_as_its_edits_change(
    connected: Program, qtbot: QtBot, tmp_path: Path
) -> None:
    path = tmp_path / "rover.txt"
    path.write_text("product: TReX\nserial_timeout: 0\n", encoding="utf-8")
    editor = connected.desk.files.edit_file(path)
    assert editor is not None
    editor.compare_with_board()
    shown = editor.findChild(QDialog, "compareDialog")
    assert isinstance(shown, QDialog)
    assert "1 match" in label(shown, "comparisonSummary")
    connected.device.parameters.edit("serial_timeout", 5)
    qtbot.waitUntil(lambda: "0 match" in label(shown, "comparisonSummary"))
    editor.close_at_once()


def test_the_dialog_follows_the_board_and_keeps_what_was_unticked(
    connected: Program, tmp_path: Path
) -> None:
    shown = offered(connected, tmp_path / "rover.txt", ROVER)
    QTest.mouseClick(button(shown, "tickNoneButton"), Qt.MouseButton.LeftButton)
    assert not button(shown, "takeChangesButton").isEnabled()
    connected.device.parameters.edit("motor_mode", 1)
    summary = label(shown, "comparisonSummary")
    assert "3 parameters: 3 will change, 0 match" in summary
    assert "Make 1 change an edit" in button(shown, "takeChangesButton").text().replace("&", "")


def test_the_dialog_closes_with_a_sentence_when_the_board_goes(
    connected: Program, qtbot: QtBot, tmp_path: Path
) -> None:
    shown = offered(connected, tmp_path / "rover.txt", ROVER)
    connected.connector.disconnect_port()
    qtbot.waitUntil(lambda: not isValid(shown))
    assert "rover.txt was not loaded: no board is connected any more" in banner(connected)


@pytest.mark.parametrize("bad", BAD_FILES, ids=lambda bad: bad.name)
def test_a_bad_file_changes_nothing_and_names_the_lines(
    connected: Program, tmp_path: Path, bad: BadFile
) -> None:
    path = tmp_path / "bad.txt"
    if not bad.is_text:
        path.write_bytes(bad.data)
        connected.desk.files.open_file(path)
        assert "bad.txt was not opened" in banner(connected)
        assert bad.words in banner(connected)
        return
    shown = offered(connected, path, bad.data)
    assert "Nothing was changed" in label(shown, "loadTrouble")
    line = "" if bad.line is None else str(bad.line)
    assert any(line == at and bad.words.lower() in words.lower() for at, words in findings(shown))
    assert not button(shown, "takeChangesButton").isEnabled()
    assert connected.device.pending == 0


def test_a_file_for_another_model_changes_nothing_and_offers_the_editor(
    connected: Program, tmp_path: Path
) -> None:
    text = "# small\nproduct: TReX Jr\nserial_timeout: 5\n"
    shown = offered(connected, tmp_path / "junior.txt", text)
    assert "for another board" in label(shown, "loadTrouble")
    assert findings(shown)[0][0] == "2"
    assert "settings of a TReX Jr" in findings(shown)[0][1]
    assert not button(shown, "takeChangesButton").isEnabled()
    QTest.mouseClick(button(shown, "editFileButton"), Qt.MouseButton.LeftButton)
    (editor,) = connected.desk.files.editors
    assert editor.document.name == "junior.txt"
    assert connected.device.pending == 0
    editor.close_at_once()


def test_a_file_for_another_firmware_leaves_out_what_the_board_lacks(
    qtbot: QtBot,
    program: Program,
    start_simulator: StartSimulator,
    tmp_path: Path,
) -> None:
    simulator = start_simulator("--firmware", "1.0", "--unpaced")
    program.device.connect_to(LinkSettings(simulator.url))
    qtbot.waitUntil(lambda: program.device.link is Link.UP)
    text = "product: TReX\nfirmware: 1.2\nuart_response_delay: 1\nserial_timeout: 5\n"
    shown = offered(program, tmp_path / "newer.txt", text)
    assert "with firmware 1.2; the board has 1.0" in label(shown, "loadHead")
    assert "firmware 1.0 does not have it" in label(shown, "comparisonLeftOut")
    take(shown)
    assert program.device.parameters.pending == (("serial_timeout", 5),)


def test_a_file_for_an_older_firmware_leaves_the_rest_as_it_is(
    connected: Program, tmp_path: Path
) -> None:
    text = "product: TReX\nfirmware: 1.0\nserial_timeout: 5\n"
    shown = offered(connected, tmp_path / "older.txt", text)
    assert "with firmware 1.0; the board has" in label(shown, "loadHead")
    assert label(shown, "comparisonSummary") == "1 parameter: 1 will change, 0 match."


def test_analog_calibrations_are_left_out_and_named_while_inputs_are_rc(
    connected: Program, tmp_path: Path
) -> None:
    text = (
        "product: TReX\nanalog_channel_1: {minimum: 10, neutral: 500, maximum: 1000, deadband: 9}\n"
    )
    shown = offered(connected, tmp_path / "analog.txt", text)
    assert "analog calibrations are left out" in label(shown, "comparisonLeftOut")


def test_a_missing_file_is_a_sentence(connected: Program, tmp_path: Path) -> None:
    connected.desk.files.open_file(tmp_path / "nowhere.txt")
    assert "was not opened" in banner(connected)


# --- Saving over a file -----------------------------------------------------------------


def answer(monkeypatch: pytest.MonkeyPatch, button: QMessageBox.StandardButton) -> list[str]:
    """Press this button in every question; return what is asked."""
    asked: list[str] = []

    def question(_window: QWidget, _title: str, text: str, *_: object) -> object:
        asked.append(text)
        return button

    monkeypatch.setattr(QMessageBox, "question", question)
    return asked


def test_saving_over_a_file_keeps_what_a_person_wrote_and_what_the_board_hides(
    connected: Program, tmp_path: Path
) -> None:
    path = tmp_path / "rover.txt"
    text = (
        "product: TReX\n# my rover\nserial_timeout: 9  # for the bench\n"
        "analog_channel_1: {minimum: 10, neutral: 500, maximum: 1000, deadband: 9}\n"
    )
    path.write_text(text, encoding="utf-8")
    connected.device.parameters.edit("serial_timeout", 5)
    connected.desk.files.save_file(path)
    after = path.read_text(encoding="utf-8")
    assert after.startswith(text.replace("9  # for", "5  # for"))
    assert "motor_mode: 0" in after
    assert "analog calibrations, which the board does not show now, were kept" in banner(connected)


@pytest.mark.parametrize("text", ["Dear diary\n", "product: TReX Jr\n"])
def test_a_file_that_is_something_else_is_replaced_only_after_a_question(
    connected: Program, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, text: str
) -> None:
    path = tmp_path / "other.txt"
    path.write_text(text, encoding="utf-8")
    asked = answer(monkeypatch, QMessageBox.StandardButton.Cancel)
    connected.desk.files.save_file(path)
    assert "Replace it?" in asked[0]
    assert path.read_text(encoding="utf-8") == text
    answer(monkeypatch, QMessageBox.StandardButton.Yes)
    connected.desk.files.save_file(path)
    assert "motor_mode: 0" in path.read_text(encoding="utf-8")


def test_the_settings_shown_are_previewed_for_print(connected: Program) -> None:
    action(connected, "print").trigger()
    shown = connected.window.findChild(QDialog, "printPreviewDialog")
    if shown is None:
        assert "printing is not installed" in banner(connected)
    else:
        assert shown.isVisible()
        shown.close()


# --- Undo, snapshots, export ------------------------------------------------------------


def action(program: Program, name: str) -> QAction:
    found = program.window.findChild(QAction, f"{name}Action")
    assert found is not None
    return found


def test_edits_are_undone_and_redone_from_the_menu_whatever_page_made_them(
    connected: Program, tmp_path: Path
) -> None:
    undo, redo = action(connected, "undo"), action(connected, "redo")
    assert not undo.isEnabled()
    connected.device.parameters.edit("serial_timeout", 5)
    connected.device.calibrations.edit(2, Calibration(2600, 3700, 4900, 60))
    assert undo.text().endswith("Calibration of channel 2")
    undo.trigger()
    assert undo.text().endswith("Serial Timeout")
    undo.trigger()
    assert connected.device.pending == 0
    assert not undo.isEnabled()
    redo.trigger()
    redo.trigger()
    assert connected.device.pending == 2


def test_a_file_that_was_loaded_is_one_step_to_undo(connected: Program, tmp_path: Path) -> None:
    text = "product: TReX\nserial_timeout: 5\nmotor_mode: 1\n"
    take(offered(connected, tmp_path / "rover.txt", text))
    assert connected.device.pending == 2
    action(connected, "undo").trigger()
    assert connected.device.pending == 0


def test_what_was_stored_before_an_apply_comes_back_from_its_snapshot(
    connected: Program, qtbot: QtBot, simulator: SimulatedDevice
) -> None:
    connected.device.parameters.edit("serial_timeout", 5)
    connected.device.apply()
    qtbot.waitUntil(lambda: connected.device.pending == 0)
    (snapshot,) = connected.device.history.snapshots()
    connected.desk.files.open_file(snapshot.path, remember=False)
    take(dialog(connected))
    assert connected.device.parameters.pending == (("serial_timeout", 0),)
    connected.device.apply()
    qtbot.waitUntil(lambda: connected.device.pending == 0)
    assert simulator.show()["parameters"]["serial_timeout"] == 0
    assert len(connected.device.history.snapshots()) == 2


@pytest.mark.parametrize("language", list(Language))
def test_the_settings_shown_are_exported_as_code(
    connected: Program, tmp_path: Path, language: Language
) -> None:
    connected.device.parameters.edit("serial_timeout", 5)
    path = tmp_path / f"board{language.suffix}"
    connected.desk.files.export_file(path, language)
    text = path.read_text(encoding="utf-8")
    assert "Serial Timeout" in text
    assert "0.5 s" in text
    assert "applies and checks" in banner(connected)


def test_a_place_that_cannot_be_written_is_told(connected: Program, tmp_path: Path) -> None:
    connected.desk.files.export_file(tmp_path / "missing" / "board.py", Language.PYTHON)
    assert "was not written" in banner(connected)
