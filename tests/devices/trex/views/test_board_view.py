"""Drawing of a board, with known and unknown values, alone and in a group."""

from collections.abc import Iterator

import pytest
from PySide6.QtCore import SIGNAL, Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QWidget
from pytestqt.qtbot import QtBot

from tests.support.simulator import SimulatedDevice, StartSimulator
from tests.support.window import WidgetDriver
from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.model.drive_status import drive_inputs
from trex_gui.devices.trex.model.group import BoardGroup
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.devices.trex.views.board.page import BoardPage
from trex_gui.devices.trex.views.board.parts import BoardPart, JumperPart, LedPart, MotorPart
from trex_gui.devices.trex.views.board.view import BoardView
from trex_gui.ui.devices.connection import ConnectionState


class DrawingDriver(WidgetDriver):
    """Drawing of a board in a window."""

    def __init__(self, view: BoardView, device: Device, qtbot: QtBot) -> None:
        super().__init__(view, qtbot)
        self.view, self.device = view, device

    def spoken(self, name: str) -> str:
        self.view.show_board(drive_inputs(self.device))
        part = self.find(BoardPart, f"boardPart{name}")
        return f"{part.accessibleName()}: {part.spoken_state()}"

    def connect(self, simulator: SimulatedDevice) -> None:
        self.device.connect_to(ConnectionSettings(simulator.url))
        self.wait(lambda: self.device.link is ConnectionState.CONNECTED)
        self.wait(lambda: self.device.telemetry.motor_currents is not None)


@pytest.fixture
def drawing(qtbot: QtBot) -> Iterator[DrawingDriver]:
    device, window = Device(), QWidget()
    qtbot.addWidget(window)
    view = BoardView(device, window)
    view.resize(800, 400)
    window.show()
    yield DrawingDriver(view, device, qtbot)
    assert device.shut_down()


def test_unknown_values_are_shown_as_unknown(drawing: DrawingDriver) -> None:
    assert drawing.spoken("Channel1") == "Channel 1: Motor 1: –"
    for jumper in ("ModeJumper", "MixJumper", "SoGroundJumper"):
        assert "not known" in drawing.spoken(jumper)
        assert drawing.find(JumperPart, f"boardPart{jumper}").is_on is None
    assert drawing.spoken("RedLed") == "Red LED: unknown"
    assert "not known" in drawing.spoken("Motor1")
    assert drawing.spoken("Serial") == "Serial line: not responding"


def test_reports_are_shown_in_serial_mode(
    drawing: DrawingDriver, quick_simulator: SimulatedDevice
) -> None:
    drawing.connect(quick_simulator)
    quick_simulator.do("channel 2 1800us")
    drawing.wait(lambda: drawing.spoken("Channel2") == "Channel 2: Motor 2: 1800 µs")
    quick_simulator.do("channel 3 invalid")
    drawing.wait(lambda: drawing.spoken("Channel3") == "Channel 3: Auxiliary: no signal")
    assert drawing.spoken("ModeJumper") == "Mode jumper: Mode: off, serial mode"
    assert drawing.spoken("SoGroundJumper") == "SO–G jumper: SO–G: off, replies arrive"
    assert drawing.spoken("RedLed") == "Red LED: on"
    assert drawing.find(LedPart, "boardPartGreenLed").is_blinking

    motor = drawing.find(MotorPart, "boardPartMotor1")
    assert drawing.spoken("Motor1") == "Motor 1: not armed, 0.00 A, no limit"
    drawing.device.motors.arm()
    drawing.device.motors.set_speed(1, -20)
    assert "reverse 20" in drawing.spoken("Motor1")
    assert motor.speed == -20
    quick_simulator.do("fault 1 on")
    drawing.wait(lambda: "Motor 1 fault" in drawing.spoken("Motor1"))
    assert motor.alarm == "danger"
    assert motor.speed == 0


def test_rc_mode_shows_safe_start_and_its_jumper(
    drawing: DrawingDriver, quick_simulator: SimulatedDevice
) -> None:
    quick_simulator.do("jumper mode rc", "channel 1 1900us", "power cycle")
    drawing.connect(quick_simulator)
    drawing.wait(lambda: "held by safe-start" in drawing.spoken("Motor1"))
    quick_simulator.do("channel 1 1500us")
    drawing.wait(lambda: ": 0, " in drawing.spoken("Motor1"))
    assert drawing.spoken("ModeJumper") == "Mode jumper: Mode: RC, channels drive"
    assert drawing.find(JumperPart, "boardPartModeJumper").is_on


def test_parts_stay_inside_the_drawing_at_any_size(drawing: DrawingDriver) -> None:
    minimum, preferred = drawing.view.minimumSizeHint(), drawing.view.sizeHint()
    for width in range(minimum.width(), 2 * preferred.width(), 40):
        for height in (minimum.height(), preferred.height(), 2 * preferred.height()):
            drawing.view.resize(width, height)
            for part in drawing.find_all(BoardPart):
                assert drawing.view.rect().contains(part.geometry()), (width, height, part)


def test_each_part_opens_its_page_with_the_keyboard(drawing: DrawingDriver) -> None:
    pages: list[str] = []
    drawing.view.page_requested.connect(pages.append)
    parts = drawing.find_all(BoardPart)
    assert len(parts) == 14
    for part in parts:
        assert part.accessibleName()
        QTest.keyClick(part, Qt.Key.Key_Space)
    assert set(pages) == {"channels", "errors", "motors", "parameters", "transcript"}


def test_boards_joined_again_are_updated_once(
    qtbot: QtBot, start_simulator: StartSimulator
) -> None:
    simulator = start_simulator("--unpaced", "--device", "7", "--device", "9:trexjr")
    window, device = QWidget(), Device()
    qtbot.addWidget(window)
    group = BoardGroup(device)
    page = BoardPage(device, group, QWidget, window)
    device.connect_to(ConnectionSettings(simulator.url).with_group((7, 9)))
    qtbot.waitUntil(lambda: device.is_connected and len(page.findChildren(BoardView)) == 2)
    telemetry, text_due = group.devices[9].telemetry, SIGNAL("text_due()")
    before = telemetry.receivers(text_due)
    group.changed.emit()
    qtbot.waitUntil(lambda: len(page.findChildren(BoardView)) == 2)
    assert telemetry.receivers(text_due) == before
    device.disconnect_line()
    qtbot.waitUntil(device.shut_down)
