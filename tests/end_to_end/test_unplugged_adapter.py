"""An adapter that is pulled while its board is in use, and plugged in again."""

import argparse

import pytest
from serial.tools.list_ports_common import ListPortInfo

from tests.support.simulator import SimulatedDevice
from tests.support.virtual_time import VirtualRuntime
from tests.support.window import WindowDriver
from trex_gui.app import connect
from trex_gui.devices.trex.protocol.parameters import ParameterKey
from trex_gui.ui.devices.auto_connect import set_automatic
from trex_gui.ui.devices.connection import ConnectionState


def adapter(url: str, number: str) -> ListPortInfo:
    info = ListPortInfo(url, skip_link_detection=True)
    info.vid, info.pid, info.serial_number, info.location = 0x0403, 0x6001, number, "1-2"
    return info


def test_window_reconnects_to_the_same_adapter_only(
    window: WindowDriver,
    quick_simulator: SimulatedDevice,
    virtual_time: VirtualRuntime,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    board, device, ports = quick_simulator, window.device, window.program.ports
    listed: list[ListPortInfo] = [adapter(board.url, "A500001")]
    monkeypatch.setattr("trex_gui.ui.devices.ports.list_ports.comports", lambda: list(listed))
    ports.refresh()
    window.program.connect_automatically()
    window.connect(board.url)
    logged: list[str] = []
    device.notifier.logged.connect(lambda text, _: logged.append(text))

    # Under another name, with a motor running and an edit:
    device.parameters.edit(ParameterKey.SERIAL_TIMEOUT, 9)
    window.wait(lambda: window.motors.is_available)
    window.motors.arm()
    window.motors.set_speed(1, 60)
    window.wait(lambda: board.show()["motors"][0]["direction"] == "forward")
    listed.clear()
    said: list[str] = []
    window.device.notifier.info.connect(said.append)
    board.do("line unplug")
    window.wait_for_text("bannerText", f"The line to {board.url} is gone.")
    assert window.has("bannerReconnect")
    board.do("line plug")
    listed[:] = [adapter(board.url, "B700002")]
    virtual_time.advance(5.0)
    assert device.link is ConnectionState.DISCONNECTED, "another adapter has its name"
    assert window.has("bannerText")
    virtual_time.ports["/dev/ttyUSB1"] = virtual_time.ports[board.url]
    listed.append(adapter("/dev/ttyUSB1", "A500001"))
    window.wait(lambda: device.link is ConnectionState.CONNECTED)
    window.wait(lambda: any(text.startswith("1 earlier change still pending.") for text in said))
    assert not window.motors.armed
    assert window.motors.board.endswith("-0403:6001-A500001"), "its speed ceiling is found again"
    assert board.show()["motors"][0]["direction"] == "brake"
    assert device.parameters.values.pending == ((ParameterKey.SERIAL_TIMEOUT, 9),)
    assert ports.preferred == ports.find("/dev/ttyUSB1")
    window.wait(lambda: any(f"adapter of {board.url} is /dev/ttyUSB1 now" in m for m in logged))
    device.parameters.discard_edits()

    # So quickly that the list of ports does not change:
    board.do("line unplug")
    window.wait(lambda: device.link is ConnectionState.DISCONNECTED)
    board.do("line plug")
    window.wait(lambda: device.link is ConnectionState.CONNECTED)
    window.wait(lambda: "Connected again to /dev/ttyUSB1. No motor was started." in logged)

    # It is listed, and does not work: one attempt, and the next when it was away.
    board.do("line unplug")
    window.wait_for_text("bannerText", "There is no port /dev/ttyUSB1.")
    listed.clear()
    virtual_time.advance(5.0)
    set_automatic(False)
    board.do("line plug")
    listed.append(adapter("/dev/ttyUSB1", "A500001"))
    window.wait(lambda: not window.has("bannerText"))
    assert device.link is ConnectionState.DISCONNECTED, "only the message is over"


def test_adapter_that_was_named_at_the_start_is_found_again(
    window: WindowDriver, quick_simulator: SimulatedDevice, monkeypatch: pytest.MonkeyPatch
) -> None:
    board, device = quick_simulator, window.device
    listed = [adapter(board.url, "A500001")]
    monkeypatch.setattr("trex_gui.ui.devices.ports.list_ports.comports", lambda: list(listed))
    window.program.ports.refresh()
    connect(window.program, argparse.Namespace(demo=False, port=board.url, device=None))
    window.wait(lambda: device.link is ConnectionState.CONNECTED)
    listed.clear()
    board.do("line unplug")
    window.wait_for_text("bannerText", f"The line to {board.url} is gone.")
    board.do("line plug")
    listed.append(adapter(board.url, "A500001"))
    window.wait(lambda: device.link is ConnectionState.CONNECTED)
    window.wait_for_text("bannerText", f"Connected again to {board.url}. No motor was started.")
