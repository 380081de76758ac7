"""What a person wants the motors to do, and whether it may be sent at all."""

from PySide6.QtCore import QObject, Signal

from trex_gui.link.messages import SetAuxiliary, SetDrive
from trex_gui.protocol.command import seven_bits
from trex_gui.protocol.commands import Drive


class Motors(QObject):
    """The wishes for both motors and the auxiliary; nothing is sent before `arm`.

    Signals:
        changed: a wish, or whether the motors are armed.
        requested: a `SetDrive` or `SetAuxiliary` to send.
        stop_requested: everything shall stop, now.
    """

    changed = Signal()
    requested = Signal(object)
    stop_requested = Signal()

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self.accelerate = True
        self._armed = False
        self._can_arm = False
        self._drives: dict[int, Drive] = {}
        self._auxiliary = 0

    @property
    def armed(self) -> bool:
        """Whether wishes are sent."""
        return self._armed

    @property
    def can_arm(self) -> bool:
        """Whether a board is there to be driven."""
        return self._can_arm

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

    def allow(self, allowed: bool) -> None:
        """Say whether a board is there; without one the motors are disarmed, nothing is sent."""
        self._can_arm = allowed
        if not allowed:
            self._rest()
        self.changed.emit()

    def arm(self) -> None:
        """Let wishes through from now on; both motors begin at rest."""
        if self._can_arm and not self._armed:
            self._rest()
            self._armed = True
            self.changed.emit()

    def stop(self) -> None:
        """Stop everything and disarm. Works armed or not: a stop is never refused."""
        self._rest()
        self.stop_requested.emit()
        self.changed.emit()

    def set_speed(self, motor: int, speed: int) -> None:
        """Wish a signed speed (-127 to 127) for motor 1 or 2; ignored unless armed.

        Raises:
            BadRequest: the speed is outside its range.
        """
        self._wish(motor, Drive.at(speed))

    def set_brake(self, motor: int, duty: int) -> None:
        """Wish braking with a duty of 0 (coast) to 127 (full); ignored unless armed.

        Raises:
            BadRequest: the duty is outside its range.
        """
        self._wish(motor, Drive.brake(duty))

    def set_auxiliary(self, speed: int) -> None:
        """Wish a speed (0-127) for the auxiliary motor; ignored unless armed.

        Raises:
            BadRequest: the speed is outside its range.
        """
        seven_bits(speed, "speed of the auxiliary motor")
        if self._armed and speed != self._auxiliary:
            self._auxiliary = speed
            self.requested.emit(SetAuxiliary(speed, self.accelerate))
            self.changed.emit()

    def _wish(self, motor: int, drive: Drive) -> None:
        if self._armed and drive != self._drives.get(motor):
            self._drives[motor] = drive
            self.requested.emit(SetDrive(motor, drive, self.accelerate))
            self.changed.emit()

    def _rest(self) -> None:
        self._armed = False
        self._drives = {}
        self._auxiliary = 0
