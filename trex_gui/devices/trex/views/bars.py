"""Bar and axis of an input."""

from collections.abc import Iterable

from PySide6.QtCore import QRectF
from PySide6.QtGui import QPainter

from trex_gui.devices.trex.protocol.calibration import Calibration
from trex_gui.devices.trex.protocol.flags import InputSource
from trex_gui.ui.plotting.axes import Labels, ticks, value_labels
from trex_gui.ui.widgets.bar import paint_track

# Raw counts. Pulses from 0.5 to 2.5 ms are valid. Ref: Pololu TReX User's Guide 4.b.
DEFAULT_AXIS = {InputSource.RC: (2000, 5500), InputSource.ANALOG: (0, 1023)}
_AXIS_STEP = 250  # counts (100 µs)
_LABEL_STEPS = {  # in µs and in V
    InputSource.RC: (100.0, 200.0, 500.0, 1000.0, 2000.0),
    InputSource.ANALOG: (0.5, 1.0, 2.5, 5.0, 10.0),
}


def input_axis(
    source: InputSource, calibration: Calibration | None, count: int | None = None
) -> tuple[int, int]:
    counts = [] if count is None else [count]
    if calibration is not None:
        counts += [calibration.minimum, calibration.maximum]
    return widened(DEFAULT_AXIS[source], counts)


def widened(axis: tuple[int, int], counts: Iterable[int]) -> tuple[int, int]:
    """Extend an axis in round steps to include the counts."""
    low, high = axis
    for count in counts:
        if count < low:
            low = max(0, count // _AXIS_STEP * _AXIS_STEP)
        if count > high:
            high = -(-count // _AXIS_STEP) * _AXIS_STEP
    return low, high


def input_labels(source: InputSource, axis: tuple[int, int], limit: int) -> Labels:
    """Return up to `limit` labels with positions in counts. The last label includes the unit."""
    low, high = (source.physical(count) for count in axis)
    for step in _LABEL_STEPS[source]:
        values = ticks(low, high, step)
        if len(values) <= limit:
            break
    labels = value_labels(values, source.unit)
    return [(value * source.counts_per_unit, text) for value, text in labels]


def paint_input(
    painter: QPainter,
    track: QRectF,
    axis: tuple[int, int],
    count: int | None,
    calibration: Calibration | None,
) -> None:
    """Paint a raw count (`None`: no signal) and its calibration (`None`: unknown)."""
    marks: tuple[int, ...] = ()
    fill = "bar"
    if calibration is not None:
        marks = calibration.minimum, calibration.neutral, calibration.maximum
        if count is not None and abs(count - calibration.neutral) <= calibration.deadband:
            fill = "neutral"
    paint_track(painter, track, axis, count, marks, fill=fill)
