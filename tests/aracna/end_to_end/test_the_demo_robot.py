"""A person without a robot handles the Demo Aracna on its panel; the program tells what happens."""

import json
import sys
from dataclasses import replace
from typing import Any

import pytest
from PySide6.QtCore import QPoint, QRect, Qt
from PySide6.QtGui import QAccessible
from PySide6.QtTest import QTest
from PySide6.QtWidgets import (
    QAbstractButton,
    QAbstractSlider,
    QCheckBox,
    QComboBox,
    QDockWidget,
    QLabel,
    QScrollArea,
    QWidget,
)
from pytestqt.qtbot import QtBot

from tests.aracna.end_to_end.person import Person
from tests.end_to_end.test_names_for_a_screen_reader import assert_named
from tests.support.demo_panels import reached_by_tab, stand_in_order
from trex_gui.aracna.model.demo_snapshot import RobotSnapshot
from trex_gui.aracna.views.demo.gauge import ServoGauge
from trex_gui.aracna.views.demo.panel import DemoRobotView
from trex_gui.model.connection import Link
from trex_gui.views.widgets.leds import Lamp
from trex_gui.views.widgets.stick_slider import StickSlider
from trex_gui.window import Program

pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="needs pseudo-terminals")


class Handler(Person):
    """A person who looks at the panel, too."""

    @property
    def truth(self) -> RobotSnapshot:
        """What the simulated robot said of itself last."""
        snapshot = self.program.robot_way.demo_robot.snapshot
        assert snapshot is not None
        return snapshot

    @property
    def panel(self) -> QDockWidget:
        return self.find(QDockWidget, "aracnaDemoPanel")

    def press(self, name: str) -> None:
        """Click on a button or a tick of the panel, scrolling to it first."""
        button = self.find(QAbstractButton, name)
        self.wait(button.isVisible)
        area = self.panel.findChild(QScrollArea)
        assert area is not None
        area.ensureWidgetVisible(button)
        place = QPoint(min(8, button.width() // 2), button.height() // 2)
        assert button.isEnabled(), f"{name} is greyed"
        QTest.mouseClick(button, Qt.MouseButton.LeftButton, pos=place)

    def slide(self, name: str, share: float) -> None:
        """Move a slider of the panel with the keyboard, to a share of its way."""
        slider = self.find(StickSlider, name)
        slider.setFocus()
        QTest.keyClick(slider, Qt.Key.Key_Home)
        steps = round(share * (slider.maximum() - slider.minimum()) / slider.singleStep())
        for _ in range(steps):
            QTest.keyClick(slider, Qt.Key.Key_Right)

    def choose(self, name: str, data: str) -> None:
        """Choose an entry of a list with the keyboard."""
        combo = self.find(QComboBox, name)
        combo.setFocus()
        QTest.keyClick(combo, Qt.Key.Key_Home)
        for _ in range(combo.findData(data)):
            QTest.keyClick(combo, Qt.Key.Key_Down)
        assert combo.currentData() == data

    def ask_simulator(self) -> dict[str, Any]:
        """What the simulator says itself, past the panel."""
        answers: list[str] = []
        self.simulator.send("show", answers.append)
        self.wait(lambda: bool(answers))
        shown: dict[str, Any] = json.loads(answers[0].removeprefix("ok "))
        return shown

    def dropped(self) -> int:
        """How many bytes have got lost on the wire."""
        return int(self.ask_simulator()["counters"]["line"]["dropped"])

    def begin_to_move(self, speed: int = 40) -> None:
        """Send all motors far away, slowly enough to meddle: 4.5 s, unless it is told otherwise."""
        self.robot.set_speeds((speed,) * self.robot.motors)
        self.robot.move((100,) * self.robot.motors)
        self.wait(lambda: self.truth.state == "moving" and self.truth.is_moving)


@pytest.fixture
def person(program: Program, qtbot: QtBot) -> Handler:
    """A person who has connected to the Demo Aracna and sees its panel."""
    person = Handler(program, qtbot)
    person.connect_to_demo()
    person.wait(person.panel.isVisible)
    person.wait(lambda: program.robot_way.demo_robot.snapshot is not None)
    return person


# --- The truth --------------------------------------------------------------------------


def test_the_panel_shows_where_the_servos_are_before_the_robot_has_told_it(
    person: Handler,
) -> None:
    assert person.text("aracnaPresent0") == "–"
    person.wait(lambda: person.text("aracnaDemoWhere0") == "512")
    assert "limp" in person.find(ServoGauge, "aracnaDemoGauge0").toolTip()
    person.wait(lambda: "Idle" in person.text("aracnaDemoState"))


def test_the_panel_follows_a_motion_while_the_robot_is_silent_about_it(person: Handler) -> None:
    person.begin_to_move()
    assert "Moving" in person.text("aracnaDemoState")
    gauge = person.find(ServoGauge, "aracnaDemoGauge7")
    person.wait(lambda: 110 < gauge.position < 500)
    assert person.robot.known.moving is not None
    assert "on its way to 100" in gauge.toolTip()
    person.wait(lambda: person.robot.known.moved is not None)
    person.wait(lambda: person.text("aracnaDemoWhere7") == str(person.robot.present[7]))
    person.wait(lambda: "holds" in gauge.toolTip())
    person.wait(lambda: "Idle" in person.text("aracnaDemoState"))


# --- Servos -----------------------------------------------------------------------------


def test_a_servo_made_dead_is_reported_by_the_robot_page(person: Handler) -> None:
    person.move_and_wait()  # from where it stands a late answer is called late sooner
    person.begin_to_move()
    person.press("aracnaDemoDead3")
    person.wait(lambda: "waits for motor 3" in person.text("aracnaReport"))
    assert person.text("aracnaState3") == "stuck here"
    assert "dead" in person.find(ServoGauge, "aracnaDemoGauge3").toolTip()
    person.press("aracnaDemoDead3")
    person.wait(lambda: person.robot.known.stuck is None and person.robot.known.moved is not None)
    person.wait(lambda: not person.truth.servos[3].dead)


def test_a_servo_that_is_blocked_holds_the_robot_up_until_it_is_free(person: Handler) -> None:
    person.move_and_wait()
    person.begin_to_move()
    person.press("aracnaDemoBlocked5")
    person.wait(lambda: "waits for motor 5" in person.text("aracnaReport"))
    assert "cannot get to 100" in person.find(ServoGauge, "aracnaDemoGauge5").toolTip()
    person.press("aracnaDemoBlocked5")
    person.wait(lambda: "where it was sent" in person.text("aracnaReport"))


def test_a_servo_with_a_load_is_late(person: Handler) -> None:
    person.move_and_wait()
    person.slide("aracnaDemoLoad0", 0.9)
    person.wait(lambda: person.truth.servos[0].load == pytest.approx(0.9))
    assert "90 %" in person.find(StickSlider, "aracnaDemoLoad0").toolTip()
    person.begin_to_move()
    person.wait(lambda: "waits for motor 0" in person.text("aracnaReport"))
    assert person.truth.servos[7].position < person.truth.servos[0].position - 100
    person.slide("aracnaDemoLoad0", 0)
    person.wait(lambda: "where it was sent" in person.text("aracnaReport"))


# --- Power ------------------------------------------------------------------------------


def test_servo_power_cut_in_motion_stops_it_and_is_told(person: Handler) -> None:
    person.move_and_wait()
    person.begin_to_move()
    assert "only thing that stops" in person.text("aracnaDemoPowerHint")
    person.press("aracnaDemoServoPower")
    person.wait(lambda: not person.truth.servo_power)
    stopped = [servo.position for servo in person.truth.servos]
    person.wait(lambda: "listens to nothing" in person.text("aracnaReport"))
    assert "servo power" in person.text("aracnaReport")
    assert [servo.position for servo in person.truth.servos] == stopped
    assert min(stopped) > 100
    assert "no power" in person.text("aracnaDemoState")
    person.press("aracnaDemoServoPower")
    person.wait(lambda: person.robot.known.stuck is None)


def test_a_robot_switched_off_is_silent_and_comes_back(person: Handler) -> None:
    person.press("aracnaDemoPower")
    person.wait(lambda: person.robot.link is Link.SILENT)
    assert "stopped answering" in person.text("statusLabel")
    person.wait(lambda: "power is off" in person.text("aracnaDemoState"))
    assert not person.find(QAbstractButton, "aracnaDemoRestart").isEnabled()
    person.press("aracnaDemoPower")
    person.wait(lambda: person.robot.link is Link.UP)
    person.wait(lambda: person.truth.servo_power)


def test_a_restarted_board_is_counted_and_lets_its_servos_go_on(person: Handler) -> None:
    person.begin_to_move(speed=15)
    person.see_silence(lambda: person.press("aracnaDemoRestart"))
    person.wait(lambda: person.text("aracnaDemoBoots") == "Starts: 2")
    assert person.truth.is_moving
    person.wait(lambda: person.robot.link is Link.UP)
    person.wait(lambda: "Idle" in person.text("aracnaDemoState"))


@pytest.mark.parametrize(
    ("state", "led", "text"),
    [
        ("booting", True, "LED: blinks"),
        ("booting", False, "LED: blinks"),
        ("idle", True, "LED: on"),
        ("moving", False, "LED: off"),
    ],
)
def test_the_led_is_told_without_its_flicker(
    person: Handler, state: str, led: bool, text: str
) -> None:
    view = person.panel.findChild(DemoRobotView)
    assert view is not None
    view.show_head(replace(person.truth, state=state, led=led))
    assert person.text("aracnaDemoLedText") == text
    lamp = person.find(Lamp, "aracnaDemoLed")
    assert lamp.lit is led
    assert lamp.accessibleName() == text


# --- The cable --------------------------------------------------------------------------


def pull_the_cable(person: Handler) -> None:
    person.press("aracnaDemoCable")
    person.wait(lambda: person.robot.link is Link.NONE)
    person.wait(lambda: not person.truth.line.plugged)


def test_a_pulled_cable_is_told_and_the_panel_says_how_it_goes_on(person: Handler) -> None:
    person.begin_to_move()
    pull_the_cable(person)
    assert person.find(QWidget, "banner").isVisible()
    assert "goes on" in person.text("aracnaMotionLabel")
    assert person.panel.isVisible()
    assert "The cable is out" in person.text("aracnaDemoState")
    assert not person.find(QWidget, "aracnaDemoNoise").isEnabled()
    person.press("aracnaDemoCable")
    person.wait(lambda: person.text("aracnaDemoState") == "The cable is in again. Press Connect.")
    person.click("connectButton")
    person.wait(lambda: person.robot.link is Link.UP)


def test_connecting_while_the_cable_is_out_says_what_to_do(person: Handler) -> None:
    pull_the_cable(person)
    person.click("connectButton")
    person.wait(lambda: "Tick “Plugged in” on its panel" in person.text("bannerText"))
    assert person.robot.link is Link.NONE
    assert person.panel.isVisible()
    assert person.text("statusLabel") == "Not connected."
    assert person.find(QAbstractButton, "connectButton").isEnabled()


def test_a_mute_line_looks_like_silence(person: Handler) -> None:
    person.press("aracnaDemoMute")
    person.wait(lambda: person.robot.link is Link.SILENT)
    person.press("aracnaDemoMute")
    person.wait(lambda: person.robot.link is Link.UP)


def test_noise_is_put_on_the_line_and_taken_off(person: Handler) -> None:
    person.slide("aracnaDemoNoise", 1)
    person.wait(lambda: person.truth.line.noise == pytest.approx(0.05))
    assert person.text("aracnaDemoNoiseValue") == "5.0\u00a0%"
    person.slide("aracnaDemoNoise", 0)
    person.wait(lambda: person.truth.line.noise == 0)


def test_an_answer_that_is_cut_in_the_middle_leaves_its_positions_unknown(
    person: Handler,
) -> None:
    person.move_and_wait()
    person.begin_to_move()
    person.choose("aracnaDemoLoss", "ANSWER_END")
    person.press("aracnaDemoLose")
    person.wait(lambda: person.robot.known.moving is None)
    assert None in person.robot.present
    assert "positions are not known" in person.text("aracnaReport")
    person.wait(lambda: person.robot.link is Link.UP)
    person.move_and_wait()
    assert None not in person.robot.present


def test_a_command_that_loses_a_byte_is_survived(person: Handler) -> None:
    """Most likely it is a question; in a move it would be a wrong value, or one too few."""
    person.move_and_wait()
    person.choose("aracnaDemoLoss", "COMMAND_BYTE")
    person.press("aracnaDemoLose")
    person.wait(lambda: person.dropped() > 0)
    person.wait(lambda: person.robot.link is Link.UP)


def test_an_answer_that_loses_a_byte_is_asked_for_again(person: Handler) -> None:
    person.choose("aracnaDemoLoss", "ANSWER_BYTE")
    person.press("aracnaDemoLose")
    person.wait(lambda: person.dropped() > 0)
    person.wait(lambda: person.robot.link is Link.UP)
    person.move_and_wait()


def test_everything_is_mended_at_once(person: Handler) -> None:
    for name in ("aracnaDemoDead1", "aracnaDemoBlocked2", "aracnaDemoMute", "aracnaDemoServoPower"):
        person.press(name)
    person.slide("aracnaDemoLoad3", 0.5)
    person.slide("aracnaDemoNoise", 0.5)
    person.wait(lambda: person.truth.servos[3].load > 0.4 and person.truth.line.noise > 0.02)
    assert person.truth.servos[1].dead
    assert person.truth.servos[2].blocked
    person.wait(lambda: person.robot.link is Link.SILENT)  # else it may be called so once mended
    person.press("aracnaDemoMend")
    person.wait(lambda: all(servo.is_whole for servo in person.truth.servos))
    person.wait(lambda: person.truth.servo_power and person.truth.line.noise == 0)
    assert not person.truth.line.mute
    for name in ("aracnaDemoDead1", "aracnaDemoBlocked2", "aracnaDemoMute"):
        assert not person.find(QCheckBox, name).isChecked()
    person.wait(lambda: person.robot.link is Link.UP)
    person.move_and_wait()


# --- When it is there -------------------------------------------------------------------


def test_there_is_no_panel_before_the_demo_is_chosen(program: Program, qtbot: QtBot) -> None:
    person = Handler(program, qtbot)
    assert person.panel.isHidden()
    assert not person.action("aracna_demo").isEnabled()


def test_the_panel_goes_with_the_demo_and_the_other_demo_has_its_own(person: Handler) -> None:
    other = person.find(QDockWidget, "demoPanel")
    assert person.program.window.dockWidgetArea(person.panel) is (
        Qt.DockWidgetArea.RightDockWidgetArea
    )
    assert other.isHidden()
    person.program.connect_to_demo("trex")
    person.wait(other.isVisible)
    assert person.panel.isHidden()
    assert not person.action("aracna_demo").isVisible()
    person.program.connect_to_demo("aracna")
    person.wait(person.panel.isVisible)
    assert other.isHidden()
    person.wait(lambda: person.robot.link is Link.UP)
    person.click("connectButton")
    person.wait(person.panel.isHidden)


def test_the_panel_is_not_there_with_a_real_port(person: Handler) -> None:
    person.program.connect_to_port("/dev/ttyNothing7", "aracna")
    person.wait(person.panel.isHidden)
    assert not person.action("aracna_demo").isEnabled()


def test_a_closed_panel_stays_closed_until_the_menu_brings_it_back(person: Handler) -> None:
    action = person.action("aracna_demo")
    assert action.isChecked()
    person.panel.close()
    assert not action.isChecked()
    person.click("connectButton")
    person.wait(lambda: person.robot.link is Link.NONE)
    person.connect_to_demo()
    assert person.panel.isHidden()
    action.trigger()
    person.wait(person.panel.isVisible)
    assert action.isChecked()


def test_nothing_is_asked_of_the_robot_while_nobody_sees_the_panel(person: Handler) -> None:
    person.action("aracna_demo").trigger()
    person.wait(person.panel.isHidden)
    person.ask_simulator()  # what was under way has been answered before
    person.robot.move((400,) * 8)
    person.wait(lambda: person.robot.known.moved is not None)
    assert person.truth.servos[0].position == 512
    person.action("aracna_demo").trigger()
    person.wait(lambda: person.truth.servos[0].position == person.robot.present[0])


# --- For everybody ----------------------------------------------------------------------

NAMES = {
    *("aracnaDemoPower", "aracnaDemoRestart", "aracnaDemoServoPower"),
    *(f"aracnaDemo{what}{motor}" for what in ("Load", "Dead", "Blocked") for motor in range(8)),
    *("aracnaDemoCable", "aracnaDemoMute", "aracnaDemoNoise", "aracnaDemoLoss", "aracnaDemoLose"),
    "aracnaDemoMend",
}


def test_every_control_has_a_name_for_those_who_cannot_see_it(person: Handler) -> None:
    kinds = (QAbstractButton, QAbstractSlider, QComboBox)
    found = [
        widget
        for widget in person.panel.findChildren(QWidget)
        if isinstance(widget, kinds) and widget.objectName().startswith("aracnaDemo")
    ]
    assert {widget.objectName() for widget in found} == NAMES
    spoken = []
    for widget in found:
        interface = QAccessible.queryAccessibleInterface(widget)
        assert interface is not None
        spoken.append(interface.text(QAccessible.Text.Name))
        assert widget.toolTip(), widget.objectName()
    assert all(spoken)
    assert len(set(spoken)) == len(spoken)
    assert_named(person.program.window)


def test_tab_reaches_every_control_in_the_order_of_the_panel(person: Handler) -> None:
    first = person.find(QAbstractButton, "aracnaDemoPower")
    person.program.window.activateWindow()
    first.setFocus()
    person.wait(first.hasFocus)
    reached = reached_by_tab("aracnaDemoMend")
    assert set(reached) == NAMES
    assert len(reached) == len(set(reached))
    assert stand_in_order(person.panel, reached)


@pytest.mark.parametrize("page", range(4))
def test_window_and_panel_fit_a_small_screen_without_anything_cut(
    person: Handler, page: int
) -> None:
    window = person.program.window
    window.pages.setCurrentIndex(page)
    window.resize(1054, 480)
    person.wait(lambda: (window.width(), window.height()) == (1054, 480))
    area = person.panel.findChild(QScrollArea)
    assert area is not None
    view = area.widget()
    assert view is not None
    person.wait(lambda: view.width() <= area.viewport().width())
    texts = (QAbstractButton, QComboBox, QLabel)
    for widget in view.findChildren(QWidget):
        if not widget.isVisible() or not widget.objectName().startswith("aracnaDemo"):
            continue
        place = QRect(widget.mapTo(view, QPoint()), widget.size())
        assert view.rect().contains(place), widget.objectName()
        if isinstance(widget, texts):
            assert widget.width() >= widget.minimumSizeHint().width(), widget.objectName()
    stop = person.find(QAbstractButton, "aracnaStopButton")
    assert window.rect().contains(QRect(stop.mapTo(window, QPoint()), stop.size()))
