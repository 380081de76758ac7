"""The bar of an input with its calibration, and its axis."""

from collections.abc import Iterable

from PySide6.QtCore import QRectF
from PySide6.QtGui import QPainter

from trex_gui.devices.trex.protocol.calibration import Calibration
from trex_gui.devices.trex.protocol.flags import InputSource
from trex_gui.ui.plotting.axes import Labels, ticks, value_labels
from trex_gui.ui.widgets.bar import paint_track

# Raw counts. Ref: Pololu TReX User's Guide 4.b: a pulse counts from 0.5 to 2.5 ms.
USUAL_AXIS = {InputSource.RC: (2000, 5500), InputSource.ANALOG: (0, 1023)}
_GROWS_BY = 250  # 100 us
_STEPS = {  # between two labels of an axis, in µs and V
    InputSource.RC: (100.0, 200.0, 500.0, 1000.0, 2000.0),
    InputSource.ANALOG: (0.5, 1.0, 2.5, 5.0, 10.0),
}


def input_axis(
    source: InputSource, calibration: Calibration | None, count: int | None = None
) -> tuple[int, int]:
    """Return the ends of an axis that includes the calibration and the count."""
    counts = [] if count is None else [count]
    if calibration is not None:
        counts += [calibration.minimum, calibration.maximum]
    return widened(USUAL_AXIS[source], counts)


def widened(axis: tuple[int, int], counts: Iterable[int]) -> tuple[int, int]:
    """Return the ends of an axis, moved in round steps to include these counts."""
    low, high = axis
    for count in counts:
        if count < low:
            low = max(0, count // _GROWS_BY * _GROWS_BY)
        if count > high:
            high = -(-count // _GROWS_BY) * _GROWS_BY
    return low, high


def input_labels(source: InputSource, axis: tuple[int, int], most: int) -> Labels:
    """Return at most `most` labels, at positions in counts. The last label has the unit."""
    low, high = (source.physical(count) for count in axis)
    for step in _STEPS[source]:
        values = ticks(low, high, step)
        if len(values) <= most:
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
