"""Whether a line has been free of damage long enough to trust a clean status.

A clean status confirms that the board latched no error, not that the packet before it was the one
that was sent: without a CRC, one bit makes C0 7F (brake) into C2 7F (full speed forward), or 86 1F
(a query) into C6 1F (a quarter forward). But a line that does so damages other bytes too, and
those are noticed.
"""

from trex_gui.devices.trex.client.client import Counters
from trex_gui.devices.trex.client.telemetry import LatchedStatus

QUIET = 300
"""Whole replies in a row without damage after which a line counts as quiet.

Each byte arrives with probability p as another one, any of its bits alike. Then the last packet
of a brake drives that motor with 2p/9 (two of the eight data bits and the stop bit), unnoticed.
Each reply stands for at least one byte of ours, damage to which would have been noticed, so that
a line which does it counts as quiet with less than 2p/9 * (1 - p)**300: at most 2.7e-4 (where
p is 1/300), 1.1e-4 at 1 %, 1.0e-5 at 2 %, 2e-9 at 5 %. The speed of the auxiliary motor has seven
such bits: 3.5 times that. CRC-7, which notices every single bit, removes what remains.

At 19200 baud and above they take 1.6 s.
"""


class LineQuality:
    """Counts whole replies since the last damage.

    Attributes:
        answers: whole replies since the line was opened.
        damages: how often damage was noticed.
    """

    def __init__(self) -> None:
        self.answers = 0
        self.damages = 0
        self._has_crc = False
        self._is_observed = False
        self._failures = 0
        self._damaged_at: int | None = None

    def observe(self, counters: Counters, *, has_crc: bool) -> None:
        """Take the counters of the client, which show whether transactions have failed."""
        self.answers = counters.answers
        self._has_crc = has_crc
        self._is_observed = True
        failures = counters.silences + counters.damaged + counters.stale
        if failures != self._failures:
            self._failures = failures
            self._note_damage()

    def note_status(self, latched: LatchedStatus | None) -> None:
        """Take the line errors that the board has latched.

        Before the first `observe` they are older than the connection.
        """
        if self._is_observed and latched is not None and latched.has_line_error:
            self._note_damage()

    @property
    def is_quiet(self) -> bool:
        """Whether clean statuses are sufficient confirmation."""
        if self._has_crc or self._damaged_at is None:
            return True
        return self.answers - self._damaged_at >= QUIET

    def _note_damage(self) -> None:
        self.damages += 1
        self._damaged_at = self.answers
