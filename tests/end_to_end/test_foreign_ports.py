"""Ports that are remote or noisy, lose their board, or have none."""

import argparse

import pytest
from PySide6.QtCore import QPoint
from PySide6.QtWidgets import QDialog
from serial.tools.list_ports_common import ListPortInfo

from tests.end_to_end.test_board_after_lost_line import lose_running_board
from tests.support.simulator import SimulatedDevice, StartSimulator
from tests.support.virtual_time import VirtualRuntime
from tests.support.window import WindowDriver
from trex_gui.app import connect
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.devices.trex.protocol.line_settings import Detection, LineSettings
from trex_gui.devices.trex.protocol.parameters import ParameterKey
from trex_gui.ui.devices.auto_connect import set_connects_automatically
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
    assert not window.has("bannerText"), "the user ended the search"


def test_program_that_may_take_the_replies_is_named(
    window: WindowDriver, simulator: SimulatedDevice, monkeypatch: pytest.MonkeyPatch
) -> None:
    users: dict[str, str] = {}
    monkeypatch.setattr("trex_gui.ui.devices.connection.other_user_of", users.get)
    text = f"cat (process 7) also has {simulator.url} open and may take replies."
    window.connect(simulator.url)
    simulator.do("line mute on")
    window.wait(lambda: window.device.link is ConnectionState.NOT_RESPONDING)
    window.wait_for_files()
    assert not window.text("bannerText"), "no other program is known"

    simulator.do("line mute off")
    window.wait(lambda: window.device.link is ConnectionState.CONNECTED)
    users[simulator.url] = "cat (process 7)"
    simulator.do("line mute on")
    window.wait_for_text("bannerText", text)
    assert not window.has("bannerReconnect"), "the session keeps retrying"
    window.disconnect()

    window.click("connectButton")
    window.wait_for_text("bannerText", text)
    simulator.do("line mute off")
    window.click("bannerReconnect")
    window.wait(lambda: window.device.link is ConnectionState.CONNECTED)
    assert not window.text("bannerText")


def adapter(url: str, number: str) -> ListPortInfo:
    info = ListPortInfo(url, skip_link_detection=True)
    info.vid, info.pid, info.serial_number, info.location = 0x0403, 0x6001, number, "1-2"
    return info


def test_window_reconnects_to_the_same_adapter_only(
    computer: list[ListPortInfo],
    window: WindowDriver,
    quick_simulator: SimulatedDevice,
    virtual_time: VirtualRuntime,
) -> None:
    board, device, ports = quick_simulator, window.device, window.program.ports
    computer.append(adapter(board.url, "A500001"))
    ports.refresh()
    window.program.auto_connect.start()
    window.connect(board.url)
    logged: list[str] = []
    device.notifier.logged.connect(lambda text, _: logged.append(text))

    # The adapter returns under another name. A motor was running, and a setting is edited.
    device.parameters.edit(ParameterKey.SERIAL_TIMEOUT, 9)
    computer.clear()
    infos: list[str] = []
    window.device.notifier.info.connect(infos.append)
    lose_running_board(window, board)
    window.wait_for_text("bannerText", f"The connection to {board.url} is gone.")
    assert window.has("bannerReconnect")
    board.do("line plug")
    computer[:] = [adapter(board.url, "B700002")]
    virtual_time.advance(5.0)
    assert device.link is ConnectionState.DISCONNECTED, "another adapter has the name of the port"
    assert window.has("bannerText")
    virtual_time.ports["/dev/ttyUSB1"] = virtual_time.ports[board.url]
    computer.append(adapter("/dev/ttyUSB1", "A500001"))
    window.wait(lambda: device.link is ConnectionState.CONNECTED)
    window.wait(lambda: any(text.startswith("1 earlier change still pending.") for text in infos))
    assert not window.motors.armed
    assert window.motors.board.endswith("-0403:6001-A500001"), "its speed ceiling applies"
    assert board.show()["motors"][0]["direction"] == "brake"
    assert device.parameters.values.pending == ((ParameterKey.SERIAL_TIMEOUT, 9),)
    assert ports.preferred == ports.find("/dev/ttyUSB1")
    window.wait(lambda: any("Reconnected to /dev/ttyUSB1." in text for text in logged))
    device.parameters.discard_edits()

    # The adapter returns before the port list changes.
    board.do("line unplug")
    window.wait(lambda: device.link is ConnectionState.DISCONNECTED)
    board.do("line plug")
    window.wait(lambda: device.link is ConnectionState.CONNECTED)
    window.wait(lambda: "Reconnected to /dev/ttyUSB1. No motor was started." in logged)

    # A listed port that cannot be opened is tried again only after it was unplugged.
    board.do("line unplug")
    window.wait_for_text("bannerText", "There is no port /dev/ttyUSB1.")
    computer.clear()
    virtual_time.advance(5.0)
    set_connects_automatically(False)
    board.do("line plug")
    computer.append(adapter("/dev/ttyUSB1", "A500001"))
    window.wait(lambda: not window.has("bannerText"))
    assert device.link is ConnectionState.DISCONNECTED, "only the message disappears"


def test_window_reconnects_to_port_of_the_command_line(
    computer: list[ListPortInfo], window: WindowDriver, quick_simulator: SimulatedDevice
) -> None:
    board, device = quick_simulator, window.device
    computer.append(adapter(board.url, "A500001"))
    window.program.ports.refresh()
    connect(window.program, argparse.Namespace(demo=False, port=board.url, device=None))
    window.wait(lambda: device.link is ConnectionState.CONNECTED)
    computer.clear()
    board.do("line unplug")
    window.wait_for_text("bannerText", f"The connection to {board.url} is gone.")
    board.do("line plug")
    computer.append(adapter(board.url, "A500001"))
    window.wait(lambda: device.link is ConnectionState.CONNECTED)
    window.wait_for_text("bannerText", f"Reconnected to {board.url}. No motor was started.")


CRC = 0x25  # 19200 baud with CRC-7


def test_noisy_line_is_reported_and_crc_is_set_up(
    window: WindowDriver, quick_simulator: SimulatedDevice
) -> None:
    device = window.device
    window.program.complete()  # the sizes of all pages matter
    window.connect(quick_simulator.url)
    assert window.text("qualityLabel") == ""

    def top_of_page() -> int:
        return window.window.pages.mapTo(window.window, QPoint()).y()

    window.window.resize(window.window.minimumSizeHint())
    window.wait_for_files()
    top = top_of_page()
    window.wait(lambda: window.text("qualityLabel") == "Line: good", 10_000)
    assert not window.has("setUpCrcButton")

    quick_simulator.do("line noise 0.01")
    window.wait(lambda: "use CRC" in window.text("qualityLabel"), 20_000)
    assert "% lost: noisy; shorten cable, check ground" in window.text("qualityLabel")
    window.wait(lambda: window.has("setUpCrcButton"))
    assert top_of_page() == top, "nothing moves under the pointer"
    window.motors.arm()
    window.wait(lambda: not window.has("setUpCrcButton"))
    assert window.text("qualityLabel")
    window.motors.stop()
    quick_simulator.do("line noise 0")

    window.click("setUpCrcButton")
    review = window.dialog("reviewDialog")
    assert review.root.isVisible()
    assert [device.draft.pending, device.parameters.values.value_of("uart_settings")] == [1, CRC]
    assert "Other programs on this line must also use" in window.text("bannerText")
    review.click("writeButton")
    window.wait(lambda: device.parameters.values.stored.get("uart_settings") == CRC)
    review.root.close()
    window.click("setUpCrcButton")
    assert window.find(QDialog, "powerCycleDialog").isVisible(), "only the power cycle is left"
    quick_simulator.do("power off")
    window.wait(lambda: device.link is ConnectionState.NOT_RESPONDING)
    assert window.text("qualityLabel") == ""
    quick_simulator.do("power on")
    window.wait(lambda: device.link is ConnectionState.CONNECTED)
    assert device.settings is not None
    assert device.settings.line.to_wire() == CRC
    assert device.parameters.values.waiting_for_power == ()

    quick_simulator.do("line noise 0.01")
    window.wait(lambda: "lost: noisy" in window.text("qualityLabel"), 20_000)
    assert "CRC" not in window.text("qualityLabel")
    assert not window.has("setUpCrcButton")
    log = [entry.text for entry in window.program.workspace("trex").log.entries]
    assert sum(text.startswith("The line is noisy: ") for text in log) == 2
