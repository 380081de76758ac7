"""Dialog for a board that does not respond."""

from pytestqt.qtbot import QtBot

from tests.support.simulator import SimulatedDevice
from tests.support.window import WidgetDriver
from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.devices.trex.views.check_board import CheckBoardFlow
from trex_gui.devices.trex.views.steps import Steps
from trex_gui.ui.devices.connection import ConnectionState


def test_reopened_dialog_shows_no_earlier_connection(
    qtbot: QtBot, quick_simulator: SimulatedDevice
) -> None:
    device = Device()
    flow = CheckBoardFlow(device)
    dialog = Steps(device, flow)
    qtbot.addWidget(dialog)
    driver = WidgetDriver(dialog, qtbot)
    device.connect_to(ConnectionSettings(quick_simulator.url))
    driver.wait(lambda: device.is_connected)
    device.disconnect_line()
    driver.wait(lambda: device.link is ConnectionState.DISCONNECTED)
    flow.show_in_front()
    assert driver.text("checkNote") == ""
    dialog.close()
    driver.wait(device.shut_down)
