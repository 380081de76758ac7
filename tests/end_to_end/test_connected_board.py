"""Window with a connected board: title, pages, port list, modes, and typed text."""

import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QSpinBox

from tests.support.pages.channels import input_of
from tests.support.pages.parameters import ParametersPage
from tests.support.simulator import SimulatedDevice
from tests.support.window import WindowDriver
from trex_gui.ui.devices.connection import ConnectionState
from trex_gui.ui.runtime import now


@pytest.fixture
def connected(window: WindowDriver, simulator: SimulatedDevice) -> WindowDriver:
    """Window connected to a board with realistic byte times."""
    window.connect(simulator.url)
    return window


def test_minimized_window_updates_after_restore(
    connected: WindowDriver, simulator: SimulatedDevice
) -> None:
    window = connected
    channels = window.open_page("channelsPage")
    channels.wait(lambda: input_of(channels, 1).startswith("1500 µs (3750)"))
    telemetry = window.device.telemetry
    window.window.showMinimized()
    simulator.do("channel 1 1800us")
    window.wait(lambda: telemetry.raw_of(1) == 4500)
    start, count = now(), telemetry.samples
    window.wait(lambda: now() > start + 2)
    assert telemetry.samples - count < 2 * 60
    assert input_of(channels, 1).startswith("1500 µs (3750)")

    window.window.showNormal()
    assert input_of(channels, 1).startswith("1800 µs (4500)")
    start, count = now(), telemetry.samples
    window.wait(lambda: now() > start + 2)
    assert telemetry.samples - count > 2 * 150


def test_title_and_pages_show_board_data_until_disconnect(
    window: WindowDriver, simulator: SimulatedDevice
) -> None:
    assert window.window.windowTitle() == "TReX Studio[*]"
    window.connect(simulator.url)
    title = f"TReX 1.2, device 7 on {simulator.url}[*] – TReX Studio"
    window.wait(lambda: window.window.windowTitle() == title)
    assert not window.window.isWindowModified()
    window.device.parameters.edit("serial_timeout", 5)
    assert window.window.isWindowModified()
    window.device.draft.discard_edits()
    assert not window.window.isWindowModified()

    assert window.text("statusLabel") == "TReX 1.2, device 7"
    board = window.open_page("boardPage")
    assert "Not armed" in board.text("motorsReason1")
    assert "TReX (DMC01) · firmware 1.2" in board.text("boardFacts")
    channels = window.open_page("channelsPage")
    simulator.do("power off")
    window.wait(lambda: window.device.link is ConnectionState.NOT_RESPONDING)
    assert "stopped responding" in window.text("statusLabel")
    simulator.do("power on")
    window.wait(lambda: window.device.link is ConnectionState.CONNECTED)
    channels.wait(lambda: "µs" in input_of(channels, 1))

    window.click("connectButton")
    window.wait(lambda: window.device.link is ConnectionState.DISCONNECTED)
    assert window.window.windowTitle() == "TReX Studio[*]"
    assert input_of(channels, 1).startswith("not known")
    assert not board.has("boardView")
    for name in ("parametersView", "runButton", "stopButton", "applyButton"):
        assert not window.is_enabled(name), name


def test_connect_menu_entry_follows_the_selected_port(connected: WindowDriver) -> None:
    window, first = connected, connected.program.device_manager.current.port
    assert not window.action("connect").isEnabled()
    window.select("portCombo", window.program.ports.demo_of("trex"))
    assert window.action("connect").isEnabled(), "the button would connect too"
    window.select("portCombo", first)
    assert not window.action("connect").isEnabled()
    window.select("portCombo", window.program.ports.demo_of("trex"))
    window.trigger("connect")
    window.wait(lambda: window.program.device_manager.current.port != first)
    window.wait(lambda: window.device.link is ConnectionState.CONNECTED)
    assert not window.action("connect").isEnabled()


def test_board_in_rc_mode_rejects_settings_and_speeds(
    window: WindowDriver, simulator: SimulatedDevice
) -> None:
    simulator.do("jumper mode rc", "power cycle")
    window.connect(simulator.url)
    motors = window.open_page("motorsPage")
    assert not window.is_enabled("runButton")
    assert "RC channels control the motors" in motors.text("motorsReason")

    window.open_page("boardPage")
    assert "Serial timeout is off" in window.text("timeoutLabel")
    assert not window.has("timeoutButton"), "the board would reject it"
    parameters = window.open_page("parametersPage")
    assert not parameters.is_enabled("parametersView")
    assert "serial mode only" in parameters.text("pageState")
    window.device.parameters.edit("serial_timeout", 15)
    assert not window.is_enabled("applyButton")
    assert not window.window.close()
    assert window.has("keepAndClose")
    assert not window.has("applyFirst"), "the board would reject it"
    window.click("questionCancel")

    simulator.do("jumper mode serial", "power cycle")
    window.wait(lambda: window.is_enabled("applyButton"))
    assert parameters.is_enabled("parametersView")
    window.open_page("boardPage")
    assert window.has("timeoutButton")
    assert window.device.parameters.values.pending == (("serial_timeout", 15),)


KEY = "serial_timeout"


def editor(page: ParametersPage) -> QSpinBox:
    widget = page.view.indexWidget(page.index_of(KEY))
    assert isinstance(widget, QSpinBox)
    return widget


def type_without_enter(page: ParametersPage, text: str) -> None:
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
    type_without_enter(page, "1.5")
    for command, link in (
        ("line mute on", ConnectionState.NOT_RESPONDING),
        ("line mute off", ConnectionState.CONNECTED),
    ):
        quick_simulator.do(command)
        window.wait(lambda: device.link is link)  # noqa: B023
        assert editor(page).text() == "1.5", command
        assert editor(page).hasFocus(), command
    quick_simulator.do("line mute on")
    window.wait(lambda: device.link is ConnectionState.NOT_RESPONDING)
    QTest.keyClick(editor(page), Qt.Key.Key_Return)
    window.wait(lambda: device.parameters.values.value_of(KEY) == 15)
    page.wait_for_no_editor(KEY)
    type_without_enter(page, "2")
    quick_simulator.do("line unplug")
    window.wait(lambda: device.link is ConnectionState.DISCONNECTED)
    assert device.parameters.values.value_of(KEY) == 20
