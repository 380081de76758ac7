"""Curves of a plot, with limits and events."""

from bisect import bisect_left, bisect_right
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from operator import attrgetter
from typing import TYPE_CHECKING

from trex_gui.core.events import Event

if TYPE_CHECKING:  # numpy takes as long to load as the window
    from trex_gui.ui.plotting.history import Floats, Points, SampleHistory, Statistics


@dataclass(frozen=True, slots=True)
class TraceInfo:
    name: str  # for programs and files: "motor1_current"
    label: str  # for the user: "Motor 1 current"
    unit: str  # "A"; empty for plain counts
    color: str  # theme colour: "motor1"
    tag: str = ""  # one or two characters at the end of the curve: "1"
    shown: bool = True  # visible by default


class Traces:
    """Curves of a history, with limits and events.

    `limits`: curve name → limit. `events`: in chronological order.
    """

    def __init__(
        self,
        traces: Sequence[TraceInfo],
        history: "SampleHistory",
        events: Sequence[Event] = (),
        limits: Mapping[str, float] | None = None,
    ) -> None:
        self.traces = tuple(traces)
        self.limits = {} if limits is None else limits
        self._columns = {trace.name: column for column, trace in enumerate(traces)}
        self._history = history
        self._events = events

    def set_color(self, name: str, color: str) -> None:
        self.traces = tuple(
            replace(trace, color=color) if trace.name == name else trace for trace in self.traces
        )

    @property
    def span(self) -> tuple[float, float] | None:
        """Times of the oldest and the newest sample in seconds, or `None`."""
        return self._history.span

    @property
    def left_unit(self) -> str:
        return self.traces[0].unit

    @property
    def right_unit(self) -> str:
        """Unit of the right axis. Empty for plain counts, or if there is no right axis."""
        return next((t.unit for t in self.traces if t.unit != self.left_unit), "")

    def points(self, name: str, start: float, end: float, bins: int) -> "Points":
        return self._history.points(self._columns[name], start, end, bins)

    def statistics(self, name: str, start: float, end: float) -> "Statistics":
        return self._history.statistics(self._columns[name], start, end)

    def value_at(self, name: str, time: float) -> float:
        """Return a curve's last value at or before a time, or NaN."""
        return self._history.value_at(self._columns[name], time)

    def samples(self, start: float, end: float) -> "tuple[Floats, Sequence[Floats]]":
        """Return the times, and the values of each curve.

        The arrays are views, which are valid until a row is added.
        """
        rows = self._history.rows(start, end)
        columns = [self._history.values(column)[rows] for column in range(len(self.traces))]
        return self._history.times[rows], columns

    def events_between(self, start: float, end: float) -> Sequence[Event]:
        time = attrgetter("time")
        first = bisect_left(self._events, start, key=time)
        return self._events[first : bisect_right(self._events, end, key=time)]
