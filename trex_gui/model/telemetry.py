"""What the board reports again and again: inputs, currents, who is in control."""

import math

from PySide6.QtCore import QObject, Signal

from trex_gui.link.messages import Batch
from trex_gui.link.telemetry import Control, Currents, ModeSeen, Raw, Remapped, StatusNews
from trex_gui.model.ring import Ring
from trex_gui.protocol.flags import CHANNELS

_HISTORY = 300_000
"""Current samples kept: an hour at 80 a second."""

_INPUT_HISTORY = 3_000
"""Samples of the inputs kept: a minute at 50 a second."""


class Telemetry(QObject):
    """The newest values, the currents of the last hour and the inputs of the last minute.

    In `inputs` a channel without a signal is not a number. The newest values are `None` while
    nothing is known: before a connection and after it.

    Signals:
        updated: new samples are in; at most once a display frame.
    """

    updated = Signal()

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self.currents = Ring(_HISTORY, columns=2)
        self.inputs = Ring(_INPUT_HISTORY, columns=len(CHANNELS))
        self.raw: tuple[int | None, ...] | None = None
        self.remapped: tuple[int, ...] | None = None
        self.motor_currents: tuple[float, float] | None = None
        self.serial_controls: bool | None = None
        self.latest: float = 0.0
        self.samples = 0
        self._ampere = 1.0

    def begin(self, ampere_per_count: float) -> None:
        """Start with an empty history for a board with this current unit (A a count)."""
        self.currents.clear()
        self.inputs.clear()
        self._ampere = ampere_per_count
        self.forget()

    def forget(self) -> None:
        """Know nothing of the present any more; the history stays to be read."""
        self.raw = None
        self.remapped = None
        self.motor_currents = None
        self.serial_controls = None
        self.updated.emit()

    def note_control(self, by_serial: bool) -> None:
        """Take who controls the motors from a reading of everything."""
        self.serial_controls = by_serial

    def take(self, batch: Batch) -> None:
        """Take the samples of one batch."""
        for sample in batch.samples:
            match sample:
                case Raw(time=time, counts=counts):
                    self.raw = counts
                    values = (math.nan if count is None else count for count in counts)
                    self.inputs.append(time, *values)
                case Remapped(values=values):
                    self.remapped = values
                case Currents(time=time, counts=(first, second)):
                    self.motor_currents = first * self._ampere, second * self._ampere
                    self.currents.append(time, *self.motor_currents)
                case Control(by_serial=by_serial):
                    self.serial_controls = by_serial
                case StatusNews() | ModeSeen():
                    pass
            self.latest = sample.time
        self.samples += len(batch.samples)
        self.updated.emit()

    def raw_of(self, channel: int) -> int | None:
        """Raw count of a channel (1-5); `None` without a valid signal or a connection."""
        return self.raw[CHANNELS.index(channel)] if self.raw else None

    def remapped_of(self, channel: int) -> int | None:
        """Remapped value of a channel (1-5), -127 to 127; `None` without a connection."""
        return self.remapped[CHANNELS.index(channel)] if self.remapped else None
