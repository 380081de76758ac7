"""What is chosen in the preferences takes effect at once, and is there at the next start."""

from collections.abc import Iterator
from pathlib import Path

import pytest
from PySide6.QtWidgets import QApplication, QComboBox, QFileDialog, QLabel, QPushButton
from pytestqt.qtbot import QtBot

from tests.support.window import WidgetDriver
from trex_gui.ui.devices.auto_connect import connects_automatically
from trex_gui.ui.frame.preferences_dialog import PreferencesDialog
from trex_gui.ui.preferences import Preferences
from trex_gui.ui.theme.theme import restore_choices, theme
from trex_gui.ui.translations import AS_THE_SYSTEM, chosen_language
from trex_gui.ui.units import units
from trex_gui.ui.widgets.file_questions import default_folder, last_folder, remember_folder


@pytest.fixture
def dialog(qtbot: QtBot, qapp: QApplication) -> Iterator[WidgetDriver]:
    theme().install(qapp)
    made = PreferencesDialog(lambda: None)
    made.open_preferences()
    yield WidgetDriver(made, qtbot)
    made.close()
    made.deleteLater()


def start_again() -> None:
    """Do what the next start of the program does."""
    theme().set_scheme("system")
    theme().set_font_size(100)
    restore_choices()
    units.cache_clear()


def test_theme_and_font_size_change_at_once_and_stay(dialog: WidgetDriver) -> None:
    label = QLabel("text")
    before = label.sizeHint().height()
    dialog.select("schemeBox", "high_contrast")
    for percent in (90, 175):  # the dialog itself makes room for its text
        dialog.select("fontSizeBox", percent)
        for text in dialog.find_all(QLabel):
            assert text.height() >= text.heightForWidth(text.width()), text.text()
        for box in dialog.find_all(QComboBox):
            assert box.height() >= box.sizeHint().height()
    assert theme().scheme == "high_contrast"
    assert label.sizeHint().height() == pytest.approx(1.75 * before, abs=2)
    start_again()
    assert (theme().choice, theme().font_size) == ("high_contrast", 175)
    assert dialog.combo("fontSizeBox").currentData() == 175


def test_dialogs_begin_in_the_chosen_folder(
    dialog: WidgetDriver, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    remember_folder(tmp_path / "used" / "a.txt")
    assert last_folder() == tmp_path / "used"
    monkeypatch.setattr(QFileDialog, "getExistingDirectory", lambda *_: str(tmp_path / "robots"))
    dialog.click("chooseFolderButton")
    for key in ("settings/folder", "recording/folder"):
        assert last_folder(key) == tmp_path / "robots"
    dialog.click("defaultFolderBox")
    assert last_folder() == tmp_path / "used"


def test_reset_restores_every_default(dialog: WidgetDriver) -> None:
    dialog.select("schemeBox", "dark")
    dialog.select("fontSizeBox", 90)
    dialog.click("defaultFolderBox")
    dialog.click("automaticBox")
    dialog.select("unitsBox", True)
    dialog.select("languageBox", "de")
    start_again()
    assert units().own_first
    assert not connects_automatically()
    assert default_folder() is not None
    assert chosen_language() == "de"
    dialog.click("preferencesReset")
    assert (theme().choice, theme().font_size) == ("system", 100)
    assert connects_automatically()
    assert not units().own_first
    assert dialog.combo("unitsBox").currentData() is False
    assert default_folder() is None
    assert chosen_language() == dialog.combo("languageBox").currentData() == AS_THE_SYSTEM
    assert dialog.button("automaticBox").isChecked()
    start_again()
    assert (theme().choice, theme().font_size) == ("system", 100)
    assert not units().own_first


def test_enter_closes_it_also_after_reset(dialog: WidgetDriver) -> None:
    dialog.button("preferencesReset").setFocus()
    dialog.root.close()
    dialog.root.show()
    assert dialog.find(QPushButton, "preferencesClose").isDefault()
    assert not dialog.find(QPushButton, "preferencesReset").autoDefault()


@pytest.mark.usefixtures("qapp")
def test_unusable_choices_count_as_none() -> None:
    Preferences().set("window/scheme", "sepia")
    Preferences().set("window/font_size", 1000)
    restore_choices()
    assert (theme().choice, theme().font_size) == ("system", 100)
