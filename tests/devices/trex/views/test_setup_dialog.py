"""Dialog of the set-up assistant."""

from collections.abc import Callable, Iterator

import pytest
from PySide6.QtCore import QPoint, Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QMenu, QWidget
from pytestqt.qtbot import QtBot

from tests.support.accessible_names import spoken_state
from tests.support.keyboard import check_keyboard
from tests.support.pages.every_window import stop_button
from tests.support.robots import Robot
from tests.support.simulator import SimulatedDevice
from tests.support.window import LEFT, WidgetDriver, WindowDriver
from trex_gui.devices.trex.driving.requests import SetMotor
from trex_gui.devices.trex.model.learning.learning import Learning
from trex_gui.devices.trex.model.setup.pulses import WEAK
from trex_gui.devices.trex.model.setup.robot_setup import SetupStep
from trex_gui.devices.trex.model.setup.wiring import Driver
from trex_gui.devices.trex.views.learning.live_pages import InputStrip
from trex_gui.devices.trex.views.motor_controls import MotorBar
from trex_gui.devices.trex.views.setup.flow import SetupFlow
from trex_gui.devices.trex.views.steps import Steps
from trex_gui.ui.theme.theme import theme
from trex_gui.ui.widgets.behaviour import HoldButton
from trex_gui.ui.widgets.scroll_box import ScrollBox
from trex_gui.ui.widgets.step_strip import StepStrip

DRIVERS = {
    Driver.ONE_STICK: "setupDriverOneStick",
    Driver.TWO_STICKS: "setupDriverTwoSticks",
    Driver.COMPUTER: "setupDriverComputer",
}


def go_to(driver: WidgetDriver, dialog: QWidget, step: SetupStep) -> None:
    assert isinstance(dialog, Steps)
    assert isinstance(dialog.flow, SetupFlow)
    for _ in SetupStep:
        if dialog.flow.setup.step is not step:
            driver.click("setupNextButton")
    assert dialog.flow.setup.step is step


class SetupDriver(WidgetDriver):
    """Set-up dialog of a robot.

    Attributes:
        requests: all requested setpoints.
    """

    def __init__(self, robot: Robot, dialog: Steps, flow: SetupFlow, qtbot: QtBot) -> None:
        super().__init__(dialog, qtbot)
        self.robot = robot
        self.setup = robot.setup = flow.setup
        self.requests: list[SetMotor] = []
        robot.device.motors.requested.connect(self.requests.append)

    def arm(self) -> None:
        self.setup.go_to(SetupStep.MOTORS)
        if not self.button("setupWheelsFree").isChecked():
            self.click("setupWheelsFree")
        self.wait(lambda: self.is_enabled("setupRunButton"))
        self.click("setupRunButton")

    def hold(self, motor: int) -> HoldButton:
        button = self.find(HoldButton, f"setupHold{motor}")
        self.root.activateWindow()
        button.setFocus()
        self.wait(button.hasFocus)
        assert button.isEnabled()
        QTest.mousePress(button, LEFT)
        speeds = (WEAK, 0) if motor == 1 else (0, WEAK)
        self.wait(lambda: self.robot.speeds() == speeds)
        return button


@pytest.fixture
def setup_dialog(
    quick_simulator: SimulatedDevice, qtbot: QtBot, qapp: QApplication
) -> Iterator[SetupDriver]:
    theme().install(qapp)
    robot = Robot(quick_simulator, qtbot)
    flow = SetupFlow(robot.device, Learning(robot.device))
    dialog = Steps(robot.device, flow)
    qtbot.addWidget(dialog)
    robot.connect()
    flow.show_in_front()
    yield SetupDriver(robot, dialog, flow, qtbot)
    dialog.close()
    qtbot.waitUntil(robot.device.shut_down)


@pytest.mark.parametrize("driver", Driver)
def test_walk_through_all_steps_moves_no_motor(setup_dialog: SetupDriver, driver: Driver) -> None:
    setup_dialog.click(DRIVERS[driver])
    assert not setup_dialog.has("setupWiringPage")  # not created yet
    go_to(setup_dialog, setup_dialog.root, SetupStep.MOTORS)
    assert not setup_dialog.is_enabled("setupRunButton")
    setup_dialog.arm()
    for button in ("rightWheelBackward", "leftWheelForward"):
        setup_dialog.click(button)  # the second click is for motor 2
    assert "✓" in setup_dialog.button("setupAnswer2").text()
    visited: list[SetupStep] = []
    while setup_dialog.setup.step is not SetupStep.REVIEW:
        assert setup_dialog.setup.step not in visited
        visited.append(setup_dialog.setup.step)
        check_keyboard(setup_dialog.root)
        if setup_dialog.setup.step is SetupStep.LIMITS:
            setup_dialog.click("setupPresetTank")
        setup_dialog.click("setupNextButton")
    check_keyboard(setup_dialog.root)
    assert (SetupStep.TIMEOUT in visited) is (driver is Driver.COMPUTER)
    _, open_steps = setup_dialog.find_only(StepStrip).accessibleName().split("Not done: ")
    assert "Motors" in open_steps  # wires or sticks are not determined yet
    assert "Limits" not in open_steps
    assert ("wires of the right motor" in setup_dialog.text("setupOpenMotors")) is (
        driver is not Driver.TWO_STICKS
    )
    assert setup_dialog.find(QWidget, "setupOpenSticks").isVisible() is driver.uses_sticks
    setup_dialog.click("setupGoToMotorsButton")
    assert setup_dialog.find(QWidget, "setupWiringPage").isVisible()
    go_to(setup_dialog, setup_dialog.root, SetupStep.REVIEW)
    assert setup_dialog.robot.device.draft.pending > 0
    assert setup_dialog.is_enabled("setupNextButton")
    assert setup_dialog.root.focusWidget() is setup_dialog.button("setupNextButton")
    for _ in setup_dialog.setup.steps[1:]:
        setup_dialog.click("setupBackButton")
    assert not setup_dialog.is_enabled("setupBackButton")
    assert setup_dialog.requests == []
    assert setup_dialog.robot.speeds() == (0, 0)
    assert setup_dialog.robot.simulator.show()["parameters"]["motor1_acceleration"] == 0


def test_unclear_stick_is_explained_beside_its_input(setup_dialog: SetupDriver) -> None:
    robot = setup_dialog.robot
    go_to(setup_dialog, setup_dialog.root, SetupStep.STICKS)
    robot.push(1)
    setup_dialog.click("setupForwardButton")
    assert "not known yet" in setup_dialog.text("setupStick1Note")
    assert "near its centre" in setup_dialog.text("setupStick2Note")
    assert "Is the transmitter on?" in setup_dialog.text("setupStick2Note")
    strip = setup_dialog.find(InputStrip, "setup1Strip")
    setup_dialog.wait(lambda: spoken_state(strip).startswith("2000 µs"))
    robot.simulator.do("channel 2 silent")
    setup_dialog.wait(lambda: robot.device.telemetry.raw_of(2) is None)
    setup_dialog.click("setupForwardButton")
    assert "no signal arrives" in setup_dialog.text("setupStick2Note")
    robot.push(2)
    setup_dialog.click("setupForwardButton")
    assert "the value rises" in setup_dialog.text("setupStick2Note")
    robot.device.disconnect_line()
    setup_dialog.wait(lambda: spoken_state(strip).startswith("not known"))


def test_motor_bar_is_amber_while_armed(setup_dialog: SetupDriver) -> None:
    bar = setup_dialog.find_only(MotorBar)
    middle = bar.rect().center()
    assert bar.grab().toImage().pixelColor(middle) != theme().color("armed")
    setup_dialog.arm()
    setup_dialog.wait(lambda: setup_dialog.robot.device.motors.armed)
    assert bar.grab().toImage().pixelColor(middle) == theme().color("armed")


def test_enter_at_the_start_of_learning_does_not_skip_it(setup_dialog: SetupDriver) -> None:
    go_to(setup_dialog, setup_dialog.root, SetupStep.STICKS)
    setup_dialog.click("setupLearnButton")
    assert setup_dialog.root.focusWidget() is not setup_dialog.button("setupSkipButton")
    setup_dialog.wait(lambda: setup_dialog.has("learnRestPage"))
    setup_dialog.wait(
        lambda: setup_dialog.root.focusWidget() is setup_dialog.button("setupNextButton")
    )


def test_motors_need_no_horizontal_scrolling_with_large_fonts(setup_dialog: SetupDriver) -> None:
    theme().set_font_size(150)
    go_to(setup_dialog, setup_dialog.root, SetupStep.MOTORS)
    setup_dialog.root.resize(900, 540)
    page = setup_dialog.find(QWidget, "setupWiringPage")
    area = setup_dialog.find_only(ScrollBox)
    setup_dialog.wait(lambda: area.width() > 860)
    assert page.isVisible()
    assert not area.horizontalScrollBar().isVisible()


def test_held_button_moves_its_motor_only(setup_dialog: SetupDriver) -> None:
    setup_dialog.arm()
    for motor in (1, 2):
        button = setup_dialog.hold(motor)
        assert not setup_dialog.is_enabled(f"setupHold{3 - motor}")
        QTest.mouseRelease(button, LEFT)
        setup_dialog.wait(lambda: setup_dialog.robot.speeds() == (0, 0))
    assert {request.motor for request in setup_dialog.requests[:2]} == {1}
    setup_dialog.robot.simulator.do("fault 2 on")
    setup_dialog.wait_for_text("setupPulseNote", "its driver shut down")


def open_menu(setup_dialog: SetupDriver) -> None:
    """Open a menu. It receives the release of the mouse button instead of the hold button."""
    menu = QMenu(setup_dialog.root)
    menu.addAction("Anything")
    menu.popup(QPoint())
    setup_dialog.wait(lambda: setup_dialog.setup.pulses.motor == 0)
    menu.close()


ENDS: dict[str, Callable[[SetupDriver], object]] = {
    "the button is released": lambda dialog: QTest.mouseRelease(dialog.button("setupHold1"), LEFT),
    "a menu opens": open_menu,
    "the dialog is closed": lambda dialog: dialog.root.close(),
    "the next step is shown": lambda dialog: dialog.click("setupNextButton"),
    "the previous step is shown": lambda dialog: dialog.click("setupBackButton"),
    "the step is skipped": lambda dialog: dialog.click("setupSkipButton"),
    "the wheels are set down": lambda dialog: dialog.click("setupWheelsFree"),
    "Stop is pressed": lambda dialog: QTest.mousePress(stop_button(dialog.root), LEFT),
    "the line is closed": lambda dialog: dialog.robot.device.disconnect_line(),
    "the line is cut": lambda dialog: dialog.robot.simulator.do("line unplug"),
}
STAYS_ARMED = {"the button is released", "a menu opens"}
"""Interruptions after which the motor brakes but stays armed, as with every held control."""

CLOSING = ("the dialog is closed", "the line is closed", "the line is cut")
"""Interruptions that end the assistant."""


@pytest.mark.parametrize(
    "ends", [[end for end in ENDS if end not in CLOSING], *([end] for end in CLOSING)], ids=str
)
@pytest.mark.qt_log_ignore("This plugin does not support", extend=True)  # a popup
def test_every_interruption_stops_the_motor(setup_dialog: SetupDriver, ends: list[str]) -> None:
    robot = setup_dialog.robot
    for end in ends:
        if not robot.device.motors.armed:
            setup_dialog.arm()
        setup_dialog.hold(1)
        ENDS[end](setup_dialog)
        setup_dialog.wait(lambda: setup_dialog.setup.pulses.motor == 0)
        assert robot.device.motors.armed is (end in STAYS_ARMED), end
        if end == "the line is cut":
            return  # the board itself stops the motor
        setup_dialog.wait(lambda: robot.speeds() == (0, 0))
        robot.pass_time(2)
        assert robot.speeds() == (0, 0), end
        assert robot.device.motors.accelerate, end


def test_board_in_rc_mode_is_explained_and_followed(setup_dialog: SetupDriver) -> None:
    robot = setup_dialog.robot
    go_to(setup_dialog, setup_dialog.root, SetupStep.JUMPERS)
    setup_dialog.wait_for_text("setupModeCheck", "serial mode")
    robot.simulator.do("jumper mode rc", "power cycle")
    setup_dialog.wait_for_text("setupModeCheck", "in RC mode")
    assert "would drive the motors" in setup_dialog.text("setupMixCheck")
    go_to(setup_dialog, setup_dialog.root, SetupStep.STICKS)
    assert not setup_dialog.is_enabled("setupForwardButton")
    assert not setup_dialog.is_enabled("setupRightButton")
    go_to(setup_dialog, setup_dialog.root, SetupStep.MOTORS)
    assert setup_dialog.root.focusWidget() is setup_dialog.button("setupSkipButton")  # not Close
    assert "in RC mode" in setup_dialog.text("setupPulseNote")
    for name in ("setupWheelsFree", "setupRunButton", "setupHold1", "setupHold2"):
        assert not setup_dialog.is_enabled(name)
    setup_dialog.click("setupSkipButton")
    assert "rejects settings" in setup_dialog.text("setupNote")
    setup_dialog.click("setupPresetTank")
    assert not setup_dialog.is_enabled("setupNextButton")
    setup_dialog.click("setupSkipButton")
    assert not setup_dialog.is_enabled("setupNextButton")
    assert setup_dialog.root.focusWidget() is not setup_dialog.button("setupNextButton")
    assert robot.device.draft.pending == 0
    setup_dialog.click("setupBackButton")

    robot.simulator.do("jumper mode serial", "power cycle")
    setup_dialog.wait(lambda: "“Next” adds 6 changes" in setup_dialog.text("setupNote"))


def test_assistant_learns_drives_and_ends_in_the_review(
    connected_window: WindowDriver, quick_simulator: SimulatedDevice
) -> None:
    window = connected_window
    assert window.root.findChild(Steps, "setupDialog") is None
    window.click("setUpButton")
    dialog = window.find(Steps, "setupDialog")
    assert dialog.isVisible()
    assert not dialog.isModal()
    go_to(window, dialog, SetupStep.STICKS)
    window.click("setupLearnButton")
    window.wait(lambda: window.has("learnRestPage"))
    assert not window.dialog("learnDialog").root.isVisible(), "learning is a step of the assistant"
    window.click("setupBackButton")
    assert window.has("setupSticksPage")

    go_to(window, dialog, SetupStep.MOTORS)
    window.click("setupWheelsFree")
    window.wait(lambda: window.motors.can_arm)
    window.click("setupRunButton")
    button = window.find(HoldButton, "setupHold2")
    QTest.mousePress(button, LEFT)
    window.wait(lambda: window.motors.text == f"motor 2 +{WEAK}")
    QTest.keyClick(button, Qt.Key.Key_Escape)
    assert dialog.isVisible()
    assert not window.motors.armed
    assert window.motors.locked_for
    QTest.mouseRelease(button, LEFT)
    window.wait(lambda: quick_simulator.show()["motors"][1]["direction"] == "brake")

    go_to(window, dialog, SetupStep.LIMITS)
    window.click("setupPresetTank")
    window.click("setupNextButton")
    window.click("setupNextButton")
    assert window.find(QWidget, "reviewDialog").isVisible()
    dialog.close()
    assert window.device.draft.pending == 6
