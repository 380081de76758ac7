"""Simulated robot with two wheels, and the assistant that sets it up."""

from collections.abc import Callable

from pytestqt.qtbot import QtBot

from tests.support.pages.motors import signed_speeds
from tests.support.simulator import SimulatedDevice
from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.model.learning.learning import Learning
from trex_gui.devices.trex.model.setup.robot_setup import RobotSetup, SetupStep
from trex_gui.devices.trex.model.setup.wiring import Driver, Movement, Side
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.ui.runtime import now


class Robot:
    """Simulated board with two wheels.

    Attributes:
        motors: side of a wheel → number of its motor.
        directions: side of a wheel → 1, or -1 if it turns backward while its motor runs forward.
        pushed: pulse of a stick that is pushed forward or right, in µs.
    """

    def __init__(self, simulator: SimulatedDevice, qtbot: QtBot) -> None:
        self.device = Device()
        self.setup = RobotSetup(self.device, Learning(self.device))
        self.simulator = simulator
        self.qtbot = qtbot
        self.motors = {Side.LEFT: 1, Side.RIGHT: 2}
        self.directions = {Side.LEFT: 1, Side.RIGHT: 1}
        self.pushed = 2000

    def wait(self, condition: Callable[[], object]) -> None:
        self.qtbot.waitUntil(lambda: bool(condition()))

    def pass_time(self, seconds: float) -> None:
        end = now() + seconds
        self.wait(lambda: now() >= end)

    def connect(self) -> None:
        self.device.connect_to(ConnectionSettings(self.simulator.url))
        self.wait(lambda: self.device.telemetry.motor_currents is not None)
        self.wait(lambda: self.device.motors.is_available)
        self.device.motors.accept_arming_without_timeout()

    def speeds(self) -> tuple[int, int]:
        first, second = signed_speeds(self.simulator)
        return first, second

    def wheels(self) -> dict[Side, int]:
        """Return the direction of each wheel: 1 forward, -1 backward, 0 stopped."""
        speeds = self.speeds()
        turns = {side: speeds[self.motors[side] - 1] * self.directions[side] for side in Side}
        return {side: (turn > 0) - (turn < 0) for side, turn in turns.items()}

    def exchange_motors(self) -> None:
        self.motors = {side: 3 - motor for side, motor in self.motors.items()}

    def exchange_wires(self, side: Side) -> None:
        self.directions[side] *= -1

    def arm(self) -> None:
        self.setup.pulses.confirm_wheels(True)
        self.device.motors.arm()
        assert self.device.motors.armed

    def go_to(self, step: SetupStep) -> None:
        self.setup.go_to(SetupStep.DRIVER)
        for _ in SetupStep:
            if self.setup.step is not step:
                self.setup.skip()
        assert self.setup.step is step

    def find_motors(self) -> None:
        """Pulse each motor and record the wheel that turns."""
        setup = self.setup
        self.arm()
        for motor in (1, 2):
            assert setup.pulses.start(motor), setup.pulses.blocker
            self.wait(lambda: any(self.wheels().values()))
            ((side, turn),) = ((side, turn) for side, turn in self.wheels().items() if turn)
            setup.pulses.release()
            self.wait(lambda: self.speeds() == (0, 0))
            movements = (each for each in Movement if (each.side, each.forward) == (side, turn > 0))
            setup.record_movement(motor, next(movements))

    def push(self, *channels: int) -> None:
        for channel in (1, 2):
            width = self.pushed if channel in channels else 1500
            self.simulator.do(f"channel {channel} {width}us")
        self.pass_time(0.3)

    def show_sticks(self) -> None:
        """Push each stick and record it: a single stick forward, then right."""
        one_stick = self.setup.driver is Driver.ONE_STICK
        for channels in ((2,), (1,)) if one_stick else ((1, 2),):
            self.push(*channels)
            assert self.setup.record_pushed(channels) == ()
        self.push()

    def apply(self) -> None:
        self.device.writer.apply()
        self.wait(lambda: not self.device.draft.pending and not self.device.writer.running)

    def start_in_rc_mode(self) -> None:
        self.simulator.do("jumper mode rc")
        is_mixed = self.setup.driver is Driver.ONE_STICK
        self.simulator.do(f"jumper mix {'on' if is_mixed else 'off'}")
        for channel in range(1, 6):
            self.simulator.do(f"channel {channel} 1500us")
        self.simulator.do("power cycle")
        self.pass_time(2)

    def turns_when_pushed(self, *channels: int) -> dict[Side, int]:
        self.push(*channels)
        turns = self.wheels()
        self.push()
        return turns
