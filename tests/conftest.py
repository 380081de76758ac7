"""What every test stands on: no screen, settings of its own, a board in virtual time."""

import os
from collections.abc import Callable, Iterator

import pytest

os.environ.setdefault("QT_QPA_PLATFORM", "offscreen")

from PySide6.QtCore import QCoreApplication, QSettings
from PySide6.QtWidgets import QApplication
from pytestqt.qtbot import QtBot

from tests.support.simulator import SimulatorProcess
from tests.support.virtual import Stage
from trex_gui.emulator.firmware import Board
from trex_gui.model.device import Link
from trex_gui.views.theme import theme
from trex_gui.window import Program, build


@pytest.fixture
def board() -> Board:
    return Board()


@pytest.fixture
def stage(board: Board) -> Stage:
    return Stage(board)


@pytest.fixture(autouse=True)
def _own_settings(tmp_path_factory: pytest.TempPathFactory) -> None:
    """Keep what the program remembers in a folder of the test's own."""
    folder = tmp_path_factory.mktemp("settings")
    QCoreApplication.setOrganizationName("TReX Studio tests")
    QCoreApplication.setApplicationName("TReX Studio")
    QSettings.setDefaultFormat(QSettings.Format.IniFormat)
    QSettings.setPath(QSettings.Format.IniFormat, QSettings.Scope.UserScope, str(folder))


@pytest.fixture
def start_simulator() -> Iterator[Callable[..., SimulatorProcess]]:
    """Start simulators that end with the test."""
    running: list[SimulatorProcess] = []

    def start(*arguments: str) -> SimulatorProcess:
        running.append(SimulatorProcess(*arguments))
        return running[-1]

    yield start
    for simulator in running:
        simulator.end()


@pytest.fixture
def simulator(start_simulator: Callable[..., SimulatorProcess]) -> SimulatorProcess:
    return start_simulator()


@pytest.fixture
def program(qtbot: QtBot, qapp: QApplication) -> Iterator[Program]:
    """The window on its models; nothing is connected, and no thread may outlive it."""
    theme().install(qapp)
    program = build()
    program.window.show()
    yield program
    program.device.discard_edits()
    program.window.close()
    program.window.deleteLater()
    assert program.device.link is Link.NONE
