"""Contrast of texts, even if disabled, and of the outlines of enabled controls."""

from math import inf
from pathlib import Path

import pytest
from PySide6.QtCore import QPoint, QRect
from PySide6.QtGui import QImage, QPainter
from PySide6.QtWidgets import (
    QAbstractButton,
    QAbstractItemView,
    QAbstractSpinBox,
    QCheckBox,
    QComboBox,
    QDialog,
    QHeaderView,
    QLineEdit,
    QPlainTextEdit,
    QPushButton,
    QRadioButton,
    QSlider,
    QStyle,
    QStyleOptionButton,
    QStyleOptionSlider,
    QTabWidget,
    QWidget,
)

from tests.support.colours import contrast, weak_texts
from tests.support.matrix import sampled
from tests.support.pages.every_dialog import every_aracna_window, every_trex_window
from tests.support.program import trex
from tests.support.window import WindowDriver
from trex_gui.devices.trex.views.line_settings_dialog import LineSettingsDialog
from trex_gui.devices.trex.views.pages.motors.gamepad_dialog import GamepadDialog
from trex_gui.devices.trex.views.pages.motors.gamepad_panel import GamepadPanel
from trex_gui.ui.theme.theme import SCHEMES, Scheme, theme
from trex_gui.ui.widgets.messages import ActionBar

each_scheme = pytest.mark.parametrize(
    "scheme", sampled(("dark", "light", "high_contrast"), every=3)
)
"""The gate checks one scheme, which reveals colours that ignore the scheme."""


def check_texts(driver: WindowDriver, window: QWidget) -> None:
    expected = theme().color("window_text")
    driver.wait(lambda: window.palette().windowText().color() == expected)
    driver.wait_for_files()  # also waits until the window has settled
    tabs = [each.tabText(each.currentIndex()) for each in window.findChildren(QTabWidget)]
    assert weak_texts(window) == {}, f"{window.objectName()} {tabs}"


@each_scheme
def test_texts_of_trex_have_enough_contrast(
    scheme: Scheme, window: WindowDriver, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    theme().set_scheme(scheme)
    for shown in every_trex_window(window, tmp_path, monkeypatch):
        check_texts(window, shown)


@each_scheme
def test_texts_of_aracna_have_enough_contrast(
    scheme: Scheme, window: WindowDriver, tmp_path: Path
) -> None:
    theme().set_scheme(scheme)
    for shown in every_aracna_window(window, tmp_path):
        check_texts(window, shown)


CONTROL_CLASSES = (
    QAbstractSpinBox,
    QCheckBox,
    QComboBox,
    QLineEdit,
    QPlainTextEdit,
    QPushButton,
    QRadioButton,
    QSlider,
)


def outline_contrast(picture: QImage, left: QPoint, *inside: QPoint) -> float:
    """Return the lowest contrast of a left edge with the window and with points inside.

    The edge is antialiased, so the pixel with the best contrast out of three counts.
    """
    edge = [picture.pixelColor(left + QPoint(x, 0)) for x in range(3)]
    neighbours = [theme().color("window"), *map(picture.pixelColor, inside)]
    return min(max(contrast(color, other) for color in edge) for other in neighbours)


def contrast_of(control: QWidget) -> float:
    picture = control.grab().toImage()
    if picture.isNull():  # the message has no space for the widget
        return inf
    if isinstance(control, QCheckBox | QRadioButton):
        option = QStyleOptionButton()
        control.initStyleOption(option)
        part = (
            QStyle.SubElement.SE_CheckBoxIndicator
            if isinstance(control, QCheckBox)
            else QStyle.SubElement.SE_RadioButtonIndicator
        )
        box = control.style().subElementRect(part, option, control)
        return outline_contrast(picture, QPoint(box.left(), box.center().y()), box.center())
    if isinstance(control, QSlider):
        slider = QStyleOptionSlider()
        control.initStyleOption(slider)
        kind, handle = QStyle.ComplexControl.CC_Slider, QStyle.SubControl.SC_SliderHandle
        box = control.style().subControlRect(kind, slider, handle, control)
        return outline_contrast(picture, QPoint(box.left(), box.top() + box.height() // 3))
    return outline_contrast(picture, QPoint(0, control.height() // 2))


def contrast_of_box_in(view: QAbstractItemView) -> float:
    """Return the contrast of a cleared check box in a cell."""
    option = QStyleOptionButton()
    option.initFrom(view)
    option.rect = QRect(0, 0, 14, 14)
    option.state = QStyle.StateFlag.State_Enabled | QStyle.StateFlag.State_Off
    picture = QImage(option.rect.size(), QImage.Format.Format_RGB32)
    picture.fill(theme().color("base"))
    with QPainter(picture) as painter:
        box = QStyle.PrimitiveElement.PE_IndicatorItemViewItemCheck
        view.style().drawPrimitive(box, option, painter, view)
    return outline_contrast(picture, QPoint(0, 7), QPoint(7, 7))


def controls_of(window: QWidget) -> list[QWidget]:
    """Return enabled controls, except checked buttons and links.

    The frame of the connection status stands for the controls in it.
    """
    controls: list[QWidget] = []
    for each in window.findChildren(QWidget):
        parent = each.parentWidget()
        control = parent if parent and parent.property("look") == "pill" else each
        if (
            isinstance(each, CONTROL_CLASSES)
            and control.isEnabledTo(control.window())
            and not (isinstance(control, QAbstractButton) and control.isChecked())
            and not (isinstance(control, QPushButton) and control.property("look") == "link")
            and not isinstance(control.parentWidget(), QAbstractSpinBox | QComboBox)
        ):
            controls.append(control)
    return controls


def test_only_the_stop_button_of_an_action_bar_has_an_icon(window: WindowDriver) -> None:
    """Other icons would be invisible on the amber of an armed bar."""
    window.connect_to_demo()
    (bar,) = window.find_all(ActionBar)
    buttons = [each for each in bar.findChildren(QPushButton) if each is not bar.stop]
    assert buttons
    assert all(each.icon().isNull() for each in buttons)


def test_controls_have_a_visible_outline_in_every_theme(window: WindowDriver) -> None:
    window.connect_to_demo()
    for key in ("learn", "find", "defaults", "bench", "history", "new"):
        window.trigger(key)
    GamepadDialog(window.find(GamepadPanel, "gamepadPanel").gamepad, window.window)
    LineSettingsDialog(trex(window.program).controller.settings, window.window)
    window.dialog("powerCycleDialog")
    controls = controls_of(window.window)
    assert all(any(isinstance(control, kind) for control in controls) for kind in CONTROL_CLASSES)
    assert len(window.find_all(QDialog)) > 8
    views = window.find_all(QAbstractItemView)
    views = [view for view in views if not isinstance(view, QHeaderView)]
    assert len(views) > 8
    for scheme in SCHEMES[1:]:
        theme().set_scheme(scheme)
        weak = {
            f"{control.window().objectName()}.{control.objectName()}": ratio
            for control in controls
            if (ratio := contrast_of(control)) < 3
        }
        assert weak == {}, scheme
        assert min(contrast_of_box_in(view) for view in views) >= 3, scheme
