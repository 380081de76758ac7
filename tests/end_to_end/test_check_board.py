"""Recovery of a board with unknown serial settings by means of its jumpers."""

import pytest
from PySide6.QtWidgets import QComboBox

from tests.support.simulator import SimulatedDevice
from tests.support.window import WidgetDriver, WindowDriver
from trex_gui.devices.trex.views.check_board import _STEPS
from trex_gui.devices.trex.views.steps import Steps
from trex_gui.ui.devices.connection import ConnectionState

pytestmark = pytest.mark.usefixtures("no_ports")


def driver_of(window: WindowDriver) -> WidgetDriver:
    dialog = window.find(Steps, "checkDialog")
    assert dialog.isVisible()
    return WidgetDriver(dialog, window.qtbot)


@pytest.mark.qt_log_ignore("This plugin does not support", extend=True)  # popups offscreen
def test_jumpers_restore_default_serial_settings(
    window: WindowDriver, quick_simulator: SimulatedDevice
) -> None:
    board = quick_simulator
    window.trigger("check_board")
    driver_of(window).click("checkConnectButton")
    ports = window.find(QComboBox, "portCombo")
    assert ports.view().isVisible(), "the user has not selected a port yet"
    ports.hidePopup()

    board.do("eeprom uart_settings 0x25")  # CRC-7
    board.do("eeprom crc7_polynomial 0x1D", "power cycle")
    window.connect_port(window.program.ports.add_typed(board.url))
    window.wait_for_text("bannerText", "No TReX responds")
    window.click("bannerCheckBoard")
    dialog = driver_of(window)
    assert not dialog.is_enabled("checkBackButton")
    dialog.click("checkNextButton")

    control_lines = (
        ("power off", "jumper mode serial", "jumper mix on", "jumper so-ground on"),
        ("power on",),
        ("jumper mix off",),
        ("jumper so-ground off",),
        ("power cycle",),
    )
    for number, (step, lines) in enumerate(zip(_STEPS, control_lines, strict=True)):
        assert dialog.text("handShakeToDo") == step.instruction
        board.do(*lines)
        window.wait(lambda: tuple(board.show()["leds"].values()) == step.leds)  # noqa: B023
        jumpers = board.show()["jumpers"]
        assert (jumpers["mix"], jumpers["so_ground"]) == step.jumpers[:2]
        if step.title == "SO–G: off":
            dialog.click("checkConnectButton")
            dialog.wait_for_text("checkNote", "is in its boot loader")
            assert window.has("bannerReconnect")
        if number < len(_STEPS) - 1:
            dialog.click("checkNextButton")
    dialog.click("checkNextButton")
    window.wait(lambda: window.device.link is ConnectionState.CONNECTED)
    assert dialog.text("checkNote") == "Connected to TReX 1.2."
    assert not dialog.is_enabled("checkNextButton")
    assert board.show()["active_uart"]["crc"] is False

    dialog.root.close()
    window.disconnect()
    window.connect(board.url)
    window.disconnect()
    window.trigger("check_board")
    assert dialog.has("checkLedsPage"), "the dialog starts again at its first page"
    assert dialog.text("checkNote") == "", "an earlier connection is not shown"
    dialog.root.close()
    window.trigger("find")
    window.click("findCheckButton")
    assert dialog.root.isVisible()
