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

HOLD_SECONDS, HEAL_SECONDS = 3.0, 5.0  # duration of a fault, and time to recover
OFF_SECONDS = 1.0  # a hand needs this long for a switch; shorter silences may be ignored
SPARE = "@8"  # board that replaces another board
NUMBERS = (7, 9)


class TwoBoardHarness:
    """Window that drives boards 7 and 9, with its messages."""

    def __init__(self, window: WindowDriver, start: StartSimulator) -> None:
        options = [word for board in ("7", "9", "8:trexjr") for word in ("--device", board)]
        line = start(*options)
        assert isinstance(line, VirtualSimulator)
        self.window, self.line = window, line
        self.messages: list[str] = []
        self.line.do(f"{SPARE} power off")
        self.connect()
        MotorsPage(window, line).arm()
        window.device.notifier.error.connect(self.messages.append)
        window.device.notifier.danger.connect(self.messages.append)
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
        states = {number: self.line.show(f"@{number}") for number in NUMBERS}
        return {
            number
            for number, state in states.items()
            if state["power"]
            and any(motor["target_direction"] != "brake" for motor in state["motors"])
        }

    def stop(self) -> None:
        self.window.program.device_manager.press_stop()
        self.window.wait(lambda: not self.window.device.may_move and not self.moving())


Action = Callable[[TwoBoardHarness, int], object]


@dataclass(frozen=True, slots=True)
class Fault:
    """Fault of a board or line. `stops`: true if the fault stops the motors."""

    inject: Action
    heal: Action = lambda _harness, _number: None
    stops: bool = True


def _board(*lines: str) -> Action:
    return lambda harness, number: harness.line.do(*(f"@{number} {line}" for line in lines))


def _line(*lines: str) -> Action:
    return lambda harness, _number: harness.line.do(*lines)


def _replace(harness: TwoBoardHarness, number: int) -> None:
    harness.line.do(f"@{number} power off", f"{SPARE} eeprom device_number {number}")
    harness.window.wait_seconds(OFF_SECONDS)
    harness.line.do(f"{SPARE} power on")


def _reset(harness: TwoBoardHarness, number: int) -> None:
    harness.line.do(f"@{number} power off")
    harness.window.wait_seconds(OFF_SECONDS)
    harness.line.do(f"@{number} power on")


def _restore(harness: TwoBoardHarness, number: int) -> None:
    harness.line.do(f"{SPARE} power off", f"@{number} power on")


def _port(fault: PortFault) -> Action:
    return lambda harness, _number: harness.line.set_port_fault(fault)


BOARD_FAULTS = {
    "silent": Fault(_board("power off"), _board("power on")),
    "replaced": Fault(_replace, _restore),
    "reset": Fault(_reset),
    "driver fault": Fault(_board("fault 1 on"), _board("fault 1 off")),
}
LINE_FAULTS = {
    "unplugged": Fault(_line("line unplug"), _line("line plug")),
    "mute": Fault(_line("line mute on"), _line("line mute off")),
    "noisy": Fault(_line("line noise 0.01"), _line("line noise 0"), stops=False),
    "dropped": Fault(_line("line drop 3"), _line("line drop 0"), stops=False),
    "late": Fault(_line("line delay 0.3"), _line("line delay 0"), stops=False),
    "jammed": Fault(_port(PortFault.JAMMED), _port(PortFault.NONE)),
}


IN_GATE = {("silent", 9), ("reset", 7), ("replaced", 9), ("driver fault", 9)}


@pytest.mark.parametrize(
    ("name", "number"),
    [
        pytest.param(name, number, marks=[] if (name, number) in IN_GATE else [pytest.mark.slow])
        for name in BOARD_FAULTS
        for number in NUMBERS
    ],
)
def test_fault_of_a_board_stops_both_and_names_the_board(
    name: str, number: int, window: WindowDriver, start_simulator: StartSimulator
) -> None:
    harness, fault = TwoBoardHarness(window, start_simulator), BOARD_FAULTS[name]
    fault.inject(harness, number)
    harness.window.wait_seconds(HOLD_SECONDS)
    assert not harness.moving()
    assert not window.motors.armed
    messages = [*harness.messages, window.motors.stop_reason]
    assert any(f"oard {number}" in text for text in messages), messages
    fault.heal(harness, number)
    _check_recovery(harness)


@pytest.mark.parametrize(
    "name",
    [
        pytest.param(name, marks=[] if name in {"unplugged", "noisy"} else [pytest.mark.slow])
        for name in LINE_FAULTS
    ],
)
def test_fault_of_the_line_stops_motors_or_shows_they_may_run(
    name: str, window: WindowDriver, start_simulator: StartSimulator
) -> None:
    harness, fault = TwoBoardHarness(window, start_simulator), LINE_FAULTS[name]
    fault.inject(harness, 0)
    harness.window.wait_seconds(HOLD_SECONDS)
    assert window.device.may_move or not harness.moving()
    assert not (window.motors.armed and fault.stops)
    assert window.motors.armed or harness.messages or window.motors.stop_reason
    fault.heal(harness, 0)
    _check_recovery(harness)


def _check_recovery(harness: TwoBoardHarness) -> None:
    """Check that both boards can be connected, driven and stopped again."""
    window = harness.window
    harness.window.wait_seconds(HEAL_SECONDS)
    if window.device.link is ConnectionState.DISCONNECTED:
        harness.connect()
    window.wait(lambda: window.device.is_connected)
    harness.stop()
    window.wait(lambda: window.motors.can_arm)
    window.motors.arm()
    window.motors.set_speeds(60, 60)
    window.wait(lambda: harness.moving() == set(NUMBERS))
    harness.stop()
