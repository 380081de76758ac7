"""The window with an Aracna, for journeys."""

import pytest
from pytestqt.qtbot import QtBot

from tests.support.pages.robot import RobotWindow
from trex_gui.ui.program import Program


@pytest.fixture
def window(program: Program, qtbot: QtBot) -> RobotWindow:
    """The window, with nothing connected."""
    return RobotWindow(program, qtbot)


@pytest.fixture
def connected_window(window: RobotWindow) -> RobotWindow:
    """The window, connected to the Demo Aracna."""
    window.choose_demo()
    return window
