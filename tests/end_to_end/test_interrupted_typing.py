"""What is typed into a cell of the parameter table survives a board that stops responding."""

from functools import partial

from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QSpinBox

from tests.support.pages.parameters import ParametersPage
from tests.support.simulator import SimulatedDevice
from tests.support.window import WindowDriver
from trex_gui.devices.trex.model.device import Device
from trex_gui.ui.devices.connection import ConnectionState

KEY = "serial_timeout"


def has_link(device: Device, link: ConnectionState) -> bool:
    return device.link is link


def editor(page: ParametersPage) -> QSpinBox:
    found = page.view.indexWidget(page.index_of(KEY))
    assert isinstance(found, QSpinBox)
    return found


def begin_to_type(page: ParametersPage, text: str) -> None:
    page.view.setCurrentIndex(page.index_of(KEY))
    QTest.keyClick(page.view, Qt.Key.Key_F2)
    editor(page).selectAll()
    QTest.keyClicks(editor(page), text)


def test_typed_text_survives_a_silent_board(
    connected_window: WindowDriver, quick_simulator: SimulatedDevice
) -> None:
    window, device = connected_window, connected_window.device
    page = ParametersPage(window)
    page.view.setFocus()
    begin_to_type(page, "1.5")
    for command, link in (
        ("line mute on", ConnectionState.NOT_RESPONDING),
        ("line mute off", ConnectionState.CONNECTED),
    ):
        quick_simulator.do(command)
        window.wait(partial(has_link, device, link))
        assert editor(page).text() == "1.5", command
        assert editor(page).hasFocus(), command
    quick_simulator.do("line mute on")
    window.wait(lambda: device.link is ConnectionState.NOT_RESPONDING)
    QTest.keyClick(editor(page), Qt.Key.Key_Return)
    window.wait(lambda: device.parameters.values.value_of(KEY) == 15)
    page.wait_for_no_editor(KEY)
    begin_to_type(page, "2")
    quick_simulator.do("line unplug")
    window.wait(lambda: device.link is ConnectionState.DISCONNECTED)
    assert device.parameters.values.value_of(KEY) == 20
