"""Main tasks with real threads, a real port and a board in a separate process.

Tests in virtual time cover the details. `tests/fault_matrix` and the soak test cover faults of real
ports.
"""

import sys

import pytest
from PySide6.QtWidgets import QSlider

from tests.support.pages.motors import MotorsPage, is_stopped
from tests.support.pages.parameters import ParametersPage
from tests.support.pages.robot import RobotWindow
from tests.support.pages.settings import ReviewDialog
from tests.support.simulator import SimulatedDevice, StartSimulator
from tests.support.window import WindowDriver

pytestmark = [
    pytest.mark.realtime,
    pytest.mark.skipif(sys.platform == "win32", reason="needs pseudo-terminals"),
]


def test_motors_page_drives_and_stops_a_board(
    window: WindowDriver, simulator: SimulatedDevice
) -> None:
    window.connect(simulator.url)
    page = MotorsPage(window, simulator)
    page.arm()
    page.drag("motor1Slider", 100)
    page.wait_for_targets(("forward", 100), None)
    page.press_escape()
    page.wait(lambda: is_stopped(simulator))
    assert not page.is_armed()
    window.disconnect()


def test_parameters_page_stores_a_value_on_a_board(
    window: WindowDriver, simulator: SimulatedDevice
) -> None:
    window.connect(simulator.url)
    page = ParametersPage(window)
    page.edit("serial_timeout", "1.5")
    review = ReviewDialog(window)
    review.write()
    review.close()
    assert simulator.show()["parameters"]["serial_timeout"] == 15
    window.disconnect()


def test_robot_page_moves_a_robot(window: WindowDriver, start_simulator: StartSimulator) -> None:
    robot_window = RobotWindow(window.program, window.qtbot)
    ports = window.program.ports
    url = start_simulator("--aracna", "--unpaced").url
    robot_window.connect_port(ports.assign(ports.add_typed(url), "aracna"))
    robot_window.wait_until_up()
    robot_window.drag("aracnaSlider0", 400)
    robot_window.move()
    (goals,) = robot_window.goals
    assert goals[0] == robot_window.find(QSlider, "aracnaSlider0").value()
