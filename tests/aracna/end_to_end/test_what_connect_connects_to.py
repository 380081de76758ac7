"""What the list of ports shows is what Connect connects to, whichever device it leads to."""

import sys

import pytest
from PySide6.QtWidgets import QComboBox, QWidget
from pytestqt.qtbot import QtBot
from serial.tools.list_ports_common import ListPortInfo

from tests.aracna.end_to_end.person import DEMO_ARACNA, DEMO_TREX, Person
from tests.support.simulator import SimulatedDevice, StartSimulator
from trex_gui.model.connection import Link
from trex_gui.model.device import Link as BoardLink
from trex_gui.model.ports import Ports
from trex_gui.window import Program

pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="needs pseudo-terminals")


@pytest.fixture
def computer(monkeypatch: pytest.MonkeyPatch) -> list[ListPortInfo]:
    """Serial ports of this computer; a test plugs adapters in."""
    ports: list[ListPortInfo] = []
    monkeypatch.setattr("serial.tools.list_ports.comports", lambda: ports)
    return ports


class Sitting(Person):
    """A person who connects and disconnects."""

    @property
    def shown(self) -> str:
        return self.find(QComboBox, "portCombo").currentText()

    def is_idle(self) -> bool:
        return self.program.switchboard.is_idle

    def connect_to_trex_demo(self) -> None:
        self.choose_port(DEMO_TREX)
        self.wait(lambda: self.program.device.link is BoardLink.UP)

    def press_connect(self) -> None:
        self.click("connectButton")

    def disconnect(self) -> None:
        self.click("connectButton")
        self.wait(self.is_idle)


@pytest.fixture
def person(computer: list[ListPortInfo], program: Program, qtbot: QtBot) -> Sitting:
    return Sitting(program, qtbot)


@pytest.fixture
def robot(start_simulator: StartSimulator) -> SimulatedDevice:
    return start_simulator("--aracna", "--unpaced")


def test_after_the_demo_of_the_robot_connect_goes_there_again(
    person: Sitting, computer: list[ListPortInfo]
) -> None:
    computer.append(ListPortInfo("/dev/ttyNothing9"))  # the only port: what is offered first
    person.program.ports.refresh()
    assert person.shown == "/dev/ttyNothing9"
    person.connect_to_demo()
    person.disconnect()
    assert person.shown == DEMO_ARACNA
    person.press_connect()
    person.wait(lambda: person.robot.link is Link.UP)
    person.disconnect()


def test_after_the_demo_of_the_board_connect_goes_there_again(
    person: Sitting, computer: list[ListPortInfo]
) -> None:
    computer.append(ListPortInfo("/dev/ttyNothing9"))
    person.program.ports.refresh()
    person.connect_to_trex_demo()
    person.disconnect()
    assert person.shown == DEMO_TREX
    person.press_connect()
    person.wait(lambda: person.program.device.link is BoardLink.UP)
    person.disconnect()


def test_from_one_demo_to_the_other_the_list_shows_the_newer(person: Sitting) -> None:
    person.connect_to_trex_demo()
    person.connect_to_demo()
    assert person.shown == DEMO_ARACNA
    person.disconnect()
    assert person.shown == DEMO_ARACNA
    person.connect_to_trex_demo()
    person.disconnect()
    assert person.shown == DEMO_TREX
    person.action("connect").trigger()
    person.wait(lambda: person.program.device.link is BoardLink.UP)
    assert person.robot.link is Link.NONE
    person.disconnect()


def test_at_the_start_the_port_used_last_is_shown_and_connected_to(
    person: Sitting, robot: SimulatedDevice
) -> None:
    ports = person.program.ports
    port = ports.lead_to(ports.add_typed(robot.url), "aracna")
    ports.note_used(port)
    ports.note_used(ports.demo)  # no port that a person would want next time
    preferred = Ports(kinds=ports.kinds).preferred
    assert preferred == port
    ports.changed.emit()
    assert person.shown == f"Aracna: {robot.url}"
    person.press_connect()
    person.wait(lambda: person.robot.link is Link.UP)
    assert person.find(QWidget, "aracnaTabs").isVisible()
    person.disconnect()


@pytest.mark.qt_log_ignore("This plugin does not support")  # offscreen opens no list
def test_who_chooses_no_port_is_offered_the_list_and_connected_to_nothing(
    person: Sitting, quick_simulator: SimulatedDevice
) -> None:
    ports = person.program.ports
    person.choose_port(ports.add_typed(quick_simulator.url).label)
    person.wait(lambda: person.program.device.link is BoardLink.UP)
    person.choose_port("Not connected")
    person.wait(person.is_idle)
    assert person.shown == "Not connected"
    combo = person.find(QComboBox, "portCombo")
    person.press_connect()
    person.wait(lambda: combo.view().isVisible())
    assert person.is_idle()
    combo.hidePopup()
    person.choose_port(quick_simulator.url)
    person.wait(lambda: person.program.device.link is BoardLink.UP)
    person.disconnect()
    assert person.shown == quick_simulator.url


def test_where_the_simulator_does_not_start_the_robot_that_was_left_for_it_is_left(
    person: Sitting, robot: SimulatedDevice, monkeypatch: pytest.MonkeyPatch
) -> None:
    person.program.connect_to_port(robot.url, "aracna")
    person.wait(lambda: person.robot.link is Link.UP)
    monkeypatch.setattr("trex_gui.model.simulator.simulator_command", lambda: ("/nothing/here", []))
    person.choose_port(DEMO_ARACNA)
    person.wait(lambda: "does not start" in person.text("bannerText"))
    person.wait(person.is_idle)
    assert person.robot.link is Link.NONE
    assert not person.robot.move((512,) * 8)


def test_a_port_that_does_not_answer_stays_in_the_list(
    person: Sitting, computer: list[ListPortInfo]
) -> None:
    computer += [ListPortInfo("/dev/ttyNothing8"), ListPortInfo("/dev/ttyNothing9")]
    person.program.ports.refresh()
    assert person.shown == "Not connected"
    person.choose_port("/dev/ttyNothing9")
    person.wait(person.is_idle)
    assert person.shown == "/dev/ttyNothing9"
    assert "There is no port /dev/ttyNothing9" in person.text("bannerText")


def test_a_port_that_was_pulled_is_shown_again_when_it_is_back(
    person: Sitting, computer: list[ListPortInfo]
) -> None:
    here, gone = ListPortInfo("/dev/ttyNothing8"), ListPortInfo("/dev/ttyNothing9")
    computer += [here, gone]
    person.program.ports.refresh()
    person.choose_port("/dev/ttyNothing9")
    person.wait(person.is_idle)
    computer.remove(gone)
    person.program.ports.refresh()
    assert person.shown == "Not connected", "nobody has chosen the other one"
    computer.append(gone)
    person.program.ports.refresh()
    assert person.shown == "/dev/ttyNothing9"
