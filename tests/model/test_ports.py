"""The list of ports."""

from collections.abc import Callable, Iterator

import pytest
from PySide6.QtCore import QTimer
from pytestqt.qtbot import QtBot
from serial.tools.list_ports_common import ListPortInfo

from trex_gui.model.kinds import TREX, Kind
from trex_gui.model.ports import Port, PortKind, Ports


@pytest.fixture
def computer(monkeypatch: pytest.MonkeyPatch) -> list[ListPortInfo]:
    """The serial ports that this computer is taken to have."""
    present: list[ListPortInfo] = []
    monkeypatch.setattr("trex_gui.model.ports.list_ports.comports", lambda: list(present))
    return present


def port(device: str, description: str = "n/a") -> ListPortInfo:
    info = ListPortInfo(device, skip_link_detection=True)
    info.description = description
    return info


Make = Callable[..., Ports]


@pytest.fixture
def make(qtbot: QtBot, computer: list[ListPortInfo]) -> Iterator[Make]:
    made: list[Ports] = []

    def new(*kinds: Kind) -> Ports:
        made.append(Ports(kinds=kinds or (TREX,)))
        return made[-1]

    yield new
    for ports in made:
        ports.deleteLater()


def urls(ports: Ports) -> list[str]:
    return [entry.url for entry in ports.entries]


def test_without_any_port_there_is_the_simulated_board(make: Make) -> None:
    ports = make()
    assert [entry.kind for entry in ports.entries] == [PortKind.DEMO]
    assert ports.demo.kind is PortKind.DEMO
    assert ports.preferred is None


def test_serial_ports_come_first_and_the_simulated_board_last(
    make: Make, computer: list[ListPortInfo]
) -> None:
    computer += [port("/dev/ttyUSB10"), port("/dev/ttyUSB2", "FT232R")]
    ports = make()
    ports.add_typed("socket://robot:5000")
    assert urls(ports) == ["/dev/ttyUSB2", "/dev/ttyUSB10", "socket://robot:5000", ""]
    assert [entry.kind for entry in ports.entries] == [
        PortKind.SERIAL,
        PortKind.SERIAL,
        PortKind.TYPED,
        PortKind.DEMO,
    ]


def test_a_port_is_labelled_with_what_the_system_says_of_it(
    make: Make, computer: list[ListPortInfo]
) -> None:
    computer += [port("/dev/ttyS0"), port("/dev/ttyUSB0", "FT232R USB UART")]
    assert [entry.label for entry in make().entries[:2]] == [
        "/dev/ttyS0",
        "/dev/ttyUSB0  (FT232R USB UART)",
    ]


def test_a_port_that_is_plugged_in_appears_by_itself(
    make: Make, computer: list[ListPortInfo], qtbot: QtBot
) -> None:
    ports = make()
    timer = ports.findChild(QTimer)
    assert isinstance(timer, QTimer)
    timer.setInterval(10)  # nobody waits that long
    with qtbot.waitSignal(ports.changed):
        computer.append(port("/dev/ttyUSB0"))
    assert urls(ports) == ["/dev/ttyUSB0", ""]


def test_a_list_that_stays_the_same_is_not_announced(make: Make, qtbot: QtBot) -> None:
    ports = make()
    with qtbot.assertNotEmitted(ports.changed):
        ports.refresh()


def test_a_typed_address_is_remembered(make: Make) -> None:
    typed = make().add_typed("  /dev/pts/7 ")
    assert typed == Port(PortKind.TYPED, "/dev/pts/7", "/dev/pts/7")
    assert urls(make()) == ["/dev/pts/7", ""]


def test_typing_an_address_twice_does_not_list_it_twice(make: Make) -> None:
    ports = make()
    assert ports.add_typed("/dev/pts/7") == ports.add_typed("/dev/pts/7")
    assert urls(ports) == ["/dev/pts/7", ""]


def test_typing_a_serial_port_finds_it(make: Make, computer: list[ListPortInfo]) -> None:
    computer.append(port("/dev/ttyUSB0"))
    ports = make()
    assert ports.add_typed("/dev/ttyUSB0").kind is PortKind.SERIAL
    assert urls(make()) == ["/dev/ttyUSB0", ""]


def test_a_typed_address_that_becomes_a_serial_port_is_listed_once(
    make: Make, computer: list[ListPortInfo]
) -> None:
    ports = make()
    ports.add_typed("/dev/ttyUSB0")
    computer.append(port("/dev/ttyUSB0"))
    ports.refresh()
    assert [(entry.kind, entry.url) for entry in ports.entries] == [
        (PortKind.SERIAL, "/dev/ttyUSB0"),
        (PortKind.DEMO, ""),
    ]


def test_only_the_last_few_typed_addresses_are_remembered(make: Make) -> None:
    ports = make()
    for number in range(12):
        ports.add_typed(f"/dev/pts/{number}")
    assert urls(make()) == [*(f"/dev/pts/{number}" for number in range(4, 12)), ""]


def test_nothing_typed_is_nothing_remembered(make: Make) -> None:
    ports = make()
    ports.add_typed("  ")
    assert urls(make()) == [""]


def test_an_address_is_found_by_its_url(make: Make) -> None:
    ports = make()
    typed = ports.add_typed("/dev/pts/7")
    assert ports.find("/dev/pts/7") == typed
    assert ports.find("/dev/pts/8") is None
    assert ports.find("") is None


def test_the_only_serial_port_is_offered(make: Make, computer: list[ListPortInfo]) -> None:
    computer.append(port("/dev/ttyUSB0"))
    preferred = make().preferred
    assert preferred is not None
    assert preferred.url == "/dev/ttyUSB0"


def test_among_several_serial_ports_none_is_guessed(
    make: Make, computer: list[ListPortInfo]
) -> None:
    computer += [port("/dev/ttyUSB0"), port("/dev/ttyUSB1")]
    assert make().preferred is None


def test_the_port_that_was_used_last_is_offered(make: Make, computer: list[ListPortInfo]) -> None:
    computer += [port("/dev/ttyUSB0"), port("/dev/ttyUSB1")]
    ports = make()
    ports.note_used(ports.entries[1])
    preferred = make().preferred
    assert preferred is not None
    assert preferred.url == "/dev/ttyUSB1"


def test_the_port_that_was_used_last_is_not_offered_when_it_is_gone(
    make: Make, computer: list[ListPortInfo]
) -> None:
    computer += [port("/dev/ttyUSB0"), port("/dev/ttyUSB1")]
    ports = make()
    ports.note_used(ports.entries[1])
    computer.pop()
    preferred = make().preferred
    assert preferred is not None
    assert preferred.url == "/dev/ttyUSB0"


# --- Kinds of devices -------------------------------------------------------------------

WALKER = Kind("walker", "Walker")


def test_each_kind_of_device_has_a_simulated_one(make: Make) -> None:
    ports = make(TREX, WALKER)
    labels = [port.label for port in ports.entries if port.kind is PortKind.DEMO]
    assert labels == ["Demo TReX (no hardware)", "Demo Walker (no hardware)"]
    assert ports.demo.device == "trex"
    assert ports.demo_of("walker").label == "Demo Walker (no hardware)"


def test_what_a_port_leads_to_is_remembered_and_shown(make: Make) -> None:
    ports = make(TREX, WALKER)
    port = ports.lead_to(ports.add_typed("socket://robot:1"), "walker")
    assert (port.device, port.label) == ("walker", "Walker: socket://robot:1")
    assert make(TREX, WALKER).find("socket://robot:1") == port
    again = ports.lead_to(port, "trex")
    assert (again.device, again.label) == ("trex", "socket://robot:1")
    found = make(TREX, WALKER).find("socket://robot:1")
    assert found is not None
    assert found.device == "trex"


def test_a_kind_that_is_not_known_any_more_is_a_trex(make: Make) -> None:
    ports = make(TREX, WALKER)
    ports.lead_to(ports.add_typed("socket://robot:1"), "walker")
    found = make().find("socket://robot:1")
    assert found is not None
    assert (found.device, found.label) == ("trex", "socket://robot:1")


def test_a_simulated_device_leads_to_nothing_else(make: Make) -> None:
    ports = make(TREX, WALKER)
    assert ports.lead_to(ports.demo, "walker") == ports.demo
