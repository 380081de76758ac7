"""Motor outputs, updated 100 times a second, and serial motor commands.

Ref: TReX 1.0 command documentation 0x84, 0x85, 0xC0-0xF1; User's Guide 5.b.
"""

import math
from collections.abc import Callable, Sequence
from enum import Enum
from functools import partial
from typing import NamedTuple

from trex_gui.devices.trex.protocol.flags import Status, UartError

FULL_SPEED = 127


class MotorDirection(Enum):
    BRAKE = "brake"
    REVERSE = "reverse"
    FORWARD = "forward"

    @classmethod
    def from_bits(cls, bits: int) -> "MotorDirection":
        return (cls.BRAKE, cls.REVERSE, cls.FORWARD, cls.BRAKE)[bits & 3]


class MotorSettings(NamedTuple):
    """Parameters of one motor (0x0E-0x16)."""

    acceleration: int = 0
    brake_duration: int = 0
    current_limit: int = 0  # 0 means no limit
    current_limit_p: int = 0


class Motor:
    """Output for a motor with two directions.

    During braking, `speed` is the duty cycle, from 127 (full brake) to 0 (coast).
    """

    def __init__(self) -> None:
        self.direction = MotorDirection.BRAKE
        self.target_direction = MotorDirection.BRAKE
        self.target_speed = 0
        self._tenths = 0  # speed in tenths; each update adds at most the acceleration
        self._driven = MotorDirection.BRAKE  # last direction in which the motor ran
        self._braked = 0  # number of braking updates since the motor ran

    @property
    def speed(self) -> int:
        return self._tenths // 10

    def set(self, direction: MotorDirection, speed: int) -> None:
        self.accelerate(direction, speed)
        self._output(direction, speed * 10)
        self._braked = 0

    def accelerate(self, direction: MotorDirection, speed: int) -> None:
        self.target_direction = direction
        self.target_speed = speed

    def update(self, settings: MotorSettings, current: int) -> bool:
        """Advance by 10 ms. Return whether the current, in counts, is over the limit."""
        limit = 2 * settings.current_limit  # counts; the parameter has steps of two counts
        is_over_limit = 0 < limit < current
        if is_over_limit and self.direction is self.target_direction is not MotorDirection.BRAKE:
            self._limit(settings.current_limit_p, current - limit)
        else:
            self._follow_target(settings)
        return is_over_limit

    def _limit(self, gain: int, excess: int) -> None:
        """Lower the speed immediately, in proportion to the excess. The formula is inferred."""
        reduction = math.ceil(gain * excess / 16) if gain else FULL_SPEED
        tenths = min(self._tenths, self.target_speed * 10) - 10 * reduction
        self._tenths = max(0, tenths)

    def _follow_target(self, settings: MotorSettings) -> None:
        target = self.target_direction
        if target is MotorDirection.BRAKE:
            self._brake(self.target_speed)
            return
        if self.direction is not target:
            # Inferred: earlier braking counts towards the brake duration, and a motor that resumes
            # its previous direction does not brake. The brake duration is a number of updates of
            # 10 ms.
            reverses = self._driven not in {target, MotorDirection.BRAKE}
            if reverses and self._braked < settings.brake_duration:
                self._brake(FULL_SPEED)
                return
            self._output(target, 0)
        self._output(target, _ramp(self._tenths, self.target_speed * 10, settings.acceleration))

    def _brake(self, duty: int) -> None:
        self._output(MotorDirection.BRAKE, duty * 10)
        self._braked += 1

    def _output(self, direction: MotorDirection, tenths: int) -> None:
        self.direction = direction
        self._tenths = tenths
        if direction is not MotorDirection.BRAKE:
            self._driven = direction
            self._braked = 0


class AuxiliaryMotor:
    """Third output. It has one direction, no brake (inferred) and no current sensing."""

    def __init__(self) -> None:
        self.target_speed = 0
        self._tenths = 0

    @property
    def speed(self) -> int:
        return self._tenths // 10

    def set(self, speed: int) -> None:
        self.target_speed = speed
        self._tenths = speed * 10

    def accelerate(self, speed: int) -> None:
        self.target_speed = speed

    def update(self, acceleration: int) -> None:
        self._tenths = _ramp(self._tenths, self.target_speed * 10, acceleration)


def _ramp(tenths: int, target: int, acceleration: int) -> int:
    """Return the speed after one update, in tenths of a count. Acceleration 0 means no ramp."""
    if acceleration == 0 or tenths >= target:
        return target  # the speed falls without a ramp
    return min(tenths + acceleration, target)


class SerialControl:
    """Latest serial commands to the motors, and the latched bits."""

    def __init__(
        self, motors: Sequence[Motor], aux: AuxiliaryMotor, *, joint: bool, in_control: bool
    ) -> None:
        self.in_control = in_control  # True if the motors obey serial commands
        self.status = Status(0)
        self.uart_errors = UartError(0)
        self.errors = 0  # number of UART errors, without timeouts
        self._motors = motors
        self._aux = aux
        self._joint = joint
        self._stops: tuple[Callable[[], None], ...] = (
            *(partial(motor.set, MotorDirection.BRAKE, FULL_SPEED) for motor in motors),
            partial(aux.set, 0),
        )
        self._commands = list(self._stops)  # commands to motors 1 and 2 and the auxiliary motor
        # Time of the last byte in seconds. Inferred: the timeout starts with the first byte.
        self.last_byte = math.inf

    def drive(
        self, number: int, direction: MotorDirection, speed: int, *, accelerate: bool = False
    ) -> None:
        """Drive motor 1 or 2 at 0-127. Without serial control, only save the command.

        Inferred: joint mode ignores commands to motor 2.
        """
        if self._joint and number == 2:
            return
        motor = self._motors[number - 1]
        drive = motor.accelerate if accelerate else motor.set
        self._command(number - 1, partial(drive, direction, speed))

    def drive_aux(self, speed: int, *, accelerate: bool = False) -> None:
        drive = self._aux.accelerate if accelerate else self._aux.set
        self._command(2, partial(drive, speed))

    def _command(self, index: int, command: Callable[[], None]) -> None:
        self._commands[index] = command
        if self.in_control:
            command()

    def set_control(self, now: float, timeout: int, *, in_control: bool, shut_down: bool) -> None:
        """Start or end serial control. At the start, apply the latest commands.

        Commands that arrived before serial control apply, too (User's Guide 4.a). Inferred: a motor
        without a command stops. With `shut_down`, all motors stop if the serial timeout has
        expired. `timeout` is in tenths of a second, or 0 if the serial timeout is off.
        """
        has_gained = in_control and not self.in_control
        self.in_control = in_control
        if has_gained:
            self.check_timeout(now, timeout, shut_down=shut_down)
            for command in self._commands:
                command()

    def stop_motors(self) -> None:
        """Brake both motors fully (inferred). The auxiliary motor coasts."""
        for stop in self._stops:
            stop()

    def check_timeout(self, now: float, timeout: int, *, shut_down: bool) -> None:
        """Latch the error after `timeout` tenths of a second without a byte. 0 means never.

        Inferred: the error occurs only in serial control, and is latched once per timeout.
        """
        if timeout and self.in_control and now - self.last_byte >= timeout * 0.1 - 1e-9:
            self.last_byte = math.inf
            self.uart_errors |= UartError.TIMEOUT
            self.status |= Status.UART_ERROR
            if shut_down:
                self._shut_down()

    def report(self, error: UartError, *, shut_down: bool) -> None:
        """Latch a UART error. `shut_down` stops the motors.

        The lost command may be a stop, so `shut_down` also drops the latest commands.
        """
        self.errors += 1
        self.uart_errors |= error
        self.status |= Status.UART_ERROR
        if shut_down:
            self._shut_down()

    def pop_status(self) -> Status:
        status, self.status = self.status, Status(0)
        return status

    def pop_uart_errors(self) -> UartError:
        errors, self.uart_errors = self.uart_errors, UartError(0)
        return errors

    def _shut_down(self) -> None:
        """Stop all motors under serial control. Inferred: the next command restarts its motor."""
        self._commands = list(self._stops)
        if self.in_control:
            self.stop_motors()
