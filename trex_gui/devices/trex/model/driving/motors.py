"""What a person wants the motors to do, and whether it may be sent at all."""

from collections.abc import Callable, Mapping

from PySide6.QtCore import QObject, Signal

from trex_gui.devices.trex.driving.requests import SetAuxiliary, SetMotor, SetMotors
from trex_gui.devices.trex.model.driving.lockout import LOCKOUT, Lockout, remembered_lockout
from trex_gui.devices.trex.protocol.calibration import FULL_SCALE
from trex_gui.devices.trex.protocol.command import seven_bits
from trex_gui.devices.trex.protocol.commands import Drive
from trex_gui.ui.runtime import now

__all__ = ["LOCKOUT", "Motors"]

_AUXILIARY = 0
"""The auxiliary motor among the numbers of the two others."""


class Motors(QObject):
    """The wishes for both motors and the auxiliary; nothing is sent before `arm`.

    A control that must be held (a pad, keys, a gamepad, a test run) takes the motors with `hold`
    and gives its name with each wish; meanwhile everybody else's wishes are dropped, and so are
    its own once it has let go. Pads that mix give each motor its own speed: they are not for
    motors that are linked.

    Signals:
        changed: a wish, who holds, an option, the lock, or whether the motors are armed.
        requested: a `SetMotor`, `SetAuxiliary`, or `SetMotors` where both motors begin something
            at once.
        stop_requested: everything shall stop, now.

    Attributes:
        accelerate: whether wishes go through the board's ramp (accelerate) or at once (set).
        lockout: seconds that nothing drives after `press_stop`, 0 to 10; 0 for none. What a
            person has set is remembered under "motors/lockout".
    """

    changed = Signal()
    requested = Signal(object)
    stop_requested = Signal()

    def __init__(self, parent: QObject | None = None, *, clock: Callable[[], float] = now) -> None:
        super().__init__(parent)
        self.accelerate = True
        self.lockout = remembered_lockout()
        self._lock = Lockout(clock, self)
        self._lock.changed.connect(self.changed)
        self._armed = False
        self._can_arm = False
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
        """Whether wishes are sent."""
        return self._armed

    @property
    def can_arm(self) -> bool:
        """Whether a board is there to be driven; `locked_for` may forbid it all the same."""
        return self._can_arm

    @property
    def locked_for(self) -> float:
        """Seconds for which nothing may be armed because stop was pressed; 0 when it may."""
        return self._lock.seconds_left

    @property
    def stop_reason(self) -> str:
        """Why the motors were stopped last, for people; empty when a person pressed stop."""
        return self._stop_reason

    @property
    def holder(self) -> str:
        """The name of the control that is held; empty when none is."""
        return self._holder

    @property
    def auxiliary(self) -> int:
        """The wish for the auxiliary motor, 0-127."""
        return self._auxiliary

    def drive(self, motor: int) -> Drive | None:
        """The wish for motor 1 or 2; `None` since the motors were armed or stopped."""
        return self._drives.get(motor)

    @property
    def text(self) -> str:
        """What is wished, in few words: `motor 1 +90, motor 2 brake, auxiliary 40`."""
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
        """The greatest speed that is sent, 1-127; wishes beyond it are made as large as it."""
        return self._ceiling

    @property
    def ceiling_in_force(self) -> int:
        """The `ceiling`, or a lower one that was set when the control that is held was taken.

        A stick that is held still would make its motors faster by itself otherwise.
        """
        return self._ceiling_in_force

    def set_ceiling(self, speed: int) -> None:
        """Send no greater speed from now on; motors that run faster are slowed down to it.

        One that is higher makes nothing faster: it waits for the next wish, and for a control
        that is held now until it is let go.

        Raises:
            ValueError: the speed is not 1 to 127.
        """
        if not 1 <= speed <= FULL_SCALE:
            raise ValueError(f"the speed ceiling is 1 to {FULL_SCALE}, not {speed}")
        self._ceiling = speed
        if not self._holder or speed < self._ceiling_in_force:
            self._ceiling_in_force = speed
        driven = {motor: drive for motor, drive in self._drives.items() if not drive.is_brake}
        self._wish(
            {motor: Drive.at(self._limited(drive.signed)) for motor, drive in driven.items()}
        )
        if self._auxiliary > speed:
            self._wish_auxiliary(speed)
        self.changed.emit()

    @property
    def linked(self) -> bool:
        """Whether a wish for one motor is one for both."""
        return self._linked

    @property
    def can_link(self) -> bool:
        """Whether linking them would change nothing that runs: not while they run differently."""
        first, second = (self._drives.get(motor, Drive.brake()) for motor in (1, 2))
        at_rest = all(drive.is_brake or not drive.speed for drive in (first, second))
        return at_rest or first == second

    def set_linked(self, linked: bool) -> None:
        """Let both motors do the same from the next wish on; refused unless `can_link`.

        Linking motors that run differently would have to start one or change its speed, which
        nobody expects of a tick.
        """
        self._linked = linked and (self._linked or self.can_link)
        self.changed.emit()

    @property
    def release_brake(self) -> int:
        """How hard the motors brake when a held control lets go: 0 (coast) to 127 (full)."""
        return self._release_brake

    def set_release_brake(self, duty: int) -> None:
        """Brake so hard when a held control lets go.

        Raises:
            BadRequest: the duty is not 0 to 127.
        """
        self._release_brake = seven_bits(duty, "brake duty")
        self.changed.emit()

    # --- Arming and stopping ------------------------------------------------------------

    def allow(self, allowed: bool) -> None:
        """Say whether a board is there; without one the motors are disarmed, nothing is sent."""
        self._can_arm = allowed
        if not allowed:
            self._rest()
        self.changed.emit()

    def arm(self) -> None:
        """Let wishes through from now on; both motors begin at rest. Not while locked."""
        if self._can_arm and not self._armed and not self.locked_for:
            self._rest()
            self._armed = True
            self._stop_reason = ""
            self.changed.emit()

    def press_stop(self) -> None:
        """Stop because a person wants it: nothing can be armed for `lockout` seconds."""
        self._lock.begin(self.lockout)
        self.stop()

    def stop(self, reason: str = "") -> None:
        """Stop everything and disarm. Works armed or not: a stop is never refused."""
        self._stop_reason = reason
        self._rest()
        self.stop_requested.emit()
        self.changed.emit()

    # --- Holding ------------------------------------------------------------------------

    def hold(self, holder: str) -> bool:
        """Take the motors for a control that must be held; return whether it has them now."""
        if not self._armed or self._holder not in {"", holder}:
            return False
        if not self._holder:
            self._holder = holder
            self.changed.emit()
        return True

    def let_go(self, holder: str) -> None:
        """End the hold; what this control has driven comes to rest, as `release_brake` says."""
        if not holder or self._holder != holder:
            return
        rest = Drive.brake(self._release_brake)
        self._wish(dict.fromkeys(sorted(self._held - {_AUXILIARY}), rest))
        if _AUXILIARY in self._held:
            self._wish_auxiliary(0)
        self._release()
        self.changed.emit()

    def lose(self, holder: str, reason: str) -> None:
        """Stop and disarm because a control that is held has gone or cannot be seen any more."""
        if holder and self._holder == holder:
            self.stop(reason)

    # --- Wishes -------------------------------------------------------------------------

    def set_speed(self, motor: int, speed: int, holder: str = "") -> None:
        """Wish a signed speed (-127 to 127) for motor 1 or 2; ignored unless armed.

        Raises:
            BadRequest: the speed is outside its range.
        """
        self._wish_for({motor: self._at(speed)}, holder)

    def set_speeds(self, first: int, second: int, holder: str = "") -> None:
        """Wish signed speeds (-127 to 127) for both motors, which begin at once.

        Where they are linked, the first is for both.

        Raises:
            BadRequest: a speed is outside its range.
        """
        self._wish_for({1: self._at(first), 2: self._at(second)}, holder)

    def set_brake(self, motor: int, duty: int, holder: str = "") -> None:
        """Wish braking with a duty of 0 (coast) to 127 (full); ignored unless armed.

        Raises:
            BadRequest: the duty is outside its range.
        """
        self._wish_for({motor: Drive.brake(duty)}, holder)

    def set_auxiliary(self, speed: int, holder: str = "") -> None:
        """Wish a speed (0-127) for the auxiliary motor; ignored unless armed.

        Raises:
            BadRequest: the speed is outside its range.
        """
        seven_bits(speed, "speed of the auxiliary motor")
        if holder == self._holder:
            if holder:
                self._held.add(_AUXILIARY)
            self._wish_auxiliary(min(speed, self._ceiling_in_force))

    def _wish_for(self, wishes: Mapping[int, Drive], holder: str) -> None:
        """Wish something for motors, the first of it for both where they are linked."""
        if holder == self._holder:
            if self._linked:
                wishes = dict.fromkeys((1, 2), next(iter(wishes.values())))
            if holder:
                self._held.update(wishes)
            self._wish(wishes)

    def _at(self, speed: int) -> Drive:
        _ = Drive.at(speed)  # one that no motor has is a mistake, not something to limit
        return Drive.at(self._limited(speed))

    def _limited(self, speed: int) -> int:
        return max(-self._ceiling_in_force, min(self._ceiling_in_force, speed))

    def _wish(self, wishes: Mapping[int, Drive]) -> None:
        """Ask for what is new, for both motors in one message: neither waits for the other."""
        new = [
            SetMotor(motor, drive, self.accelerate)
            for motor, drive in wishes.items()
            if drive != self._drives.get(motor)
        ]
        if not self._armed or not new:
            return
        self._drives.update((wish.motor, wish.drive) for wish in new)
        self.requested.emit(SetMotors((new[0], new[1])) if len(new) > 1 else new[0])
        self.changed.emit()

    def _wish_auxiliary(self, speed: int) -> None:
        if self._armed and speed != self._auxiliary:
            self._auxiliary = speed
            self.requested.emit(SetAuxiliary(speed, self.accelerate))
            self.changed.emit()

    def _release(self) -> None:
        self._holder = ""
        self._held.clear()
        self._ceiling_in_force = self._ceiling

    def _rest(self) -> None:
        self._armed = False
        self._release()
        self._drives = {}
        self._auxiliary = 0
