"""The curves of a history with what happened meanwhile: what a plot is given."""

from bisect import bisect_left, bisect_right
from collections.abc import Mapping, Sequence

from trex_gui.ui.devices.event_log import Event
from trex_gui.ui.plotting.data.history import SampleHistory
from trex_gui.ui.plotting.data.source import Floats, Points, Statistics, TraceInfo


class Traces:
    """A `TraceSource`: one curve a column of a history, and events.

    Nothing is copied; it shows what the history and the list of events hold at the moment.
    """

    def __init__(
        self,
        traces: Sequence[TraceInfo],
        history: SampleHistory,
        events: Sequence[Event] = (),
        limits: Mapping[str, float] | None = None,
    ) -> None:
        """Show the columns of `history` as `traces`, in this order.

        `limits` are in the curves' units; `events` are in the order of time.

        Raises:
            ValueError: there are not as many names as columns.
        """
        if len(traces) != history.columns:
            raise ValueError(f"{len(traces)} names for {history.columns} columns")
        self._traces = tuple(traces)
        self._columns = {trace.name: column for column, trace in enumerate(traces)}
        self._history = history
        self._events = events
        self._limits = {} if limits is None else limits  # it may be filled later

    @property
    def traces(self) -> Sequence[TraceInfo]:
        """The curves, in the order of the columns."""
        return self._traces

    @property
    def span(self) -> tuple[float, float] | None:
        """The times of the oldest and of the newest sample."""
        return self._history.span

    def points(self, name: str, start: float, end: float, bins: int) -> Points:
        """Return what to draw of a curve; see `SampleHistory.points`."""
        return self._history.points(self._columns[name], start, end, bins)

    def statistics(self, name: str, start: float, end: float) -> Statistics:
        """Return what a curve's samples come to."""
        return self._history.statistics(self._columns[name], start, end)

    def value_at(self, name: str, time: float) -> float:
        """Return a curve's last value before or at a time, else NaN."""
        return self._history.value_at(self._columns[name], time)

    def limit(self, name: str) -> float | None:
        """Return a curve's limit."""
        return self._limits.get(name)

    def samples(self, start: float, end: float) -> tuple[Floats, Sequence[Floats]]:
        """Return the times and every curve's values: views, valid until the next row."""
        rows = self._history.rows(start, end)
        columns = [self._history.values(column)[rows] for column in range(len(self._traces))]
        return self._history.times[rows], columns

    def events_between(self, start: float, end: float) -> Sequence[Event]:
        """Return what happened from `start` to `end`, oldest first."""
        first = bisect_left(self._events, start, key=_time)
        return self._events[first : bisect_right(self._events, end, key=_time)]


def _time(event: Event) -> float:
    return event.time
