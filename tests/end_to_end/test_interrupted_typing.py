"""What is typed into a cell of the parameter table survives a board that stops responding."""

from functools import partial

from PySide6.QtCore import QModelIndex, Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QSpinBox

from tests.support.simulator import SimulatedDevice
from tests.support.window import WindowDriver
from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.views.pages.parameters.filters import ParameterFilter
from trex_gui.devices.trex.views.pages.parameters.view import ParameterView
from trex_gui.ui.devices.connection import ConnectionState

KEY = "serial_timeout"


def cell(view: ParameterView) -> QModelIndex:
    rows = view.model()
    assert isinstance(rows, ParameterFilter)
    return rows.index_of(KEY)


def open_editor(view: ParameterView) -> QSpinBox:
    view.setCurrentIndex(cell(view))
    QTest.keyClick(view, Qt.Key.Key_F2)
    return editor(view)


def editor(view: ParameterView) -> QSpinBox:
    found = view.indexWidget(cell(view))
    assert isinstance(found, QSpinBox)
    return found


def has_link(device: Device, link: ConnectionState) -> bool:
    return device.link is link


def type_text(box: QSpinBox, text: str) -> None:
    box.selectAll()
    QTest.keyClicks(box, text)


def test_typed_text_survives_a_silent_board(
    connected_window: WindowDriver, quick_simulator: SimulatedDevice
) -> None:
    window, device = connected_window, connected_window.device
    page = window.open_page("parametersPage")
    view = page.find(ParameterView, "parametersView")
    view.setFocus()
    type_text(open_editor(view), "1.5")
    for command, link in (
        ("line mute on", ConnectionState.NOT_RESPONDING),
        ("line mute off", ConnectionState.CONNECTED),
    ):
        quick_simulator.do(command)
        window.wait(partial(has_link, device, link))
        assert editor(view).text() == "1.5", command
        assert editor(view).hasFocus(), command
    quick_simulator.do("line mute on")
    window.wait(lambda: device.link is ConnectionState.NOT_RESPONDING)
    QTest.keyClick(editor(view), Qt.Key.Key_Return)
    window.wait(lambda: device.parameters.values.value_of(KEY) == 15)
    window.wait(lambda: view.indexWidget(cell(view)) is None)
    type_text(open_editor(view), "2")
    quick_simulator.do("line unplug")
    window.wait(lambda: device.link is ConnectionState.DISCONNECTED)
    assert device.parameters.values.value_of(KEY) == 20
