"""A right-to-left language does not mirror robots, values and axes."""

from collections.abc import Callable, Iterator

import pytest
from PySide6.QtCore import QPoint, Qt
from PySide6.QtGui import QImage
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QAbstractSpinBox, QApplication, QSlider, QWidget
from pytestqt.qtbot import QtBot

from tests.support.window import LEFT, WindowDriver
from trex_gui.devices.aracna.views.robot.joint_table import JointSlider
from trex_gui.devices.trex.views.pages.motors.drive_control import SpeedSlider
from trex_gui.devices.trex.views.pages.motors.drive_pad import DrivePad
from trex_gui.ui.frame.wiring_sketch import WiringSketch
from trex_gui.ui.plotting.canvas import PlotCanvas
from trex_gui.ui.widgets.labels import LiveLabel
from trex_gui.ui.widgets.painted import Painted
from trex_gui.ui.widgets.sliders import StickSlider

Direction = Qt.LayoutDirection


@pytest.fixture
def _right_to_left(qapp: QApplication) -> Iterator[None]:
    qapp.setLayoutDirection(Direction.RightToLeft)
    yield
    qapp.setLayoutDirection(Direction.LeftToRight)


@pytest.mark.usefixtures("_right_to_left")
def test_window_mirrors_no_painted_widget_slider_or_number(window: WindowDriver) -> None:
    assert window.root.layoutDirection() is Direction.RightToLeft
    for workspace in window.program.workspaces.values():
        workspace.create_pages()
    window.connect_to_demo()  # the demo panel has sliders
    kinds = Painted, LiveLabel, QSlider, QAbstractSpinBox
    widgets = [widget for widget in window.find_all(QWidget) if isinstance(widget, kinds)]
    assert len(widgets) > 50
    assert {DrivePad, SpeedSlider, JointSlider, WiringSketch, StickSlider} <= set(
        map(type, widgets)
    )
    mirrored = [each for each in widgets if each.layoutDirection() is not Direction.LeftToRight]
    assert not mirrored


def picture(create: Callable[[QWidget], QWidget], direction: Direction) -> QImage:
    QApplication.setLayoutDirection(direction)
    parent = QWidget()
    widget = create(parent)
    widget.resize(300, 200)
    return widget.grab().toImage()


def plot(parent: QWidget) -> QWidget:
    canvas = PlotCanvas("plot", parent)
    canvas.set_margins(left="\N{MINUS SIGN}127", top=9, right=9, x_axis=True)
    labels = [(-100.0, "−100"), (0.0, "0")]
    canvas.set_axes((-100, 0), (-100, 0), labels, labels)
    return canvas


@pytest.mark.usefixtures("_right_to_left")
@pytest.mark.parametrize("create", [DrivePad, plot])
def test_picture_is_the_same_in_both_directions(create: Callable[[QWidget], QWidget]) -> None:
    mirrored = picture(create, Direction.RightToLeft)
    assert picture(create, Direction.LeftToRight) == mirrored


@pytest.mark.usefixtures("_right_to_left")
@pytest.mark.parametrize("x", [20, 230])
def test_right_side_and_right_key_increase_the_setpoint(qtbot: QtBot, x: int) -> None:
    slider, pad = SpeedSlider(0), DrivePad()
    turns = []
    pad.steered.connect(lambda _forward, turn: turns.append(turn))
    for widget in (slider, pad):
        qtbot.addWidget(widget)
        widget.resize(250, 250)
        widget.show()
    QTest.mousePress(pad, LEFT, pos=pad.rect().center())
    QTest.mouseMove(pad, QPoint(x, 125))
    assert (turns[-1] > 0) is (x > 125)
    QTest.keyClick(slider, Qt.Key.Key_Right)
    assert slider.value() == 1
