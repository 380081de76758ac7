"""The window says what is odd about the settings together, and what would mend it."""

import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QLabel, QPushButton, QWidget
from pytestqt.qtbot import QtBot

from tests.support.simulator import SimulatedDevice
from tests.support.virtual_devices import VirtualSimulator
from trex_gui.link.settings import LinkSettings
from trex_gui.model.device import Link
from trex_gui.protocol.line_settings import LineSettings
from trex_gui.window import Program


@pytest.fixture
def connected(program: Program, qtbot: QtBot, quick_simulator: SimulatedDevice) -> Program:
    program.device.connect_to(LinkSettings(quick_simulator.url))
    qtbot.waitUntil(lambda: program.device.link is Link.UP)
    program.window.pages.setCurrentIndex(5)
    return program


def messages(program: Program) -> list[str]:
    window = program.window
    found = [window.findChild(QLabel, f"advice{index}") for index in range(3)]
    return [label.text() for label in found if label is not None and label.isVisible()]


def shown(program: Program) -> bool:
    advice = program.window.findChild(QWidget, "adviceList")
    assert advice is not None
    return advice.isVisible()


def test_of_a_new_board_there_is_nothing_to_say(connected: Program) -> None:
    assert not shown(connected)


def test_an_odd_pair_is_told_and_accepting_makes_an_edit(connected: Program, qtbot: QtBot) -> None:
    device = connected.device
    device.parameters.edit("ignored_channels", 1)
    assert len(messages(connected)) == 1
    accept = connected.window.findChild(QPushButton, "acceptAdvice0")
    assert accept is not None
    QTest.mouseClick(accept, Qt.MouseButton.LeftButton)
    assert device.parameters.value_of("required_channels") == 0
    qtbot.waitUntil(lambda: not shown(connected))
    assert device.pending == 2
    device.undo.undo()
    assert device.pending == 1
    assert len(messages(connected)) == 1


def test_who_drives_is_told_of_the_serial_timeout(connected: Program, qtbot: QtBot) -> None:
    qtbot.waitUntil(lambda: connected.device.motors.can_arm)
    connected.device.motors.arm()
    qtbot.waitUntil(lambda: shown(connected))
    accept = connected.window.findChild(QPushButton, "acceptAdvice0")
    assert accept is not None
    QTest.mouseClick(accept, Qt.MouseButton.LeftButton)
    assert connected.device.parameters.value_of("serial_timeout") == 5


def test_without_a_board_there_is_nothing_to_say(connected: Program, qtbot: QtBot) -> None:
    connected.device.parameters.edit("ignored_channels", 1)
    assert shown(connected)
    connected.connector.disconnect_port()
    qtbot.waitUntil(lambda: connected.device.link is Link.NONE)
    assert not shown(connected)


def test_a_rate_that_this_computers_port_cannot_do_is_told(
    program: Program,
    qtbot: QtBot,
    quick_simulator: VirtualSimulator,
) -> None:
    quick_simulator.rates = frozenset({9600, 19200})
    program.device.connect_to(LinkSettings(quick_simulator.url))
    qtbot.waitUntil(lambda: program.device.link is Link.UP)
    program.window.pages.setCurrentIndex(5)
    program.device.parameters.edit("uart_settings", LineSettings(76800).to_wire())
    told = "\n".join(messages(program))
    assert "cannot do 76800 baud" in told
    program.device.parameters.edit("uart_settings", LineSettings(9600).to_wire())
    assert "cannot do" not in "\n".join(messages(program))
