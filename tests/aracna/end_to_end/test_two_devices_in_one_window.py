"""One window, a TReX and an Aracna: who chooses another port sees another desk."""

import sys

import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QComboBox, QWidget
from pytestqt.qtbot import QtBot

from tests.aracna.end_to_end.person import DEMO_ARACNA, DEMO_TREX, Person
from tests.support.simulator import StartSimulator
from trex_gui.model.connection import Link
from trex_gui.model.device import Link as BoardLink
from trex_gui.window import Program

pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="needs pseudo-terminals")

TREX_MENUS = ["File", "Edit", "Device", "Window", "Help"]
ARACNA_MENUS = ["File", "Device", "Aracna", "Poses", "Window", "Help"]


@pytest.fixture
def person(program: Program, qtbot: QtBot) -> Person:
    return Person(program, qtbot)


def connect_to_trex(person: Person) -> None:
    person.choose_port(DEMO_TREX)
    person.wait(lambda: person.program.device.link is BoardLink.UP)


def test_the_demo_of_each_device_is_offered(person: Person) -> None:
    combo = person.find(QComboBox, "portCombo")
    texts = [combo.itemText(index) for index in range(combo.count())]
    assert DEMO_TREX in texts
    assert DEMO_ARACNA in texts


def test_the_desk_and_its_menus_change_with_the_port_and_back(person: Person) -> None:
    tabs = person.find(QWidget, "tabs")
    robot_tabs = person.find(QWidget, "aracnaTabs")
    connect_to_trex(person)
    assert tabs.isVisible()
    assert not robot_tabs.isVisible()
    assert person.menus == TREX_MENUS
    assert person.find(QWidget, "demoPanel").isVisible()

    person.connect_to_demo()
    assert person.program.device.link is BoardLink.NONE, "one device at a time"
    assert robot_tabs.isVisible()
    assert not tabs.isVisible()
    assert person.menus == ARACNA_MENUS
    assert not person.find(QWidget, "demoPanel").isVisible()
    assert person.text("statusLabel") == "Connected to Aracna: firmware 1, 8 motors."
    assert not person.find(QWidget, "lineButton").isEnabled()

    connect_to_trex(person)
    assert person.robot.link is Link.NONE
    assert tabs.isVisible()
    assert not robot_tabs.isVisible()
    assert person.menus == TREX_MENUS
    assert person.find(QWidget, "demoPanel").isVisible()


def test_a_shortcut_that_both_have_goes_to_the_desk_that_is_shown(
    person: Person, qtbot: QtBot
) -> None:
    window = person.program.window
    qtbot.waitActive(window)
    connect_to_trex(person)
    QTest.keyClick(window, Qt.Key.Key_2, Qt.KeyboardModifier.ControlModifier)
    assert person.program.desk.pages.currentIndex() == 1
    assert person.program.aracna.pages.currentIndex() == 0

    person.connect_to_demo()
    QTest.keyClick(window, Qt.Key.Key_3, Qt.KeyboardModifier.ControlModifier)
    assert person.program.aracna.pages.currentIndex() == 2
    assert person.program.desk.pages.currentIndex() == 1
    QTest.keyClick(window, Qt.Key.Key_1, Qt.KeyboardModifier.ControlModifier)
    assert person.program.aracna.pages.currentIndex() == 0


def test_escape_reaches_the_robot_from_any_of_its_pages(person: Person) -> None:
    person.connect_to_demo()
    halts: list[bool] = []
    person.robot.halted.connect(lambda: halts.append(True))
    for page in range(person.program.aracna.pages.count()):
        person.program.aracna.pages.setCurrentIndex(page)
        QTest.keyClick(person.program.window, Qt.Key.Key_Escape)
    assert len(halts) >= person.program.aracna.pages.count()


def test_disconnect_and_connect_come_back_to_the_robot(person: Person) -> None:
    person.connect_to_demo()
    person.click("connectButton")
    person.wait(lambda: person.robot.link is Link.NONE)
    assert person.find(QWidget, "aracnaTabs").isVisible()
    assert not person.find(QWidget, "aracnaMoveButton").isEnabled()
    assert "No robot is connected" in person.text("aracnaReport")
    person.connect_to_demo()


def test_a_typed_port_leads_to_the_robot_once_it_was_said_so(
    person: Person, start_simulator: StartSimulator
) -> None:
    simulator = start_simulator("--aracna", "--unpaced")
    person.program.connect_to_port(simulator.url, "aracna")
    person.wait(lambda: person.robot.link is Link.UP)
    combo = person.find(QComboBox, "portCombo")
    assert combo.currentText() == f"Aracna: {simulator.url}"
    person.click("connectButton")
    person.wait(lambda: person.robot.link is Link.NONE)
    person.click("connectButton")  # the port that was used last, and what it leads to
    person.wait(lambda: person.robot.link is Link.UP)
    person.click("connectButton")
    person.wait(lambda: person.robot.link is Link.NONE)
    simulator.end()


def test_a_robot_is_found_in_the_search_and_connected_to(
    person: Person, start_simulator: StartSimulator
) -> None:
    simulator = start_simulator("--aracna", "--unpaced")
    port = person.program.ports.add_typed(simulator.url)
    finder = person.program.connector.finder
    person.action("find").trigger()
    finder.start([port])
    person.wait(lambda: not finder.running)
    assert [finding.device for finding in finder.findings] == ["aracna"], finder.findings
    person.click("connectFound0")
    person.wait(lambda: person.robot.link is Link.UP)
    person.find(QWidget, "findDialog").close()
    person.click("connectButton")
    person.wait(lambda: person.robot.link is Link.NONE)
    simulator.end()
