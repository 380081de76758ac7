"""Whether a line has been free of damage for a while: what stands behind every clean status.

A clean status proves that the board latched no error, not that the packet before it was the one
that was sent: without a CRC, one bit makes C0 7F (brake) into C2 7F (full speed ahead), or 86 1F
(a question) into C6 1F (a quarter ahead). But a line that does so damages other bytes too, and
those are noticed.
"""

from trex_gui.devices.trex.client.client import Counters, TrexClient
from trex_gui.devices.trex.client.telemetry import LatchedStatus
from trex_gui.devices.trex.protocol.line_settings import Detection

QUIET = 300
"""Whole answers in a row, none of them with damage, after which a line counts as quiet.

Each byte arrives with probability p as another one, any of its bits alike. Then the last packet
of a brake drives that motor with 2p/9 (two of the eight data bits and the stop bit), and goes
unnoticed. Each answer stands for at least one byte of ours whose damage would have been noticed, so
that a line which does it counts as quiet with less than 2p/9 * (1 - p)**300: at most 2.7e-4 (where
p is 1/300), 1.1e-4 at 1 %, 1.0e-5 at 2 %, 2e-9 at 5 %. The speed of the auxiliary motor has seven
such bits: 3.5 times that. What remains is cured by CRC-7, which notices every single bit.

At 19200 baud and above they take 1.6 s.
"""


class LineQuality:
    """Counts the whole answers since the last damage; without any in sight a line is quiet.

    Attributes:
        damages: how often damage was seen.
    """

    def __init__(self) -> None:
        self.damages = 0
        self._counters: Counters | None = None
        self._harm = 0
        self._harmed_at: int | None = None

    def look(self, client: TrexClient) -> None:
        """See whether transactions have failed since the last look."""
        counters = client.counters
        harm = counters.silences + counters.damaged + counters.stale
        if self._counters is not counters:
            self._counters, self._harm = counters, 0
            self._harmed_at = None if self._harmed_at is None else counters.answers
        if harm != self._harm:
            self._harm = harm
            self._note_damage()

    def note(self, news: LatchedStatus | None) -> None:
        """Learn from a status what the board has seen."""
        if news is not None and news.has_line_error:
            self._note_damage()

    def is_quiet(self, client: TrexClient) -> bool:
        """Whether what has been proved by clean statuses is proved for good."""
        self.look(client)
        if client.settings.line.detection is Detection.CRC7 or self._harmed_at is None:
            return True
        return client.counters.answers - self._harmed_at >= QUIET

    def _note_damage(self) -> None:
        self.damages += 1
        if self._counters is not None:
            self._harmed_at = self._counters.answers
