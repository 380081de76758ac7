r"""Finding an Aracna on a port where anything may be, without moving anything.

Asked is `\n.q\n` at 38400 8N1: to an Aracna a line that is nothing and the one question that
changes nothing. To a TReX at 38400 baud these are no commands; what one at another rate takes them
for is ended before and after by FF at 1200 baud, as the probe of the TReX does it, so nothing
that is asked hangs on what was asked before. The tests go through every TReX there can be. Where
somebody else sets the rate, as behind a plain network port, FF at that rate ends nothing at
another, and the question is an order to some: there it is asked only where a person has said that
the port leads to an Aracna.

Opening a port may reset the board: it says `.h` and is deaf for a second, so it is asked several
times.
"""

import contextlib
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field

from trex_gui.core.discovery.flush import flush
from trex_gui.core.discovery.prober import (
    Diagnosis,
    Evidence,
    ProberInfo,
    ScanProgress,
    ignore_step,
    never_cancelled,
)
from trex_gui.core.discovery.scan import listen, probe_in_order
from trex_gui.core.errors import BadReply, BadRequest, PortUnavailable
from trex_gui.core.transport.serial_port import SerialTransport, Transport
from trex_gui.core.transport.settings import PortSettings, SerialFormat
from trex_gui.devices.aracna.protocol import lines
from trex_gui.devices.aracna.protocol.replies import Reader, Version
from trex_gui.devices.aracna.session.client import LINE
from trex_gui.devices.aracna.session.diagnosis import diagnose, is_echo, is_start
from trex_gui.devices.aracna.session.liveness import motors_of

QUESTION = lines.NOTHING + lines.QUERY

QUESTIONS = 5
"""How often is asked; with the listening, 3.2 s on a local port."""

_WAIT = 0.45
"""Seconds until it is asked again."""

_HELLO = b"h\r\n"
_RESETS = "Opening this port has reset its board: it answers about a second later."

_SLICE = 0.02
_KEPT = 48


@dataclass(frozen=True, slots=True)
class FoundRobot:
    """An Aracna, and how to reach it."""

    settings: PortSettings
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
class AracnaScan:
    """What a search has seen.

    Attributes:
        settings: the port, and how it was asked.
        found: the robot, if it is one.
        heard: the first bytes that came.
            skipped: the port cannot be set so.
        fixed: somebody else sets the rate, so that it was not asked.
        cancelled: whether it ended early because it was asked to.
    """

    settings: PortSettings
    found: list[FoundRobot] = field(default_factory=list)
    heard: bytes = b""
    skipped: bool = False
    fixed: bool = False
    cancelled: bool = False

    def diagnosis(self) -> str:
        """Say what was seen where no robot was found, and what to look at."""
        return self.judged().text

    def judged(self) -> Diagnosis:
        """Say what was seen where no robot was found, what to look at, and how telling it is."""
        where = self.settings.text()
        if self.skipped:
            port = self.settings.name or self.settings.url
            text = f"No Aracna was asked for: {port} cannot be set to {LINE.text()}."
            return Diagnosis(Evidence.SILENCE, text)
        if self.fixed:
            return Diagnosis(
                Evidence.SILENCE,
                f"No Aracna was asked for on {self.settings.name or self.settings.url}: its baud "
                "rate is set at the other end of the network, and at another than its own a TReX "
                "could take the question for an order. Where you know that it is an Aracna, say "
                f"so once: trex-gui --device aracna --port {self.settings.url}",
            )
        if is_echo(self.heard):
            return Diagnosis(
                Evidence.ECHO,
                f"No Aracna answers on {where}: everything sent comes back, and nothing else. "
                "The adapter's TX and RX are joined; nothing of an Aracna does that.",
            )
        text = str(diagnose(self.settings, self.heard))
        if is_start(self.heard):
            return Diagnosis(Evidence.KNOWN, text)
        return Diagnosis(Evidence.STRANGE if self.heard.strip(b"\r\n") else Evidence.SILENCE, text)


class AracnaProber:
    """Looks for a robot on one line, and remembers in a search what came.

    Attributes:
        search: what it has seen.
    """

    parts = (QUESTIONS,)

    def __init__(self, settings: PortSettings, *, full: bool = False, known: bool = False) -> None:
        """Look on this port; there is one setting only, so `full` changes nothing."""
        del full
        self._known = known
        self.search = AracnaScan(settings.at(LINE))
        self._reader = Reader()

    @property
    def found(self) -> Sequence[FoundRobot]:
        """The robot, if it has answered."""
        return self.search.found

    @property
    def is_over(self) -> bool:
        """Whether it has answered."""
        return bool(self.search.found)

    def diagnosis(self) -> Diagnosis:
        """Say what was tried and heard, where no robot was found."""
        return self.search.judged()

    def note_unsolicited(self, line: SerialFormat, data: bytes) -> None:
        """Notice a board that opening the port has reset."""
        if line == LINE:
            self._take(data)

    def ask(
        self,
        wire: Transport,
        part: int,
        progress: Callable[[ScanProgress], None],
        cancelled: Callable[[], bool],
    ) -> None:
        """Ask until it answers or has not for long enough.

        Raises:
            PortUnavailable: the line is gone.
        """
        del part  # there is one
        search = self.search
        if not wire.is_configurable and not self._known:
            search.fixed = True
            return
        for done in range(QUESTIONS):
            if cancelled():
                search.cancelled = True
                return
            progress(ScanProgress(done, QUESTIONS, LINE))
            try:
                flush(wire, search.settings.timeouts.extra)
                wire.reconfigure(LINE)
            except BadRequest:
                search.skipped = True
                return
            if done == 0:
                with contextlib.suppress(BadReply):
                    wire.discard()  # what others were answered
            wire.write(QUESTION)
            if self._listen(wire, _WAIT + wire.latency + search.settings.timeouts.extra):
                return

    def _listen(self, wire: Transport, seconds: float) -> bool:
        """Take what comes; return whether it was a robot's answer."""
        end = wire.clock() + seconds
        while (rest := end - wire.clock()) > 0:
            data = wire.read(1, min(rest, _SLICE))
            try:
                data += wire.discard()
            except BadReply:  # bytes without end
                data += wire.read(_KEPT, 0.0)
            self._take(data)
            if self.search.found:
                return True
        return False

    def _take(self, data: bytes) -> None:
        search = self.search
        search.heard = (search.heard + data)[:_KEPT]
        for reply in self._reader.feed(data):
            if isinstance(reply, Version):
                note = _RESETS if _HELLO in search.heard else ""
                search.found.append(FoundRobot(search.settings, reply, note))
                return


ARACNA_PROBER = ProberInfo("Aracna", AracnaProber, announces_at=LINE)
"""How to look for an Aracna; its board says `.h` when it starts."""


def find_aracna(
    settings: PortSettings,
    *,
    progress: Callable[[ScanProgress], None] = ignore_step,
    cancelled: Callable[[], bool] = never_cancelled,
    open_wire: Callable[[PortSettings], Transport] = SerialTransport,
) -> AracnaScan:
    """Look for an Aracna alone on a port; end when it answers.

    Args:
        settings: the port, and how patient to be; the line does not matter.
        progress: called before each question.
        cancelled: asked before each question whether to end.
        open_wire: opens the port.

    Raises:
        PortUnavailable: the port cannot be opened, or is gone.
    """
    seeker = AracnaProber(settings)
    search = seeker.search
    wire = open_wire(search.settings)
    try:
        seeker.note_unsolicited(LINE, listen(wire))
        names = {"": ARACNA_PROBER.name}
        probe_in_order(wire, {"": seeker}, names, progress=progress, cancelled=cancelled)
    finally:
        # What a board at another rate has taken for a beginning must not be left to others.
        with contextlib.suppress(BadRequest, PortUnavailable):
            if not search.found and wire.is_configurable:
                flush(wire, search.settings.timeouts.extra)
            wire.reconfigure(LINE)
        wire.close()
    return search
