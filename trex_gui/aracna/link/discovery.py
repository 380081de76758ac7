r"""Finding an Aracna on a port where anything may be, without moving anything.

Asked is `\n.q\n` at 38400 8N1: to an Aracna a line that is nothing and the one question that
changes nothing. To a TReX at 38400 baud these are no commands; what one at another rate takes them
for is ended before and after by FF at 1200 baud, as `trex_gui.link.looking` does it, so nothing
that is asked hangs on what was asked before. The tests go through every TReX there can be.

Opening a port may reset the board: it says `.h` and is deaf for a second, so it is asked several
times.
"""

import contextlib
from collections.abc import Callable
from dataclasses import dataclass, field, replace

from trex_gui.aracna.link.client import LINE
from trex_gui.aracna.link.doctor import why_no_robot
from trex_gui.aracna.link.presence import motors_of
from trex_gui.aracna.protocol import lines
from trex_gui.aracna.protocol.replies import Reader, Version
from trex_gui.link.discovery import Step
from trex_gui.link.looking import rinse
from trex_gui.link.settings import LinkSettings
from trex_gui.link.transport import SerialTransport, Transport
from trex_gui.protocol.errors import BadReply, BadRequest, PortUnavailable

QUESTION = lines.NOTHING + lines.QUERY

QUESTIONS = 5
"""How often is asked; with the listening, 2.8 s on a local port."""

_LISTEN = 0.3
"""Seconds to hear a board that opening the port has reset."""

_WAIT = 0.45
"""Seconds until it is asked again."""

_HELLO = b"h\r\n"
_RESETS = "Opening this port has reset its board: it answers about a second later."

_SLICE = 0.02
_KEPT = 48


@dataclass(frozen=True, slots=True)
class Found:
    """An Aracna, and how to reach it."""

    settings: LinkSettings
    version: Version
    note: str = ""

    @property
    def name(self) -> str:
        """Which it is, such as `Aracna 1`."""
        return f"Aracna {self.version.version}"

    @property
    def motors(self) -> int:
        """How many motors it has."""
        return motors_of(self.version)

    @property
    def device_number(self) -> None:
        """It has none: it is alone on its line."""

    @property
    def echo(self) -> bool:
        """What is sent does not come back."""
        return False


@dataclass(slots=True)
class Search:
    """What a search has seen.

    Attributes:
        settings: the port, and how it was asked.
        found: the robot, if it is one.
        heard: the first bytes that came.
        skipped: the port cannot be set so.
        cancelled: whether it ended early because it was asked to.
    """

    settings: LinkSettings
    found: list[Found] = field(default_factory=list)
    heard: bytes = b""
    skipped: bool = False
    cancelled: bool = False

    def verdict(self) -> str:
        """Say what was seen where no robot was found, and what to look at."""
        if self.skipped:
            return f"{self.settings.name or self.settings.url} cannot be set to {LINE.text()}."
        return str(why_no_robot(self.settings, self.heard))


def _silent(step: Step) -> None:
    del step


def _never() -> bool:
    return False


def find_aracna(
    settings: LinkSettings,
    *,
    progress: Callable[[Step], None] = _silent,
    cancelled: Callable[[], bool] = _never,
    full: bool = False,
    open_wire: Callable[[LinkSettings], Transport] = SerialTransport,
) -> Search:
    """Look for an Aracna on a port; end when it answers.

    Args:
        settings: the port, and how patient to be; the line does not matter.
        progress: called before each question.
        cancelled: asked before each question whether to end.
        full: changes nothing; there is one setting only.
        open_wire: opens the port.

    Raises:
        PortUnavailable: the port cannot be opened, or is gone.
    """
    del full
    settings = replace(settings, line=LINE, device_number=None)
    search = Search(settings)
    wire = open_wire(settings)
    try:
        _Seeker(wire, search).run(progress, cancelled)
    finally:
        # What a board at another rate has taken for a beginning must not be left to others.
        with contextlib.suppress(BadRequest, PortUnavailable):
            rinse(wire, settings.patience)
            wire.tune(LINE)
        wire.close()
    return search


class _Seeker:
    """Asks on one line, and remembers in a search what came."""

    def __init__(self, wire: Transport, search: Search) -> None:
        self._wire = wire
        self._search = search
        self._reader = Reader()

    def run(self, progress: Callable[[Step], None], cancelled: Callable[[], bool]) -> None:
        """Listen, then ask until it answers or has not for long enough."""
        search, wire = self._search, self._wire
        self._listen(_LISTEN)
        for done in range(QUESTIONS):
            if cancelled():
                search.cancelled = True
                return
            progress(Step(done, QUESTIONS, LINE))
            try:
                rinse(wire, search.settings.patience)
                wire.tune(LINE)
            except BadRequest:
                search.skipped = True
                return
            wire.write(QUESTION)
            if self._listen(_WAIT + wire.latency + search.settings.patience):
                return

    def _listen(self, seconds: float) -> bool:
        """Take what comes; return whether it was a robot's answer."""
        wire, search = self._wire, self._search
        end = wire.clock() + seconds
        while (rest := end - wire.clock()) > 0:
            data = wire.read(1, min(rest, _SLICE))
            try:
                data += wire.discard()
            except BadReply:  # bytes without end
                data += wire.read(_KEPT, 0.0)
            search.heard = (search.heard + data)[:_KEPT]
            for reply in self._reader.feed(data):
                if isinstance(reply, Version):
                    note = _RESETS if _HELLO in search.heard else ""
                    search.found.append(Found(search.settings, reply, note))
                    return True
        return False
