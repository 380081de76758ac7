"""Operation of the Demo TReX on its panel."""

import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QCheckBox, QDockWidget

from tests.support.pages.channels import input_of
from tests.support.program import trex
from tests.support.simulator import SimulatedDevice
from tests.support.window import WidgetDriver, WindowDriver
from trex_gui.devices.trex.model.demo import DemoJumpers, DemoSnapshot
from trex_gui.devices.trex.protocol.flags import CHANNELS
from trex_gui.devices.trex.views.board.parts import MotorPart
from trex_gui.ui.devices.connection import ConnectionState
from trex_gui.ui.widgets.sliders import StickSlider


class DemoPanel(WidgetDriver):
    def __init__(self, window: WindowDriver) -> None:
        super().__init__(window.find(QDockWidget, "demoPanel"), window.qtbot)
        self._window = window
        self._demo = trex(window.program).controller.demo_board

    @property
    def board(self) -> DemoSnapshot:
        snapshot = self._demo.snapshot
        assert snapshot is not None
        return snapshot

    def wait_for(self, link: ConnectionState) -> None:
        self.wait(lambda: self._window.device.link is link)

    def drag_stick(self, name: str, share: float) -> StickSlider:
        """Drag a slider to a share of its range."""
        slider = self.find(StickSlider, name)
        span = slider.maximum() - slider.minimum()
        self.drag(name, slider.minimum() + round(share * span))
        return slider

    def pull_cable(self) -> None:
        self.click("demoCable")
        self.wait_for(ConnectionState.DISCONNECTED)
        self.wait(lambda: not self.board.line.plugged)

    def plug_cable(self) -> None:
        self.click("demoCable")
        self.wait(lambda: self.board.line.plugged)


@pytest.fixture
def panel(window: WindowDriver) -> DemoPanel:
    """Panel of the connected Demo TReX."""
    window.connect_to_demo()
    window.wait(lambda: trex(window.program).controller.demo_board.snapshot is not None)
    panel = DemoPanel(window)
    assert panel.root.isVisible()
    return panel


def test_stick_sliders_set_channel_inputs(window: WindowDriver, panel: DemoPanel) -> None:
    telemetry = window.device.telemetry
    window.wait(lambda: telemetry.raw is not None)
    first = telemetry.raw
    window.wait(lambda: telemetry.raw != first)

    page = window.open_page("channelsPage")
    expected = 900 + panel.drag_stick("demoInput1", 0.9).value()
    assert 1900 < expected < 2100
    page.wait(lambda: input_of(page, 1).startswith(f"{expected} µs"))
    panel.wait(lambda: panel.text("demoValue1") == f"{expected}\u00a0µs")
    automatic = panel.find(QCheckBox, "demoAutomatic")
    assert not automatic.isChecked()

    slider = panel.find(StickSlider, "demoInput3")
    slider.setFocus()
    QTest.keyClick(slider, Qt.Key.Key_Delete)
    page.wait(lambda: "no signal" in input_of(page, 3))
    panel.wait(lambda: not panel.is_enabled("demoInput3"))
    panel.click("demoNoSignal3")
    page.wait(lambda: "µs" in input_of(page, 3))

    panel.click("demoAutomatic")
    assert trex(window.program).controller.demo_board.automatic == set(CHANNELS)
    slider = panel.find(StickSlider, "demoInput1")
    before = slider.value()
    panel.wait(lambda: slider.value() != before)

    window.trigger("learn")
    learning = WidgetDriver(window.dialog("learnDialog").root, window.qtbot)
    learning.wait_for_text("learnNote", "Release every stick")
    assert trex(window.program).controller.demo_board.automatic == frozenset()


def test_pressed_parts_of_the_drawing_change_the_board(panel: DemoPanel) -> None:
    for mode in ("rc", "analog", "serial"):
        panel.click("demoMode")
        panel.wait(lambda: panel.board.jumpers.mode == mode)  # noqa: B023 - called at once
    for name in ("demoMix", "demoSoGround", "demoFault2"):
        QTest.keyClick(panel.button(name), Qt.Key.Key_Space)
    panel.wait(lambda: panel.board.jumpers == DemoJumpers("serial", mix=True, so_ground=True))
    panel.wait(lambda: panel.board.motors[1].fault)


def test_motors_draw_current_and_keep_running_when_unplugged(
    window: WindowDriver, panel: DemoPanel
) -> None:
    panel.drag_stick("demoLoad1", 0.3)
    window.motors.arm()
    window.motors.set_speed(1, 127)
    panel.wait(lambda: panel.board.motors[0].speed == 127)
    panel.wait(lambda: panel.board.motors[0].current > 5)
    motor = panel.find(MotorPart, "demoFault1")
    panel.wait(lambda: motor.spoken_state().startswith("forward 127, "))

    panel.pull_cable()
    assert "may still be turning" in window.text("motorStateLabel")
    assert "forward 127" in motor.spoken_state()
    panel.plug_cable()
    window.click("connectButton")
    panel.wait_for(ConnectionState.CONNECTED)
    panel.wait(lambda: panel.board.motors[0].direction == "brake")
    panel.wait(lambda: not window.device.may_move)


def test_cable_is_unplugged_and_plugged_in_again(
    window: WindowDriver, panel: DemoPanel, quick_simulator: SimulatedDevice
) -> None:
    panel.pull_cable()
    assert "is gone" in window.text("bannerText")
    assert panel.root.isVisible()
    panel.wait_for_text("demoState", "The cable is unplugged")
    assert not panel.is_enabled("demoNoise")

    window.click("bannerReconnect")
    assert "Plug the cable in on the demo panel" in window.text("bannerText")
    assert window.device.link is ConnectionState.DISCONNECTED
    assert panel.root.isVisible()
    assert window.text("statusLabel") == "Not connected"
    assert window.is_enabled("connectButton")

    panel.click("demoCable")
    panel.wait(lambda: panel.text("demoState") == "The cable is plugged in again. Press Connect.")
    window.click("bannerReconnect")
    panel.wait_for(ConnectionState.CONNECTED)
    panel.wait(lambda: panel.text("demoState").startswith("Serial commands"))
    assert trex(window.program).controller.port == window.program.ports.demo_of("trex")
    controller = trex(window.program).controller

    panel.pull_cable()
    window.connect(quick_simulator.url)
    assert panel.root.isHidden()
    controller.connect_to(window.program.ports.demo_of("trex"))
    panel.wait_for(ConnectionState.DISCONNECTED)
    assert controller.port is None, "the other board is disconnected"
    assert "Plug the cable in on the demo panel" in window.text("bannerText")
    assert panel.root.isVisible()
    panel.plug_cable()
    window.connect_port(window.program.ports.demo_of("trex"))
    panel.wait_for(ConnectionState.CONNECTED)

    panel.click("demoPower")
    panel.pull_cable()
    panel.plug_cable()
    panel.wait_for_text("demoState", "Switch it on")
