"""Preferences take effect at once and are restored at the next start."""

from collections.abc import Iterator

import pytest
from PySide6.QtWidgets import QComboBox, QLabel
from pytestqt.qtbot import QtBot

from tests.support.window import WidgetDriver
from trex_gui.ui.devices.auto_connect import connects_automatically
from trex_gui.ui.frame.preferences_dialog import PreferencesDialog
from trex_gui.ui.preferences import Preferences
from trex_gui.ui.theme.theme import restore_choices, theme
from trex_gui.ui.translations import selected_language
from trex_gui.ui.units import units


@pytest.fixture
def dialog(qtbot: QtBot) -> Iterator[WidgetDriver]:
    dialog = PreferencesDialog()
    dialog.open_preferences()
    yield WidgetDriver(dialog, qtbot)
    dialog.close()
    dialog.deleteLater()


def restart_program() -> None:
    """Simulate the next start of the program."""
    theme().set_scheme("system")
    theme().set_font_size(100)
    restore_choices()
    units.cache_clear()


def test_theme_and_font_size_change_at_once_and_are_saved(dialog: WidgetDriver) -> None:
    label = QLabel("text")
    before = label.sizeHint().height()
    dialog.select("schemeBox", "high_contrast")
    for percent in (90, 175):  # the dialog adapts to its own text size
        dialog.select("fontSizeBox", percent)
        for text in dialog.find_all(QLabel):
            assert text.height() >= text.heightForWidth(text.width()), text.text()
        for box in dialog.find_all(QComboBox):
            assert box.height() >= box.sizeHint().height()
    assert theme().scheme == "high_contrast"
    assert label.sizeHint().height() == pytest.approx(1.75 * before, abs=2)
    restart_program()
    assert (theme().choice, theme().font_size) == ("high_contrast", 175)
    assert dialog.combo("fontSizeBox").currentData() == 175


def test_other_preferences_are_saved(dialog: WidgetDriver) -> None:
    dialog.click("automaticBox")
    dialog.select("unitsBox", True)
    dialog.select("languageBox", "de")
    restart_program()
    assert units().own_first
    assert not connects_automatically()
    assert selected_language() == "de"


@pytest.mark.usefixtures("qapp")
def test_invalid_preferences_are_replaced_by_defaults() -> None:
    Preferences().set("window/scheme", "sepia")
    Preferences().set("window/font_size", 1000)
    restore_choices()
    assert (theme().choice, theme().font_size) == ("system", 100)
