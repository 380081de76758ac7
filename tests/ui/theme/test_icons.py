"""Icons of dialogs, editors and docks that Qt provides."""

import pytest
from PySide6.QtGui import QAction, QColor, QIcon
from PySide6.QtWidgets import QAbstractButton, QDockWidget, QMessageBox, QWidget
from pytestqt.qtbot import QtBot

from tests.support.window import WindowDriver
from trex_gui.ui.theme.icons import icon
from trex_gui.ui.theme.theme import Scheme, theme
from trex_gui.ui.widgets.builders import search_field


def middle_row(drawn: QIcon) -> list[QColor]:
    """Return the pixels of the middle row."""
    image = drawn.pixmap(16, 16).toImage()
    return [image.pixelColor(x, image.height() // 2) for x in range(image.width())]


def test_buttons_of_a_message_box_have_no_icons(window: WindowDriver) -> None:
    button = QMessageBox.StandardButton.Save
    box = QMessageBox(QMessageBox.Icon.Question, "", "Save?", button, window.window)
    box.open()
    assert box.button(button).icon().isNull()
    box.close()


@pytest.mark.parametrize("scheme", ["dark", "high_contrast"])
def test_clear_button_of_an_editor_follows_the_theme(qtbot: QtBot, scheme: Scheme) -> None:
    parent = QWidget()
    qtbot.addWidget(parent)
    editor = search_field(parent, "", "", "")
    theme().set_scheme(scheme)
    (action,) = editor.findChildren(QAction)
    assert middle_row(action.icon()) == middle_row(icon("clear"))


@pytest.mark.qt_log_ignore("does not support raise")  # message of the offscreen platform
def test_docked_and_floating_panel_have_icons_of_the_program(window: WindowDriver) -> None:
    window.connect_to_demo()
    dock = window.find(QDockWidget, "demoPanel")
    for floating in (False, True, False):
        dock.setFloating(floating)
        window.wait_for_files()
        for name, icon_name in (("float", "float"), ("close", "clear")):
            button = dock.findChild(QAbstractButton, f"qt_dockwidget_{name}button")
            assert button is not None
            assert middle_row(button.icon()) == middle_row(icon(icon_name))
