"""Connecting by itself: only where and when the user can expect it."""

import pytest
from serial.tools.list_ports_common import ListPortInfo

from tests.support.simulator import SimulatedDevice
from tests.support.window import WindowDriver
from trex_gui.ui.devices import auto_connect
from trex_gui.ui.devices.auto_connect import set_automatic
from trex_gui.ui.devices.connection import ConnectionState


@pytest.fixture
def computer(monkeypatch: pytest.MonkeyPatch) -> list[ListPortInfo]:
    """The serial ports that this computer is taken to have."""
    present: list[ListPortInfo] = []
    monkeypatch.setattr("trex_gui.ui.devices.ports.list_ports.comports", lambda: list(present))
    return present


def adapter(url: str, number: str = "0001") -> ListPortInfo:
    info = ListPortInfo(url, skip_link_detection=True)
    info.vid, info.pid, info.serial_number = 0x10C4, 0xEA60, number
    return info


@pytest.fixture
def used(
    window: WindowDriver, computer: list[ListPortInfo], quick_simulator: SimulatedDevice
) -> WindowDriver:
    """A window that was connected to its only port, and is not now."""
    computer.append(adapter(quick_simulator.url))
    window.program.ports.refresh()
    window.connect(quick_simulator.url)
    window.disconnect()
    return window


def plug(window: WindowDriver, computer: list[ListPortInfo], *ports: ListPortInfo) -> None:
    computer[:] = ports
    window.program.ports.refresh()
    window.wait_for_files()


def test_last_port_is_connected_at_the_start_and_when_it_appears(
    used: WindowDriver, computer: list[ListPortInfo]
) -> None:
    device, here = used.device, list(computer)
    used.program.connect_automatically()
    used.wait_for_files()
    assert device.link is ConnectionState.DISCONNECTED, "it is off by default"

    set_automatic(True)
    plug(used, computer)
    plug(used, computer, *here)
    used.wait(lambda: device.link is ConnectionState.CONNECTED)

    used.disconnect()
    plug(used, computer, adapter("/dev/ttyUSB99"), *here)
    assert device.link is ConnectionState.DISCONNECTED, "the user has disconnected it"


def test_start_connects(used: WindowDriver) -> None:
    set_automatic(True)
    used.program.connect_automatically()
    used.wait(lambda: used.device.link is ConnectionState.CONNECTED)


def test_other_adapters_and_ports_in_use_are_left_alone(
    used: WindowDriver, computer: list[ListPortInfo], monkeypatch: pytest.MonkeyPatch
) -> None:
    set_automatic(True)
    url, here = computer[0].device, list(computer)
    plug(used, computer)
    used.program.connect_automatically()
    plug(used, computer, adapter(url, "0002"))
    plug(used, computer)
    plug(used, computer, adapter("/dev/ttyUSB99"))
    monkeypatch.setattr(auto_connect, "holder_of", lambda _: "minicom (process 7)")
    plug(used, computer, *here)
    assert used.device.link is ConnectionState.DISCONNECTED


def test_typed_address_is_connected_when_its_adapter_appears(
    used: WindowDriver, computer: list[ListPortInfo]
) -> None:
    """A typed address is in the list all the time."""
    set_automatic(True)
    here = list(computer)
    plug(used, computer)
    used.program.ports.add_typed(here[0].device)
    used.program.connect_automatically()
    used.wait_for_files()
    assert used.device.link is ConnectionState.DISCONNECTED
    plug(used, computer, *here)
    used.wait(lambda: used.device.link is ConnectionState.CONNECTED)
