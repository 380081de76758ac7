"""Setpoints, arming and lockout of the motors."""

import math
from collections.abc import Mapping

from PySide6.QtCore import QObject, Signal, Slot

from trex_gui.core.texts import signed_text
from trex_gui.core.translation import tr
from trex_gui.devices.trex.driving.requests import SetAuxiliary, SetMotor, SetMotors
from trex_gui.devices.trex.protocol.calibration import FULL_SCALE
from trex_gui.devices.trex.protocol.driving import Drive
from trex_gui.devices.trex.protocol.flags import seven_bits
from trex_gui.ui.preferences import Preferences
from trex_gui.ui.runtime import new_timer, now

_STEP_MS = 100
_KEY = "motors/lockout"

FIRST_CEILING = round(0.3 * FULL_SCALE)
"""Default speed ceiling (inferred). At this speed, a robot with swapped motors can be caught."""

LOCKOUT = 3.0
"""Default lockout after a pressed stop, in seconds (inferred).

Without a lockout, a slider that is still being dragged would start its motor again.
"""

MAX_LOCKOUT = 10.0  # s
_AUXILIARY = 0  # number of the auxiliary motor


class Motors(QObject):
    """Setpoints of motors 1 and 2 and of the auxiliary motor.

    Setpoints are ignored before `arm`. A momentary control (pad, keys, gamepad, bench test)
    acquires the motors and passes its name as `holder` with each setpoint. Until `release`, only
    its setpoints count. Setpoints outside their range raise `BadRequest`.

    Set attributes through methods, except `accelerate`, `are_sides` and `adapter`.
    """

    arming_changed = Signal()  # `armed`, `is_available`, `stop_reason`, `locked_for`
    setpoints_changed = Signal()  # `drive`, `auxiliary` or `text`
    holder_changed = Signal()
    options_changed = Signal()  # `board`, `ceiling`, `linked` or `release_brake`
    board_changed = Signal()  # another board is connected
    requested = Signal(object)  # a `SetMotor`, `SetMotors` or `SetAuxiliary`
    stop_requested = Signal()  # emitted before all other signals of a stop

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self.accelerate = True  # speeds follow the board's ramp
        self._store = Preferences()
        # Seconds of lockout after `press_stop`, 0 to 10
        self.lockout = self._store.real(_KEY, LOCKOUT, 0.0, MAX_LOCKOUT)
        self.armed = False
        self.is_available = False  # serial commands can drive the motors
        self.stop_reason = ""  # reason for the last stop; empty if the user pressed stop
        self.holder = ""  # name of the control that has acquired the motors
        self.auxiliary = 0  # setpoint of the auxiliary motor, 0-127
        self.board = ""  # key of the saved ceiling; empty before a board is read
        self.adapter = ""  # adapter that distinguishes identical boards; empty if unknown
        self.is_first_drive = True  # no ceiling has been saved for this board
        self.ceiling = FIRST_CEILING  # highest speed that is sent, 1-127
        # Not raised while a control is held, because a motionless stick must not speed up motors
        self.ceiling_in_force = FIRST_CEILING
        self.are_sides = False  # motors 1 and 2 are the sides of a group
        self.linked = False  # a setpoint for one motor applies to both
        self.release_brake = FULL_SCALE  # brake duty after a momentary control, 0 (coast) to 127
        self._drives: dict[int, Drive] = {}
        self._held: set[int] = set()  # motors that the holder drives
        self._options: tuple[bool, bool] | None = None  # `accelerate` and `linked` to restore
        self._locked_until = -math.inf
        self._reported_lockout = 0
        self._lockout_timer = new_timer(self, _STEP_MS, self._on_lockout_step)

    @property
    def can_arm(self) -> bool:
        return self.is_available and not self.armed and not self.locked_for

    def drive(self, motor: int) -> Drive | None:
        """Return the setpoint of motor 1 or 2. `None` without a setpoint."""
        return self._drives.get(motor)

    @property
    def text(self) -> str:
        """Short text of the setpoints: `motor 1 +90, motor 2 brake`."""
        parts = []
        for motor, drive in sorted(self._drives.items()):
            value = tr("brake") if drive.is_brake else signed_text(drive.signed)
            name = tr("motor {0}").format(motor)
            if self.are_sides:
                name = tr("left") if motor == 1 else tr("right")
            parts.append(f"{name} {value}")
        if self.auxiliary:
            parts.append(tr("auxiliary {0}").format(self.auxiliary))
        return ", ".join(parts)

    # --- Options ------------------------------------------------------------------------

    def set_board(self, board: str, *, is_renamed: bool = False) -> None:
        """Load the saved ceiling of a board. Unlink the motors.

        With `is_renamed`, retain the ceiling and the link, and save the ceiling under the new name.
        """
        board = "-".join(filter(None, (board, self.adapter)))
        if board == self.board:
            return
        self.board = board
        if is_renamed:
            self._store.set(self._ceiling_key, 0 if self.is_first_drive else self.ceiling)
            self.options_changed.emit()
            return
        saved = self._store.integer(self._ceiling_key, 0, 0, FULL_SCALE)
        self.is_first_drive = not saved
        self.linked = False
        if self._options is not None:
            self._options = self._options[0], False
        self.board_changed.emit()
        self._limit_to(saved or FIRST_CEILING)

    def set_ceiling(self, speed: int) -> None:
        """Set and save the speed ceiling of this board. Faster motors slow down.

        A higher ceiling applies from the next setpoint, or once a held control is released.
        """
        if not 1 <= speed <= FULL_SCALE:
            raise ValueError(f"the speed ceiling must be 1 to {FULL_SCALE}, not {speed}")
        if self.board:
            self._store.set(self._ceiling_key, speed)
            self.is_first_drive = False
        self._limit_to(speed)

    @Slot(int)
    def set_lockout(self, seconds: float) -> None:
        self.lockout = float(min(max(seconds, 0.0), MAX_LOCKOUT))
        self._store.set(_KEY, self.lockout)

    @property
    def arms_without_timeout(self) -> bool:
        """True if the user has accepted arming without a serial timeout."""
        return self._store.flag(f"motors/without_timeout/{self.board}", default=False)

    def accept_arming_without_timeout(self) -> None:
        self._store.set(f"motors/without_timeout/{self.board}", True)

    @property
    def _ceiling_key(self) -> str:
        return f"motors/ceilings/{self.board}"

    def _limit_to(self, speed: int) -> None:
        self.ceiling = speed
        if not self.holder or speed < self.ceiling_in_force:
            self.ceiling_in_force = speed
        driven = {motor: drive for motor, drive in self._drives.items() if not drive.is_brake}
        self._request({motor: self._limited(drive.signed) for motor, drive in driven.items()})
        if self.auxiliary > speed:
            self._set_auxiliary(speed)
        self.options_changed.emit()

    @property
    def can_link(self) -> bool:
        first, second = (self._drives.get(motor, Drive.brake()) for motor in (1, 2))
        at_rest = all(drive.is_brake or not drive.speed for drive in (first, second))
        return at_rest or first == second

    def set_linked(self, linked: bool) -> None:
        self.linked = linked and (self.linked or self.can_link)
        self.options_changed.emit()

    def set_release_brake(self, duty: int) -> None:
        self.release_brake = seven_bits(duty, "brake duty")
        self.options_changed.emit()

    # --- Arming and stopping ------------------------------------------------------------

    def set_available(self, available: bool) -> None:
        """Record whether a board can be driven. If not, disarm without a stop."""
        was_available, self.is_available = self.is_available, available
        if not available:
            self._disarm()
        if available != was_available:
            self.arming_changed.emit()

    def arm(self) -> None:
        if self.can_arm:
            self.armed = True
            self.stop_reason = ""
            self.arming_changed.emit()

    def press_stop(self, *, reason: str = "") -> None:
        """Stop everything, and lock arming for `lockout` seconds."""
        self._locked_until = max(self._locked_until, now() + self.lockout)
        self._reported_lockout = math.ceil(self.locked_for)
        self._lockout_timer.start()
        self.stop(reason)

    @property
    def locked_for(self) -> float:
        """Remaining lockout in seconds."""
        return max(0.0, self._locked_until - now())

    @Slot()
    def _on_lockout_step(self) -> None:
        seconds = math.ceil(self.locked_for)
        if not seconds:
            self._lockout_timer.stop()
        if seconds != self._reported_lockout:
            self._reported_lockout = seconds
            self.arming_changed.emit()

    def stop(self, reason: str = "") -> None:
        """Stop everything and disarm. A stop is never rejected."""
        self.stop_reason = reason
        self._disarm(stopping=True)

    def _disarm(self, *, stopping: bool = False) -> None:
        was_armed, self.armed = self.armed, False
        had_holder, had_setpoints = bool(self.holder), bool(self._drives or self.auxiliary)
        self._clear_holder()
        self._drives = {}
        self.auxiliary = 0
        if stopping:
            self.stop_requested.emit()
        if was_armed or stopping:
            self.arming_changed.emit()
        if had_setpoints:
            self.setpoints_changed.emit()
        if had_holder:
            self._restore_options()
            self.holder_changed.emit()

    # --- Momentary controls -------------------------------------------------------------

    def acquire(self, holder: str, *, accelerate: bool | None = None) -> bool:
        """Reserve the motors for a control. Return whether they are reserved.

        If `accelerate` is given, it overrides the ramp option and unlinks the motors until
        `release`.
        """
        if not self.armed or self.holder not in {"", holder}:
            return False
        if not self.holder:
            self.holder = holder
            if accelerate is not None:
                self._options = self.accelerate, self.linked
                self.accelerate, self.linked = accelerate, False
                self.options_changed.emit()
            self.holder_changed.emit()
        return True

    def release(self, holder: str) -> None:
        """Release the motors. Driven motors brake with `release_brake`."""
        if not holder or self.holder != holder:
            return
        rest = Drive.brake(self.release_brake)
        self._request(dict.fromkeys(sorted(self._held - {_AUXILIARY}), rest))
        if _AUXILIARY in self._held:
            self._set_auxiliary(0)
        self._clear_holder()
        self._restore_options()
        self.holder_changed.emit()

    def abort(self, holder: str, reason: str) -> None:
        if holder and self.holder == holder:
            self.stop(reason)

    def _clear_holder(self) -> None:
        self.holder = ""
        self._held.clear()
        self.ceiling_in_force = self.ceiling

    def _restore_options(self) -> None:
        if self._options is not None:
            (self.accelerate, self.linked), self._options = self._options, None
            self.options_changed.emit()

    # --- Setpoints ----------------------------------------------------------------------

    def set_speed(self, motor: int, speed: int, holder: str = "") -> None:
        """Drive at a signed speed (-127 to 127)."""
        self._set_drives({motor: self._limited(speed)}, holder)

    def set_speeds(self, first: int, second: int, holder: str = "") -> None:
        """Drive both motors. If they are linked, the first speed applies to both."""
        self._set_drives({1: self._limited(first), 2: self._limited(second)}, holder)

    def set_brake(self, motor: int, duty: int, holder: str = "") -> None:
        """Brake with a duty of 0 (coast) to 127 (full)."""
        self._set_drives({motor: Drive.brake(duty)}, holder)

    def set_auxiliary(self, speed: int, holder: str = "") -> None:
        seven_bits(speed, "speed of the auxiliary motor")
        if holder == self.holder:
            if holder:
                self._held.add(_AUXILIARY)
            self._set_auxiliary(min(speed, self.ceiling_in_force))

    def _set_drives(self, drives: Mapping[int, Drive], holder: str) -> None:
        if holder == self.holder:
            if self.linked:
                drives = dict.fromkeys((1, 2), next(iter(drives.values())))
            if holder:
                self._held.update(drives)
            self._request(drives)

    def _limited(self, speed: int) -> Drive:
        _ = Drive.at(speed)  # raises on an invalid speed instead of limiting it
        return Drive.at(max(-self.ceiling_in_force, min(self.ceiling_in_force, speed)))

    def _request(self, drives: Mapping[int, Drive]) -> None:
        """Request changed setpoints. Both motors start together."""
        new = [
            SetMotor(motor, drive, self.accelerate)
            for motor, drive in drives.items()
            if drive != self._drives.get(motor)
        ]
        if not self.armed or not new:
            return
        self._drives.update((request.motor, request.drive) for request in new)
        self.requested.emit(SetMotors((new[0], new[1])) if len(new) > 1 else new[0])
        self.setpoints_changed.emit()

    def _set_auxiliary(self, speed: int) -> None:
        if self.armed and speed != self.auxiliary:
            self.auxiliary = speed
            self.requested.emit(SetAuxiliary(speed, self.accelerate))
            self.setpoints_changed.emit()
