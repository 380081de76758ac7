"""Whether the board responds; where it does not, when and where to look for it."""

import logging
from collections import deque

from trex_gui.core.errors import BadRequest
from trex_gui.core.timing import Timeouts
from trex_gui.devices.trex.client.client import TrexClient
from trex_gui.devices.trex.discovery.probe import is_board_at, reconnect_places
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings

log = logging.getLogger(__name__)

_FAILURES = 3
"""Failed transactions in a row after which a board counts as not responding."""


class LivenessMonitor:
    """Counts failures, and looks for a board that does not respond, one place after the other.

    Attributes:
        silent: whether the board has stopped responding.
        retry_at: when to look for it again, on the line's clock.
    """

    def __init__(self, timeouts: Timeouts) -> None:
        self.silent = False
        self.retry_at = 0.0
        self._retry = timeouts.retry
        self._failures = 0
        self._has_probed = False
        self._places: deque[ConnectionSettings] = deque()
        self._candidates: tuple[ConnectionSettings, ...] = ()

    def begin(self) -> None:
        """Take the board for responding: everything was read."""
        self.silent = False
        self._failures = 0
        self._has_probed = False

    def note_answer(self) -> None:
        """One transaction succeeded."""
        self._failures = 0

    def note_failure(self, now: float) -> bool:
        """One transaction failed; return whether the board counts as silent from now on."""
        self._failures += 1
        if self._failures < _FAILURES or self.silent:
            return False
        self.silent = True
        self._places.clear()
        self.retry_later(now)
        return True

    def retry_later(self, now: float) -> None:
        """Look again after the usual pause."""
        self.retry_at = now + self._retry

    def is_scanning(self, client: TrexClient, candidates: tuple[ConnectionSettings, ...]) -> bool:
        """Whether a silent board may be at other settings.

        Then nothing may be sent but stops and what is harmless to a board at any rate. After the
        first probe it stays so: a board at another rate may have received other bytes.
        """
        can_probe = client.transport.is_configurable
        return self.silent and can_probe and (self._has_probed or bool(candidates))

    def look(
        self, client: TrexClient, candidates: tuple[ConnectionSettings, ...]
    ) -> TrexClient | None:
        """Send one probe; return the client to use from now on if the board answered.

        Raises:
            PortUnavailable: the line is gone.
        """
        self._has_probed = True
        if candidates != self._candidates:
            self._places.clear()
            self._candidates = candidates
        if not self._places:
            self._places.extend(reconnect_places(client.settings, candidates))
        found = _probe(client, self._places.popleft())
        if found is None:
            self.retry_at = client.transport.clock() + (0.0 if self._places else self._retry)
        return found


def _probe(client: TrexClient, place: ConnectionSettings) -> TrexClient | None:
    transport = client.transport
    try:
        found = is_board_at(transport, place, echo=client.echo)
    except BadRequest as error:
        log.info("%s: %s", place.text(), error)
        found = False
    if not found:
        # A stop must find the line as the board was last heard.
        transport.reconfigure(client.settings.line)
        return None
    if place == client.settings:
        return client
    log.info("the board came back at %s", place.text())
    there = TrexClient(transport, place, echo=client.echo)
    there.counters = client.counters
    return there
