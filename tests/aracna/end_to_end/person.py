"""What a person with a robot can do and see, by the names of the widgets."""

from collections.abc import Callable, Sequence
from typing import TypeVar

from PySide6.QtCore import QPoint, Qt
from PySide6.QtGui import QAction
from PySide6.QtTest import QTest
from PySide6.QtWidgets import (
    QAbstractButton,
    QComboBox,
    QLabel,
    QMenu,
    QSlider,
    QStyle,
    QStyleOptionSlider,
    QWidget,
)
from pytestqt.qtbot import QtBot

from trex_gui.model.connection import Link
from trex_gui.window import Program

WidgetT = TypeVar("WidgetT", bound=QWidget)

DEMO_TREX, DEMO_ARACNA = "Demo TReX (no hardware)", "Demo Aracna (no hardware)"


class Person:
    """Sits in front of the window."""

    def __init__(self, program: Program, qtbot: QtBot) -> None:
        self.program = program
        self.robot = program.robot
        self.simulator = program.robot_way.simulator
        self.qtbot = qtbot
        self.silences = 0
        self.robot.link_changed.connect(self._count_silences)

    def _count_silences(self) -> None:
        if self.robot.link is Link.SILENT:
            self.silences += 1

    def find(self, kind: type[WidgetT], name: str) -> WidgetT:
        widget = self.program.window.findChild(kind, name)
        assert isinstance(widget, kind), name
        return widget

    def text(self, name: str) -> str:
        return self.find(QLabel, name).text()

    def wait(self, condition: Callable[[], bool]) -> None:
        self.qtbot.waitUntil(condition, timeout=30_000)

    def see_silence(self, act: Callable[[], object]) -> None:
        """Do something and wait until the robot was silent: after a restart it is so for 1 s."""
        before = self.silences
        act()
        self.wait(lambda: self.silences > before)

    def click(self, name: str) -> None:
        button = self.find(QAbstractButton, name)
        self.wait(button.isVisible)  # what was just laid out is shown in the next round
        assert button.isEnabled(), f"{name} is greyed"
        place = QPoint(8, button.height() // 2)
        QTest.mouseClick(button, Qt.MouseButton.LeftButton, pos=place)

    def action(self, key: str) -> QAction:
        action = self.program.window.findChild(QAction, f"{key}Action")
        assert isinstance(action, QAction), key
        return action

    @property
    def menus(self) -> list[str]:
        """The titles of the menus that are offered."""
        bar = self.program.window.menuBar()
        return [
            menu.title().replace("&", "")
            for action in bar.actions()
            if action.isVisible() and isinstance(menu := action.menu(), QMenu)
        ]

    def choose_port(self, label: str) -> None:
        """Choose an entry of the list of ports."""
        combo = self.find(QComboBox, "portCombo")
        index = combo.findText(label)
        assert index >= 0, [combo.itemText(i) for i in range(combo.count())]
        combo.setCurrentIndex(index)
        combo.activated.emit(index)  # offscreen has no list to open

    def connect_to_demo(self) -> None:
        self.choose_port(DEMO_ARACNA)
        self.wait(lambda: self.robot.link is Link.UP)

    def handle(self, slider: QSlider) -> QPoint:
        """Where the handle of a slider is."""
        return self._handle_at(slider, slider.sliderPosition())

    def _handle_at(self, slider: QSlider, value: int) -> QPoint:
        option = QStyleOptionSlider()
        slider.initStyleOption(option)
        option.sliderPosition = option.sliderValue = value
        kind, part = QStyle.ComplexControl.CC_Slider, QStyle.SubControl.SC_SliderHandle
        return slider.style().subControlRect(kind, option, part, slider).center()

    def drag(self, name: str, value: int, *, release: bool = True) -> QSlider:
        """Drag the handle of a slider with the mouse to a value."""
        slider = self.find(QSlider, name)
        start, end = self.handle(slider), self._handle_at(slider, value)
        QTest.mousePress(slider, Qt.MouseButton.LeftButton, pos=start)
        for step in range(1, 11):
            QTest.mouseMove(slider, start + (end - start) * step / 10)
        if release:
            QTest.mouseRelease(slider, Qt.MouseButton.LeftButton, pos=end)
        return slider

    def wait_for_motion(self, before: int, sent: Sequence[object]) -> None:
        """Wait until more than so many motions were sent, and the last one is over."""
        self.wait(lambda: len(sent) > before and self.robot.known.moving is None)

    def move_and_wait(self) -> None:
        """Press Move and wait for the robot's answer."""
        before = self.robot.known.moved
        self.click("aracnaMoveButton")
        self.wait(lambda: self.robot.known.moved not in (None, before))
