"""Page of reported errors and connection quality."""

from PySide6.QtWidgets import QWidget
from pytestqt.qtbot import QtBot

from tests.support.simulator import SimulatedDevice
from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.devices.trex.views.pages.errors import ErrorsPage
from trex_gui.ui.runtime import now


def test_duration_of_a_connection_contains_no_words(
    qtbot: QtBot, quick_simulator: SimulatedDevice
) -> None:
    device, window = Device(), QWidget()
    qtbot.addWidget(window)
    page = ErrorsPage(device, window)
    device.connect_to(ConnectionSettings(quick_simulator.url))
    qtbot.waitUntil(lambda: device.is_connected)
    device.board.connected_at = now() - 90_061
    values = {reading.caption: reading.value for reading in page.readings()}
    assert values["Connected for"] == "25:01:01"
    device.disconnect_line()
    qtbot.waitUntil(device.shut_down)
