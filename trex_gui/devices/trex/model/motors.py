"""The setpoints of the motors, whether they may be sent at all, and the lock after a stop."""

import math
from collections.abc import Callable, Mapping

from PySide6.QtCore import QObject, QSettings, Signal, Slot

from trex_gui.devices.trex.driving.requests import SetAuxiliary, SetMotor, SetMotors
from trex_gui.devices.trex.protocol.calibration import FULL_SCALE
from trex_gui.devices.trex.protocol.driving import Drive
from trex_gui.devices.trex.protocol.flags import seven_bits
from trex_gui.ui.runtime import now, runtime

_STEP_MS = 100
_KEY = "motors/lockout"

LOCKOUT = 3.0
"""Default lock after a pressed stop, in seconds.

Inferred from what others do: 5 s where throttles are large, none where people drag on and meet a
motor that starts again.
"""

LONGEST = 10.0


def remembered_lockout() -> float:
    """Return the seconds that the user set last, 0 to 10."""
    try:
        seconds = float(str(QSettings().value(_KEY, LOCKOUT)))
    except ValueError:
        return LOCKOUT
    return min(max(seconds, 0.0), LONGEST) if math.isfinite(seconds) else LOCKOUT


def remember_lockout(seconds: float) -> None:
    """Lock for so many seconds, 0 to 10, from the next start of the program on, too."""
    QSettings().setValue(_KEY, min(max(seconds, 0.0), LONGEST))


class Lockout(QObject):
    """A time that runs down.

    Signals:
        changed: `seconds_left` counts another whole second, or the lock is over.
    """

    changed = Signal()

    def __init__(self, clock: Callable[[], float] = now, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._clock = clock
        self._until = -math.inf
        self._announced = 0
        self._timer = runtime().timer(self)
        self._timer.setInterval(_STEP_MS)
        self._timer.timeout.connect(self._on_step)

    @property
    def seconds_left(self) -> float:
        """How long it lasts still; 0 when nothing is locked."""
        return max(0.0, self._until - self._clock())

    def begin(self, seconds: float) -> None:
        """Lock from now on for so long, or for as long as an earlier lock lasts."""
        self._until = max(self._until, self._clock() + seconds)
        if self.seconds_left > 0:
            self._announced = math.ceil(self.seconds_left)
            self._timer.start()

    @Slot()
    def _on_step(self) -> None:
        left = self.seconds_left
        if not left:
            self._timer.stop()
        if math.ceil(left) != self._announced:
            self._announced = math.ceil(left)
            self.changed.emit()


__all__ = ["LOCKOUT", "Motors"]

_AUXILIARY = 0
"""The number of the auxiliary motor beside motors 1 and 2."""


class Motors(QObject):
    """The setpoints of both motors and the auxiliary; nothing is sent before `arm`.

    A momentary control (pad, keys, gamepad, bench test) acquires the motors and passes its name
    with each setpoint. Until it releases them all other setpoints are ignored, and its own are
    ignored afterwards. Pads that mix give each motor its own speed: they are not for linked motors.

    Signals:
        arming_changed: `armed` or `stop_reason`.
        availability_changed: `is_available`.
        setpoints_changed: what `drive`, `auxiliary` and `text` return.
        holder_changed: `holder`.
        options_changed: `ceiling`, `linked` or `release_brake`.
        lockout_changed: `locked_for` began, passed another second, or ended.
        requested: a `SetMotor`, a `SetAuxiliary`, or a `SetMotors` if both motors start at once.
        stop_requested: everything has to stop now; emitted before any other signal of a stop.

    Attributes:
        accelerate: whether speeds follow the board's ramp (accelerate) or apply at once (set).
        lockout: seconds without arming after `press_stop`, 0 to 10; remembered under
            "motors/lockout".
    """

    arming_changed = Signal()
    availability_changed = Signal()
    setpoints_changed = Signal()
    holder_changed = Signal()
    options_changed = Signal()
    lockout_changed = Signal()
    requested = Signal(object)
    stop_requested = Signal()

    def __init__(self, parent: QObject | None = None, *, clock: Callable[[], float] = now) -> None:
        super().__init__(parent)
        self.accelerate = True
        self.lockout = remembered_lockout()
        self._lock = Lockout(clock, self)
        self._lock.changed.connect(self.lockout_changed)
        self._armed = False
        self._is_available = False
        self._drives: dict[int, Drive] = {}
        self._auxiliary = 0
        self._ceiling = self._ceiling_in_force = FULL_SCALE
        self._linked = False
        self._release_brake = FULL_SCALE
        self._holder = ""
        self._held: set[int] = set()
        self._stop_reason = ""

    # --- What is known ------------------------------------------------------------------

    @property
    def armed(self) -> bool:
        """Whether setpoints are sent."""
        return self._armed

    @property
    def is_available(self) -> bool:
        """Whether a board can be driven by serial commands; `locked_for` may still forbid it."""
        return self._is_available

    @property
    def locked_for(self) -> float:
        """Seconds for which the motors cannot be armed because stop was pressed, or 0."""
        return self._lock.seconds_left

    @property
    def stop_reason(self) -> str:
        """Why the motors were stopped last; empty if the user pressed stop."""
        return self._stop_reason

    @property
    def holder(self) -> str:
        """The name of the control that has acquired the motors; empty if none has."""
        return self._holder

    @property
    def auxiliary(self) -> int:
        """The setpoint of the auxiliary motor, 0-127."""
        return self._auxiliary

    def drive(self, motor: int) -> Drive | None:
        """The setpoint of motor 1 or 2; `None` if there was none since arming."""
        return self._drives.get(motor)

    @property
    def text(self) -> str:
        """The setpoints in short: `motor 1 +90, motor 2 brake, auxiliary 40`."""
        parts = []
        for motor, drive in sorted(self._drives.items()):
            if drive.is_brake:
                parts.append(self.tr("motor {0} brake").format(motor))
            else:
                parts.append(self.tr("motor {0} {1:+d}").format(motor, drive.signed))
        if self._auxiliary:
            parts.append(self.tr("auxiliary {0}").format(self._auxiliary))
        return ", ".join(parts).replace("-", "−")

    # --- Options ------------------------------------------------------------------------

    @property
    def ceiling(self) -> int:
        """The greatest speed that is sent, 1-127; greater setpoints are limited to it."""
        return self._ceiling

    @property
    def ceiling_in_force(self) -> int:
        """The `ceiling`, or a lower one that was in force when the motors were acquired.

        Otherwise raising it would speed up motors under a stick that is paused.
        """
        return self._ceiling_in_force

    def set_ceiling(self, speed: int) -> None:
        """Send no greater speed from now on; motors that run faster are slowed down to it.

        A higher ceiling applies from the next setpoint, and to a held control from its release.

        Raises:
            ValueError: the speed is not 1 to 127.
        """
        if not 1 <= speed <= FULL_SCALE:
            raise ValueError(f"the speed ceiling is 1 to {FULL_SCALE}, not {speed}")
        self._ceiling = speed
        if not self._holder or speed < self._ceiling_in_force:
            self._ceiling_in_force = speed
        driven = {motor: drive for motor, drive in self._drives.items() if not drive.is_brake}
        self._set({motor: Drive.at(self._limited(drive.signed)) for motor, drive in driven.items()})
        if self._auxiliary > speed:
            self._set_auxiliary(speed)
        self.options_changed.emit()

    @property
    def linked(self) -> bool:
        """Whether a setpoint of one motor applies to both."""
        return self._linked

    @property
    def can_link(self) -> bool:
        """Whether linking would change no speed: both at rest, or both at the same setpoint."""
        first, second = (self._drives.get(motor, Drive.brake()) for motor in (1, 2))
        at_rest = all(drive.is_brake or not drive.speed for drive in (first, second))
        return at_rest or first == second

    def set_linked(self, linked: bool) -> None:
        """Apply setpoints to both motors from now on; ignored unless `can_link`."""
        self._linked = linked and (self._linked or self.can_link)
        self.options_changed.emit()

    @property
    def release_brake(self) -> int:
        """The brake duty when a momentary control is released: 0 (coast) to 127 (full)."""
        return self._release_brake

    def set_release_brake(self, duty: int) -> None:
        """Set the brake duty for the release of a momentary control.

        Raises:
            BadRequest: the duty is not 0 to 127.
        """
        self._release_brake = seven_bits(duty, "brake duty")
        self.options_changed.emit()

    # --- Arming and stopping ------------------------------------------------------------

    def set_available(self, available: bool) -> None:
        """Set whether a board can be driven; without one the motors are disarmed, unsent."""
        was_available, self._is_available = self._is_available, available
        if not available:
            self._disarm()
        if available != was_available:
            self.availability_changed.emit()

    def arm(self) -> None:
        """Send setpoints from now on, beginning at rest; ignored while locked or unavailable."""
        if self._is_available and not self._armed and not self.locked_for:
            self._armed = True
            self._stop_reason = ""
            self.arming_changed.emit()

    def press_stop(self) -> None:
        """Stop because the user wants it: the motors cannot be armed for `lockout` seconds."""
        self._lock.begin(self.lockout)
        self.stop()
        self.lockout_changed.emit()

    def stop(self, reason: str = "") -> None:
        """Stop everything and disarm, armed or not: a stop is never rejected."""
        self._stop_reason = reason
        self._disarm(stopping=True)

    def _disarm(self, *, stopping: bool = False) -> None:
        was_armed, self._armed = self._armed, False
        had_holder, had_setpoints = bool(self._holder), bool(self._drives or self._auxiliary)
        self._forget_holder()
        self._drives = {}
        self._auxiliary = 0
        if stopping:
            self.stop_requested.emit()
        if was_armed or stopping:
            self.arming_changed.emit()
        if had_setpoints:
            self.setpoints_changed.emit()
        if had_holder:
            self.holder_changed.emit()

    # --- Momentary controls -------------------------------------------------------------

    def acquire(self, holder: str) -> bool:
        """Reserve the motors for a momentary control; return whether it has them now."""
        if not self._armed or self._holder not in {"", holder}:
            return False
        if not self._holder:
            self._holder = holder
            self.holder_changed.emit()
        return True

    def release(self, holder: str) -> None:
        """End the reservation; motors that this control drove brake with `release_brake`."""
        if not holder or self._holder != holder:
            return
        rest = Drive.brake(self._release_brake)
        self._set(dict.fromkeys(sorted(self._held - {_AUXILIARY}), rest))
        if _AUXILIARY in self._held:
            self._set_auxiliary(0)
        self._forget_holder()
        self.holder_changed.emit()

    def abort(self, holder: str, reason: str) -> None:
        """Stop and disarm because a control is gone or out of sight while it is held."""
        if holder and self._holder == holder:
            self.stop(reason)

    def _forget_holder(self) -> None:
        self._holder = ""
        self._held.clear()
        self._ceiling_in_force = self._ceiling

    # --- Setpoints ----------------------------------------------------------------------

    def set_speed(self, motor: int, speed: int, holder: str = "") -> None:
        """Drive motor 1 or 2 at a signed speed (-127 to 127); ignored unless armed.

        Raises:
            BadRequest: the speed is outside its range.
        """
        self._set_for({motor: self._at(speed)}, holder)

    def set_speeds(self, first: int, second: int, holder: str = "") -> None:
        """Drive both motors at signed speeds (-127 to 127), starting at once.

        If they are linked, the first applies to both.

        Raises:
            BadRequest: a speed is outside its range.
        """
        self._set_for({1: self._at(first), 2: self._at(second)}, holder)

    def set_brake(self, motor: int, duty: int, holder: str = "") -> None:
        """Brake motor 1 or 2 with a duty of 0 (coast) to 127 (full); ignored unless armed.

        Raises:
            BadRequest: the duty is outside its range.
        """
        self._set_for({motor: Drive.brake(duty)}, holder)

    def set_auxiliary(self, speed: int, holder: str = "") -> None:
        """Drive the auxiliary motor at a speed (0-127); ignored unless armed.

        Raises:
            BadRequest: the speed is outside its range.
        """
        seven_bits(speed, "speed of the auxiliary motor")
        if holder == self._holder:
            if holder:
                self._held.add(_AUXILIARY)
            self._set_auxiliary(min(speed, self._ceiling_in_force))

    def _set_for(self, drives: Mapping[int, Drive], holder: str) -> None:
        """Drive motors for a control; if they are linked, the first setpoint applies to both."""
        if holder == self._holder:
            if self._linked:
                drives = dict.fromkeys((1, 2), next(iter(drives.values())))
            if holder:
                self._held.update(drives)
            self._set(drives)

    def _at(self, speed: int) -> Drive:
        _ = Drive.at(speed)  # raises for a speed that no motor has; only valid ones are limited
        return Drive.at(self._limited(speed))

    def _limited(self, speed: int) -> int:
        return max(-self._ceiling_in_force, min(self._ceiling_in_force, speed))

    def _set(self, drives: Mapping[int, Drive]) -> None:
        """Request what is new, for both motors in one message so that they start together."""
        new = [
            SetMotor(motor, drive, self.accelerate)
            for motor, drive in drives.items()
            if drive != self._drives.get(motor)
        ]
        if not self._armed or not new:
            return
        self._drives.update((request.motor, request.drive) for request in new)
        self.requested.emit(SetMotors((new[0], new[1])) if len(new) > 1 else new[0])
        self.setpoints_changed.emit()

    def _set_auxiliary(self, speed: int) -> None:
        if self._armed and speed != self._auxiliary:
            self._auxiliary = speed
            self.requested.emit(SetAuxiliary(speed, self.accelerate))
            self.setpoints_changed.emit()
