"""For a while after a stop nothing drives: a slider that is still being dragged is too late."""

import math
from collections.abc import Callable

from PySide6.QtCore import QObject, QSettings, Signal, Slot

from trex_gui.ui.runtime import now, runtime

_STEP_MS = 100
_KEY = "motors/lockout"

LOCKOUT = 3.0
"""Seconds that nothing drives after a person has pressed stop, unless set otherwise.

Inferred from what others do: 5 s where throttles are large, none where people drag on and meet a
motor that starts again.
"""

LONGEST = 10.0


def remembered_lockout() -> float:
    """Return the seconds that a person has set last, 0 to 10."""
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
        self._told = 0
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
            self._told = math.ceil(self.seconds_left)
            self._timer.start()

    @Slot()
    def _on_step(self) -> None:
        left = self.seconds_left
        if not left:
            self._timer.stop()
        if math.ceil(left) != self._told:
            self._told = math.ceil(left)
            self.changed.emit()
