"""Panel of the Demo Aracna."""

from dataclasses import replace

import pytest
from PySide6.QtWidgets import QCheckBox, QDockWidget, QProgressBar

from tests.support.pages.robot import RobotWindow
from tests.support.program import aracna
from tests.support.window import WidgetDriver
from trex_gui.devices.aracna.model.demo import FirmwareState, RobotSnapshot
from trex_gui.devices.aracna.views.demo import DemoRobotView
from trex_gui.ui.devices.connection import ConnectionState
from trex_gui.ui.widgets.leds import Lamp
from trex_gui.ui.widgets.sliders import StickSlider


class DemoRobotPanel(WidgetDriver):
    def __init__(self, window: RobotWindow) -> None:
        self.dock = window.find(QDockWidget, "aracnaDemoPanel")
        super().__init__(self.dock, window.qtbot)
        self.window = window
        self.robot = window.robot

    @property
    def snapshot(self) -> RobotSnapshot:
        """Last reported state of the simulated robot."""
        snapshot = aracna(self.window.program).controller.demo_robot.snapshot
        assert snapshot is not None
        return snapshot

    def gauge(self, motor: int) -> QProgressBar:
        return self.find(QProgressBar, f"aracnaDemoGauge{motor}")

    def start_motion(self, goal: int = 100, speed: int = 40) -> None:
        """Start a slow motion of all motors, which takes 4.5 s."""
        self.robot.set_speeds((speed,) * self.robot.state.motors)
        self.robot.move((goal,) * self.robot.state.motors)
        self.wait(lambda: self.snapshot.state is FirmwareState.MOVING and self.snapshot.is_moving)


@pytest.fixture
def panel(connected_window: RobotWindow) -> DemoRobotPanel:
    """Return the panel of a connected Demo Aracna."""
    panel = DemoRobotPanel(connected_window)
    panel.wait(panel.dock.isVisible)
    panel.wait(lambda: aracna(connected_window.program).controller.demo_robot.snapshot is not None)
    return panel


# --- Servos -----------------------------------------------------------------------------


def test_panel_shows_servo_positions_before_robot_reports_them(panel: DemoRobotPanel) -> None:
    assert panel.window.text("aracnaPresent0") == "–", "not reported by the robot yet"
    panel.wait_for_text("aracnaDemoPosition0", "512")
    assert "limp" in panel.gauge(0).toolTip()
    panel.wait_for_text("aracnaDemoState", "Idle")

    panel.start_motion()
    assert "Moving" in panel.text("aracnaDemoState")
    gauge = panel.gauge(7)
    panel.wait(lambda: 110 < gauge.value() < 500)
    assert panel.robot.state.moving is not None
    assert "moving to 100" in gauge.toolTip()
    panel.wait(lambda: panel.robot.state.moved is not None)
    panel.wait(lambda: panel.text("aracnaDemoPosition7") == str(panel.robot.state.present[7]))
    panel.wait(lambda: "holds" in gauge.toolTip())
    panel.wait_for_text("aracnaDemoState", "Idle")


def test_lamp_and_its_text_follow_debug_led(panel: DemoRobotPanel) -> None:
    view, lamp = panel.find_only(DemoRobotView), panel.find(Lamp, "aracnaDemoLed")
    for state, led, text in (
        (FirmwareState.BOOTING, True, "LED: blinks"),
        (FirmwareState.BOOTING, False, "LED: blinks"),
        (FirmwareState.IDLE, True, "LED: on"),
        (FirmwareState.MOVING, False, "LED: off"),
    ):
        view.show_header(replace(panel.snapshot, state=state, led=led))
        assert panel.text("aracnaDemoLedText") == text, state
        assert lamp.lit is led, state
        assert lamp.accessibleName() == text, state


# --- Power ------------------------------------------------------------------------------


def test_board_can_be_restarted_and_switched_off(panel: DemoRobotPanel) -> None:
    window, robot = panel.window, panel.robot
    panel.start_motion(speed=15)
    window.wait_for_silence(lambda: panel.click("aracnaDemoRestart"))
    panel.wait_for_text("aracnaDemoBoots", "Starts: 2")
    assert panel.snapshot.is_moving, "the servos keep moving"
    window.wait_until_up()
    panel.wait_for_text("aracnaDemoState", "Idle")

    panel.click("aracnaDemoPower")
    panel.wait(lambda: robot.link is ConnectionState.NOT_RESPONDING)
    assert "not responding" in window.text("statusLabel")
    panel.wait_for_text("aracnaDemoState", "power is off")
    assert not panel.is_enabled("aracnaDemoRestart")
    panel.click("aracnaDemoPower")
    window.wait_until_up()
    panel.wait(lambda: panel.snapshot.servo_power)


# --- The cable --------------------------------------------------------------------------


def test_faults_last_until_they_are_cleared(panel: DemoRobotPanel) -> None:
    window = panel.window
    panel.start_motion()
    panel.click("aracnaDemoCable")
    panel.wait(lambda: panel.robot.link is ConnectionState.DISCONNECTED)
    assert "ends by itself" in window.text("aracnaMotionLabel")
    panel.click("aracnaDemoCable")
    panel.wait_for_text("aracnaDemoState", "plugged in again")
    window.press_connect()

    for name in ("aracnaDemoDead1", "aracnaDemoBlocked2", "aracnaDemoMute", "aracnaDemoServoPower"):
        panel.click(name)
    noise = panel.find(StickSlider, "aracnaDemoNoise")
    panel.drag("aracnaDemoNoise", noise.maximum() // 2)
    panel.wait(lambda: panel.snapshot.line.noise > 0.02)
    assert panel.snapshot.servos[1].dead
    assert panel.snapshot.servos[2].blocked
    assert panel.text("aracnaDemoNoiseValue") == "2.5\u00a0%"
    panel.wait(
        lambda: panel.robot.link is ConnectionState.NOT_RESPONDING
    )  # otherwise the next text may be outdated

    panel.click("aracnaDemoRepair")
    panel.wait(lambda: not any(servo.dead or servo.blocked for servo in panel.snapshot.servos))
    panel.wait(lambda: panel.snapshot.servo_power and panel.snapshot.line.noise == 0)
    assert not panel.snapshot.line.mute
    for name in ("aracnaDemoDead1", "aracnaDemoBlocked2", "aracnaDemoMute"):
        assert not panel.find(QCheckBox, name).isChecked(), name
    window.wait_until_up()
    window.move()
