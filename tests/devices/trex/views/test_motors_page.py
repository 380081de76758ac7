"""Motors page: layout, speed ceiling, currents and channels."""

from collections.abc import Iterator

import pytest
from PySide6.QtCore import QPoint, QRect
from PySide6.QtWidgets import QApplication, QSpinBox, QWidget
from pytestqt.qtbot import QtBot

from tests.support.accessible_names import spoken_state
from tests.support.simulator import StartSimulator
from tests.support.virtual_time import VirtualRuntime
from tests.support.window import WidgetDriver
from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.model.group import BoardGroup
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.devices.trex.views.pages.motors.drive_control import SpeedSlider
from trex_gui.devices.trex.views.pages.motors.drive_pad import DrivePad
from trex_gui.devices.trex.views.pages.motors.page import MotorsPage
from trex_gui.ui.theme.theme import theme
from trex_gui.ui.widgets.labels import LiveLabel
from trex_gui.ui.widgets.scroll_box import ScrollBox


class MotorsPageDriver(WidgetDriver):
    """Motors page in a scroll area."""

    def __init__(self, device: Device, qtbot: QtBot) -> None:
        self.device = device
        self.page = MotorsPage(device, BoardGroup(device))
        self.area = ScrollBox(self.page)
        super().__init__(self.page, qtbot)
        qtbot.addWidget(self.area)
        self.area.show()
        self.resize(990, 519)
        self.pad = self.find(DrivePad, "drivePad")

    def resize(self, width: int, height: int) -> None:
        self.area.resize(width, height)
        QApplication.processEvents()

    def connect(self, url: str) -> None:
        self.device.connect_to(ConnectionSettings(url))
        self.wait(lambda: self.device.motors.is_available)

    def place_of(self, widget: QWidget) -> QRect:
        return QRect(widget.mapTo(self.page, QPoint()), widget.size())


@pytest.fixture
def page(qtbot: QtBot, qapp: QApplication) -> Iterator[MotorsPageDriver]:
    theme().install(qapp)
    device = Device()
    yield MotorsPageDriver(device, qtbot)
    qtbot.waitUntil(device.shut_down)


def test_page_explains_a_low_ceiling(
    page: MotorsPageDriver, start_simulator: StartSimulator
) -> None:
    entry = page.find(QSpinBox, "ceilingEntry")
    assert not entry.isEnabled()
    assert page.text("ceilingNote") == ""
    page.connect(start_simulator("--unpaced", "--device", "9").url)
    assert entry.text() == "38 (30 %)"
    assert page.text("ceilingNote").startswith("Raise the ceiling once")
    assert "30 % of full speed" in spoken_state(page.pad)
    assert page.find(QSpinBox, "motor1Entry").maximum() == 38

    page.type_into("ceilingEntry", "127")
    assert page.device.motors.ceiling == 127
    assert page.text("ceilingNote") == ""
    assert "full speed" not in spoken_state(page.pad)
    assert page.find(QSpinBox, "motor1Entry").maximum() == 127


def test_controls_do_not_move_while_armed(
    page: MotorsPageDriver, start_simulator: StartSimulator, virtual_time: VirtualRuntime
) -> None:
    brake = page.button("motor1Brake")
    page.resize(760, 900)  # one column
    page.connect(start_simulator("--unpaced").url)
    page.device.motors.arm()
    page.wait(page.pad.isEnabled)

    def positions() -> list[tuple[int, int]]:
        places = map(page.place_of, (brake, page.pad))
        return [(place.top(), place.bottom()) for place in places]

    before = positions()
    page.resize(760, 800)
    page.wait(lambda: positions() != before)
    virtual_time.advance(0.1)
    before = positions()
    page.button("moreOptions").click()
    QApplication.processEvents()
    assert positions() == before
    page.device.motors.stop()
    page.wait(lambda: positions() != before)


def test_currents_are_shown_with_their_limits(
    page: MotorsPageDriver, start_simulator: StartSimulator
) -> None:
    assert page.text("motor1Reported") == "–"
    simulator = start_simulator("--unpaced")
    simulator.do("eeprom motor2_current_limit 20", "current 1 3.0", "current 2 4.5")
    page.connect(simulator.url)
    for amps, text in ((4.5, "4.50 A"), (4.95, "⚠ 4.95 A"), (6.15, "⚠ 6.15 A")):
        simulator.do(f"current 2 {amps}")
        page.wait_for_text("motor2Current", text)
    assert page.text("motor2Reported") == "limit 6.0 A"
    assert page.find(LiveLabel, "motor1Current").spoken_name() == "Motor 1, current: 3.00 A"
    assert page.text("motor1Reported") == "no limit"
    page.device.disconnect_line()
    page.wait_for_text("motor1Current", "–")


def test_currents_are_below_the_motors_on_a_narrow_page(page: MotorsPageDriver) -> None:
    plot = page.button("openPlot")
    assert page.place_of(plot).left() > page.place_of(page.button("auxZero")).right()
    page.resize(664, 519)
    assert page.place_of(plot).top() > page.place_of(page.button("auxZero")).bottom()


def test_driving_channels_are_shown_on_the_controls(
    page: MotorsPageDriver, start_simulator: StartSimulator
) -> None:
    simulator = start_simulator("--unpaced", "--mode", "rc")
    page.device.connect_to(ConnectionSettings(simulator.url))
    page.wait_for_text("motor1Setpoint", "0 %")
    simulator.do("channel 1 1900us")
    slider, entry = page.find(SpeedSlider, "motor1Slider"), page.find(QSpinBox, "motor1Entry")
    page.wait(lambda: entry.value() > 80)
    assert slider.value() == entry.value()
    assert not slider.isEnabled()
    simulator.do("channel 1 silent")
    page.wait_for_text("motor1Setpoint", "held by safe-start")
    assert slider.value() == 0
