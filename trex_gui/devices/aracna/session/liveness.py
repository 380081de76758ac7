"""Schedule of queries, and detection of a robot that does not respond."""

from enum import Enum, auto

KEEPALIVE_INTERVAL = 2.0  # seconds from a reply to the next query of an idle robot
QUERY_INTERVAL = 0.5  # seconds between queries while a reply is awaited
RECONNECT_INTERVAL = 1.0  # seconds between queries of a robot that does not respond
BOOT_TIME = 1.1  # seconds from `.h` to the next query; the firmware reads nothing for 1 s
BOOT_TIMEOUT = 6.0  # maximum duration of a restart in seconds, including a boot loader
CONNECT_TIMEOUT = 15.0  # maximum seconds to connect to a robot that keeps restarting


class QueryReason(Enum):
    """Reason to await a reply to `.q` before other commands are sent."""

    CONNECTING = auto()
    RESTARTED = auto()
    UNCERTAIN = auto()
    NOT_RESPONDING = auto()


class LivenessMonitor:
    """Decides when to send `.q`. `reason`: `None` while the robot responds."""

    def __init__(self, now: float) -> None:
        self.reason: QueryReason | None = QueryReason.CONNECTING
        self._query_at = now
        self._deadline = now + BOOT_TIMEOUT
        self._connect_deadline = now + CONNECT_TIMEOUT
        self._keepalive_at = now

    @property
    def is_responding(self) -> bool:
        return self.reason in {None, QueryReason.UNCERTAIN}

    def on_missing_reply(self, now: float) -> None:
        """Schedule a query that precedes other commands."""
        if self.reason is None:
            self.reason = QueryReason.UNCERTAIN
            self._query_at = now
            self._deadline = now + QUERY_INTERVAL

    def on_restart(self, now: float) -> None:
        self._query_at = now + BOOT_TIME
        self._deadline = now + BOOT_TIMEOUT
        if self.reason is QueryReason.CONNECTING:
            self._deadline = min(self._deadline, self._connect_deadline)
        else:
            self.reason = QueryReason.RESTARTED

    def set_not_responding(self, now: float) -> None:
        self.reason = QueryReason.NOT_RESPONDING
        self._query_at = now + RECONNECT_INTERVAL

    def on_reply(self, now: float) -> None:
        self._keepalive_at = now + KEEPALIVE_INTERVAL

    def on_version(self, now: float) -> None:
        self.reason = None
        self.on_reply(now)

    def on_query_timeout(self, now: float) -> None:
        self._query_at = max(self._query_at, now)
        if self.reason is QueryReason.NOT_RESPONDING:
            self._query_at = now + RECONNECT_INTERVAL - QUERY_INTERVAL

    def seconds_to_query(self, now: float) -> float:
        """Return the seconds until a query is due, at least 0."""
        return max(0.0, (self._keepalive_at if self.reason is None else self._query_at) - now)

    def timed_out(self, now: float) -> bool:
        return self.reason not in {None, QueryReason.NOT_RESPONDING} and now >= self._deadline
