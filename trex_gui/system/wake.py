"""A net under everything else: was the computer asleep just now?"""

import time
from collections.abc import Callable

from PySide6.QtCore import QObject, QTimer, Signal, Slot

_INTERVAL_MS = 500
_LEAST_S = 1.0
"""Seconds of sleep that count; less is the rounding of two clocks that are read one by one."""


def slept_so_far() -> float:
    """Return seconds that this computer has slept since it was started, as far as it tells.

    Linux has a clock that stands still meanwhile and one that does not. Elsewhere 0. On Windows
    Python's monotonic clock goes on, so that the line session misses its signs of life. On macOS
    it stands still during sleep, as everything that is measured with it: sleep is not seen there.
    """
    boottime = getattr(time, "CLOCK_BOOTTIME", None)
    return time.clock_gettime(boottime) - time.monotonic() if boottime is not None else 0.0


class SuspendDetector(QObject):
    """Looks twice a second.

    Signals:
        woke: the computer was asleep; why to stop, for people: a clause without a full stop.
    """

    woke = Signal(str)

    def __init__(
        self, slept: Callable[[], float] = slept_so_far, parent: QObject | None = None
    ) -> None:
        super().__init__(parent)
        self._slept = slept
        self._known = slept()
        self._timer = QTimer(self)
        self._timer.setInterval(_INTERVAL_MS)
        self._timer.timeout.connect(self.look)
        self._timer.start()

    @Slot()
    def look(self) -> None:
        """Compare the clocks."""
        before, self._known = self._known, self._slept()
        if self._known - before >= _LEAST_S:
            self.woke.emit(self.tr("The computer was asleep"))
