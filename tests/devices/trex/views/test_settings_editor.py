"""Editor window of a settings file, without a board."""

from collections.abc import Callable, Iterator
from pathlib import Path

import pytest
from PySide6.QtCore import QLocale, Qt
from PySide6.QtGui import QColor, QTextCursor
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QDialog, QMessageBox, QTabBar
from pytestqt.qtbot import QtBot
from shiboken6 import isValid

from tests.support.catalogs import in_language
from tests.support.colours import contrast
from tests.support.keyboard import check_keyboard
from tests.support.pages.settings import SettingsEditorWindow, answer_questions
from tests.support.window import WidgetDriver
from trex_gui.core.files import load
from trex_gui.core.resource_files import resource
from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.model.parameters.parameters import ParameterModel
from trex_gui.devices.trex.model.settings.document import SettingsDocument
from trex_gui.devices.trex.protocol.calibration import (
    DEFAULT_CALIBRATION,
    Calibration,
    CalibrationKey,
)
from trex_gui.devices.trex.protocol.flags import InputSource
from trex_gui.devices.trex.settings.document import Settings
from trex_gui.devices.trex.settings.reader import read_settings
from trex_gui.devices.trex.views.count_editor import CountEditor
from trex_gui.devices.trex.views.settings_editor.pdf import (
    settings_document,
    settings_html,
    settings_pdf,
)
from trex_gui.devices.trex.views.settings_editor.text_page import NumberedText
from trex_gui.devices.trex.views.settings_editor.window import SettingsEditor
from trex_gui.devices.trex.views.settings_files import SAMPLES
from trex_gui.ui.theme.theme import SCHEMES, theme
from trex_gui.ui.translations import LANGUAGES

TEXT = (
    "product: TReX\r\n"
    "# my rover\r\n"
    "motor_mode: 0   # two motors\r\n"
    "rc_channel_2: {minimum: 2600, neutral: 3700, maximum: 4900, deadband: 60}\r\n"
)
PARAMETERS, CALIBRATIONS, TEXT_PAGE = range(3)


class EditorDriver(SettingsEditorWindow):
    """Settings editor and its pages."""

    def __init__(self, editor: SettingsEditor, qtbot: QtBot) -> None:
        super().__init__(editor, qtbot)
        self.tabs = editor.tabs

    @property
    def path(self) -> Path:
        assert self.document.path is not None
        return self.document.path

    @property
    def banner(self) -> str:
        return self.text("bannerText")

    @property
    def text_page(self) -> NumberedText:
        return self.find(NumberedText, "settingsText")

    def value_of(self, key: str) -> int | None:
        return self.document.draft.parameters.values.value_of(key)

    def trigger(self, name: str) -> None:
        """Trigger a menu entry."""
        action = self.action(name)
        assert action.isEnabled(), name
        action.trigger()

    def save(self) -> None:
        self.trigger("Save")
        self.wait_for_files()

    def select_channel(self, channel: int, source: InputSource = InputSource.RC) -> None:
        self.tabs.setCurrentIndex(CALIBRATIONS)
        self.find(QTabBar, "sourceTabs").setCurrentIndex(list(InputSource).index(source))
        self.click(f"channel{channel}Strip")

    def type_minimum(self, text: str) -> None:
        field = self.find(CountEditor, "minimumEdit")
        field.selectAll()
        QTest.keyClicks(field, text)
        QTest.keyClick(field, Qt.Key.Key_Return)

    def compare_dialog(self) -> WidgetDriver:
        return WidgetDriver(self.find(QDialog, "compareDialog"), self.qtbot)


OpenEditor = Callable[[str | bytes], EditorDriver]


@pytest.fixture
def device(qapp: QApplication) -> Device:
    theme().install(qapp)
    return Device()


@pytest.fixture
def open_text(device: Device, tmp_path: Path, qtbot: QtBot) -> Iterator[OpenEditor]:
    """Function that opens a settings file with this content."""
    editors = []

    def open_editor(data: str | bytes) -> EditorDriver:
        path = tmp_path / "rover.txt"
        path.write_bytes(data if isinstance(data, bytes) else data.encode())
        editor = SettingsEditor(SettingsDocument.of_file(path, load(path)), device)
        editors.append(editor)
        editor.show()
        return EditorDriver(editor, qtbot)

    yield open_editor
    for editor in editors:
        if isValid(editor):
            editor.close_at_once()


@pytest.fixture
def editor(open_text: OpenEditor) -> EditorDriver:
    """Editor of a file without findings."""
    return open_text(TEXT)


# --- Pages ------------------------------------------------------------------------------


def test_title_and_text_page_follow_edits(editor: EditorDriver) -> None:
    window, text = editor.editor, editor.text_page
    assert window.windowTitle() == "rover.txt[*] – TReX settings file"
    assert not window.isWindowModified()
    assert text.isReadOnly()
    editor.edit("motor_mode", 1)
    editor.wait(window.isWindowModified)
    editor.wait(lambda: "motor_mode: 1   # two motors" in text.lines)
    assert "\n".join(text.lines) == editor.document.text.replace("\r\n", "\n")
    editor.trigger("Undo")
    editor.wait(lambda: not window.isWindowModified())


def test_line_numbers_are_readable_in_each_scheme(editor: EditorDriver) -> None:
    editor.tabs.setCurrentIndex(TEXT_PAGE)
    for scheme in SCHEMES[1:]:
        theme().set_scheme(scheme)
        background = editor.text_page.grab().toImage().pixelColor(4, 20)
        assert contrast(theme().color("muted"), background) >= 4.5, scheme


def test_repaired_text_opens_the_pages(open_text: OpenEditor) -> None:
    editor = open_text("product: TReX\r\nmotor_mode: 9\r\n# mine\r\n")
    text = editor.text_page
    text.show_line(2)
    QTest.keyClick(text, Qt.Key.Key_End)
    QTest.keyClick(text, Qt.Key.Key_Backspace)
    editor.click("checkAgainButton")
    assert not editor.tabs.isTabEnabled(PARAMETERS)
    QTest.keyClicks(text, "1")
    assert editor.editor.isWindowModified()
    editor.click("checkAgainButton")
    assert editor.tabs.isTabEnabled(PARAMETERS)
    assert text.isReadOnly()
    editor.save()
    assert editor.path.read_bytes() == b"product: TReX\r\nmotor_mode: 1\r\n# mine\r\n"


def test_values_are_repaired_and_listed(open_text: OpenEditor) -> None:
    faulty = "\ufeffproduct: TReX\r\nserial_timeout: 1.5 s  # mine\r\nmotor_mode: 9\r\n"
    editor = open_text(faulty)
    check_keyboard(editor.root)
    editor.click("repairTextButton")
    message = "Repaired: line 2: serial_timeout: 1.5 s becomes 15 (1.5 s). Correct the rest"
    assert editor.text("bannerText").startswith(message)
    assert editor.path.read_bytes() == faulty.encode(), "the repair is not saved"
    editor.click("repairTextButton")
    assert "Nothing could be repaired" in editor.text("bannerText")
    assert editor.document.text == faulty.replace("1.5 s", "15")
    editor.action("Undo").trigger()
    assert editor.document.text == faulty

    editor = open_text("product: TReX\nserial_timeout: 300 # mine\n")
    editor.click("repairTextButton")
    assert "serial_timeout: 300 becomes 127 (12.7 s)." in editor.text("bannerText")
    assert editor.tabs.isTabEnabled(PARAMETERS)
    assert editor.editor.isWindowModified()
    editor.save()
    assert editor.path.read_bytes() == b"product: TReX\nserial_timeout: 127 # mine\n"


def test_undo_of_typing_restores_every_byte(open_text: OpenEditor) -> None:
    for text in (
        "product: TReX\nmotor_mode: 9\n",
        "a\xa0b\r\nc\rd\n\u2028e",
        "\ufeffx: [\n",
        "x: {\x85y\n",
    ):
        editor = open_text(text)
        QTest.keyClicks(editor.text_page, "# ")
        assert "# " in editor.document.text
        editor.trigger("Undo")
        assert editor.document.text == text, repr(text)
        assert not editor.editor.isWindowModified(), repr(text)
        editor.editor.close_at_once()


def test_finding_shows_its_line(open_text: OpenEditor) -> None:
    editor = open_text("product: TReX\n\n\nmotor_mode: 9\n")
    check_keyboard(editor.root)
    assert editor.button("textLine0").text() == "Show line 4"
    editor.click("textLine0")
    assert editor.text_page.textCursor().blockNumber() == 3


# --- Calibrations -----------------------------------------------------------------------


def test_calibrations_are_typed_added_and_left_out(editor: EditorDriver) -> None:
    calibrations = editor.document.draft.calibrations
    editor.select_channel(2)
    editor.type_minimum("1040.4")
    expected = Calibration(2601, 3700, 4900, 60)
    assert calibrations.shown(CalibrationKey.RC_CHANNEL_2) == expected
    editor.trigger("Undo")
    assert editor.document.text == TEXT
    editor.type_minimum("1900")
    assert "is above neutral" in editor.text("calibrationNote")
    assert editor.document.text == TEXT
    check_keyboard(editor.root)

    editor.select_channel(3, InputSource.ANALOG)
    assert not editor.is_enabled("minimumEdit")
    editor.click("addCalibrationButton")
    added = calibrations.shown(CalibrationKey.ANALOG_CHANNEL_3)
    assert added == DEFAULT_CALIBRATION[InputSource.ANALOG]
    editor.select_channel(2)
    editor.click("leaveOutCalibrationButton")
    assert calibrations.shown(CalibrationKey.RC_CHANNEL_2) is None
    assert "# rc_channel_2" in editor.document.text
    editor.trigger("Undo")
    editor.trigger("Undo")
    assert editor.document.text == TEXT
    editor.click("reversedBox")
    assert editor.value_of("reversed_channels") == 2


# --- Saving and closing -----------------------------------------------------------------


def test_file_changed_on_disk_is_overwritten_after_a_question(
    editor: EditorDriver, monkeypatch: pytest.MonkeyPatch
) -> None:
    editor.path.write_text("product: TReX\n# by another program\n", encoding="utf-8")
    questions = answer_questions(monkeypatch, QMessageBox.StandardButton.Cancel)
    editor.save()
    assert "changed by another program" in questions[0]
    assert "by another program" in editor.path.read_text(encoding="utf-8")
    answer_questions(monkeypatch, QMessageBox.StandardButton.Yes)
    editor.save()
    assert editor.path.read_bytes() == TEXT.encode()


def test_file_is_rewritten_only_after_a_question(
    open_text: OpenEditor, monkeypatch: pytest.MonkeyPatch
) -> None:
    editor = open_text("product: TReX\nfirmware: |\n  1.2")  # an edit rewrites the file
    editor.edit("motor_mode", 1)
    questions = answer_questions(monkeypatch, QMessageBox.StandardButton.Cancel)
    editor.save()
    assert "Rewrite the file" in questions[0]
    assert editor.document.modified
    answer_questions(monkeypatch, QMessageBox.StandardButton.Yes)
    editor.save()
    assert "motor_mode: 1" in editor.path.read_text(encoding="utf-8")


def test_edits_remain_until_saved_or_discarded(
    editor: EditorDriver, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    editor.edit("motor_mode", 1)
    editor.editor.save_to(tmp_path / "gone" / "rover.txt")
    editor.wait_for_files()
    assert "Not saved" in editor.banner
    assert editor.document.modified

    questions = answer_questions(monkeypatch, QMessageBox.StandardButton.Cancel)
    assert not editor.editor.close()
    assert "rover.txt has changes" in questions[0]
    assert editor.document.modified
    answer_questions(monkeypatch, QMessageBox.StandardButton.Save)
    path = editor.path
    assert not editor.editor.close()
    editor.wait(lambda: not editor.editor.isVisible())
    assert b"motor_mode: 1" in path.read_bytes()


# --- Comparing --------------------------------------------------------------------------


def test_files_are_compared_and_values_copied(editor: EditorDriver, tmp_path: Path) -> None:
    editor.editor.compare_with_file(tmp_path / "nowhere.txt")
    editor.wait_for_files()
    assert "no such file" in editor.banner

    other = tmp_path / "other.txt"
    other.write_text("product: TReX\nmotor_mode: 1\nserial_timeout: 5\n", encoding="utf-8")
    editor.editor.compare_with_file(other)
    editor.wait_for_files()
    dialog = editor.compare_dialog()
    assert "3 settings differ, 0 match" in dialog.text("comparisonSummary")
    check_keyboard(dialog.root)
    dialog.click("takeValuesButton")
    assert (editor.value_of("motor_mode"), editor.value_of("serial_timeout")) == (1, 5)
    assert "2 values copied from other.txt" in editor.banner
    dialog.wait_for_text("comparisonSummary", "1 setting differs, 2 match")
    editor.trigger("Undo")
    assert editor.document.text == TEXT
    dialog.root.close()


def test_values_of_other_models_are_not_copied(open_text: OpenEditor, tmp_path: Path) -> None:
    editor = open_text(TEXT)
    other = tmp_path / "junior.txt"
    other.write_text("product: TReX Jr\nmotor_mode: 1\n", encoding="utf-8")
    editor.editor.compare_with_file(other)
    editor.wait_for_files()
    dialog = editor.compare_dialog()
    assert "TReX Jr" in dialog.text("compareTrouble")
    assert not dialog.has("takeValuesButton")
    dialog.root.close()
    editor.editor.close_at_once()

    editor = open_text("product: TReX Jr\nserial_timeout: 5\n")
    editor.trigger("CompareFactory")
    dialog = editor.compare_dialog()
    assert "match" in dialog.text("comparisonSummary")
    dialog.root.close()


# --- Save as PDF ------------------------------------------------------------------------


def settings_in(text: str) -> Settings:
    settings, _ = read_settings(text)
    return settings


def test_pdf_names_every_row(device: Device) -> None:
    settings = settings_in(TEXT)
    html = settings_html(settings, "a<b>.txt", ["line 3: odd & strange"])
    for spec in settings.specs.readable:
        assert spec.name in html
        assert spec.key in html
    assert "a&lt;b&gt;.txt" in html
    assert "1040 µs (2600)" in html
    assert "odd &amp; strange" in html
    assert "<b>" not in html  # only factory defaults

    changed = settings_in("product: TReX\nserial_timeout: 5\n")
    assert "<b>0.5 s</b>" in settings_html(changed, "rover.txt")


def test_pdf_has_the_headings_of_the_page_in_each_language(qapp: QApplication) -> None:
    for language in LANGUAGES:
        with in_language(qapp, QLocale(language)):
            html = settings_html(settings_in(TEXT), "rover.txt")
            rows = ParameterModel()
            rows.load(settings_in(TEXT).specs, {}, {}, power_cycled=True)
            headings = [f"<i>{row.name}</i>" for row in rows.rows if not row.keys]
        assert headings
        assert [heading for heading in headings if heading not in html] == [], language


def test_pdf_is_black_on_white_in_a_dark_scheme(device: Device) -> None:
    theme().set_scheme("dark")
    document = settings_document(settings_in(TEXT), "rover.txt")
    cursor = QTextCursor(document)
    colours = set()
    while cursor.movePosition(QTextCursor.MoveOperation.NextWord):
        colours.add(cursor.charFormat().foreground().color().name())
    assert colours == {QColor(Qt.GlobalColor.black).name()}


def test_pages_are_saved_as_pdf(open_text: OpenEditor, tmp_path: Path) -> None:
    editor = open_text(resource("samples/tank_with_mix.txt").read_bytes())
    path = tmp_path / "tank.pdf"
    editor.editor.save_pdf(path)
    editor.wait_for_files()
    data = path.read_bytes()
    assert data.startswith(b"%PDF")
    assert data.rstrip().endswith(b"%%EOF")
    assert data.count(b"/Type /Page\n") >= 1
    editor.editor.save_pdf(tmp_path / "gone" / "tank.pdf")
    editor.wait_for_files()
    assert "Not saved" in editor.banner

    long = tmp_path / "long.pdf"
    findings = [f"finding {number}" for number in range(200)]
    long.write_bytes(settings_pdf(settings_in(TEXT), "long.txt", findings))
    assert long.read_bytes().count(b"/Type /Page\n") > 2


def test_title_of_a_sample_is_its_first_comment() -> None:
    for name, title in SAMPLES.items():
        lines = resource(f"samples/{name}.txt").read_text("utf-8").splitlines()
        assert lines[1] == f"# {title}."
