"""Icons of Qt's own dialogs and buttons come from the program."""

import pytest
from PySide6.QtGui import QAction, QColor, QPixmap
from PySide6.QtWidgets import QAbstractButton, QDockWidget, QMessageBox, QWidget
from pytestqt.qtbot import QtBot

from tests.support.window import WindowDriver
from trex_gui.ui.theme.icons import icon
from trex_gui.ui.theme.theme import theme
from trex_gui.ui.widgets.builders import search_field


def picture(pixmap: QPixmap) -> list[QColor]:
    image = pixmap.toImage()
    return [image.pixelColor(x, image.height() // 2) for x in range(image.width())]


def test_message_box_has_no_icons_on_its_buttons(window: WindowDriver) -> None:
    button = QMessageBox.StandardButton.Save
    box = QMessageBox(QMessageBox.Icon.Question, "", "Save?", button, window.window)
    box.open()
    assert box.button(button).icon().isNull()
    box.close()


@pytest.mark.parametrize("scheme", ["dark", "high_contrast"])
def test_button_that_clears_an_editor_follows_the_theme(qtbot: QtBot, scheme: str) -> None:
    parent = QWidget()
    qtbot.addWidget(parent)
    editor = search_field(parent, "", "", "")
    theme().set_scheme("dark" if scheme == "dark" else "high_contrast")
    (action,) = editor.findChildren(QAction)
    assert picture(action.icon().pixmap(16, 16)) == picture(icon("clear").pixmap(16, 16))


@pytest.mark.qt_log_ignore("does not support raise")  # message of the offscreen platform
def test_dock_has_our_icons_also_when_it_floats(window: WindowDriver) -> None:
    window.connect_to_demo()
    dock = window.find(QDockWidget, "demoPanel")
    for floating in (False, True, False):
        dock.setFloating(floating)
        window.wait_for_files()
        for name, sign in (("float", "float"), ("close", "clear")):
            button = dock.findChild(QAbstractButton, f"qt_dockwidget_{name}button")
            assert button is not None
            assert picture(button.icon().pixmap(16, 16)) == picture(icon(sign).pixmap(16, 16))
