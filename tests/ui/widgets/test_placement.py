"""Windows fit on the screen and reopen at their last position."""

import pytest
from PySide6.QtCore import QPoint, QRect, QSize
from PySide6.QtGui import QGuiApplication
from PySide6.QtWidgets import QDialog, QMainWindow, QWidget
from pytestqt.qtbot import QtBot

from trex_gui.ui.widgets.placement import fit_on_screen, fitted, restore_geometry, save_geometry

NETBOOK = QRect(0, 0, 1024, 600)
SECOND_SCREEN = QRect(1920, 30, 1366, 738)  # right of the first screen, below a panel


@pytest.mark.parametrize("screen", [NETBOOK, SECOND_SCREEN, QRect(0, 0, 1920, 1080)])
@pytest.mark.parametrize("size", [QSize(300, 200), QSize(1100, 760), QSize(2500, 1500)])
@pytest.mark.parametrize("corner", [QPoint(-500, -500), QPoint(1000, 300), QPoint(9999, 9999)])
def test_window_and_frame_fit_screen(screen: QRect, size: QSize, corner: QPoint) -> None:
    geometry = fitted(QRect(corner, size), screen)
    assert screen.contains(geometry.adjusted(-8, -31, 8, 8)), "with the frame of Windows 11"
    assert geometry.width() == min(size.width(), screen.width() - 16)
    assert geometry.height() == min(size.height(), screen.height() - 48)
    assert fitted(geometry, screen) == geometry, "a window that fits is not moved"


def _screen() -> QRect:
    return QGuiApplication.primaryScreen().availableGeometry()


def test_dialog_reopens_where_it_was_closed(qtbot: QtBot) -> None:
    parent = QWidget()
    qtbot.addWidget(parent)
    parent.setGeometry(200, 150, 800, 600)
    parent.show()
    dialog = QDialog(parent)
    dialog.resize(400, 300)
    fit_on_screen(dialog)
    dialog.show()
    first = dialog.geometry()
    assert (first.center() - parent.geometry().center()).manhattanLength() < 10
    for _ in range(3):
        dialog.close()
        dialog.move(dialog.pos() + QPoint(2, 26))  # a window manager may move the dialog
        dialog.show()
        assert dialog.geometry() == first


def test_stored_position_is_restored_within_the_screen(qtbot: QtBot) -> None:
    def open_window() -> QMainWindow:
        window = QMainWindow()
        qtbot.addWidget(window)
        restore_geometry(window, "test", 5000, 5000)
        fit_on_screen(window)
        window.show()
        return window

    window = open_window()
    assert _screen().contains(window.frameGeometry())
    window.setGeometry(60, 70, 500, 400)
    save_geometry(window, "test")
    window = open_window()
    assert window.geometry() == QRect(60, 70, 500, 400)
    window.setGeometry(1700, 900, 500, 400)
    save_geometry(window, "test")
    window = open_window()
    assert _screen().contains(window.frameGeometry())


def test_window_can_fill_the_whole_screen(qtbot: QtBot) -> None:
    window = QMainWindow()
    qtbot.addWidget(window)
    fit_on_screen(window)
    window.showFullScreen()
    assert window.isFullScreen()
