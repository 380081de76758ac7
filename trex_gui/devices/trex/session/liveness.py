"""Whether the board still answers; where it does not, when and where to look for it again."""

from trex_gui.core.timing import Timeouts
from trex_gui.devices.trex.client.client import TrexClient
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.devices.trex.session.reconnecting import ReconnectSearch

_FAILURES_TO_SILENCE = 3


class LivenessMonitor:
    """One board, as far as its answers tell; knows no clock.

    Attributes:
        silent: whether the board has stopped answering.
        retry_at: when to look for a silent one again.
    """

    def __init__(self, timeouts: Timeouts) -> None:
        self._retry = timeouts.retry
        self.silent = False
        self.retry_at = 0.0
        self._failures = 0
        self._search = ReconnectSearch()

    def begin(self) -> None:
        """Take the board for there: everything was read."""
        self.silent = False
        self._failures = 0
        self._search.end()

    def note_answer(self) -> None:
        """One transaction succeeded."""
        self._failures = 0

    def note_failure(self, now: float) -> bool:
        """One transaction failed; return whether the board counts as silent from now on."""
        self._failures += 1
        if self._failures < _FAILURES_TO_SILENCE or self.silent:
            return False
        self.silent = True
        self._search.begin()
        self.retry_later(now)
        return True

    def retry_later(self, now: float) -> None:
        """Look again after the usual pause."""
        self.retry_at = now + self._retry

    def is_scanning(self, client: TrexClient, expected: tuple[ConnectionSettings, ...]) -> bool:
        """Whether a silent board may be at other settings.

        Then nothing goes out but stops and what is harmless to a board at any rate.
        """
        can = client.transport.is_configurable
        return self.silent and can and (self._search.has_looked or bool(expected))

    def look(
        self, client: TrexClient, expected: tuple[ConnectionSettings, ...]
    ) -> TrexClient | None:
        """Put one question; return who talks to the board from now on, if it answered.

        Raises:
            PortUnavailable: the line is gone.
        """
        found = self._search.look(client, expected)
        if found is None:
            pause = self._retry if self._search.is_round_over else 0.0
            self.retry_at = client.transport.clock() + pause
        return found
