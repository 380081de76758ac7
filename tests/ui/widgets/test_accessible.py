"""Accessible names, values and announcements of painted widgets."""

import gc

import pytest
from PySide6.QtCore import QCoreApplication, QEvent, Qt
from PySide6.QtGui import QAccessible, QAccessibleAnnouncementEvent, QAccessibleInterface
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QLabel, QPushButton, QWidget
from pytestqt.qtbot import QtBot

from trex_gui.ui.widgets import builders as ui
from trex_gui.ui.widgets.labels import LinkLabel, LiveLabel, Sign
from trex_gui.ui.widgets.leds import Lamp
from trex_gui.ui.widgets.sliders import StickSlider

Role, Text = QAccessible.Role, QAccessible.Text


def interface_of(widget: QWidget) -> QAccessibleInterface:
    interface = QAccessible.queryAccessibleInterface(widget)
    assert interface is not None
    return interface


def test_slider_is_read_and_set_in_its_visible_unit(qtbot: QtBot) -> None:
    slider = StickSlider(40, 160, 40, "bar")
    qtbot.addWidget(slider)
    slider.positions_per_unit = 10
    slider.value_label = QLabel("12.0 V", slider)
    slider.setValue(120)
    interface = interface_of(slider)
    value = interface.valueInterface()
    assert value is not None
    assert (value.minimumValue(), value.currentValue(), value.maximumValue()) == (4, 12, 16)
    assert interface.role() is Role.Slider
    assert interface.text(Text.Description) == "12.0 V"
    slider.setToolTip("The power supply")
    assert interface.text(Text.Description) == "12.0 V\nThe power supply"
    value.setCurrentValue(13.5)
    assert slider.value() == 135


def test_live_label_is_announced_with_its_name(qtbot: QtBot) -> None:
    label = LiveLabel("value", "Input 1")
    qtbot.addWidget(label)
    label.setText("1500 µs")
    assert interface_of(label).text(Text.Name) == "Input 1: 1500 µs"
    assert interface_of(label).role() is Role.StaticText


def test_sign_has_a_name_while_it_is_visible(qtbot: QtBot) -> None:
    sign = Sign()
    qtbot.addWidget(sign)
    sign.show_sign("warning", "warning")
    assert interface_of(sign).text(Text.Name) == "Warning"
    sign.show_sign("")
    assert not interface_of(sign).text(Text.Name)


@pytest.mark.parametrize("has_value", [True, False])
def test_only_a_widget_with_a_value_has_a_value_interface(has_value: bool, qtbot: QtBot) -> None:
    widget = StickSlider(0, 1, 0, "bar") if has_value else Lamp("led_red")
    qtbot.addWidget(widget)
    interface = interface_of(widget)
    assert interface.textInterface() is None
    assert interface.selectionInterface() is None
    assert (interface.valueInterface() is not None) is has_value


def test_interface_survives_the_deletion_of_other_widgets(qtbot: QtBot) -> None:
    parent = QWidget()
    qtbot.addWidget(parent)
    permanent = Lamp("led_red", parent)
    interface_of(permanent)
    for _ in range(5):
        temporary = Lamp("led_red", parent)
        interface_of(temporary)
        temporary.deleteLater()
        del temporary
        QCoreApplication.sendPostedEvents(None, QEvent.Type.DeferredDelete)
        gc.collect()
        assert interface_of(permanent).role() is Role.Graphic
    assert parent.findChildren(Lamp) == [permanent]


def test_tab_announces_each_link(qtbot: QtBot, monkeypatch: pytest.MonkeyPatch) -> None:
    announced: list[str] = []

    def update(event: object) -> None:
        assert isinstance(event, QAccessibleAnnouncementEvent)
        announced.append(event.message())

    monkeypatch.setattr(QAccessible, "updateAccessibility", update)
    window = QWidget()
    qtbot.addWidget(window)
    before, label, after = QPushButton(window), LinkLabel("links", window), QPushButton(window)
    label.setText('<a href="1">first</a> and <a href="2">second</a>')
    ui.column(before, label, after, into=window)
    window.show()
    window.activateWindow()
    qtbot.waitUntil(window.isActiveWindow)
    before.setFocus()
    for _ in range(3):  # to the label, and to each link
        focused = window.focusWidget()
        assert focused is not None
        QTest.keyClick(focused, Qt.Key.Key_Tab)
    assert label.hasFocus()
    assert announced == ["first", "second"]
    QTest.keyClick(label, Qt.Key.Key_Tab)
    assert after.hasFocus()
