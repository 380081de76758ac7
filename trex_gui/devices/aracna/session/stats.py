"""Telling how a line does, often enough to be read and no more often."""

from collections.abc import Callable

from trex_gui.devices.aracna.session.client import AracnaClient
from trex_gui.devices.aracna.session.messages import LineStats, LineStatsChanged, Report

INTERVAL = 1.0
"""Seconds between two reports at least."""


class StatsReporter:
    """Tells what a client has counted, where it is new."""

    def __init__(self, client: AracnaClient, tell: Callable[[Report], None]) -> None:
        self._client = client
        self._tell = tell
        self._told = LineStats()
        self._next = client.transport.clock()

    def look(self, now: float) -> None:
        """Tell, if it is time and there is something new: not of a command on its way alone."""
        counters = self._client.counters
        if now < self._next or _settled(counters) == _settled(self._told):
            return
        self._told, self._next = counters, now + INTERVAL
        self._tell(LineStatsChanged(counters))


def _settled(counters: LineStats) -> tuple[int, ...]:
    """Return what changes with every end of a command, and with what comes unasked."""
    return (
        counters.answers,
        counters.silences,
        counters.damaged,
        counters.strange,
        counters.restarts,
    )
