"""Where a person wants each joint to go: what the sliders show, sent or not."""

from collections.abc import Sequence

from PySide6.QtCore import QObject, Signal, Slot

from trex_gui.devices.aracna.model.limits import JointLimits
from trex_gui.devices.aracna.protocol.units import MOTORS

CENTRE = 512
"""The middle of a servo's travel, 150 degrees."""


class Targets(QObject):
    """One position a motor, never beyond its limits.

    Signals:
        changed: one of them is another.
    """

    changed = Signal()

    def __init__(self, limits: JointLimits, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._limits = limits
        self._goals = limits.crop((CENTRE,) * MOTORS)
        limits.changed.connect(self._on_limits_changed)

    @property
    def goals(self) -> tuple[int, ...]:
        """All of them, motor 0 first."""
        return self._goals

    def set_count(self, motors: int) -> None:
        """Be so many: what is missing stands in the centre."""
        more = (CENTRE,) * (motors - len(self._goals))
        self.set_all((*self._goals[:motors], *more))

    def set(self, motor: int, position: int) -> None:
        """Want one joint somewhere, or as near as its limits let it."""
        self.set_all((*self._goals[:motor], position, *self._goals[motor + 1 :]))

    def set_all(self, goals: Sequence[int]) -> None:
        """Want every joint somewhere, or as near as its limits let it."""
        cropped = self._limits.crop(goals)
        if cropped != self._goals:
            self._goals = cropped
            self.changed.emit()

    @Slot()
    def _on_limits_changed(self) -> None:
        self.set_all(self._goals)
