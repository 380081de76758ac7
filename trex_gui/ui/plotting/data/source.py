"""What a plot takes its curves from: a board that is connected, a recording, a bench test."""

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from trex_gui.ui.devices.event_log import Event

Floats = NDArray[np.float64]

Points = tuple[Floats, Floats]
"""Times and values; a value that is no number interrupts the line."""


@dataclass(frozen=True, slots=True)
class TraceInfo:
    """What one curve is.

    Curves of one unit share an axis: the first unit of a source is that of the left one.
    """

    name: str  # one word, for programs and files: "motor1_current"
    label: str  # for people: "Motor 1 current"
    unit: str  # "A"; empty for plain counts
    color: str  # a name of the theme: "motor1"
    tag: str = ""  # one or two letters at the end of the line: "1"
    shown: bool = True  # whether it is drawn before a person chooses


@dataclass(frozen=True, slots=True)
class Statistics:
    """What a curve comes to within a time; times without samples count for nothing.

    `mean`, `rms`, `low` and `high` are no number where there is nothing to tell.
    """

    seconds: float = 0.0  # for which there were samples
    integral: float = 0.0  # unit x seconds
    mean: float = math.nan  # over time
    rms: float = math.nan  # over time
    low: float = math.nan
    high: float = math.nan

    @property
    def per_hour(self) -> float:
        """The integral in unit x hours: a current's charge in Ah."""
        return self.integral / 3600


class TraceSource(Protocol):
    """Curves and events on one clock, in seconds; it may grow while it is shown."""

    @property
    def traces(self) -> Sequence[TraceInfo]:
        """The curves, in the order of the legend; the same all the time."""
        ...

    @property
    def span(self) -> tuple[float, float] | None:
        """The times of the oldest and of the newest sample; `None` without any."""
        ...

    def points(self, name: str, start: float, end: float, bins: int) -> Points:
        """Return what to draw of a curve from `start` to `end`: a few points for each of `bins`.

        However many samples there are, it costs the same and no peak is lost.
        """
        ...

    def statistics(self, name: str, start: float, end: float) -> Statistics:
        """Return what a curve's samples from `start` to `end` come to."""
        ...

    def value_at(self, name: str, time: float) -> float:
        """Return a curve's value at a time, that of the last sample before it; else NaN."""
        ...

    def limit(self, name: str) -> float | None:
        """Return the limit of a curve, in its unit; `None` when there is none."""
        ...

    def samples(self, start: float, end: float) -> tuple[Floats, Sequence[Floats]]:
        """Return every time from `start` to `end` and each curve's values at these times."""
        ...

    def events_between(self, start: float, end: float) -> Sequence[Event]:
        """Return what happened from `start` to `end`, oldest first."""
        ...
