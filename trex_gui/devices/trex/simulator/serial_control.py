"""Serial motor control: latest commands, latched errors, serial timeout.

Ref: TReX 1.0 command documentation 0x84, 0x85 and motor commands; User's Guide 5.b.
"""

import math
from collections.abc import Sequence
from dataclasses import dataclass

from trex_gui.devices.trex.protocol.flags import Status, UartError
from trex_gui.devices.trex.simulator.motors import FULL_SPEED, AuxiliaryMotor, Motor, MotorDirection


@dataclass(frozen=True, slots=True)
class _Command:
    direction: MotorDirection
    speed: int
    accelerate: bool

    def apply(self, motor: Motor) -> None:
        if self.accelerate:
            motor.accelerate(self.direction, self.speed)
        else:
            motor.set(self.direction, self.speed)


_STOP = _Command(MotorDirection.BRAKE, FULL_SPEED, accelerate=False)
"""Inferred: a shut-down motor brakes fully."""


class SerialControl:
    """The latest serial command to each motor, and the bits that are latched until read.

    Attributes:
        in_control: whether the motors obey serial commands; 0x83 answers it.
        status, uart_errors: the latched bits.
        errors: number of UART errors.
    """

    def __init__(
        self, motors: Sequence[Motor], aux: AuxiliaryMotor, *, joint: bool, in_control: bool
    ) -> None:
        self.in_control = in_control
        self.status = Status(0)
        self.uart_errors = UartError(0)
        self.errors = 0
        self._motors = motors
        self._aux = aux
        self._joint = joint
        self._commands = [_STOP] * len(motors)
        self._aux_command = (0, False)
        self._last_byte = math.inf  # inferred: the timeout runs from the first byte on

    def drive(
        self, number: int, direction: MotorDirection, speed: int, *, accelerate: bool = False
    ) -> None:
        """Command motor 1 or 2 (speed 0-127); applied when the channels hand over control.

        Inferred: in joint mode commands to motor 2 are accepted and ignored.
        """
        if self._joint and number == 2:
            return
        command = _Command(direction, speed, accelerate)
        self._commands[number - 1] = command
        if self.in_control:
            command.apply(self._motors[number - 1])

    def drive_aux(self, speed: int, *, accelerate: bool = False) -> None:
        """Command the auxiliary motor (speed 0-127)."""
        self._aux_command = (speed, accelerate)
        if self.in_control:
            self._apply_aux_command()

    def hand_over(self, now: float, timeout: int, *, in_control: bool) -> None:
        """Set who controls the motors; serial control applies the latest commands of any age.

        Inferred: a motor without a command stops; so do all after the serial timeout (tenths of a
        second, 0 for none).
        """
        begins = in_control and not self.in_control
        self.in_control = in_control
        if begins:
            self.check_timeout(now, timeout)
            for command, motor in zip(self._commands, self._motors, strict=True):
                command.apply(motor)
            self._apply_aux_command()

    def stop_motors(self) -> None:
        """Brake both motors fully and let the auxiliary motor coast, in either control."""
        for motor in self._motors:
            _STOP.apply(motor)
        self._aux.set(0)

    def restart_timeout(self, now: float) -> None:
        """Restart the serial timeout: a byte arrived, valid or not."""
        self._last_byte = now

    def check_timeout(self, now: float, timeout: int) -> None:
        """Stop after `timeout` tenths of a second without a byte; 0 for never.

        Inferred: only in serial control, and the bit is latched once per timeout.
        """
        if timeout and self.in_control and now - self._last_byte >= timeout * 0.1 - 1e-9:
            self._last_byte = math.inf
            self.uart_errors |= UartError.TIMEOUT
            self.status |= Status.UART_ERROR
            self._shut_down()

    def report(self, error: UartError, *, shut_down: bool) -> None:
        """Latch a UART error; stop the motors if the parameter requires it.

        The lost command may have been a stop, so commands not yet applied are dropped, too.
        """
        self.errors += 1
        self.uart_errors |= error
        self.status |= Status.UART_ERROR
        if shut_down:
            self._shut_down()

    def take_status(self) -> Status:
        """Return the status bits and clear them (0x84)."""
        status, self.status = self.status, Status(0)
        return status

    def take_uart_errors(self) -> UartError:
        """Return the UART error bits and clear them (0x85)."""
        errors, self.uart_errors = self.uart_errors, UartError(0)
        return errors

    def _shut_down(self) -> None:
        """Stop serial control's motors; inferred: the next command restarts its motor."""
        self._commands = [_STOP] * len(self._motors)
        self._aux_command = (0, False)
        if self.in_control:
            self.stop_motors()

    def _apply_aux_command(self) -> None:
        speed, accelerate = self._aux_command
        if accelerate:
            self._aux.accelerate(speed)
        else:
            self._aux.set(speed)
