"""The search for a board that has fallen silent and may come back at other settings."""

import logging
from collections import deque

from trex_gui.core.errors import BadRequest
from trex_gui.devices.trex.client.client import TrexClient
from trex_gui.devices.trex.discovery.probe import is_board_at, reconnect_places
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings

log = logging.getLogger(__name__)


class ReconnectSearch:
    """Looks at one place after the other, round and round.

    Attributes:
        has_looked: whether a question went out since the board was there: then one at another
            rate may have heard other bytes than those that were sent.
    """

    def __init__(self) -> None:
        self.has_looked = False
        self._places: deque[ConnectionSettings] = deque()
        self._expected: tuple[ConnectionSettings, ...] = ()

    @property
    def is_round_over(self) -> bool:
        """Whether each place had its turn."""
        return not self._places

    def begin(self) -> None:
        """Begin with the first place: the board has just fallen silent."""
        self._places.clear()

    def end(self) -> None:
        """Take the board for found."""
        self.has_looked = False

    def look(
        self, client: TrexClient, expected: tuple[ConnectionSettings, ...]
    ) -> TrexClient | None:
        """Put one question; return who talks to the board from now on, if it answered.

        Raises:
            PortUnavailable: the line is gone.
        """
        self.has_looked = True
        if expected != self._expected:
            self._places.clear()  # of the others, where it is not expected any more
            self._expected = expected
        if not self._places:
            self._places.extend(reconnect_places(client.settings, expected))
        place, transport = self._places.popleft(), client.transport
        try:
            found = is_board_at(transport, place, echo=client.echo)
        except BadRequest as error:
            log.info("%s: %s", place.text(), error)
            found = False
        if not found:
            # A stop must find the line as the board was heard last.
            transport.reconfigure(client.settings.line)
            return None
        if place == client.settings:
            return client
        log.info("the board came back at %s", place.text())
        there = TrexClient(transport, place, echo=client.echo)
        there.counters = client.counters
        return there
