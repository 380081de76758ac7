"""Find, on ports that lead to a robot, to a board, or to nobody."""

import os
import sys
import threading

import pytest
from PySide6.QtWidgets import QLabel, QWidget
from pytestqt.qtbot import QtBot

from tests.aracna.end_to_end.person import Person
from tests.support.simulator import SimulatedDevice, StartSimulator
from trex_gui.link.discovery import attempts
from trex_gui.link.settings import LinkSettings
from trex_gui.model.connection import Link
from trex_gui.runtime import open_transport
from trex_gui.window import Program

pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="needs pseudo-terminals")


@pytest.fixture
def person(program: Program, qtbot: QtBot, monkeypatch: pytest.MonkeyPatch) -> Person:
    few = list(attempts())[:7]  # all of them take half a minute
    monkeypatch.setattr("trex_gui.link.discovery.attempts", lambda *, full: few)
    return Person(program, qtbot)


@pytest.fixture
def robot(start_simulator: StartSimulator) -> SimulatedDevice:
    return start_simulator("--aracna", "--unpaced")


def search(person: Person, url: str) -> list[str]:
    """Search a port to the end; return what was tried, in order."""
    finder = person.program.connector.finder
    texts: list[str] = []
    finder.progressed.connect(lambda: texts.append(finder.text))
    person.action("find").trigger()
    finder.start([person.program.ports.add_typed(url)])
    person.qtbot.waitUntil(lambda: not finder.running, timeout=60_000)
    return [text for text in texts if text.startswith("Looking")]


def kinds(texts: list[str]) -> list[str]:
    """Return the kinds that were looked for, each once in a row."""
    names = [text.split()[2] for text in texts]
    return [name for i, name in enumerate(names) if i == 0 or names[i - 1] != name]


def close(person: Person) -> None:
    person.find(QWidget, "findDialog").close()


def test_a_robot_is_found_between_the_likely_and_the_long_search_for_a_board(
    person: Person, robot: SimulatedDevice
) -> None:
    tried = search(person, robot.url)
    assert kinds(tried) == ["TReX", "Aracna"]
    assert len(tried) <= 10
    assert person.text("findText0").startswith(f"Aracna 1 on {robot.url} at 38400 8N1.")
    close(person)


def test_a_port_that_a_robot_was_found_on_is_asked_for_a_robot_first(
    person: Person, robot: SimulatedDevice
) -> None:
    search(person, robot.url)
    assert kinds(search(person, robot.url)) == ["Aracna"]
    person.click("connectFound0")
    person.wait(lambda: person.robot.link is Link.UP)
    close(person)
    person.click("connectButton")
    person.wait(lambda: person.robot.link is Link.NONE)


def test_a_board_on_a_port_that_led_to_a_robot_is_found_as_well(
    person: Person, quick_simulator: SimulatedDevice
) -> None:
    ports = person.program.ports
    ports.lead_to(ports.add_typed(quick_simulator.url), "aracna")
    assert kinds(search(person, quick_simulator.url)) == ["Aracna", "TReX"]
    assert person.text("findText0").startswith(f"TReX 1.2 on {quick_simulator.url}")
    close(person)


def test_on_a_silent_port_it_is_told_of_each_device_what_was_tried(
    person: Person, robot: SimulatedDevice
) -> None:
    robot.do("power off")
    assert kinds(search(person, robot.url)) == ["TReX", "Aracna", "TReX"]
    trex, aracna = person.text("findText0").split("\n\n")
    assert trex.startswith(f"No TReX answers on {robot.url} at any baud rate")
    assert aracna.startswith(f"No Aracna answers on {robot.url} at 38400 baud")
    label = person.find(QLabel, "findText0")
    person.wait(lambda: label.height() >= label.heightForWidth(label.width()) > 0)
    close(person)


class EchoingPort:
    """A pseudo-terminal whose other end sends back all that it hears, until it is closed."""

    def __init__(self) -> None:
        import tty

        self._far, self._near = os.openpty()
        tty.setraw(self._near)
        self.url = os.ttyname(self._near)
        self._thread = threading.Thread(target=self._echo)
        self._thread.start()

    def _echo(self) -> None:
        while data := os.read(self._far, 64):
            if data == b"end":
                return
            os.write(self._far, data)

    def close(self) -> None:
        os.write(self._near, b"end")
        self._thread.join(15)
        os.close(self._near)
        os.close(self._far)


def test_an_echo_is_told_of_each_device(person: Person) -> None:
    port = EchoingPort()
    search(person, port.url)
    trex, aracna = person.text("findText0").split("\n\n")
    assert trex.startswith(f"No TReX answers on {port.url}: everything sent comes back")
    assert aracna.startswith(f"No Aracna answers on {port.url} at 38400 baud")
    assert "everything sent comes back" in aracna
    close(person)
    port.close()


def test_a_port_in_use_is_told_once(person: Person, robot: SimulatedDevice) -> None:
    other = open_transport(LinkSettings(robot.url))
    assert search(person, robot.url) == []
    other.close()
    text = person.text("findText0")
    assert f"{robot.url} is in use" in text
    assert "\n" not in text
    close(person)


def test_the_simulated_robot_is_called_a_robot_when_it_is_found(person: Person) -> None:
    person.connect_to_demo()
    person.click("connectButton")
    person.wait(lambda: person.robot.link is Link.NONE)
    finder = person.program.connector.finder
    person.action("find").trigger()
    finder.start([person.program.ports.demo_of("aracna")])
    person.wait(lambda: not finder.running)
    assert person.text("findText0") == "Aracna 1 on the simulated robot at 38400 8N1."
    close(person)
