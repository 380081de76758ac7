"""Visible keyboard focus in every theme."""

from collections import Counter
from collections.abc import Iterator, Sequence

import pytest
from PySide6.QtCore import QPoint, QRect, Qt
from PySide6.QtGui import QColor, QImage
from PySide6.QtTest import QTest
from PySide6.QtWidgets import (
    QListWidget,
    QMainWindow,
    QPlainTextEdit,
    QPushButton,
    QRadioButton,
    QSlider,
    QTabBar,
    QTableWidget,
    QTabWidget,
    QWidget,
)
from pytestqt.qtbot import QtBot

from tests.support.colours import contrast
from trex_gui.devices.trex.views.pages.motors.drive_control import SpeedSlider
from trex_gui.devices.trex.views.pages.motors.drive_pad import DrivePad
from trex_gui.ui.theme.theme import SCHEMES, Scheme, set_look, theme
from trex_gui.ui.widgets import builders as ui
from trex_gui.ui.widgets.sliders import StickSlider

FRAME_WIDTH = 3
"""Pixels around a widget that also show its focus."""


def controls(parent: QWidget) -> Iterator[QWidget]:
    """Create a widget of each focusable kind. The tab bar is a child of its tab widget."""
    buttons = [ui.button(parent, name, name) for name in ("ok", "link", "go", "no")]
    default, flat, run, stop = buttons
    default.setDefault(True)
    for button, look in ((flat, "link"), (run, "primary"), (stop, "stop")):
        set_look(button, look)
    yield from buttons
    yield ui.tool_button(parent, "tool", icon="clear")
    yield ui.check_box(parent, "box", "Box")
    yield ui.check_box(parent, "boxOfRow")
    yield QRadioButton("Choice", parent)
    yield ui.combo_box(parent, "combo", "Choice", items=["first"])
    yield ui.spin_box(parent, "number", "Number", 0, 9)
    yield QSlider(parent)
    yield SpeedSlider(-127, parent)
    yield StickSlider(0, 9, 5, "bar", parent)
    for rows in (0, 2):
        yield ui.flat_table(QTableWidget(rows, 2, parent), f"table{rows}", "Table")
    yield QListWidget(parent)
    yield QPlainTextEdit(parent)
    yield DrivePad(parent)
    tabs = QTabWidget(parent)
    tabs.setDocumentMode(True)
    tabs.addTab(QWidget(), "Page")
    yield tabs.tabBar()


def colors(picture: QImage) -> Sequence[int]:
    return memoryview(picture.convertToFormat(QImage.Format.Format_RGB32).constBits()).cast("I")


def changed_pixels(before: QImage, after: QImage) -> int:
    """Count pixels that differ by a contrast of 3:1, as WCAG 2.2 requires."""
    pairs = Counter(zip(colors(before), colors(after), strict=True))
    return sum(
        count
        for (old, new), count in pairs.items()
        if old != new and contrast(QColor(old), QColor(new)) >= 3
    )


@pytest.mark.parametrize("scheme", SCHEMES[1:])
def test_focus_is_visible_on_every_widget(scheme: Scheme, qtbot: QtBot) -> None:
    theme().set_scheme(scheme)
    window = QWidget()
    qtbot.addWidget(window)
    widgets = list(controls(window))
    button = QPushButton(window)
    parts = (each if each.parentWidget() is window else each.parentWidget() for each in widgets)
    ui.column(*(part for part in parts if part is not None), button, into=window)
    window.show()
    window.activateWindow()
    QTest.qWait(0)
    for widget in widgets:
        area = QRect(widget.mapTo(window, QPoint()), widget.size()).adjusted(
            -FRAME_WIDTH, -FRAME_WIDTH, FRAME_WIDTH, FRAME_WIDTH
        )
        button.setFocus()
        before = window.grab(area).toImage()
        widget.setFocus()
        assert widget.hasFocus()
        changed = changed_pixels(before, window.grab(area).toImage())
        framed = widget.tabRect(0) if isinstance(widget, QTabBar) else widget
        perimeter = 2 * (framed.width() + framed.height())
        assert changed >= 0.8 * perimeter, f"{widget!r}: {changed} pixels"


def test_focus_has_a_frame_unless_the_mouse_has_set_it(qtbot: QtBot) -> None:
    window = QWidget()
    qtbot.addWidget(window)
    first, second = QPushButton("First", window), QPushButton("Second", window)
    ui.row(first, second, into=window)
    window.show()
    window.activateWindow()
    QTest.qWait(0)

    def is_framed() -> bool:
        return any(frame.isVisible() for frame in window.findChildren(QWidget, "focusFrame"))

    handle = window.windowHandle()
    QTest.mouseClick(handle, Qt.MouseButton.LeftButton, pos=second.geometry().center())
    assert second.hasFocus()
    assert not is_framed()
    QTest.keyClick(second, Qt.Key.Key_Tab)
    assert first.hasFocus()
    assert is_framed()
    second.setEnabled(False)
    first.hide()  # Qt finds no other widget for the focus
    assert not is_framed()
    QTest.mouseClick(handle, Qt.MouseButton.LeftButton, pos=second.geometry().center())
    assert not is_framed()


def test_menu_bar_with_the_focus_has_no_frame(qtbot: QtBot) -> None:
    window = QMainWindow()
    qtbot.addWidget(window)
    window.menuBar().addMenu("File")
    window.show()
    window.activateWindow()
    QTest.qWait(0)
    window.menuBar().setFocus()
    assert window.menuBar().hasFocus()
    assert not window.findChildren(QWidget, "focusFrame")
