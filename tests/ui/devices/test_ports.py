"""List of ports."""

from collections.abc import Callable, Iterator
from pathlib import Path

import pytest
from pytestqt.qtbot import QtBot
from serial.tools.list_ports_common import ListPortInfo

from tests.support.program import new_plugin
from trex_gui.core.plugin import DevicePlugin
from trex_gui.devices.trex.plugin import TREX
from trex_gui.ui.devices.ports import Port, PortKind, Ports


def port(device: str, description: str = "n/a") -> ListPortInfo:
    info = ListPortInfo(device, skip_link_detection=True)
    info.description = description
    return info


CreatePorts = Callable[..., Ports]


@pytest.fixture
def create_ports(qtbot: QtBot, computer: list[ListPortInfo]) -> Iterator[CreatePorts]:
    created: list[Ports] = []

    def new(*plugins: DevicePlugin) -> Ports:
        created.append(Ports(plugins or (TREX,)))
        return created[-1]

    yield new
    for ports in created:
        ports.deleteLater()


def urls(ports: Ports) -> list[str]:
    return [entry.url for entry in ports.entries]


def test_serial_ports_come_first_and_demo_board_last(
    create_ports: CreatePorts, computer: list[ListPortInfo]
) -> None:
    computer += [port("/dev/ttyUSB10"), port("/dev/ttyUSB2", "FT232R")]
    ports = create_ports()
    ports.add_typed("socket://robot:5000")
    assert [(entry.kind, entry.label) for entry in ports.entries] == [
        (PortKind.SERIAL, "/dev/ttyUSB2  (FT232R)"),
        (PortKind.SERIAL, "/dev/ttyUSB10"),
        (PortKind.TYPED, "socket://robot:5000"),
        (PortKind.DEMO, "Demo TReX (no hardware)"),
    ]


def test_plugged_in_port_appears_automatically(
    create_ports: CreatePorts, computer: list[ListPortInfo], qtbot: QtBot
) -> None:
    ports = create_ports()
    with qtbot.waitSignal(ports.changed):
        computer.append(port("/dev/ttyUSB0"))
    assert urls(ports) == ["/dev/ttyUSB0", ""]
    with qtbot.assertNotEmitted(ports.changed):
        ports.refresh()


def test_typed_address_is_saved_once(create_ports: CreatePorts) -> None:
    ports = create_ports()
    typed = ports.add_typed("  /dev/pts/7 ")
    assert typed == Port(PortKind.TYPED, "/dev/pts/7", "/dev/pts/7", "trex")
    assert ports.add_typed("/dev/pts/7") == ports.find("/dev/pts/7") == typed
    assert ports.find("/dev/pts/8") is None
    ports.add_typed("  ")
    assert urls(create_ports()) == ["/dev/pts/7", ""]


def test_typed_serial_port_selects_the_listed_port(
    create_ports: CreatePorts, computer: list[ListPortInfo]
) -> None:
    computer.append(port("/dev/ttyUSB0"))
    ports = create_ports()
    assert ports.add_typed("/dev/ttyUSB0").kind is PortKind.SERIAL
    assert urls(create_ports()) == ["/dev/ttyUSB0", ""]


def test_typed_link_selects_the_listed_port_of_its_target(
    create_ports: CreatePorts, computer: list[ListPortInfo], tmp_path: Path
) -> None:
    device, terminal = tmp_path / "ttyUSB0", tmp_path / "pts7"
    for path in (device, terminal):
        path.touch()
    by_id, link = tmp_path / "usb-FTDI_FT232R_A500001", tmp_path / "trex"
    by_id.symlink_to("ttyUSB0")
    link.symlink_to("pts7")
    computer.append(port(str(device)))
    ports = create_ports()
    assert ports.add_typed(str(by_id)) == ports.find(str(device))
    assert ports.add_typed(str(link)).kind is PortKind.TYPED, "the target of the link is not listed"
    assert len(ports.entries) == 3


def test_typed_address_of_a_new_serial_port_is_listed_once(
    create_ports: CreatePorts, computer: list[ListPortInfo]
) -> None:
    ports = create_ports()
    ports.add_typed("/dev/ttyUSB0")
    computer.append(port("/dev/ttyUSB0"))
    ports.refresh()
    assert [(entry.kind, entry.url) for entry in ports.entries] == [
        (PortKind.SERIAL, "/dev/ttyUSB0"),
        (PortKind.DEMO, ""),
    ]


def test_only_the_last_eight_typed_addresses_are_saved(create_ports: CreatePorts) -> None:
    ports = create_ports()
    for number in range(12):
        ports.add_typed(f"/dev/pts/{number}")
    assert urls(create_ports()) == [*(f"/dev/pts/{number}" for number in range(4, 12)), ""]


def test_single_usb_adapter_is_first_and_preferred(
    create_ports: CreatePorts, computer: list[ListPortInfo]
) -> None:
    """Many computers have built-in serial ports without a connector."""
    adapter = port("/dev/ttyUSB0")
    adapter.vid, adapter.pid = 0x10C4, 0xEA60
    computer += [port("/dev/ttyS0"), port("/dev/ttyS1"), adapter]
    ports = create_ports()
    assert urls(ports) == ["/dev/ttyUSB0", "/dev/ttyS0", "/dev/ttyS1", ""]
    assert ports.preferred == ports.find("/dev/ttyUSB0")


def test_adapters_with_the_same_serial_number_are_identified_by_socket(
    create_ports: CreatePorts, computer: list[ListPortInfo]
) -> None:
    first, second = port("/dev/ttyUSB0"), port("/dev/ttyUSB1")
    for adapter, socket in ((first, "1-1"), (second, "1-2")):
        adapter.vid, adapter.pid, adapter.serial_number = 0x0403, 0x6001, "A50285BI"
        adapter.location = socket
    computer += [first, second]
    ports = create_ports()
    used = ports.entries[1]
    first.device, second.device = second.device, first.device
    ports.refresh()
    assert ports.current_entry(used) == ports.find("/dev/ttyUSB0"), "the names were exchanged"
    second.location = "1-3"
    ports.refresh()
    assert ports.current_entry(used) is None, "either adapter may be the used one"
    computer.remove(first)
    ports.refresh()
    assert ports.current_entry(used) == ports.find("/dev/ttyUSB0"), "only one adapter is left"


def test_single_or_last_used_port_is_preferred(
    create_ports: CreatePorts, computer: list[ListPortInfo]
) -> None:
    def preferred() -> str | None:
        entry = create_ports().preferred
        return None if entry is None else entry.url

    assert preferred() is None
    computer.append(port("/dev/ttyUSB0"))
    assert preferred() == "/dev/ttyUSB0"
    computer.append(port("/dev/ttyUSB1"))
    assert preferred() is None
    ports = create_ports()
    ports.assign(ports.entries[1], "trex", "settings")
    assert preferred() == "/dev/ttyUSB1"
    computer.pop()
    assert preferred() == "/dev/ttyUSB0"


# --- Device kinds -------------------------------------------------------------------------

WALKER = new_plugin("walker", "Walker")


def test_each_device_kind_has_a_demo_port_of_fixed_kind(create_ports: CreatePorts) -> None:
    ports = create_ports(TREX, WALKER)
    labels = [port.label for port in ports.entries if port.kind is PortKind.DEMO]
    assert labels == ["Demo TReX (no hardware)", "Demo Walker (no hardware)"]
    assert ports.demo_of("trex").device == "trex"
    assert ports.demo_of("walker").label == "Demo Walker (no hardware)"
    assert ports.assign(ports.demo_of("trex"), "walker") == ports.demo_of("trex")


def test_device_kind_of_a_port_is_saved_and_shown(create_ports: CreatePorts) -> None:
    ports = create_ports(TREX, WALKER)
    port = ports.assign(ports.add_typed("socket://robot:1"), "walker")
    assert (port.device, port.label) == ("walker", "Walker: socket://robot:1")
    assert create_ports(TREX, WALKER).find("socket://robot:1") == port
    found = create_ports().find("socket://robot:1")
    assert found is not None
    assert (found.device, found.label) == ("trex", "socket://robot:1"), "without the kind walker"
    changed = ports.assign(port, "trex")
    assert (changed.device, changed.label) == ("trex", "socket://robot:1")
    found = create_ports(TREX, WALKER).find("socket://robot:1")
    assert found is not None
    assert found.device == "trex"
