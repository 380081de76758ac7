"""Windows of recordings of a robot, and what a person finds in them by name."""

from pathlib import Path
from typing import TypeVar

from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QLabel, QPushButton, QWidget
from pytestqt.qtbot import QtBot

from tests.aracna.recordings import HEADER, MOTORS, T0, write
from trex_gui.aracna.link.messages import Moved, Moving, Passed, SpeedsHeld
from trex_gui.aracna.model.playback import RobotPlayback
from trex_gui.aracna.model.robot import Robot
from trex_gui.aracna.recording import Header, Row
from trex_gui.aracna.views.recording.window import RobotPlaybackWindow
from trex_gui.recording.recording import Marker

PATIENCE = 20_000
WidgetT = TypeVar("WidgetT", bound=QWidget)

GOALS, REACHED = (200,) * MOTORS, (201, 199, *(200,) * 5, -1)
STORY: list[Row] = [
    SpeedsHeld(T0 + 1, (100,) * MOTORS, (100, 0, *(100,) * 5, -1)),
    Marker(T0 + 1, "fault", "Motor 7 does not answer (−1)"),
    Moving(T0 + 10, GOALS, (None,) * MOTORS, 2.0),
    Passed(T0 + 11, (201, 199, 200)),
    Moved(T0 + 12, GOALS, REACHED, 2.0),
    Marker(T0 + 40, "note", "Not moved: No robot is connected that could move."),
    Marker(T0 + 60, "stop", "Stopped: nothing more is sent."),
]


def opened(
    path: Path, qtbot: QtBot, what: list[Row], header: Header = HEADER
) -> RobotPlaybackWindow:
    write(path, what, header)
    window = RobotPlaybackWindow(RobotPlayback.open(path), Robot())
    qtbot.addWidget(window)
    window.show()
    qtbot.waitUntil(lambda: window.playback.is_loaded, timeout=PATIENCE)
    return window


def find(window: QWidget, kind: type[WidgetT], name: str) -> WidgetT:
    widget = window.findChild(kind, name)
    assert isinstance(widget, kind), name
    return widget


def text(window: QWidget, name: str) -> str:
    return find(window, QLabel, name).text()


def click(window: QWidget, qtbot: QtBot, name: str) -> None:
    button = find(window, QPushButton, name)
    qtbot.waitUntil(button.isVisible, timeout=PATIENCE)
    QTest.mouseClick(button, Qt.MouseButton.LeftButton)
