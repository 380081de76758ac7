"""Faults of two boards that are driven together."""

from collections.abc import Callable
from dataclasses import dataclass

import pytest

from tests.support.pages.motors import MotorsPage
from tests.support.simulator import PortFault, StartSimulator
from tests.support.virtual_devices import VirtualSimulator
from tests.support.window import WindowDriver
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.ui.devices.connection import ConnectionState
from trex_gui.ui.runtime import now

HOLD_SECONDS, HEAL_SECONDS = 3.0, 5.0
OFF_SECONDS = 1.0  # as long as a hand needs for a switch; a shorter silence may pass unnoticed
SPARE = "@8"  # a board that may take the place of another one
NUMBERS = (7, 9)


class TwoDriven:
    """A window that drives boards 7 and 9, with its messages."""

    def __init__(self, window: WindowDriver, start: StartSimulator) -> None:
        options = [word for one in ("7", "9", "8:trexjr") for word in ("--device", one)]
        line = start(*options)
        assert isinstance(line, VirtualSimulator)
        self.window, self.line = window, line
        self.said: list[str] = []
        self.line.do(f"{SPARE} power off")
        self.connect()
        MotorsPage(window, line).arm()
        window.device.notifier.error.connect(self.said.append)
        window.device.notifier.danger.connect(self.said.append)
        window.motors.set_speeds(60, -60)
        window.wait(lambda: self.moving() == set(NUMBERS))

    def connect(self) -> None:
        window = self.window
        settings = ConnectionSettings(self.line.url).with_group(NUMBERS)
        port = window.program.ports.add_typed(self.line.url)
        window.program.device_manager.connect_with(port, settings)
        window.wait(lambda: window.device.is_connected and window.motors.is_available)

    def moving(self) -> set[int]:
        """Return the powered boards that drive a motor."""
        shown = {number: self.line.show(f"@{number}") for number in NUMBERS}
        return {
            number
            for number, one in shown.items()
            if one["power"] and any(motor["target_direction"] != "brake" for motor in one["motors"])
        }

    def let_pass(self, seconds: float) -> None:
        end = now() + seconds
        self.window.wait(lambda: now() >= end)


Act = Callable[[TwoDriven, int], object]


@dataclass(frozen=True, slots=True)
class Fault:
    """Event at a board. `stops`: it ends the drive with a message about the board."""

    inject: Act
    heal: Act = lambda _scene, _number: None
    stops: bool = True


def _board(*lines: str) -> Act:
    return lambda scene, number: scene.line.do(*(f"@{number} {line}" for line in lines))


def _line(*lines: str) -> Act:
    return lambda scene, _number: scene.line.do(*lines)


def _exchange(scene: TwoDriven, number: int) -> None:
    scene.line.do(f"@{number} power off", f"{SPARE} eeprom device_number {number}")
    scene.let_pass(OFF_SECONDS)
    scene.line.do(f"{SPARE} power on")


def _reset(scene: TwoDriven, number: int) -> None:
    scene.line.do(f"@{number} power off")
    scene.let_pass(OFF_SECONDS)
    scene.line.do(f"@{number} power on")


def _exchange_back(scene: TwoDriven, number: int) -> None:
    scene.line.do(f"{SPARE} power off", f"@{number} power on")


def _port(fault: PortFault) -> Act:
    return lambda scene, _number: scene.line.set_port_fault(fault)


OF_ONE = {
    "silent": Fault(_board("power off"), _board("power on")),
    "exchanged": Fault(_exchange, _exchange_back),
    "reset": Fault(_reset),
    "driver fault": Fault(_board("fault 1 on"), _board("fault 1 off")),
}
OF_LINE = {
    "unplugged": Fault(_line("line unplug"), _line("line plug")),
    "mute": Fault(_line("line mute on"), _line("line mute off")),
    "noisy": Fault(_line("line noise 0.01"), _line("line noise 0"), stops=False),
    "dropped": Fault(_line("line drop 3"), _line("line drop 0"), stops=False),
    "late": Fault(_line("line delay 0.3"), _line("line delay 0"), stops=False),
    "jammed": Fault(_port(PortFault.JAMMED), _port(PortFault.NONE)),
}


IN_GATE = {("silent", 9), ("reset", 7), ("exchanged", 9), ("driver fault", 9)}


@pytest.mark.parametrize(
    ("name", "number"),
    [
        pytest.param(name, one, marks=[] if (name, one) in IN_GATE else [pytest.mark.slow])
        for name in OF_ONE
        for one in NUMBERS
    ],
)
def test_board_that_fails_stops_both_and_is_named(
    name: str, number: int, window: WindowDriver, start_simulator: StartSimulator
) -> None:
    scene, fault = TwoDriven(window, start_simulator), OF_ONE[name]
    fault.inject(scene, number)
    scene.let_pass(HOLD_SECONDS)
    assert not scene.moving()
    assert not window.motors.armed
    said = [*scene.said, window.motors.stop_reason]
    assert any(f"oard {number}" in text for text in said), said
    fault.heal(scene, number)
    _check_recovery(scene)


@pytest.mark.parametrize(
    "name",
    [
        pytest.param(name, marks=[] if name in {"unplugged", "noisy"} else [pytest.mark.slow])
        for name in OF_LINE
    ],
)
def test_line_that_fails_leaves_no_motor_unnoticed(
    name: str, window: WindowDriver, start_simulator: StartSimulator
) -> None:
    scene, fault = TwoDriven(window, start_simulator), OF_LINE[name]
    fault.inject(scene, 0)
    scene.let_pass(HOLD_SECONDS)
    assert window.device.may_move or not scene.moving()
    assert not (window.motors.armed and fault.stops)
    assert window.motors.armed or scene.said or window.motors.stop_reason
    fault.heal(scene, 0)
    _check_recovery(scene)


def _check_recovery(scene: TwoDriven) -> None:
    """Both boards return stopped, and can be driven and stopped again."""
    window = scene.window
    scene.let_pass(HEAL_SECONDS)
    if window.device.link is ConnectionState.DISCONNECTED:
        scene.connect()
    window.wait(lambda: window.device.is_connected)
    window.program.device_manager.press_stop()
    window.wait(lambda: not window.device.may_move and not scene.moving())
    window.wait(lambda: window.motors.can_arm)
    window.motors.arm()
    window.motors.set_speeds(60, 60)
    window.wait(lambda: scene.moving() == set(NUMBERS))
    window.program.device_manager.press_stop()
    window.wait(lambda: not window.device.may_move and not scene.moving())
