"""Window with an Aracna."""

import pytest
from pytestqt.qtbot import QtBot

from tests.support.pages.robot import RobotWindow
from trex_gui.ui.program import Program


@pytest.fixture
def window(program: Program, qtbot: QtBot) -> RobotWindow:
    """Return a window without a connection."""
    return RobotWindow(program, qtbot)


@pytest.fixture
def connected_window(window: RobotWindow) -> RobotWindow:
    """Return a window connected to the Demo Aracna."""
    window.select_demo()
    return window
