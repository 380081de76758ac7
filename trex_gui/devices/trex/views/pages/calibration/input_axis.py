"""The axis that channel inputs stand along: how far it goes, and its ticks."""

from collections.abc import Iterable

from trex_gui.devices.trex.protocol.flags import InputSource
from trex_gui.ui.plotting.axes import ticks

# Raw counts. Ref: Pololu TReX User's Guide 4.b: a pulse counts from 0.5 to 2.5 ms.
_USUAL = {InputSource.RC: (2000, 5500), InputSource.ANALOG: (0, 1023)}
_ROOM = {InputSource.RC: 125, InputSource.ANALOG: 0}  # beyond a handle, to drag it on
_GROWS_BY = 250  # 100 us
_STEPS = {
    InputSource.RC: (100.0, 200.0, 500.0, 1000.0, 2000.0),
    InputSource.ANALOG: (0.5, 1.0, 2.5, 5.0, 10.0),
}


def axis_for(source: InputSource, shown: Iterable[int]) -> tuple[int, int]:
    """Return the counts at both ends: the usual ones, or further when something lies there."""
    low, high = _USUAL[source]
    room = _ROOM[source]
    for count in shown:
        if count - room < low:
            low = max(0, (count - room) // _GROWS_BY * _GROWS_BY)
        if count + room > high:
            high = -(-(count + room) // _GROWS_BY) * _GROWS_BY
    return low, high


def input_ticks(source: InputSource, axis: tuple[int, int], most: int) -> list[tuple[float, str]]:
    """Return where the ticks lie, in counts, and what stands there; the last has the unit."""
    low, high = (source.physical(count) for count in axis)
    values: list[float] = []
    for step in _STEPS[source]:
        values = ticks(low, high, step)
        if len(values) <= most:
            break
    texts = [f"{value:g}" for value in values]
    if texts:
        texts[-1] += f" {source.unit}"
    return [(v * source.counts_per_unit, t) for v, t in zip(values, texts, strict=True)]
