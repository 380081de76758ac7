"""Ports that are remote, damaged, or lead to no TReX."""

import pytest

from tests.support.simulator import SimulatedDevice, StartSimulator
from tests.support.window import WindowDriver
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.devices.trex.protocol.line_settings import Detection, LineSettings
from trex_gui.ui.devices.connection import ConnectionState


@pytest.mark.parametrize("kind", ["--tcp", "--rfc2217"])
@pytest.mark.filterwarnings("ignore:set(Daemon|Name):DeprecationWarning")
@pytest.mark.realtime
def test_network_board_connects_and_its_loss_is_reported(
    kind: str, window: WindowDriver, start_simulator: StartSimulator
) -> None:
    simulator = start_simulator(kind, "127.0.0.1:0")
    window.device.connect_to(ConnectionSettings(simulator.url))
    window.wait(lambda: window.device.link is ConnectionState.CONNECTED)
    simulator.do("line unplug")
    window.wait(lambda: window.device.link is ConnectionState.DISCONNECTED)
    assert "gone" in window.text("bannerText")


def test_port_without_a_board_is_reported(window: WindowDriver, simulator: SimulatedDevice) -> None:
    simulator.do("power off")
    port = window.program.ports.add_typed(simulator.url)
    window.connect_port(port)
    window.wait_for_text("statusLabel", "No reply yet. Trying other settings: 19200 baud, ")
    window.wait(lambda: window.device.link is ConnectionState.DISCONNECTED)
    assert "No TReX responds" in window.text("bannerText")
    assert "power" in window.text("bannerText")

    window.click("bannerDismiss")
    crc = LineSettings(detection=Detection.CRC7)
    window.program.device_manager.connect_with(port, ConnectionSettings("", crc))
    window.wait_for_text("statusLabel", "Trying other settings: 19200 baud, CRC-7")
    window.click("connectButton")
    window.wait(lambda: window.device.link is ConnectionState.DISCONNECTED)
    assert not window.has("bannerText"), "the search was ended by the user"


def test_program_that_may_take_the_replies_is_named(
    window: WindowDriver, simulator: SimulatedDevice, monkeypatch: pytest.MonkeyPatch
) -> None:
    users: dict[str, str] = {}
    monkeypatch.setattr("trex_gui.ui.devices.connection.other_user_of", users.get)
    text = f"cat (process 7) also has {simulator.url} open and may take replies. Close it there."
    window.connect(simulator.url)
    simulator.do("line mute on")
    window.wait(lambda: window.device.link is ConnectionState.NOT_RESPONDING)
    window.wait_for_files()
    assert not window.text("bannerText"), "nothing is known"

    simulator.do("line mute off")
    window.wait(lambda: window.device.link is ConnectionState.CONNECTED)
    users[simulator.url] = "cat (process 7)"
    simulator.do("line mute on")
    window.wait_for_text("bannerText", text)
    assert not window.has("bannerReconnect"), "the session goes on trying"
    window.disconnect()

    window.click("connectButton")
    window.wait_for_text("bannerText", text)
    simulator.do("line mute off")
    window.click("bannerReconnect")
    window.wait(lambda: window.device.link is ConnectionState.CONNECTED)
    assert not window.text("bannerText")
