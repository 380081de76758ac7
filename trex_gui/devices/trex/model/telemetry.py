"""Polled values, their history, and the mix jumper."""

import math
from collections.abc import Callable, Sequence
from enum import IntEnum
from functools import cached_property
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, Signal, Slot

from trex_gui.core.timing import TEXT_INTERVAL
from trex_gui.core.translation import tr
from trex_gui.devices.trex.calibration.channel_curve import is_mixed
from trex_gui.devices.trex.client.telemetry import Currents, Newest, Raw, Remapped, Sample
from trex_gui.devices.trex.model.settings.draft import SettingsDraft
from trex_gui.devices.trex.protocol.driving import Drive
from trex_gui.devices.trex.protocol.flags import CHANNELS
from trex_gui.devices.trex.protocol.parameters import ParameterKey
from trex_gui.ui.plotting.traces import TraceInfo

if TYPE_CHECKING:
    from trex_gui.ui.plotting.history import SampleHistory

_CURRENT_HISTORY = 288_000  # samples; one hour at 80 per second
_INPUT_HISTORY = 3_000  # samples; one minute at 50 per second
_UNKNOWN = (math.nan,) * len(CHANNELS)
_CHANNEL_COLORS = ("good", "warning", "dirty", "muted", "plot_text")


Series = IntEnum(
    "Series",
    "CURRENT1 CURRENT2 SETPOINT1 SETPOINT2 CHANNEL1 CHANNEL2 CHANNEL3 CHANNEL4 CHANNEL5",
    start=0,
)
"""Columns of `Telemetry.currents`."""

_TYPES = ["float64" if s in {Series.CURRENT1, Series.CURRENT2} else "float16" for s in Series]
"""All series except the currents contain whole numbers from -127 to 127."""


def board_traces() -> list[TraceInfo]:
    """Return the curves in the order of `Series`."""
    currents = [
        TraceInfo(f"motor{m}_current", tr("Motor {0}").format(m), "A", f"motor{m}", str(m))
        for m in (1, 2)
    ]
    speed = tr("Speed setpoint {0}")
    setpoints = [
        TraceInfo(f"motor{m}_setpoint", speed.format(m), "", f"motor{m}", f"S{m}", shown=False)
        for m in (1, 2)
    ]
    channels = [
        TraceInfo(f"channel{c}", tr("Channel {0}").format(c), "", color, f"C{c}", shown=False)
        for c, color in zip(CHANNELS, _CHANNEL_COLORS, strict=True)
    ]
    return [*currents, *setpoints, *channels]


def values_of_series(
    newest: Newest, setpoint: Callable[[int], Drive | None], ampere: float
) -> tuple[float, ...]:
    """Return the value of each `Series`. A missing setpoint counts as 0.

    `setpoint` returns the setpoint of a motor. `ampere` is A per count.
    """
    first, second = newest[Currents].counts
    speeds = (drive.signed if (drive := setpoint(motor)) else 0 for motor in (1, 2))
    remapped = newest.get(Remapped)
    channels = _UNKNOWN if remapped is None else remapped.values
    return (first * ampere, second * ampere, *speeds, *channels)


def _new_history(columns: Sequence[str], capacity: int) -> "SampleHistory":
    from trex_gui.ui.plotting.history import SampleHistory  # noqa: PLC0415 - numpy loads slowly

    return SampleHistory(columns, capacity=capacity)


class Telemetry(QObject):
    """Newest values, with the history of currents and inputs.

    A row of `currents` contains the currents of both motors (A), their speed setpoints (-127 to
    127) and the remapped channels at the time of the sample. Unknown values are NaN. In `inputs`,
    channels without a signal are NaN. Without a connection, the newest values are `None`.
    """

    updated = Signal()  # new samples, at most once per display frame
    frame_due = Signal()  # `updated` while a window is visible; also when a window becomes visible
    text_due = Signal()  # like `frame_due`, but for text: at most once per `TEXT_INTERVAL`

    def __init__(
        self, drive_of: Callable[[int], Drive | None], newest: Newest, parent: QObject | None = None
    ) -> None:
        super().__init__(parent)
        self.newest = newest  # owned by the `BoardMirror`
        self.latest: float = 0.0  # time of the newest sample
        self.samples = 0  # number of samples so far
        self._is_visible = True
        self._text_at = -math.inf
        self.ampere = 0.15  # A per count; initially the value of a TReX
        self._drive_of = drive_of

    @cached_property
    def currents(self) -> "SampleHistory":
        return _new_history(_TYPES, _CURRENT_HISTORY)

    @cached_property
    def inputs(self) -> "SampleHistory":
        return _new_history(["float64"] * len(CHANNELS), _INPUT_HISTORY)

    def start(self, ampere_per_count: float) -> None:
        """Start an empty history. `ampere_per_count` is the unit of current."""
        self.currents.clear()
        self.inputs.clear()
        self.ampere = ampere_per_count
        self.report_cleared()

    def report_cleared(self) -> None:
        """Update the views after the newest values were cleared."""
        self.updated.emit()
        self._renew_views()

    def add(self, sample: Sample) -> None:
        """Add a sample. `finish` updates the views."""
        if isinstance(sample, Raw):
            values = (math.nan if count is None else count for count in sample.counts)
            self.inputs.append(sample.time, *values)
        elif isinstance(sample, Currents):
            row = values_of_series(self.newest, self._drive_of, self.ampere)
            self.currents.append(sample.time, *row)
        self.latest = sample.time
        self.samples += 1

    def finish(self) -> None:
        self.updated.emit()
        if self._is_visible:
            self.frame_due.emit()
            if self.latest - self._text_at >= TEXT_INTERVAL:
                self._text_at = self.latest
                self.text_due.emit()

    def set_visible(self, visible: bool) -> None:
        self._is_visible = visible
        self._renew_views()

    def _renew_views(self) -> None:
        self._text_at = -math.inf
        if self._is_visible:
            self.frame_due.emit()
            self.text_due.emit()

    @property
    def raw(self) -> tuple[int | None, ...] | None:
        sample = self.newest.get(Raw)
        return None if sample is None else sample.counts

    @property
    def remapped(self) -> tuple[int, ...] | None:
        sample = self.newest.get(Remapped)
        return None if sample is None else sample.values

    @property
    def motor_currents(self) -> tuple[float, float] | None:
        sample = self.newest.get(Currents)
        unit = self.ampere
        return None if sample is None else (sample.counts[0] * unit, sample.counts[1] * unit)  # A

    def raw_of(self, channel: int) -> int | None:
        """Return the raw count of a channel (1-5). `None` without a valid signal."""
        return self.raw[CHANNELS.index(channel)] if self.raw else None

    def remapped_of(self, channel: int) -> int | None:
        """Return the remapped value of a channel (1-5). `None` if unknown."""
        return self.remapped[CHANNELS.index(channel)] if self.remapped else None


_MIN_RESULTS = 3  # consecutive equal results after which the state counts as known


class MixJumper(QObject):
    """State of the mix jumper.

    No command reads the jumper. While a stick is off neutral, the state of the jumper is inferred
    by comparing the computed outputs of channels 1 and 2 with the outputs that the board reports.
    """

    changed = Signal()

    def __init__(
        self, draft: SettingsDraft, telemetry: Telemetry, parent: QObject | None = None
    ) -> None:
        super().__init__(parent)
        self._draft = draft
        self._telemetry = telemetry
        self.is_on: bool | None = None  # `None` if unknown
        self._candidate: bool | None = None
        self._count = 0
        telemetry.updated.connect(self._on_updated)
        telemetry.text_due.connect(self._on_text_due)

    def feed(self, outputs: tuple[int, int], reported: tuple[int, int]) -> None:
        mixed = is_mixed(outputs, reported)
        if mixed is None:
            return
        self._count = self._count + 1 if mixed is self._candidate else 1
        self._candidate = mixed
        if self._count >= _MIN_RESULTS:
            self._set(mixed)

    def clear(self) -> None:
        self._candidate = None
        self._set(None)

    def _set(self, is_on: bool | None) -> None:
        if is_on is not self.is_on:
            self.is_on = is_on
            self.changed.emit()

    @Slot()
    def _on_updated(self) -> None:
        if self._telemetry.raw is None:
            self.clear()

    @Slot()
    def _on_text_due(self) -> None:
        telemetry, draft = self._telemetry, self._draft
        reported = telemetry.remapped
        if draft.parameters.values.active_of(ParameterKey.MOTOR_MODE) == 1:
            self.clear()  # joint mode has no mixing
            return
        first, second, flip = (draft.stored_curve(channel) for channel in (1, 2, 4))
        if first and second and flip and reported and not flip.is_switched(4, telemetry.raw_of(4)):
            outputs = first.output(telemetry.raw_of(1)), second.output(telemetry.raw_of(2))
            self.feed(outputs, (reported[0], reported[1]))
