"""A person without hardware: the Demo TReX is handled on its panel, the program shows it."""

from collections.abc import Callable
from typing import TypeVar

import pytest
from PySide6.QtCore import QPoint, Qt
from PySide6.QtGui import QAccessible
from PySide6.QtTest import QTest
from PySide6.QtWidgets import (
    QAbstractButton,
    QAbstractSlider,
    QCheckBox,
    QComboBox,
    QDockWidget,
    QLabel,
    QStyle,
    QStyleOptionSlider,
    QTableWidget,
    QTabWidget,
    QWidget,
)
from pytestqt.qtbot import QtBot

from tests.support.demo_panels import reached_by_tab, stand_in_order
from tests.support.simulator import SimulatedDevice
from trex_gui.model.demo_snapshot import DemoSnapshot
from trex_gui.model.device import Link
from trex_gui.protocol.flags import CHANNELS, Mode
from trex_gui.views.widgets.stick_slider import StickSlider
from trex_gui.window import Program

WidgetT = TypeVar("WidgetT", bound=QWidget)


class Person:
    """What a person without hardware can do and see, by the names of the widgets."""

    def __init__(self, program: Program, qtbot: QtBot) -> None:
        self.program = program
        self.qtbot = qtbot

    @property
    def board(self) -> DemoSnapshot:
        snapshot = self.program.connector.demo_board.snapshot
        assert snapshot is not None
        return snapshot

    def find(self, kind: type[WidgetT], name: str) -> WidgetT:
        widget = self.program.window.findChild(kind, name)
        assert isinstance(widget, kind), name
        return widget

    def text(self, name: str) -> str:
        return self.find(QLabel, name).text()

    def wait(self, condition: Callable[[], bool], timeout: int = 20_000) -> None:
        self.qtbot.waitUntil(condition, timeout=timeout)

    def wait_for(self, link: Link) -> None:
        self.wait(lambda: self.program.device.link is link)

    def press(self, name: str) -> None:
        """Click on a button, or on the box of a tick."""
        button = self.find(QAbstractButton, name)
        assert button.isEnabled(), f"{name} is greyed"
        box = QPoint(8, button.height() // 2)
        QTest.mouseClick(button, Qt.MouseButton.LeftButton, pos=box)

    def choose(self, name: str, data: str) -> None:
        """Choose an entry of a list with the keyboard."""
        combo = self.find(QComboBox, name)
        combo.setFocus()
        QTest.keyClick(combo, Qt.Key.Key_Home)
        for _ in range(combo.findData(data)):
            QTest.keyClick(combo, Qt.Key.Key_Down)
        assert combo.currentData() == data

    def drag(self, name: str, share: float) -> None:
        """Drag the handle of a slider with the mouse to a share of its way."""
        slider = self.find(StickSlider, name)
        option = QStyleOptionSlider()
        slider.initStyleOption(option)
        part = QStyle.SubControl.SC_SliderHandle
        kind = QStyle.ComplexControl.CC_Slider
        handle = slider.style().subControlRect(kind, option, part, slider)
        start = handle.center()
        room = slider.width() - handle.width()
        end = QPoint(handle.width() // 2 + round(share * room), start.y())
        QTest.mousePress(slider, Qt.MouseButton.LeftButton, pos=start)
        for step in range(1, 11):
            QTest.mouseMove(slider, start + (end - start) * step / 10)
        QTest.mouseRelease(slider, Qt.MouseButton.LeftButton, pos=end)

    def open_page(self, name: str) -> None:
        tabs = self.find(QTabWidget, "tabs")
        tabs.setCurrentWidget(self.find(QWidget, f"{name}Area"))

    def errors(self) -> dict[str, int]:
        """What the table of the status page counts."""
        table = self.find(QTableWidget, "errorsTable")
        counts = {}
        for row in range(table.rowCount()):
            name, count = table.item(row, 0), table.item(row, 1)
            assert name is not None
            assert count is not None
            counts[name.text()] = int(count.text())
        return counts


@pytest.fixture
def person(program: Program, qtbot: QtBot) -> Person:
    """A person who has connected to the Demo TReX and sees its panel."""
    person = Person(program, qtbot)
    program.connector.connect_to(program.ports.demo)
    person.wait_for(Link.UP)
    person.wait(lambda: program.connector.demo_board.snapshot is not None)
    assert person.find(QDockWidget, "demoPanel").isVisible()
    return person


def test_a_stick_that_is_dragged_is_seen_on_the_channels_page(person: Person) -> None:
    person.open_page("channelsPage")
    person.drag("demoInput1", 0.9)
    wanted = person.find(StickSlider, "demoInput1").value()
    assert 1900 < wanted < 2100
    person.wait(lambda: person.text("channel1Input").startswith(f"{wanted} µs"))
    person.wait(lambda: person.text("demoValue1") == f"{wanted}\u00a0µs")
    automatic = person.find(QCheckBox, "demoAutomatic")
    assert automatic.checkState() is Qt.CheckState.PartiallyChecked


def test_a_stick_obeys_the_keyboard(person: Person) -> None:
    slider = person.find(StickSlider, "demoInput2")
    slider.setFocus()
    QTest.keyClick(slider, Qt.Key.Key_End)
    person.open_page("channelsPage")
    person.wait(lambda: person.text("channel2Input").startswith("2100 µs"))
    QTest.mouseDClick(slider, Qt.MouseButton.LeftButton)
    person.wait(lambda: person.text("channel2Input").startswith("1500 µs"))


def test_a_pulled_receiver_is_no_signal(person: Person) -> None:
    person.open_page("channelsPage")
    person.press("demoNoSignal3")
    person.wait(lambda: person.text("channel3Input") == "no signal")
    person.wait(lambda: not person.find(StickSlider, "demoInput3").isEnabled())
    person.press("demoNoSignal3")
    person.wait(lambda: "µs" in person.text("channel3Input"))


def test_sticks_that_were_moved_move_by_themselves_again(person: Person) -> None:
    person.drag("demoInput1", 0.2)
    person.press("demoAutomatic")
    assert person.program.connector.demo_board.automatic == {1, 2, 3, 4, 5}
    slider = person.find(StickSlider, "demoInput1")
    before = slider.value()
    person.wait(lambda: slider.value() != before)


def test_a_board_without_power_is_silent_and_comes_back(person: Person) -> None:
    person.press("demoPower")
    person.wait_for(Link.SILENT)
    assert "stopped answering" in person.text("statusLabel")
    person.wait(lambda: "power is off" in person.text("demoState"))
    person.press("demoPower")
    person.wait_for(Link.UP)


def test_a_driver_fault_is_counted_on_the_status_page(person: Person) -> None:
    person.press("demoFault2")
    person.wait(lambda: person.errors()["Motor 2 fault"] > 0)
    assert person.errors()["Motor 1 fault"] == 0


@pytest.mark.parametrize(
    ("error", "name"), [("framing", "Framing error"), ("overrun", "Data overrun")]
)
def test_a_spoilt_byte_is_counted_on_the_status_page(person: Person, error: str, name: str) -> None:
    person.choose("demoByteError", error)
    person.press("demoSpoil")
    person.wait(lambda: person.errors()[name] > 0)


def test_noise_is_survived_and_seen(person: Person) -> None:
    person.drag("demoNoise", 1)
    person.wait(lambda: person.board.line.noise == pytest.approx(0.05))
    counters = person.program.device.counters
    person.wait(lambda: person.program.device.counters != counters)
    person.drag("demoNoise", 0)
    person.wait(lambda: person.board.line.noise == 0)
    person.wait_for(Link.UP)


def test_lost_answers_look_like_silence(person: Person) -> None:
    person.press("demoMute")
    person.wait_for(Link.SILENT)
    person.press("demoMute")
    person.wait_for(Link.UP)


def test_a_jumper_acts_after_a_power_cycle(person: Person) -> None:
    person.open_page("statusPage")
    person.press("demoCentre")
    person.choose("demoMode", "rc")
    person.wait(lambda: person.text("demoHint") == "Power cycle to enter RC mode.")
    assert person.text("modeValue").startswith("Serial mode")
    person.press("demoPowerCycle")
    person.wait(lambda: person.board.mode is Mode.RC)
    person.wait(lambda: person.text("modeValue").startswith("RC mode"))
    person.wait(lambda: "enter" not in person.text("demoHint"))


def test_safe_start_is_shown_and_ended_by_centred_sticks(person: Person) -> None:
    person.drag("demoInput1", 1)
    person.choose("demoMode", "rc")
    person.press("demoPowerCycle")
    person.wait(lambda: "Safe-start" in person.text("demoState"))
    person.wait(lambda: person.board.leds.green == "fast flash")
    person.press("demoCentre")
    person.wait(lambda: "The sticks control" in person.text("demoState"))


def test_learning_is_led_by_the_panel(person: Person) -> None:
    person.choose("demoMode", "rc")
    person.press("demoMix")
    person.press("demoSoGround")
    person.wait(lambda: person.text("demoHint") == "Power cycle to learn the inputs.")
    person.press("demoPowerCycle")
    person.wait(lambda: "take the Mix jumper off" in person.text("demoState"))
    person.press("demoMix")
    person.wait(lambda: "leave the sticks" in person.text("demoState"))


def test_a_loaded_motor_draws_its_current(person: Person) -> None:
    motors = person.program.device.motors
    person.drag("demoLoad1", 0.3)
    motors.arm()
    motors.set_speed(1, 127)
    person.wait(lambda: person.board.motors[0].speed == 127)
    person.wait(lambda: person.board.motors[0].current > 5)
    person.wait(lambda: "forward 127" in person.text("demoMotor1"))
    motors.stop()
    person.wait(lambda: not person.program.device.may_move)


def test_the_factory_state_forgets_everything(person: Person) -> None:
    person.choose("demoMode", "analog")
    person.press("demoPowerCycle")
    person.drag("demoInput4", 0.1)
    person.press("demoNoSignal5")
    person.wait(lambda: not person.board.channels[4].has_signal)
    person.press("demoFactory")
    person.wait(lambda: person.board.mode is Mode.SERIAL_RC)
    person.wait(lambda: person.board.channels[4].has_signal)
    assert person.find(QComboBox, "demoMode").currentData() == "serial"
    person.wait_for(Link.UP)


# --- The cable --------------------------------------------------------------------------


def pull_the_cable(person: Person) -> None:
    person.press("demoCable")
    person.wait_for(Link.NONE)
    person.wait(lambda: not person.board.line.plugged)


def test_a_pulled_cable_is_a_sentence_and_the_panel_stays(person: Person) -> None:
    pull_the_cable(person)
    assert "is gone" in person.text("bannerText")
    assert person.find(QDockWidget, "demoPanel").isVisible()
    person.wait(lambda: "The cable is out" in person.text("demoState"))
    assert not person.find(QWidget, "demoNoise").isEnabled()


def test_a_cable_that_is_in_again_is_connected_by_the_usual_button(person: Person) -> None:
    pull_the_cable(person)
    person.press("demoCable")
    person.wait(lambda: person.text("demoState") == "The cable is in again. Press Connect.")
    person.press("connectButton")
    person.wait_for(Link.UP)
    person.wait(lambda: person.text("demoState").startswith("Serial mode."))
    assert person.program.connector.port == person.program.ports.demo


def test_a_cable_that_is_in_again_is_connected_by_the_list(person: Person) -> None:
    pull_the_cable(person)
    person.press("demoCable")
    person.wait(lambda: person.board.line.plugged)
    combo = person.find(QComboBox, "portCombo")
    index = next(
        index
        for index in range(combo.count())
        if combo.itemData(index) == person.program.ports.demo
    )
    combo.setCurrentIndex(index)
    combo.activated.emit(index)
    person.wait_for(Link.UP)


def test_connecting_while_the_cable_is_out_says_what_to_do(person: Person) -> None:
    pull_the_cable(person)
    person.press("connectButton")
    assert "Tick “Plugged in” on its panel" in person.text("bannerText")
    assert person.program.device.link is Link.NONE
    assert person.find(QDockWidget, "demoPanel").isVisible()
    assert person.text("statusLabel") == "Not connected."
    assert person.find(QAbstractButton, "connectButton").isEnabled()


def test_another_line_is_closed_though_the_demos_cable_is_out(
    person: Person, quick_simulator: SimulatedDevice
) -> None:
    pull_the_cable(person)
    connector, ports = person.program.connector, person.program.ports
    connector.connect_to(ports.add_typed(quick_simulator.url))
    person.wait_for(Link.UP)
    assert person.find(QDockWidget, "demoPanel").isHidden()
    connector.connect_to(ports.demo)
    person.wait_for(Link.NONE)
    assert connector.port is None
    assert "Tick “Plugged in” on its panel" in person.text("bannerText")
    assert person.find(QDockWidget, "demoPanel").isVisible()


def test_a_cable_pulled_while_motors_turn_warns_of_them(person: Person) -> None:
    motors = person.program.device.motors
    motors.arm()
    motors.set_speed(1, 60)
    person.wait(lambda: person.board.motors[0].speed == 60)
    pull_the_cable(person)
    assert "motors may still turn" in person.text("motorStateLabel")
    person.wait(lambda: person.text("demoMotor1").startswith("forward 60"))
    person.press("demoCable")
    person.wait(lambda: person.board.line.plugged)
    person.press("connectButton")
    person.wait_for(Link.UP)
    person.wait(lambda: person.board.motors[0].speed != 60)


def test_a_board_without_power_is_not_found_and_the_panel_says_what_to_do(
    person: Person,
) -> None:
    person.press("demoPower")
    pull_the_cable(person)
    person.press("demoCable")
    person.wait(lambda: person.board.line.plugged)
    person.wait(lambda: "Switch it on" in person.text("demoState"))


# --- For everybody ----------------------------------------------------------------------


def controls(person: Person) -> list[QWidget]:
    panel = person.find(QDockWidget, "demoPanel")
    kinds = (QAbstractButton, QAbstractSlider, QComboBox)
    return [
        widget
        for widget in panel.findChildren(QWidget)
        if isinstance(widget, kinds) and widget.objectName().startswith("demo")
    ]


NAMES = {
    *("demoPower", "demoPowerCycle", "demoBattery", "demoMode", "demoMix", "demoSoGround"),
    *(f"demo{what}{channel}" for what in ("Input", "NoSignal") for channel in CHANNELS),
    *("demoAutomatic", "demoCentre", "demoLoad1", "demoLoad2", "demoFault1", "demoFault2"),
    *("demoCable", "demoMute", "demoNoise", "demoByteError", "demoSpoil", "demoFactory"),
}


def test_every_control_has_a_name_for_those_who_cannot_see_it(person: Person) -> None:
    assert {control.objectName() for control in controls(person)} == NAMES
    for control in controls(person):
        interface = QAccessible.queryAccessibleInterface(control)
        assert interface is not None
        assert interface.text(QAccessible.Text.Name), control.objectName()
        assert control.toolTip(), control.objectName()


def test_tab_reaches_every_control_in_the_order_of_the_panel(person: Person) -> None:
    first = person.find(QAbstractButton, "demoPower")
    person.program.window.activateWindow()
    first.setFocus()
    person.wait(first.hasFocus)
    reached = reached_by_tab("demoFactory")
    assert set(reached) == NAMES
    assert len(reached) == len(set(reached))
    assert stand_in_order(person.find(QDockWidget, "demoPanel"), reached)
