"""Finding a board whose serial settings nobody knows, without moving anything.

Every question is put as `looking` does it: harmless to a board at any settings, whatever was
asked before.
"""

import contextlib
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field, replace
from itertools import product

from trex_gui.link.client import Client
from trex_gui.link.looking import RINSE_LINE, Answer, Attempt, Heard, checksum, put_question, rinse
from trex_gui.link.reading import ask
from trex_gui.link.settings import LinkSettings
from trex_gui.link.transport import SerialTransport, Transport
from trex_gui.protocol.commands import GetParameter, GetSignature, Signature
from trex_gui.protocol.crc7 import DEFAULT_POLYNOMIAL
from trex_gui.protocol.errors import BadReply, BadRequest, NoReply, PortUnavailable
from trex_gui.protocol.line_settings import Detection, LineSettings, baud_rates
from trex_gui.protocol.parameters import parameter_number

_LIKELY = (19200, 115200, 9600, 38400, 57600)

_NUMBERS = 128

_LOADER = b"?"
"""What a board that waits for firmware answers to anything, behind an echo."""

_LOOK = 0.3
"""Seconds to listen for something that talks by itself."""


def attempts(*, full: bool = False) -> Iterator[Attempt]:
    """Return every question in the order in which to ask, the likely ones first.

    `full` adds every other CRC-7 polynomial than the factory's, which takes some minutes; ten of
    them cannot be asked for safely at two of the rates (`looking.UNSAFE`).
    """
    rates = sorted(baud_rates(), key=lambda baud: (baud not in _LIKELY, _rank(baud)))
    for stop_bits in (1, 2):
        for detection in (Detection.NONE, Detection.EVEN, Detection.ODD):
            for baud in rates:
                yield Attempt(LineSettings(baud, detection, stop_bits))
        for baud in rates:
            line = LineSettings(baud, Detection.CRC7, stop_bits)
            yield Attempt(line, (DEFAULT_POLYNOMIAL,))
    if not full:
        return
    alike: dict[int, list[int]] = {}
    for polynomial in range(0x80, 0x100):
        if polynomial != DEFAULT_POLYNOMIAL:
            alike.setdefault(checksum(polynomial), []).append(polynomial)
    for stop_bits, baud, polynomials in product((1, 2), rates, alike.values()):
        attempt = Attempt(LineSettings(baud, Detection.CRC7, stop_bits), tuple(polynomials))
        if not attempt.is_unsafe:
            yield attempt


def _rank(baud: int) -> int:
    return _LIKELY.index(baud) if baud in _LIKELY else -baud


@dataclass(frozen=True, slots=True)
class Found:
    """A board, and how to reach it.

    Attributes:
        settings: what to connect with; addressed by number only where several boards share
            the line.
        signature: which board it is.
        device_number: the number that it answers to, where it said so.
        note: what else to know of it, for people; may be empty.
    """

    settings: LinkSettings
    signature: Signature
    device_number: int | None = None
    echo: bool = False
    note: str = ""

    @property
    def name(self) -> str:
        """Product and firmware, such as `TReX 1.2`."""
        return str(self.signature)


@dataclass(frozen=True, slots=True)
class Step:
    """How far a search is: `done` of `total` questions; `line` is asked on next.

    `number` is the device number that is asked for, where a board has answered already.
    """

    done: int
    total: int
    line: LineSettings
    number: int | None = None


@dataclass(slots=True)
class Search:
    """What a search has seen.

    Attributes:
        found: boards; more than one only where several share the line.
        echo: whether what was sent came back.
        strange: what answered otherwise, and at which settings, first things first.
        skipped: settings that the port cannot have.
        fixed: whether somebody else sets the rate, so that only one question could be asked.
        cancelled: whether it ended early because it was asked to.
    """

    url: str
    found: list[Found] = field(default_factory=list)
    echo: bool = False
    strange: list[tuple[LineSettings, bytes]] = field(default_factory=list)
    several: LineSettings | None = None
    skipped: list[LineSettings] = field(default_factory=list)
    fixed: bool = False
    cancelled: bool = False

    def verdict(self) -> str:
        """Say what was seen where no board was found, and what to look at."""
        if self.several is not None:
            return (
                f"Several boards answer at once on {self.url} at {self.several.text()}. "
                "The full search asks for each device number."
            )
        if self.strange:
            line, data = self.strange[0]
            shown = data[:12].hex(" ").upper() + (" …" if len(data) > 12 else "")
            if all(data == _LOADER for _, data in self.strange):
                return (
                    f"What is connected to {self.url} answers as a TReX that waits for new "
                    "firmware. Take the SO-G jumper off, then switch the board off and on."
                )
            return (
                f"Something is connected to {self.url}, but it does not answer as a TReX does: "
                f"{shown} came at {line.text()}. Another device, or a line that is disturbed."
            )
        if self.echo:
            return (
                f"Everything sent on {self.url} comes back, and nothing else, at every rate. "
                "Either this is the RS-232 side of a board that is off, or the adapter's TX and "
                "RX are joined."
            )
        if self.fixed:
            return (
                f"No TReX answers on {self.url}. Its baud rate is set at the other end of the "
                "network, so only that one could be tried, without parity and without CRC."
            )
        return (
            f"No TReX answers on {self.url} at any baud rate, with any parity or with CRC. Check "
            "that the board has power (an LED is lit), that the adapter's TX goes to SI and its "
            "RX to SO (or both RS-232 pins, never mixed), and that ground is connected. A board "
            "with a CRC polynomial of its own is only found by the full search."
        )


def _silent(step: Step) -> None:
    del step


def _never() -> bool:
    return False


def find(
    settings: LinkSettings,
    open_wire: Callable[[LinkSettings], Transport] = SerialTransport,
    progress: Callable[[Step], None] = _silent,
    cancelled: Callable[[], bool] = _never,
    *,
    full: bool = False,
) -> Search:
    """Look for a board on a port, whatever it is set to; end with the first that answers.

    Args:
        settings: the port, and how patient to be; line and framing do not matter.
        open_wire: opens the port.
        progress: called before each question.
        cancelled: asked before each question whether to end.
        full: try every polynomial, and ask a found line for each device number. All boards
            on that line must run at its rate then.

    Raises:
        PortUnavailable: the port cannot be opened, or is gone.
    """
    wire = open_wire(replace(settings, line=RINSE_LINE, device_number=None))
    search = Search(settings.name or settings.url, fixed=not wire.can_be_tuned)
    # A separator that is as fast as the question does not keep two kinds of questions apart.
    plan = [Attempt(LineSettings())] if search.fixed else list(attempts(full=full))
    try:
        seeker = _Seeker(wire, settings, search, progress, cancelled)
        seeker.listen()
        for done, attempt in enumerate(plan):
            if cancelled():
                search.cancelled = True
                break
            progress(Step(done, len(plan), attempt.line))
            if seeker.try_out(attempt, full=full):
                break
    finally:
        # A byte that is on its way must not change its rate. And some boards with USB start
        # their loader when a port is closed at 1200 baud.
        wire.wait(RINSE_LINE.seconds(2) + wire.latency)
        with contextlib.suppress(BadRequest, PortUnavailable):
            wire.tune(LineSettings())
        wire.close()
    return search


class _Seeker:
    """Asks on one line, and remembers in a search what it saw."""

    def __init__(
        self,
        wire: Transport,
        settings: LinkSettings,
        search: Search,
        progress: Callable[[Step], None],
        cancelled: Callable[[], bool],
    ) -> None:
        self._progress = progress
        self._cancelled = cancelled
        self._wire = wire
        self._settings = settings
        self._search = search

    def listen(self) -> None:
        """Notice what talks without being asked."""
        with contextlib.suppress(BadReply):
            self._wire.discard()
        if data := self._wire.read(16, _LOOK):
            self._search.strange.append((RINSE_LINE, data))

    def try_out(self, attempt: Attempt, *, full: bool) -> bool:
        """Ask once; return whether the search is over."""
        rinse(self._wire, self._settings.patience)
        try:
            self._wire.tune(attempt.line)
        except BadRequest:
            self._search.skipped.append(attempt.line)
            return False
        heard = put_question(self._wire, attempt, self._settings.patience)
        self._search.echo = self._search.echo or heard.echo
        return self._judge(attempt, heard, full=full)

    def _judge(self, attempt: Attempt, heard: Heard, *, full: bool) -> bool:
        found = self._confirm(attempt) if heard.answer is Answer.BOARD else None
        if found is not None:
            self._search.found.append(found)
        elif heard.answer is Answer.SEVERAL:
            self._search.several = attempt.line
        else:
            if heard.answer in {Answer.STRANGE, Answer.BOARD}:
                self._search.strange.append((attempt.line, heard.data))
            return False
        if full:
            self._ask_each_number(attempt)
        return True

    def _confirm(self, attempt: Attempt) -> Found | None:
        """Ask a board that answered for more, at settings which it now is known to have."""
        for polynomial in attempt.polynomials or (DEFAULT_POLYNOMIAL,):
            settings = replace(
                self._settings, line=attempt.line, device_number=None, polynomial=polynomial
            )
            client = Client(self._wire, settings, echo=self._search.echo)
            try:
                signature = ask(client.request, GetSignature())
                number = ask(client.request, GetParameter(parameter_number("device_number")))
                stored = ask(client.request, GetParameter(parameter_number("uart_settings")))
            except (NoReply, BadReply):
                continue
            note = _note(attempt.line, signature, stored)
            return Found(settings, signature, number, self._search.echo, note)
        return None

    def _ask_each_number(self, attempt: Attempt) -> None:
        """Look which device numbers answer; several that do replace what answered for all."""
        polynomial = self._search.found[0].settings.polynomial if self._search.found else None
        polynomial = polynomial or (attempt.polynomials or (DEFAULT_POLYNOMIAL,))[0]
        by_number: list[Found] = []
        for number in range(_NUMBERS):
            if self._cancelled():
                self._search.cancelled = True
                break
            self._progress(Step(number, _NUMBERS, attempt.line, number))
            settings = replace(
                self._settings, line=attempt.line, device_number=number, polynomial=polynomial
            )
            client = Client(self._wire, settings, echo=self._search.echo)
            with contextlib.suppress(NoReply, BadReply):
                signature = client.request(GetSignature())
                by_number.append(Found(settings, signature, number, self._search.echo))
        if len(by_number) > 1 or not self._search.found:
            self._search.found = by_number


def _note(line: LineSettings, signature: Signature, stored: int) -> str:
    """Say how what a board has stored differs from how it was reached."""
    try:
        kept = LineSettings.from_wire(stored)
    except BadRequest:
        return f"Its UART settings hold {stored:#04x}, which is no setting that is known."
    if kept == line:
        return ""
    real = kept.real_baud(signature.firmware)
    if real != kept.baud and real == line.baud:
        return (
            f"It is set to {kept.baud} baud, which firmware {signature.firmware} runs at half "
            f"the rate: connect at {line.baud}."
        )
    if replace(kept, stop_bits=line.stop_bits) == line:
        return f"It is set to {kept.stop_bits} stop bits; both numbers work on this line."
    return f"Switched off and on, it will run at {kept.text()}."
