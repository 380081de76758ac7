"""Transport to a served board, for commands that send single packets.

Each packet crosses the network as a `SendPacket`. The server sends the packet
between its own transactions.
"""

import time
from collections.abc import Callable, Collection
from itertools import count

from trex_gui.core.errors import BadReply, BadRequest, NoReply, PortUnavailable
from trex_gui.core.guardian.guardian import Guardian
from trex_gui.core.host import Host
from trex_gui.core.session import Close, Closed, Outcome, RequestQueue
from trex_gui.core.transport.settings import SerialFormat
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.devices.trex.protocol.framing import Malformed
from trex_gui.devices.trex.protocol.raw_packets import RawPacket
from trex_gui.devices.trex.serve.sessions import session_at
from trex_gui.devices.trex.session.messages import (
    Connected,
    NotResponding,
    Report,
    SendPacket,
    SetWatched,
)

_OPEN_TIMEOUT = 20.0  # seconds for the server to read the board
_REPLY_TIMEOUT = 10.0  # seconds; a packet may wait behind requests of other clients


class RemoteTransport:
    """`Transport` that reaches a board through a server.

    Raises:
        PortUnavailable: the server cannot be reached or has no board.
        NoReply: the board does not respond to the server.
    """

    latency = 0.0  # a reply is complete when it arrives
    is_configurable = False

    def __init__(self, settings: ConnectionSettings, computer: Host) -> None:
        self.clock = computer.clock
        self._ids = count(1)
        self._inbox = RequestQueue(computer.condition())
        self._reports = RequestQueue(computer.condition())
        self._received = b""
        self._closed: Closed | None = None
        session = session_at(
            settings, self._inbox, self._reports.put, computer.open_transport, computer.clock
        )
        self._join = computer.start_thread(session.run)
        self._inbox.put(SetWatched(False))
        try:
            connected = self._wait_for(
                lambda report: isinstance(report, Connected | NotResponding), _OPEN_TIMEOUT
            )
        except BaseException:
            self.close()
            raise
        if not isinstance(connected, Connected):
            self.close()
            raise NoReply(getattr(connected, "reason", ""))
        self.settings = connected.settings  # with the device number that the server uses

    def _wait_for(self, is_awaited: Callable[[Report], object], seconds: float) -> Report:
        end = self.clock() + seconds
        while (left := end - self.clock()) > 0:
            report: Report | None = self._reports.get(left)
            if isinstance(report, Closed):
                self._closed = report
                raise report.error or PortUnavailable("The connection was closed.")
            if report is not None and is_awaited(report):
                return report
        raise NoReply(f"The server did not reply within {seconds:g} s.")

    # --- Transport ----------------------------------------------------------------------

    def rates(self, wanted: Collection[int]) -> frozenset[int] | None:
        del wanted
        return None

    def reconfigure(self, line: SerialFormat) -> None:
        raise BadRequest(f"The line of a served board cannot be set to {line.short}.")

    def write(self, data: bytes) -> None:
        """Send a packet and wait for its reply, which `read` returns."""
        if self._closed is not None:
            raise self._closed.error or PortUnavailable("The connection was closed.")
        number = next(self._ids)
        self._inbox.put(SendPacket(number, RawPacket(Malformed(data, ""))))
        outcome = self._wait_for(
            lambda report: isinstance(report, Outcome) and report.id == number, _REPLY_TIMEOUT
        )
        assert isinstance(outcome, Outcome)  # noqa: S101 - checked
        if outcome.error is None and isinstance(outcome.value, bytes):
            self._received += outcome.value
        elif not isinstance(outcome.error, NoReply | BadReply):
            raise outcome.error or BadReply("The server returned no reply from the board.")

    def read(self, size: int, seconds: float) -> bytes:
        del seconds
        data, self._received = self._received[:size], self._received[size:]
        return data

    def discard(self) -> bytes:
        data, self._received = self._received, b""
        return data

    def wait(self, seconds: float) -> None:
        time.sleep(max(0.0, seconds))

    def start_guardian(self, silence: float) -> Guardian:
        del silence
        raise PortUnavailable("The guardian of a served board runs on its server.")

    def close(self) -> None:
        self._inbox.put(Close())
        self._join()
