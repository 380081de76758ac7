"""Schedule of queries to the robot, and the decision that it does not respond."""

from enum import Enum, auto

KEEPALIVE_INTERVAL = 2.0  # seconds without a reply after which an idle robot is queried
QUERY_INTERVAL = 0.5  # seconds between two queries while a reply is awaited
RECONNECT_INTERVAL = 1.0  # seconds between two queries to a robot that is not responding
BOOT_TIME = 1.1
"""Seconds after `.h` in which the firmware reads nothing: 1 s of blinking, and a margin."""

BOOT_TIMEOUT = 6.0  # seconds allowed for a restart: a boot loader may delay it
CONNECT_TIMEOUT = 15.0
"""Seconds after which connecting fails if the robot only reports its start."""


class QueryReason(Enum):
    """Reason to await the reply to `.q` before anything else is sent."""

    CONNECTING = auto()
    RESTARTED = auto()
    UNCERTAIN = auto()
    NOT_RESPONDING = auto()


class LivenessMonitor:
    """Decides when to send `.q`.

    `reason`: why a reply to `.q` is awaited, or `None` while the robot responds.
    """

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
        """Schedule a query before anything else is sent."""
        if self.reason is None:
            self.reason = QueryReason.UNCERTAIN
            self._query_at = now
            self._deadline = now + QUERY_INTERVAL

    def on_restart(self, now: float) -> None:
        """Wait for the firmware to boot after `.h`."""
        self._query_at = now + BOOT_TIME
        self._deadline = now + BOOT_TIMEOUT
        if self.reason is QueryReason.CONNECTING:
            self._deadline = min(self._deadline, self._connect_deadline)
        else:
            self.reason = QueryReason.RESTARTED

    def set_not_responding(self, now: float) -> None:
        """Schedule queries at long intervals from now on."""
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
        """Return the seconds until a query is due, if the line is free. 0 if it is already due."""
        return max(0.0, (self._keepalive_at if self.reason is None else self._query_at) - now)

    def timed_out(self, now: float) -> bool:
        return self.reason not in {None, QueryReason.NOT_RESPONDING} and now >= self._deadline
