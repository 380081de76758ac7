"""Samples on their way out, told together: nobody sees more than one batch a display frame."""

from collections.abc import Callable
from dataclasses import replace

from trex_gui.devices.trex.client.client import Counters
from trex_gui.devices.trex.client.telemetry import Sample
from trex_gui.devices.trex.session.messages import Batch

FRAME = 1 / 60
"""Seconds between two batches."""


class SampleBatcher:
    """Gathers samples; knows no clock but the times it is given."""

    def __init__(self, emit: Callable[[Batch], None]) -> None:
        self._emit = emit
        self._samples: list[Sample] = []
        self._last_flush = 0.0
        self.add = self._samples.append
        self.extend = self._samples.extend

    def seconds_to_next(self, now: float) -> float | None:
        """Return when what was gathered is due; `None`: there is nothing."""
        return self._last_flush + FRAME - now if self._samples else None

    def tell(self, counters: Counters, now: float) -> None:
        """Tell what was gathered, if it is anything."""
        self._last_flush = now
        if self._samples:
            batch = Batch(tuple(self._samples), replace(counters))
            self._samples.clear()
            self._emit(batch)
