"""A gamepad that exists only in SDL drives a simulated board through the whole window."""

from tests.gamepad.virtual_pad import VirtualPad
from tests.support.pages.gamepad_panel import GamepadPanelPage, Y
from tests.support.pages.motors import MotorsPage, is_stopped
from tests.support.simulator import SimulatedDevice
from tests.support.window import WindowDriver
from trex_gui.devices.trex.views.pages.motors.gamepad_panel import GamepadPanel

HOLD, STOP = 9, 1  # of SDL's virtual gamepads: left shoulder, B


def test_gamepad_drives_and_its_stop_button_works_on_other_pages(
    connected_window: WindowDriver, quick_simulator: SimulatedDevice
) -> None:
    page = MotorsPage(connected_window, quick_simulator)
    page.motors.accelerate = False
    page.click("gamepadBox")  # loads SDL
    pad = VirtualPad()
    widget = page.find(GamepadPanel, "gamepadPanel")
    panel = GamepadPanelPage(widget, page.device, pad, page.qtbot)
    page.wait(lambda: panel.gamepad.pad is not None)

    def runs() -> bool:
        motors = quick_simulator.show()["motors"]
        return all(each["direction"] == "forward" and each["speed"] >= 40 for each in motors)

    panel.drive()
    page.wait(runs)
    pad.press(HOLD, down=False)
    page.wait(lambda: is_stopped(quick_simulator))
    assert page.is_armed()
    pad.move(Y, 0.0)
    for name in ("statusPage", "currentsPage", "parametersPage"):
        page.open_page(name)
        page.motors.arm()
        page.motors.set_speed(1, 60)
        page.motors.set_speed(2, 60)
        page.wait(runs)
        pad.press(STOP)
        page.wait(lambda: is_stopped(quick_simulator))
        assert not page.is_armed(), name
        pad.press(STOP, down=False)
        page.let_nothing_happen(0.1)  # the button goes up
        assert not page.is_armed(), name
    panel.gamepad.switch_off()
