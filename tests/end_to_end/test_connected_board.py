"""A board in the window: connection, pages, settings and motors."""

import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QSlider, QTableView, QWidget

from tests.support.accessible_names import spoken_state
from tests.support.pages.parameters import ParametersPage
from tests.support.program import trex
from tests.support.simulator import SimulatedDevice
from tests.support.window import WindowDriver
from trex_gui.devices.trex.protocol.calibration import Calibration, CalibrationKey
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.ui.devices.connection import ConnectionState
from trex_gui.ui.runtime import now, open_transport


@pytest.fixture
def connected(window: WindowDriver, simulator: SimulatedDevice) -> WindowDriver:
    """The window, connected to a board whose bytes take their time."""
    window.connect(simulator.url)
    return window


def apply(window: WindowDriver) -> None:
    """Open the review and write."""
    window.click("applyButton")
    window.click("writeButton")


def wait_for_speed(
    window: WindowDriver, simulator: SimulatedDevice, index: int, speed: int
) -> None:
    window.wait(lambda: simulator.show()["motors"][index]["direction"] != "brake")
    window.wait(lambda: simulator.show()["motors"][index]["speed"] == speed)


def wait_for_brake(window: WindowDriver, simulator: SimulatedDevice, index: int) -> None:
    window.wait(lambda: simulator.show()["motors"][index]["direction"] == "brake")


def test_minimised_window_shows_nothing_new_until_it_is_restored(
    connected: WindowDriver, simulator: SimulatedDevice
) -> None:
    window = connected
    channels = window.open_page("channelsPage")
    channels.wait(lambda: channels.text("channel1Input") == "1500 µs (3750)")
    telemetry = window.device.telemetry
    window.window.showMinimized()
    simulator.do("channel 1 1800us")
    window.wait(lambda: telemetry.raw_of(1) == 4500)
    begun, before = now(), telemetry.samples
    window.wait(lambda: now() > begun + 2)
    assert telemetry.samples - before < 2 * 60
    assert channels.text("channel1Input") == "1500 µs (3750)"

    window.window.showNormal()
    assert channels.text("channel1Input") == "1800 µs (4500)"
    begun, before = now(), telemetry.samples
    window.wait(lambda: now() > begun + 2)
    assert telemetry.samples - before > 2 * 150

    window.window.showMinimized()
    window.disconnect()
    window.wait(lambda: window.device.link is ConnectionState.DISCONNECTED)
    window.window.showNormal()
    assert channels.text("channel1Input") == "N/A"


def test_title_names_the_board_and_marks_edits(
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
    window.disconnect()
    assert window.window.windowTitle() == "TReX Studio[*]"


def test_pages_show_board_data_until_disconnect(
    connected: WindowDriver, simulator: SimulatedDevice
) -> None:
    window = connected
    assert window.text("statusLabel") == "Connected to TReX 1.2."
    status = window.open_page("statusPage")
    assert "Serial commands control the motors" in status.text("controlValue")

    channels = window.open_page("channelsPage")
    channels.wait(lambda: channels.text("channel1Input") == "1500 µs (3750)")
    simulator.do("channel 1 1800us")
    channels.wait(lambda: channels.text("channel1Input") == "1800 µs (4500)")
    bar, output = channels.find(QWidget, "channel1Bar"), channels.find(QWidget, "channel1Output")
    channels.wait(lambda: "1800 µs" in spoken_state(bar))
    remapped = simulator.show()["channels"][0]["remapped"]
    channels.wait(lambda: str(remapped) in spoken_state(output))
    simulator.do("channel 2 invalid")
    channels.wait(lambda: channels.text("channel2Input") == "no signal")

    simulator.do("power off")
    window.wait(lambda: window.device.link is ConnectionState.NOT_RESPONDING)
    assert "stopped responding" in window.text("statusLabel")
    simulator.do("power on")
    window.wait(lambda: window.device.link is ConnectionState.CONNECTED)
    channels.wait(lambda: "µs" in channels.text("channel1Input"))

    window.click("connectButton")
    window.wait(lambda: window.device.link is ConnectionState.DISCONNECTED)
    assert channels.text("channel1Input") == "N/A"
    assert status.text("modelValue") == "N/A"
    for name in ("parametersView", "runButton", "stopButton", "applyButton"):
        assert not window.is_enabled(name), name


def test_connect_in_the_menu_follows_the_port_in_the_list(connected: WindowDriver) -> None:
    window, first = connected, connected.program.device_manager.current.port
    assert not window.action("connect").isEnabled()
    window.select("portCombo", window.program.ports.demo_of("trex"))
    assert window.action("connect").isEnabled(), "as the button connects"
    window.select("portCombo", first)
    assert not window.action("connect").isEnabled()
    window.select("portCombo", window.program.ports.demo_of("trex"))
    window.trigger("connect")
    window.wait(lambda: window.program.device_manager.current.port != first)
    window.wait(lambda: window.device.link is ConnectionState.CONNECTED)
    assert not window.action("connect").isEnabled()


def test_parameters_are_edited_applied_and_activated(
    connected: WindowDriver, simulator: SimulatedDevice
) -> None:
    window, device = connected, connected.device
    page = ParametersPage(window)
    editor = page.type_value("serial_timeout", "99 s")
    assert editor.isVisible()
    assert editor.text() == "99 s"
    assert "off to 12.7 s" in page.text("parametersNotice")
    QTest.keyClick(editor, Qt.Key.Key_Escape)
    page.wait_for_no_editor("serial_timeout")
    assert device.draft.pending == 0
    assert not window.has("unappliedLabel")

    page.edit("serial_timeout", "1.5 s")
    assert window.has("unappliedLabel")
    assert window.text("unappliedLabel") == "There are unapplied changes."
    assert simulator.show()["parameters"]["serial_timeout"] == 0
    apply(window)
    window.wait(lambda: not device.parameters.values.pending)
    assert simulator.show()["parameters"]["serial_timeout"] == 15
    assert "written and verified" in page.text("parametersNotice")

    wanted = Calibration(2400, 3700, 5100, 60)
    device.calibrations.edit(1, wanted)
    device.parameters.edit("motor1_current_limit", 10)
    device.parameters.edit("motor_mode", 1)
    apply(window)
    window.wait(lambda: device.draft.pending == 0 and not device.writer.running)
    assert device.state is not None
    assert device.state.calibrations[1] == wanted
    assert device.draft.stored is not None
    assert device.draft.stored.calibrations[CalibrationKey.RC_CHANNEL_1] == wanted
    assert device.parameters.values.stored_of("motor1_current_limit") == 10

    assert device.parameters.values.waiting_for_power == ("Motor Mode",)
    assert "Motor Mode" in page.text("parametersNotice")
    simulator.do("power off")
    window.wait(lambda: device.link is ConnectionState.NOT_RESPONDING)
    assert window.is_enabled("parametersView")  # what is typed is written with Apply only
    simulator.do("power on")
    window.wait(lambda: device.parameters.values.waiting_for_power == ())
    assert device.state.parameters["motor_mode"] == 1


def test_board_in_rc_mode_rejects_settings_and_speeds(
    window: WindowDriver, simulator: SimulatedDevice
) -> None:
    simulator.do("jumper mode rc")
    simulator.do("power cycle")
    window.connect(simulator.url)
    motors = window.open_page("motorsPage")
    assert not window.is_enabled("runButton")
    assert "RC channels control the motors" in motors.text("motorsReason")

    assert window.has("timeoutNotice")
    assert not window.has("timeoutButton"), "the board would reject it"
    parameters = window.open_page("parametersPage")
    assert not parameters.is_enabled("parametersView")
    assert "serial mode only" in parameters.text("parametersNotice")
    window.device.parameters.edit("serial_timeout", 15)
    assert not window.is_enabled("applyButton")
    assert not window.window.close()
    assert window.has("keepAndClose")
    assert not window.has("applyFirst"), "the board would reject it"
    window.click("questionCancel")

    simulator.do("jumper mode serial")
    simulator.do("power cycle")
    window.wait(lambda: window.is_enabled("applyButton"))
    assert parameters.is_enabled("parametersView")
    assert window.has("timeoutButton")
    assert window.device.parameters.values.pending == (("serial_timeout", 15),)


def test_motors_run_from_arming_until_stopped(
    connected: WindowDriver, simulator: SimulatedDevice
) -> None:
    window = connected
    page = window.open_page("motorsPage")
    slider = page.find(QSlider, "motor1Slider")
    assert not slider.isEnabled()
    window.click("runButton")
    assert "Drive them on the Motors page" in window.text("motorStateLabel")
    slider.setValue(80)
    assert window.text("motorStateLabel") == "Armed. Sent: motor 1 +80"
    wait_for_speed(window, simulator, 0, 80)
    assert simulator.show()["motors"][0]["direction"] == "forward"
    page.wait(lambda: "A" in page.text("motor1Reported"))
    window.click("stopButton")
    wait_for_brake(window, simulator, 0)
    assert slider.value() == 0
    assert not slider.isEnabled()

    window.wait(lambda: window.is_enabled("runButton"))
    window.click("runButton")
    window.motors.set_speed(2, -100)
    wait_for_speed(window, simulator, 1, 100)
    parameters = ParametersPage(window)
    parameters.view.edit(parameters.index_of("serial_timeout"))
    handle = window.window.windowHandle()
    window.wait(lambda: handle.isActive() or handle.isExposed())
    QTest.keyClick(handle, Qt.Key.Key_Escape)
    wait_for_brake(window, simulator, 1)

    window.wait(lambda: window.is_enabled("runButton"))
    window.click("runButton")
    window.motors.set_speed(1, 60)
    wait_for_speed(window, simulator, 0, 60)
    window.window.close()
    wait_for_brake(window, simulator, 0)


def test_unplugging_is_detected_and_reconnecting_brakes_motors(
    connected: WindowDriver, simulator: SimulatedDevice
) -> None:
    window = connected
    window.click("runButton")
    window.motors.set_speed(1, 50)
    wait_for_speed(window, simulator, 0, 50)
    begin = now()
    simulator.do("line unplug")
    window.wait(lambda: window.device.link is ConnectionState.DISCONNECTED)
    assert now() - begin < 0.5
    assert "gone" in window.text("bannerText")
    assert not window.motors.armed
    assert window.text("statusLabel") == "Not connected."
    assert "may still be turning" in window.text("motorStateLabel")
    assert simulator.show()["motors"][0]["speed"] == 50

    window.connect(simulator.do("line plug").split()[-1])
    assert window.text("statusLabel") == "Connected to TReX 1.2."
    assert simulator.show()["motors"][0]["direction"] == "brake"
    assert "Not armed" in window.text("motorStateLabel")
    table = window.open_page("parametersPage").find(QTableView, "parametersView")
    assert table.rowAt(0) == 0, "its first heading is in sight"


def test_board_that_does_not_reply_is_stopped(
    connected: WindowDriver, simulator: SimulatedDevice
) -> None:
    window = connected
    window.click("runButton")
    window.motors.set_speed(2, 90)
    wait_for_speed(window, simulator, 1, 90)
    simulator.do("line mute on")
    window.wait(lambda: window.device.link is ConnectionState.NOT_RESPONDING)
    wait_for_brake(window, simulator, 1)
    assert window.open_page("statusPage").text("modelValue") == "N/A"
    simulator.do("line mute off")
    window.wait(lambda: window.device.link is ConnectionState.CONNECTED)
    assert not window.motors.armed


def test_missing_and_busy_ports_are_reported(
    window: WindowDriver, simulator: SimulatedDevice
) -> None:
    connector, ports = trex(window.program).controller, window.program.ports
    connector.connect_to(ports.add_typed("/dev/ttyNothing7"))
    window.wait_for_text("bannerText", "There is no port /dev/ttyNothing7")
    assert window.device.link is ConnectionState.DISCONNECTED

    other = open_transport(ConnectionSettings(simulator.url))
    connector.connect_to(ports.add_typed(simulator.url))
    window.wait_for_text("bannerText", "in use")
    other.close()
