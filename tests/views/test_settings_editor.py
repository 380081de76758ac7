"""The window for one settings file, with no board."""

from collections.abc import Callable, Iterator
from pathlib import Path
from typing import TypeVar

import pytest
from PySide6.QtCore import QCoreApplication, Qt
from PySide6.QtGui import QAction, QColor, QTextCursor
from PySide6.QtTest import QTest
from PySide6.QtWidgets import (
    QApplication,
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
from trex_gui.model.device import Device
from trex_gui.model.settings_document import SettingsDocument
from trex_gui.protocol.calibration import DEFAULT_CALIBRATION, Calibration
from trex_gui.protocol.flags import InputSource
from trex_gui.resource_files import resource
from trex_gui.views.settings_editor.count_editor import CountEditor
from trex_gui.views.settings_editor.numbered_text import NumberedText
from trex_gui.views.settings_editor.printed import PrintedSettings
from trex_gui.views.settings_editor.window import SettingsEditor
from trex_gui.views.theme import theme

TEXT = (
    "product: TReX\r\n"
    "# my rover\r\n"
    "motor_mode: 0   # two motors\r\n"
    "rc_channel_2: {minimum: 2600, neutral: 3700, maximum: 4900, deadband: 60}\r\n"
)
PARAMETERS, CALIBRATIONS, FINDINGS, TEXT_PAGE = range(4)

WidgetT = TypeVar("WidgetT", bound=QWidget)
Open = Callable[[str | bytes], SettingsEditor]


@pytest.fixture
def device(qapp: QApplication) -> Device:
    theme().install(qapp)
    return Device()


@pytest.fixture
def open_text(device: Device, tmp_path: Path, qtbot: QtBot) -> Iterator[Open]:
    editors = []

    def opened(data: str | bytes) -> SettingsEditor:
        path = tmp_path / "rover.txt"
        path.write_bytes(data if isinstance(data, bytes) else data.encode())
        editor = SettingsEditor(SettingsDocument.open(path), device)
        editors.append(editor)
        editor.show()
        return editor

    yield opened
    for editor in editors:
        if isValid(editor):
            editor.close_at_once()


def child(parent: QWidget, kind: type[WidgetT], name: str) -> WidgetT:
    found = parent.findChild(kind, name)
    assert isinstance(found, kind), name
    return found


def trigger(editor: SettingsEditor, name: str) -> None:
    found = editor.findChild(QAction, f"editor{name}Action")
    assert found is not None
    assert found.isEnabled(), name
    found.trigger()


def answer(monkeypatch: pytest.MonkeyPatch, button: QMessageBox.StandardButton) -> list[str]:
    """Press this button in every question; return what is asked."""
    asked: list[str] = []

    def question(_window: QWidget, _title: str, text: str, *_: object) -> object:
        asked.append(text)
        return button

    monkeypatch.setattr(QMessageBox, "question", question)
    return asked


def banner(editor: SettingsEditor) -> str:
    return child(editor, QLabel, "bannerText").text()


def press(editor: QWidget, name: str) -> None:
    QTest.mouseClick(child(editor, QPushButton, name), Qt.MouseButton.LeftButton)


def select(editor: SettingsEditor, row: int, column: int = 1) -> QTableView:
    editor.tabs.setCurrentIndex(CALIBRATIONS)
    view = child(editor, QTableView, "calibrationsView")
    view.setCurrentIndex(view.model().index(row, column))
    return view


def type_count(editor: SettingsEditor, row: int, column: int, text: str) -> CountEditor:
    view = select(editor, row, column)
    view.edit(view.currentIndex())
    box = child(view, CountEditor, "countEditor")
    box.selectAll()
    QTest.keyClick(box, Qt.Key.Key_Delete)
    QTest.keyClicks(box, text)
    QTest.keyClick(box, Qt.Key.Key_Return)
    QCoreApplication.sendPostedEvents(view.itemDelegate())  # it takes Return a moment later
    return box


def findings(panel: QWidget) -> list[tuple[str, str]]:
    """Line and words of each row."""
    table = child(panel, QTableWidget, "findingsTable")
    cells = [[table.item(row, column) for column in (1, 3)] for row in range(table.rowCount())]
    return [(line.text(), words.text()) for line, words in cells if line and words]


def says(rows: list[tuple[str, str]], bad: BadFile) -> bool:
    """Whether one of the rows says what has to be said of a bad file, in its line."""
    line = "" if bad.line is None else str(bad.line)
    return any(line == at and bad.words.lower() in words.lower() for at, words in rows)


# --- What is shown ----------------------------------------------------------------------


def test_the_title_names_the_file_and_marks_unsaved_edits(open_text: Open, qtbot: QtBot) -> None:
    editor = open_text(TEXT)
    assert editor.windowTitle() == "rover.txt[*] – TReX settings file"
    assert not editor.isWindowModified()
    editor.document.draft.parameters.edit("motor_mode", 1)
    qtbot.waitUntil(editor.isWindowModified)
    trigger(editor, "Undo")
    qtbot.waitUntil(lambda: not editor.isWindowModified())


def test_the_text_page_shows_what_save_writes_and_cannot_be_typed_into(
    open_text: Open, qtbot: QtBot
) -> None:
    editor = open_text(TEXT)
    text = child(editor, NumberedText, "settingsText")
    assert text.isReadOnly()
    editor.document.draft.parameters.edit("motor_mode", 1)
    qtbot.waitUntil(lambda: "motor_mode: 1   # two motors" in text.lines)
    assert "\n".join(text.lines) == editor.document.text.replace("\r\n", "\n")


def test_the_samples_open_with_every_page(open_text: Open) -> None:
    for path in resource("samples").glob("*.txt"):
        editor = open_text(path.read_bytes())
        for page in range(editor.tabs.count()):
            assert editor.tabs.isTabEnabled(page)
            editor.tabs.setCurrentIndex(page)
            assert not editor.grab().isNull()


@pytest.mark.parametrize("bad", [bad for bad in BAD_FILES if bad.is_text], ids=lambda bad: bad.name)
def test_a_bad_file_opens_as_text_with_its_findings(bad: BadFile, open_text: Open) -> None:
    editor = open_text(bad.data)
    assert editor.tabs.currentIndex() == TEXT_PAGE
    assert not editor.tabs.isTabEnabled(PARAMETERS)
    assert not editor.tabs.isTabEnabled(CALIBRATIONS)
    assert not child(editor, NumberedText, "settingsText").isReadOnly()
    rows = findings(child(editor, QWidget, "textFindings"))
    assert says(rows, bad)
    assert rows == findings(child(editor, QWidget, "findingsPanel"))
    assert not editor.isWindowModified()


def test_mending_the_text_and_checking_again_opens_the_pages(open_text: Open) -> None:
    editor = open_text("product: TReX\r\nmotor_mode: 9\r\n# mine\r\n")
    text = child(editor, NumberedText, "settingsText")
    text.show_line(2)
    QTest.keyClick(text, Qt.Key.Key_End)
    QTest.keyClick(text, Qt.Key.Key_Backspace)
    press(editor, "checkAgainButton")
    assert not editor.tabs.isTabEnabled(PARAMETERS)
    QTest.keyClicks(text, "1")
    assert editor.isWindowModified()
    press(editor, "checkAgainButton")
    assert editor.tabs.isTabEnabled(PARAMETERS)
    assert text.isReadOnly()
    trigger(editor, "Save")
    assert editor.document.path is not None
    saved = editor.document.path.read_bytes()
    assert saved == b"product: TReX\r\nmotor_mode: 1\r\n# mine\r\n"


def test_typing_is_undone_while_the_text_is_edited(open_text: Open) -> None:
    editor = open_text("product: TReX\nmotor_mode: 9\n")
    text = child(editor, NumberedText, "settingsText")
    QTest.keyClicks(text, "# ")
    assert editor.document.text.startswith("# product")
    trigger(editor, "Undo")
    assert editor.document.text == "product: TReX\nmotor_mode: 9\n"
    assert not editor.isWindowModified()


@pytest.mark.parametrize("text", ["a\xa0b\r\nc\rd\n\u2028e", "\ufeffx: [\n", "x: {\x85y\n"])
def test_looking_at_odd_text_changes_nothing_of_it(open_text: Open, text: str) -> None:
    editor = open_text(text)
    shown = child(editor, NumberedText, "settingsText")
    QTest.keyClicks(shown, "z")
    trigger(editor, "Undo")
    assert editor.document.text == text


def test_a_double_click_on_a_finding_shows_its_line(open_text: Open, qtbot: QtBot) -> None:
    editor = open_text("product: TReX\n\n\nmotor_mode: 9\n")
    editor.tabs.setCurrentIndex(FINDINGS)
    table = child(child(editor, QWidget, "findingsPanel"), QTableWidget, "findingsTable")
    item = table.item(0, 3)
    assert item is not None
    where = table.visualItemRect(item).center()
    QTest.mouseClick(table.viewport(), Qt.MouseButton.LeftButton, pos=where)
    QTest.mouseDClick(table.viewport(), Qt.MouseButton.LeftButton, pos=where)
    assert editor.tabs.currentIndex() == TEXT_PAGE
    assert child(editor, NumberedText, "settingsText").textCursor().blockNumber() == 3


def test_advice_stands_among_the_findings_and_can_be_accepted(
    open_text: Open, qtbot: QtBot
) -> None:
    editor = open_text("product: TReX\nrequired_channels: 1\nignored_channels: 1\n")
    editor.tabs.setCurrentIndex(FINDINGS)
    panel = child(editor, QWidget, "findingsPanel")
    rows = findings(panel)
    place = next(n for n, (_, words) in enumerate(rows) if "required and ignored" in words)
    assert rows[place][0] == "2"
    assert editor.tabs.tabText(FINDINGS) == f"Findings ({len(rows)})"
    child(panel, QTableWidget, "findingsTable").setCurrentCell(place, 0)
    press(panel, "acceptFindingButton")
    assert editor.document.draft.parameters.value_of("required_channels") == 0
    qtbot.waitUntil(lambda: len(findings(panel)) == len(rows) - 1)


# --- Calibrations -----------------------------------------------------------------------


@pytest.mark.parametrize("typed", ["1040.4", "1040.4 µs", "1,0404 ms", "2601 counts", "2601 #"])
def test_a_count_can_be_typed_in_any_unit(open_text: Open, typed: str) -> None:
    editor = open_text(TEXT)
    type_count(editor, 1, 1, typed)
    expected = Calibration(2601, 3700, 4900, 60)
    assert editor.document.draft.calibrations.shown(2, InputSource.RC) == expected
    trigger(editor, "Undo")
    assert editor.document.text == TEXT


@pytest.mark.parametrize("typed", ["2.5 V", "fast", "99999", "-1", ""])
def test_what_is_no_count_keeps_the_editor_open_and_is_told(open_text: Open, typed: str) -> None:
    editor = open_text(TEXT)
    box = type_count(editor, 1, 1, typed)
    assert box.isVisible()
    assert "no value here" in child(editor, QLabel, "calibrationsNote").text()
    QTest.keyClick(box, Qt.Key.Key_Escape)
    assert editor.document.text == TEXT


def test_a_refused_order_is_told_in_words(open_text: Open) -> None:
    editor = open_text(TEXT)
    type_count(editor, 1, 1, "1900")
    note = child(editor, QLabel, "calibrationsNote").text()
    assert "minimum 4750 is above neutral 3700" in note
    assert editor.document.text == TEXT


def test_calibrations_are_added_and_left_out(open_text: Open, qtbot: QtBot) -> None:
    editor = open_text(TEXT)
    calibrations = editor.document.draft.calibrations
    view = select(editor, 7)
    assert view.model().index(7, 1).data() == "not given"
    press(editor, "addCalibrationButton")
    assert calibrations.shown(3, InputSource.ANALOG) == DEFAULT_CALIBRATION[InputSource.ANALOG]
    select(editor, 1)
    press(editor, "leaveOutCalibrationButton")
    assert calibrations.shown(2, InputSource.RC) is None
    assert "# rc_channel_2" in editor.document.text
    trigger(editor, "Undo")
    trigger(editor, "Undo")
    assert editor.document.text == TEXT


# --- Saving and closing -----------------------------------------------------------------


def test_a_file_that_changed_on_disk_is_overwritten_only_after_a_question(
    open_text: Open, monkeypatch: pytest.MonkeyPatch
) -> None:
    editor = open_text(TEXT)
    path = editor.document.path
    assert path is not None
    path.write_text("product: TReX\n# by another program\n", encoding="utf-8")
    asked = answer(monkeypatch, QMessageBox.StandardButton.Cancel)
    trigger(editor, "Save")
    assert "changed by another program" in asked[0]
    assert "by another program" in path.read_text(encoding="utf-8")
    answer(monkeypatch, QMessageBox.StandardButton.Yes)
    trigger(editor, "Save")
    assert path.read_bytes() == TEXT.encode()


def test_what_cannot_be_changed_in_place_is_saved_fresh_only_after_a_question(
    open_text: Open, monkeypatch: pytest.MonkeyPatch
) -> None:
    editor = open_text("product: TReX\nfirmware: |\n  1.2")
    editor.document.draft.parameters.edit("motor_mode", 1)
    assert editor.document.path is not None
    asked = answer(monkeypatch, QMessageBox.StandardButton.Cancel)
    trigger(editor, "Save")
    assert "fresh text" in asked[0]
    assert editor.document.modified
    answer(monkeypatch, QMessageBox.StandardButton.Yes)
    trigger(editor, "Save")
    assert "motor_mode: 1" in editor.document.path.read_text(encoding="utf-8")


def test_a_place_that_cannot_be_written_is_told_and_nothing_is_lost(
    open_text: Open, tmp_path: Path
) -> None:
    editor = open_text(TEXT)
    editor.document.draft.parameters.edit("motor_mode", 1)
    assert not editor.save_to(tmp_path / "gone" / "rover.txt")
    assert "Not saved" in banner(editor)
    assert editor.document.modified


def test_closing_asks_what_becomes_of_edits(
    open_text: Open, monkeypatch: pytest.MonkeyPatch
) -> None:
    editor = open_text(TEXT)
    editor.document.draft.parameters.edit("motor_mode", 1)
    asked = answer(monkeypatch, QMessageBox.StandardButton.Cancel)
    assert not editor.close()
    assert "rover.txt has changes" in asked[0]
    answer(monkeypatch, QMessageBox.StandardButton.Save)
    path = editor.document.path
    assert editor.close()
    assert path is not None
    assert b"motor_mode: 1" in path.read_bytes()


# --- Comparing --------------------------------------------------------------------------


def test_another_file_is_compared_and_its_values_taken(
    open_text: Open, tmp_path: Path, qtbot: QtBot
) -> None:
    editor = open_text(TEXT)
    other = tmp_path / "other.txt"
    other.write_text("product: TReX\nmotor_mode: 1\nserial_timeout: 5\n", encoding="utf-8")
    editor.compare_with_file(other)
    dialog = child(editor, QDialog, "compareDialog")
    assert "3 settings: 3 differ, 0 match" in child(dialog, QLabel, "comparisonSummary").text()
    press(dialog, "takeValuesButton")
    parameters = editor.document.draft.parameters
    assert (parameters.value_of("motor_mode"), parameters.value_of("serial_timeout")) == (1, 5)
    assert "2 values were taken from other.txt" in banner(editor)
    summary = child(dialog, QLabel, "comparisonSummary")
    qtbot.waitUntil(lambda: "1 differs, 2 match" in summary.text())
    trigger(editor, "Undo")
    assert editor.document.text == TEXT
    dialog.close()


def test_factory_values_are_compared(open_text: Open) -> None:
    editor = open_text("product: TReX Jr\nserial_timeout: 5\n")
    trigger(editor, "CompareFactory")
    dialog = child(editor, QDialog, "compareDialog")
    assert "match" in child(dialog, QLabel, "comparisonSummary").text()
    dialog.close()


def test_a_file_of_another_model_is_compared_but_gives_nothing(
    open_text: Open, tmp_path: Path
) -> None:
    editor = open_text(TEXT)
    other = tmp_path / "junior.txt"
    other.write_text("product: TReX Jr\nmotor_mode: 1\n", encoding="utf-8")
    editor.compare_with_file(other)
    dialog = child(editor, QDialog, "compareDialog")
    assert "TReX Jr" in child(dialog, QLabel, "compareTrouble").text()
    assert not child(dialog, QPushButton, "takeValuesButton").isVisible()
    dialog.close()


def test_a_bad_file_is_not_compared(open_text: Open, tmp_path: Path) -> None:
    editor = open_text(TEXT)
    editor.compare_with_file(tmp_path / "nowhere.txt")
    assert "no such file" in banner(editor)


# --- Printing ---------------------------------------------------------------------------


def test_the_pages_hold_every_row(open_text: Open) -> None:
    editor = open_text(TEXT)
    settings = editor.document.settings
    assert settings is not None
    html = PrintedSettings(settings, "a<b>.txt", ["line 3: odd & strange"]).html()
    for spec in settings.specs.readable:
        assert spec.name in html
        assert spec.key in html
    assert "a&lt;b&gt;.txt" in html
    assert "1040 µs (2600)" in html
    assert "odd &amp; strange" in html
    assert "<b>" not in html  # everything given is as from the factory


def test_what_is_not_as_from_the_factory_is_bold(open_text: Open) -> None:
    editor = open_text("product: TReX\nserial_timeout: 5\n")
    settings = editor.document.settings
    assert settings is not None
    assert "<b>0.5 s</b>" in PrintedSettings(settings, "rover.txt").html()


def test_pages_are_saved_as_pdf(open_text: Open, tmp_path: Path) -> None:
    editor = open_text(resource("samples/tank_with_mix.txt").read_bytes())
    path = tmp_path / "tank.pdf"
    editor.save_pdf(path)
    data = path.read_bytes()
    assert data.startswith(b"%PDF")
    assert data.rstrip().endswith(b"%%EOF")
    assert data.count(b"/Type /Page\n") >= 1
    editor.save_pdf(tmp_path / "gone" / "tank.pdf")
    assert "Not saved" in banner(editor)


def test_what_does_not_fit_goes_to_the_next_page(open_text: Open, tmp_path: Path) -> None:
    settings = open_text(TEXT).document.settings
    assert settings is not None
    path = tmp_path / "long.pdf"
    PrintedSettings(settings, "long.txt", [f"finding {n}" for n in range(200)]).save_pdf(path)
    assert path.read_bytes().count(b"/Type /Page\n") > 2


def test_print_is_black_on_paper_in_dark_colours_too(open_text: Open) -> None:
    settings = open_text(TEXT).document.settings
    assert settings is not None
    theme().set_scheme("dark")
    document = PrintedSettings(settings, "rover.txt").document()
    cursor = QTextCursor(document)
    colours = set()
    while cursor.movePosition(QTextCursor.MoveOperation.NextWord):
        colours.add(cursor.charFormat().foreground().color().name())
    theme().set_scheme("system")
    assert colours == {QColor(Qt.GlobalColor.black).name()}


def test_a_preview_opens_where_this_qt_can_print(open_text: Open, qtbot: QtBot) -> None:
    editor = open_text(TEXT)
    dialog = editor.preview()
    if dialog is None:
        assert "printing is not installed" in banner(editor)
        return
    qtbot.waitUntil(dialog.isVisible)
    dialog.close()
