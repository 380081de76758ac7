"""The inputs as they come in: each measurement once, and whether they still come."""

import math

from PySide6.QtCore import QObject, Signal, Slot

from trex_gui.devices.trex.model.telemetry import Telemetry
from trex_gui.devices.trex.protocol.flags import CHANNELS
from trex_gui.ui.runtime import now, runtime

Counts = tuple[int | None, ...]
"""Raw counts of channels 1-5; `None` without a valid signal."""

_STALLED_AFTER = 1.0
"""Seconds without a measurement until that is said."""

_TICK_MS = 200

_SAME_VALUE = 0.012
"""Seconds within which two samples are one: the board renews its inputs every 20 ms, but a line
that was held up reads them in a burst. One wild pulse, read thrice, must not look held."""


class MeasuredInputs(QObject):
    """Hands on what is measured from `begin` to `end`.

    Signals:
        arrived: measurements since the last time, a list of (seconds, `Counts`).
        stalled_changed: whether measurements should come, and do not.
    """

    arrived = Signal(object)
    stalled_changed = Signal()

    def __init__(self, telemetry: Telemetry, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._telemetry = telemetry
        self._taken_until = -math.inf
        self._heard_at = 0.0
        self._ticked_at = 0.0
        self._stalled = False
        self._timer = runtime().timer(self)
        self._timer.setInterval(_TICK_MS)

        self._timer.timeout.connect(self._on_tick)
        telemetry.updated.connect(self._on_updated)

    @property
    def stalled(self) -> bool:
        """Whether measurements should come, and do not."""
        return self._stalled

    def begin(self) -> None:
        """Hand on what is measured from now on."""
        times = self._telemetry.inputs.times
        self._taken_until = float(times[-1]) if len(times) else -math.inf
        self._heard_at = self._ticked_at = now()
        self._stalled = False
        self._timer.start()

    def end(self) -> None:
        """Hand nothing on any more."""
        self._stalled = False
        self._timer.stop()

    @Slot()
    def _on_updated(self) -> None:
        if not self._timer.isActive():
            return
        inputs = self._telemetry.inputs
        first = int(inputs.times.searchsorted(self._taken_until, side="right"))
        found: list[tuple[float, Counts]] = []
        for index, moment in enumerate(inputs.times[first:].tolist(), first):
            self._heard_at = now()
            if moment - self._taken_until < _SAME_VALUE:
                continue
            self._taken_until = moment
            row = [inputs.values(column)[index] for column in range(len(CHANNELS))]
            found.append((moment, tuple(None if math.isnan(v) else int(v) for v in row)))
        if found:
            self.arrived.emit(found)

    @Slot()
    def _on_tick(self) -> None:
        moment = now()
        was_busy = moment - self._ticked_at > 3 * _TICK_MS / 1000
        self._ticked_at = moment
        if was_busy:  # the window was: measurements may wait to be taken
            return
        stalled = moment - self._heard_at > _STALLED_AFTER
        if stalled != self._stalled:
            self._stalled = stalled
            self.stalled_changed.emit()
