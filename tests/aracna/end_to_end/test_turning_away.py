"""From one device to another: what was begun with the first is given up."""

import sys

import pytest
from PySide6.QtWidgets import QDockWidget
from pytestqt.qtbot import QtBot

from tests.support.simulator import SimulatedDevice, StartSimulator
from trex_gui.link.settings import LinkSettings
from trex_gui.model.device import Link
from trex_gui.window import Program

pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="needs pseudo-terminals")


def test_the_panel_of_the_demo_trex_comes_back_with_it(program: Program, qtbot: QtBot) -> None:
    program.connect_to_demo("trex")
    qtbot.waitUntil(lambda: program.device.link is Link.UP, timeout=20_000)
    panel = program.window.findChild(QDockWidget, "demoPanel")
    assert panel is not None
    assert panel.isVisible()
    program.connect_to_demo("aracna")
    qtbot.waitUntil(lambda: program.robot.link is Link.UP, timeout=20_000)
    assert not panel.isVisible()
    assert not program.connector.demo_in_use
    program.connect_to_demo("trex")
    qtbot.waitUntil(lambda: program.device.link is Link.UP, timeout=20_000)
    assert panel.isVisible()


def test_a_port_that_waits_for_a_search_to_end_is_not_connected_to_behind_another_device(
    program: Program, qtbot: QtBot, quick_simulator: SimulatedDevice
) -> None:
    port = program.ports.add_typed(quick_simulator.url)
    finder = program.connector.finder
    finder.start([port])
    program.switchboard.connect_to(port)
    program.connect_to_demo("aracna")
    qtbot.waitUntil(lambda: program.robot.link is Link.UP, timeout=20_000)
    qtbot.waitUntil(lambda: not finder.running, timeout=20_000)
    assert program.device.link is Link.NONE


def test_disconnecting_forgets_the_line_that_was_to_come_next(
    program: Program, qtbot: QtBot, quick_simulator: SimulatedDevice
) -> None:
    settings = LinkSettings(quick_simulator.url)
    program.device.connect_to(settings)
    qtbot.waitUntil(lambda: program.device.link is Link.UP, timeout=20_000)
    program.device.connect_to(settings)
    program.device.disconnect_line()
    qtbot.waitUntil(lambda: program.device.link is Link.NONE, timeout=20_000)
    assert program.connector.port is None
    qtbot.wait(100)
    assert program.device.link is Link.NONE


def test_disconnecting_forgets_the_robot_that_was_to_come_next(
    program: Program, qtbot: QtBot, start_simulator: StartSimulator
) -> None:
    robot = start_simulator("--aracna", "--unpaced")
    try:
        settings = LinkSettings(robot.url)
        program.robot.connect_to(settings)
        qtbot.waitUntil(lambda: program.robot.link is Link.UP, timeout=20_000)
        program.robot.connect_to(settings)
        program.robot.disconnect_line()
        qtbot.waitUntil(lambda: program.robot.link is Link.NONE, timeout=20_000)
        qtbot.wait(100)
        assert program.robot.link is Link.NONE
    finally:
        program.robot.disconnect_line()
        robot.end()
