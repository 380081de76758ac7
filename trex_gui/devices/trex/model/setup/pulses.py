"""Short motor pulses that identify the wheel of a motor."""

from PySide6.QtCore import QObject, Signal, Slot

from trex_gui.core.translation import tr
from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.model.drive_status import held_drive_blocker
from trex_gui.devices.trex.model.learning.preconditions import mode_blocker
from trex_gui.devices.trex.model.motors import FIRST_CEILING
from trex_gui.devices.trex.protocol.calibration import FULL_SCALE
from trex_gui.ui.runtime import new_timer

_HOLDER = "setup"  # holder name for `Motors.acquire`

WEAK, STRONGER = round(0.2 * FULL_SCALE), FIRST_CEILING
"""Speeds of a pulse (inferred). 20 % turns most geared motors with free wheels, and moves a robot
on the floor by a few centimetres."""

PULSE = 0.4  # s; long enough to see the direction
PAUSE = 0.6  # s between two pulses


class MotorPulses(QObject):
    """Drives a motor in pulses while a button is held.

    Pulses are setpoints of a momentary control, so arming, the speed ceiling, stops and the
    guardian apply. The other motor stays at rest.
    """

    changed = Signal()  # `motor`, `wheels_are_free` or `blocker`

    def __init__(self, device: Device, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self.motor = 0  # driven motor; 0 if no button is held
        self.wheels_are_free = False  # confirmed by the user
        self._device = device
        self._motors = motors = device.motors
        self._speed = WEAK
        self._is_on = False
        self._timer = new_timer(self, round(PULSE * 1000), self._on_step, single_shot=True)

        for signal in (motors.arming_changed, motors.setpoints_changed, motors.holder_changed):
            signal.connect(self._on_motors_changed)
        device.link_changed.connect(self._on_link_changed)
        device.state_changed.connect(self.changed)

    @property
    def mode_problem(self) -> str:
        """Reason why pulses are impossible in this mode, or an empty string."""
        if self._device.is_connected and self._device.board.is_joint:
            return tr("Joint mode: both outputs drive one motor, so there is nothing to identify.")
        return mode_blocker(self._device) if self._device.is_connected else ""

    @property
    def blocker(self) -> str:
        """Reason why no pulse can start, or an empty string."""
        if self.mode_problem:
            return self.mode_problem
        if self._device.is_connected and not self.wheels_are_free:
            return tr("Lift the robot so that its wheels turn freely, then confirm this here.")
        return held_drive_blocker(self._device, _HOLDER)

    def confirm_wheels(self, free: bool) -> None:
        """Record whether the wheels are off the ground."""
        if free:
            self.wheels_are_free = True
            self.changed.emit()
        else:
            self.stop(tr("The wheels may touch the ground."))

    def stop(self, reason: str) -> None:
        self.wheels_are_free = False
        if self._motors.armed or self._device.may_move:
            self._motors.stop(reason)
        self.changed.emit()

    def start(self, motor: int, *, stronger: bool = False) -> bool:
        if self.motor or self.blocker:
            return False
        # With a slow ramp, the motor would not move within a pulse.
        if not self._motors.acquire(_HOLDER, accelerate=False):
            return False
        self.motor, self._speed = motor, STRONGER if stronger else WEAK
        self._is_on = False
        self._on_step()
        self.changed.emit()
        return bool(self.motor)

    def release(self) -> None:
        self._motors.release(_HOLDER)

    @Slot()
    def _on_step(self) -> None:
        if not self.motor:
            return
        self._is_on = not self._is_on
        if self._is_on:
            self._motors.set_speed(self.motor, self._speed, _HOLDER)
        else:
            self._motors.set_brake(self.motor, self._motors.release_brake, _HOLDER)
        if self.motor:  # a setpoint may have caused a stop
            self._timer.start(round((PULSE if self._is_on else PAUSE) * 1000))

    @Slot()
    def _on_motors_changed(self) -> None:
        if self.motor and self._motors.holder != _HOLDER:
            self._timer.stop()
            self.motor = 0
        self.changed.emit()

    @Slot()
    def _on_link_changed(self) -> None:
        if not self._device.is_connected:
            self.wheels_are_free = False  # the user may put the robot down
        self.changed.emit()
