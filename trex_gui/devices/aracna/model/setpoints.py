"""The user's joint limits and goals."""

from collections.abc import Sequence

from PySide6.QtCore import QObject, Signal, Slot

from trex_gui.devices.aracna.protocol.joints import CENTER, MOTORS, Limits, factory_limits
from trex_gui.ui.preferences import Preferences

_KEY = "aracna/limits"


class JointLimits(QObject):
    """Limits of each joint, saved in the preferences. The firmware has no limits."""

    changed = Signal()

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._store = Preferences()
        self._all = self._read()

    def of(self, motor: int) -> Limits:
        if motor < len(self._all):
            return self._all[motor]
        return factory_limits(motor + 1)[motor]

    def for_motors(self, motors: int) -> tuple[Limits, ...]:
        return tuple(self.of(motor) for motor in range(motors))

    @property
    def are_factory(self) -> bool:
        return self._all == factory_limits(len(self._all))

    def set(self, motor: int, low: int, high: int) -> None:
        """Set the limits of a joint. Raises BadRequest for invalid limits."""
        limits = Limits(low, high)
        if motor >= len(self._all):
            self._all += factory_limits(motor + 1)[len(self._all) :]
        if limits != self._all[motor]:
            self._all = (*self._all[:motor], limits, *self._all[motor + 1 :])
            self._save()

    def reset(self) -> None:
        if not self.are_factory:
            self._all = factory_limits(len(self._all))
            self._save()

    def clamp(self, goals: Sequence[int]) -> tuple[int, ...]:
        return tuple(self.of(motor).clamp(goal) for motor, goal in enumerate(goals))

    def _save(self) -> None:
        text = " ".join(f"{limits.low}-{limits.high}" for limits in self._all)
        self._store.set(_KEY, text)
        self.changed.emit()

    def _read(self) -> tuple[Limits, ...]:
        pairs = [word.split("-") for word in self._store.text(_KEY).split()]
        try:
            saved = tuple(Limits(int(low), int(high)) for low, high in pairs)
        except ValueError:
            saved = ()
        return saved if len(saved) >= MOTORS else factory_limits()


class Targets(QObject):
    """Goals set with the sliders, clamped to the limits. They may still be unsent."""

    changed = Signal()

    def __init__(self, limits: JointLimits, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._limits = limits
        self.goals = limits.clamp((CENTER,) * MOTORS)
        limits.changed.connect(self._on_limits_changed)

    def set_count(self, motors: int) -> None:
        missing = (CENTER,) * (motors - len(self.goals))
        self.set_all((*self.goals[:motors], *missing))

    def set(self, motor: int, position: int) -> None:
        self.set_all((*self.goals[:motor], position, *self.goals[motor + 1 :]))

    def set_all(self, goals: Sequence[int]) -> None:
        clamped = self._limits.clamp(goals)
        if clamped != self.goals:
            self.goals = clamped
            self.changed.emit()

    @Slot()
    def _on_limits_changed(self) -> None:
        self.set_all(self.goals)
