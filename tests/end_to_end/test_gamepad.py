"""A gamepad that exists only in SDL drives a simulated board through the whole window."""

from collections.abc import Iterator

import pytest

from tests.gamepad.virtual_pad import VirtualPad
from tests.support.pages.gamepad_panel import GamepadPanelPage, Y
from tests.support.pages.motors import MotorsPage
from tests.support.simulator import SimulatedDevice
from tests.support.window import WindowDriver
from trex_gui.devices.trex.views.pages.motors.gamepad_panel import GamepadPanel

HOLD, STOP = 9, 1  # of SDL's virtual gamepads: left shoulder, B


class GamepadPage(MotorsPage):
    """The Motors page with the gamepad switched on and plugged in."""

    def __init__(self, window: WindowDriver, simulator: SimulatedDevice) -> None:
        super().__init__(window, simulator)
        self.motors.accelerate = False
        self.click("gamepadBox")
        self.plug_in()

    def plug_in(self) -> None:
        self.gamepad = VirtualPad()
        panel = self.find(GamepadPanel, "gamepadPanel")
        self.panel = GamepadPanelPage(panel, self.device, self.gamepad, self.qtbot)
        self.wait(lambda: self.panel.gamepad.pad is not None)

    def wait_for_motors(self, direction: str) -> None:
        """Wait until both motors go this way, and are meant to."""

        def check() -> None:
            for motor in self.simulator.show()["motors"]:
                assert motor["direction"] == motor["target_direction"] == direction
                assert motor["speed"] >= 40

        self.qtbot.waitUntil(check, timeout=20_000)

    def drive(self) -> None:
        self.panel.drive()
        self.wait_for_motors("forward")

    def release(self) -> None:
        """Let go of stick and buttons."""
        self.gamepad.move(Y, 0.0)
        for button in (HOLD, STOP):
            self.gamepad.press(button, down=False)


@pytest.fixture
def page(connected_window: WindowDriver, quick_simulator: SimulatedDevice) -> Iterator[GamepadPage]:
    page = GamepadPage(connected_window, quick_simulator)
    yield page
    page.panel.gamepad.switch_off()


def test_gamepad_stop_button_works_on_other_pages(page: GamepadPage) -> None:
    for name in ("statusPage", "currentsPage", "parametersPage"):
        page.open_page(name)
        page.motors.arm()
        page.motors.set_speed(1, 60)
        page.motors.set_speed(2, 60)
        page.wait_for_motors("forward")
        page.gamepad.press(STOP)
        page.wait_for_motors("brake")
        assert not page.is_armed(), name
        page.release()
        page.let_nothing_happen(0.1)  # the button goes up
        assert not page.is_armed(), name
