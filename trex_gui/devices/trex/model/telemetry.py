"""Polled values: inputs, currents, source of control."""

import math
from enum import IntEnum, auto

from PySide6.QtCore import QObject, Signal, Slot

from trex_gui.devices.trex.client.telemetry import (
    Control,
    Currents,
    LatchedStatus,
    ModeSample,
    Raw,
    Remapped,
)
from trex_gui.devices.trex.model.motors import Motors
from trex_gui.devices.trex.protocol.flags import CHANNELS
from trex_gui.devices.trex.session.messages import Batch
from trex_gui.ui.plotting.data.history import SampleHistory

_INPUT_HISTORY = 3_000
"""Samples of the inputs kept: a minute at 50 a second."""

_UNKNOWN = (math.nan,) * len(CHANNELS)


class Series(IntEnum):
    """The columns of `Telemetry.currents`."""

    CURRENT1 = 0
    CURRENT2 = auto()
    SETPOINT1 = auto()
    SETPOINT2 = auto()
    CHANNEL1 = auto()
    CHANNEL2 = auto()
    CHANNEL3 = auto()
    CHANNEL4 = auto()
    CHANNEL5 = auto()


class Telemetry(QObject):
    """The newest values, the currents of the last hours and the inputs of the last minute.

    A row of `currents` holds what both motors draw (A), their speed setpoints (-127 to 127)
    and the remapped channels at that moment. What is not known is not a number, in `inputs` a
    channel without a signal too. The newest values are `None` while nothing is known: before a
    connection and after it.

    Signals:
        updated: new samples are in; at most once a display frame.
    """

    updated = Signal()

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self.currents = SampleHistory(len(Series))
        self.inputs = SampleHistory(len(CHANNELS), capacity=_INPUT_HISTORY)
        self.raw: tuple[int | None, ...] | None = None
        self.remapped: tuple[int, ...] | None = None
        self.motor_currents: tuple[float, float] | None = None
        self.serial_controls: bool | None = None
        self.latest: float = 0.0
        self.samples = 0
        self._ampere = 1.0
        self._motors: Motors | None = None

    def watch(self, motors: Motors) -> None:
        """Record the setpoints of these motors beside their currents."""
        self._motors = motors

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

    @Slot(object)
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
                    self.currents.append(
                        time,
                        *self.motor_currents,
                        *self._setpoints(),
                        *(self.remapped or _UNKNOWN),
                    )
                case Control(by_serial=by_serial):
                    self.serial_controls = by_serial
                case LatchedStatus() | ModeSample():
                    pass
            self.latest = sample.time
        self.samples += len(batch.samples)
        self.updated.emit()

    def _setpoints(self) -> tuple[float, float]:
        """Return the speed setpoints of motors 1 and 2; 0 for none and for braking."""
        if self._motors is None:
            return math.nan, math.nan
        first, second = (self._motors.drive(motor) for motor in (1, 2))
        return first.signed if first else 0, second.signed if second else 0

    def raw_of(self, channel: int) -> int | None:
        """Raw count of a channel (1-5); `None` without a valid signal or a connection."""
        return self.raw[CHANNELS.index(channel)] if self.raw else None

    def remapped_of(self, channel: int) -> int | None:
        """Remapped value of a channel (1-5), -127 to 127; `None` without a connection."""
        return self.remapped[CHANNELS.index(channel)] if self.remapped else None
