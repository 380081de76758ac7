"""The serial side of motor control: whose orders count, what went wrong, who fell silent.

Ref: TReX 1.0 command documentation 0x84, 0x85 and motor commands; User's Guide 5.b.
"""

import math
from collections.abc import Sequence
from dataclasses import dataclass

from trex_gui.devices.trex.protocol.flags import Status, UartError
from trex_gui.devices.trex.simulator.motors import FULL_SPEED, AuxiliaryMotor, Motor, MotorDirection


@dataclass(frozen=True, slots=True)
class _Order:
    direction: MotorDirection
    speed: int
    accelerate: bool

    def give(self, motor: Motor) -> None:
        if self.accelerate:
            motor.accelerate(self.direction, self.speed)
        else:
            motor.set(self.direction, self.speed)


_STOP = _Order(MotorDirection.BRAKE, FULL_SPEED, accelerate=False)
"""Inferred: to be shut down is to be braked fully."""


class SerialControl:
    """The latest serial order to each motor, and the bits that are latched until read.

    Attributes:
        in_control: whether the motors obey serial commands; 0x83 answers it.
        status, uart_errors: the latched bits.
        errors: how many UART errors there were.
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
        self._orders = [_STOP] * len(motors)
        self._aux_order = (0, False)
        self._heard_at = math.inf  # inferred: the timeout runs from the first byte on

    def drive(
        self, number: int, direction: MotorDirection, speed: int, *, accelerate: bool = False
    ) -> None:
        """Take a command to motor 1 or 2 (speed 0-127); kept while the channels control.

        Inferred: in joint mode commands to motor 2 are taken and ignored.
        """
        if self._joint and number == 2:
            return
        order = _Order(direction, speed, accelerate)
        self._orders[number - 1] = order
        if self.in_control:
            order.give(self._motors[number - 1])

    def drive_aux(self, speed: int, *, accelerate: bool = False) -> None:
        """Take a command to the auxiliary motor (speed 0-127)."""
        self._aux_order = (speed, accelerate)
        if self.in_control:
            self._give_aux_order()

    def hand_over(self, now: float, timeout: int, *, in_control: bool) -> None:
        """Give or take control; on taking it each motor obeys its latest order, however old.

        Inferred: a motor that never had an order stops; so do all when the host has been
        silent for longer than the serial timeout (tenths of a second, 0 for none).
        """
        begins = in_control and not self.in_control
        self.in_control = in_control
        if begins:
            self.watch_silence(now, timeout)
            for order, motor in zip(self._orders, self._motors, strict=True):
                order.give(motor)
            self._give_aux_order()

    def stop_motors(self) -> None:
        """Brake both motors fully and let the auxiliary one run out, whoever controls."""
        for motor in self._motors:
            _STOP.give(motor)
        self._aux.set(0)

    def hear(self, now: float) -> None:
        """Note that a byte came, good or bad: the serial timeout starts again."""
        self._heard_at = now

    def watch_silence(self, now: float, timeout: int) -> None:
        """Stop when the host has been silent for `timeout` tenths of a second; 0 for never.

        Inferred: it only acts while serial controls the motors, and the bit is latched once
        for each silence.
        """
        if timeout and self.in_control and now - self._heard_at >= timeout * 0.1 - 1e-9:
            self._heard_at = math.inf
            self.uart_errors |= UartError.TIMEOUT
            self.status |= Status.UART_ERROR
            self._shut_down()

    def report(self, error: UartError, *, shut_down: bool) -> None:
        """Latch an error of the line; stop the motors if the parameter wants that.

        The order that was lost may have been a stop, so orders that wait are dropped too.
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
        """Stop what serial drives; inferred: the next command starts that motor again."""
        self._orders = [_STOP] * len(self._motors)
        self._aux_order = (0, False)
        if self.in_control:
            self.stop_motors()

    def _give_aux_order(self) -> None:
        speed, accelerate = self._aux_order
        if accelerate:
            self._aux.accelerate(speed)
        else:
            self._aux.set(speed)
