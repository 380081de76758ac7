"""How far each joint may turn: enforced here, because the firmware enforces nothing."""

from collections.abc import Sequence

from PySide6.QtCore import QObject, QSettings, Signal

from trex_gui.devices.aracna.protocol.joints import Limits, factory_limits
from trex_gui.devices.aracna.protocol.units import MOTORS

_KEY = "aracna/limits"


class JointLimits(QObject):
    """One pair of positions a motor, kept for the next time.

    Signals:
        changed: they are others.
    """

    changed = Signal()

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._store = QSettings(self)
        self._all = self._read()

    def of(self, motor: int) -> Limits:
        """Return the limits of a motor (0-); one that is not known has those of its kind."""
        if motor < len(self._all):
            return self._all[motor]
        return factory_limits(motor + 1)[motor]

    def first(self, motors: int) -> tuple[Limits, ...]:
        """Return the limits of motors 0 to `motors` - 1."""
        return tuple(self.of(motor) for motor in range(motors))

    @property
    def are_factory(self) -> bool:
        """Whether every joint has the limits tuned on the robot."""
        return self._all == factory_limits(len(self._all))

    def set(self, motor: int, low: int, high: int) -> None:
        """Let a joint turn from `low` to `high` (0-1023).

        Raises:
            ValueError: they are not in this order, or outside 0-1023.
        """
        limits = Limits(low, high)
        if motor >= len(self._all):
            self._all += factory_limits(motor + 1)[len(self._all) :]
        if limits != self._all[motor]:
            self._all = (*self._all[:motor], limits, *self._all[motor + 1 :])
            self._keep()

    def reset(self) -> None:
        """Take the limits tuned on the robot again."""
        if not self.are_factory:
            self._all = factory_limits(len(self._all))
            self._keep()

    def crop(self, goals: Sequence[int]) -> tuple[int, ...]:
        """Return the nearest goals that are allowed."""
        return tuple(self.of(motor).crop(goal) for motor, goal in enumerate(goals))

    def _keep(self) -> None:
        text = " ".join(f"{limits.low}-{limits.high}" for limits in self._all)
        self._store.setValue(_KEY, text)
        self.changed.emit()

    def _read(self) -> tuple[Limits, ...]:
        """Return what was kept; anything that is not limits counts as nothing kept."""
        pairs = [word.split("-") for word in str(self._store.value(_KEY, "")).split()]
        try:
            kept = tuple(Limits(int(low), int(high)) for low, high in pairs)
        except ValueError:
            kept = ()
        return kept if len(kept) >= MOTORS else factory_limits()
