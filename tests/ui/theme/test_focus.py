"""Visible keyboard focus in every theme."""

from collections import Counter
from collections.abc import Iterator, Sequence

import pytest
from PySide6.QtCore import QPoint, QRect, Qt
from PySide6.QtGui import QColor, QImage
from PySide6.QtTest import QTest
from PySide6.QtWidgets import (
    QApplication,
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

AROUND = 3
"""Pixels beside a widget that show its focus, too."""


def controls(sheet: QWidget) -> Iterator[QWidget]:
    """Create each kind of focusable widget. A tab bar is inside its tabs."""
    default, flat, run, stop = (ui.button(sheet, name, name) for name in ("ok", "link", "go", "no"))
    default.setDefault(True)
    for button, look in ((flat, "link"), (run, "primary"), (stop, "stop")):
        set_look(button, look)
    yield from (default, flat, run, stop)
    yield ui.tool_button(sheet, "tool", icon="clear")
    yield ui.check_box(sheet, "box", "Box")
    yield ui.check_box(sheet, "boxOfRow")
    yield QRadioButton("One of several", sheet)
    yield ui.combo_box(sheet, "combo", "Choice", items=["first"])
    yield ui.spin_box(sheet, "number", "Number", 0, 9)
    yield QSlider(sheet)
    yield SpeedSlider(-127, sheet)
    yield StickSlider(0, 9, 5, "bar", sheet)
    for rows in (0, 2):
        yield ui.flat_table(QTableWidget(rows, 2, sheet), f"table{rows}", "Table")
    yield QListWidget(sheet)
    yield QPlainTextEdit(sheet)
    yield DrivePad(sheet)
    tabs = QTabWidget(sheet)
    tabs.setDocumentMode(True)
    tabs.addTab(QWidget(), "Page")
    yield tabs.tabBar()


def colours(picture: QImage) -> Sequence[int]:
    return memoryview(picture.convertToFormat(QImage.Format.Format_RGB32).constBits()).cast("I")


def changed_pixels(before: QImage, after: QImage) -> int:
    """Count pixels that differ by a contrast of 3:1, as WCAG 2.2 requires."""
    pairs = Counter(zip(colours(before), colours(after), strict=True))
    return sum(
        count
        for (old, new), count in pairs.items()
        if old != new and contrast(QColor(old), QColor(new)) >= 3
    )


@pytest.mark.parametrize("scheme", SCHEMES[1:])
def test_focus_is_visible(scheme: Scheme, qtbot: QtBot, qapp: QApplication) -> None:
    theme().install(qapp)
    theme().set_scheme(scheme)
    sheet = QWidget()
    qtbot.addWidget(sheet)
    shown = list(controls(sheet))
    rest = QPushButton(sheet)
    parts = (each.parentWidget() if each.parentWidget() is not sheet else each for each in shown)
    ui.column(*(part for part in parts if part is not None), rest, into=sheet)
    sheet.show()
    sheet.activateWindow()
    QTest.qWait(0)
    for each in shown:
        place = QRect(each.mapTo(sheet, QPoint()), each.size())
        area = place.adjusted(-AROUND, -AROUND, AROUND, AROUND)
        rest.setFocus()
        before = sheet.grab(area).toImage()
        each.setFocus()
        assert each.hasFocus()
        found = changed_pixels(before, sheet.grab(area).toImage())
        framed = each.tabRect(0) if isinstance(each, QTabBar) else each
        perimeter = 2 * (framed.width() + framed.height())
        assert found >= 0.8 * perimeter, (
            f"{type(each).__name__} {each.objectName()}: {found} pixels"
        )


def test_focus_is_framed_unless_it_comes_from_the_mouse(qtbot: QtBot, qapp: QApplication) -> None:
    theme().install(qapp)
    sheet = QWidget()
    qtbot.addWidget(sheet)
    first, second = QPushButton("First", sheet), QPushButton("Second", sheet)
    ui.row(first, second, into=sheet)
    sheet.show()
    sheet.activateWindow()
    QTest.qWait(0)

    def is_framed() -> bool:
        return any(frame.isVisible() for frame in sheet.findChildren(QWidget, "focusFrame"))

    window = sheet.windowHandle()
    QTest.mouseClick(window, Qt.MouseButton.LeftButton, pos=second.geometry().center())
    assert second.hasFocus()
    assert not is_framed()
    QTest.keyClick(second, Qt.Key.Key_Tab)
    assert first.hasFocus()
    assert is_framed()
    second.setEnabled(False)
    first.hide()  # Qt finds no other place for the focus
    assert not is_framed()
    QTest.mouseClick(window, Qt.MouseButton.LeftButton, pos=second.geometry().center())
    assert not is_framed()


def test_menu_bar_with_the_focus_has_no_frame(qtbot: QtBot, qapp: QApplication) -> None:
    theme().install(qapp)
    window = QMainWindow()
    qtbot.addWidget(window)
    window.menuBar().addMenu("File")
    window.show()
    window.activateWindow()
    QTest.qWait(0)
    window.menuBar().setFocus()
    assert window.menuBar().hasFocus()
    assert not window.findChildren(QWidget, "focusFrame")
