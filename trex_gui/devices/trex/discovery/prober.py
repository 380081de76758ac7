"""Finding a board with unknown serial settings, without moving anything; see `probe`."""

import contextlib
from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from itertools import product

from trex_gui.core.discovery.prober import (
    FLUSH_LINE,
    Diagnosis,
    ProberInfo,
    ScanProgress,
    flush,
    ignore_step,
    never_cancelled,
)
from trex_gui.core.discovery.scan import listen, probe_in_order
from trex_gui.core.errors import BadReply, BadRequest, NoReply, PortUnavailable
from trex_gui.core.transport.serial_port import SerialTransport, Transport
from trex_gui.core.transport.settings import PortSettings, SerialFormat
from trex_gui.devices.trex.client.client import TrexClient
from trex_gui.devices.trex.client.reading import query
from trex_gui.devices.trex.discovery.probe import (
    Attempt,
    ProbeReply,
    ReplyKind,
    checksum,
    send_probe,
)
from trex_gui.devices.trex.discovery.results import FoundBoard, TrexScan
from trex_gui.devices.trex.protocol.commands import GetParameter, GetSignature, Signature
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.devices.trex.protocol.framing import DEFAULT_POLYNOMIAL
from trex_gui.devices.trex.protocol.line_settings import Detection, LineSettings, baud_rates
from trex_gui.devices.trex.protocol.parameters import ParameterKey, parameter_number

__all__ = [
    "TREX_PROBER",
    "FoundBoard",
    "ScanProgress",
    "TrexProber",
    "TrexScan",
    "attempts",
    "find",
]

_LIKELY = (19200, 115200, 9600, 38400, 57600)

_NUMBERS = 128


def attempts(*, full: bool = False) -> Iterator[Attempt]:
    """Return every probe, likely ones first.

    `full` adds every CRC-7 polynomial but the default, which takes some minutes; ten of them cannot
    be probed safely at two of the rates (`probe.UNSAFE`).
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


class TrexProber:
    """Probes one line; `search` has the results so far."""

    def __init__(self, settings: PortSettings, *, full: bool = False, known: bool = False) -> None:
        """`full` tries every polynomial and each device number."""
        del known  # a probe moves nothing, whatever is connected
        self.search = TrexScan(settings.label)
        self._settings = ConnectionSettings.on(settings)
        self._full = full
        plan = list(attempts(full=full))
        self._plans = (plan[: len(_LIKELY)], plan[len(_LIKELY) :])

    @property
    def parts(self) -> tuple[int, ...]:
        """The likely rates, then everything else."""
        return tuple(len(plan) for plan in self._plans)

    @property
    def found(self) -> Sequence[FoundBoard]:
        """The boards; more than one only where several share the line."""
        return self.search.found

    @property
    def is_over(self) -> bool:
        """Whether boards have answered."""
        return bool(self.search.found) or self.search.several is not None

    def diagnosis(self) -> Diagnosis:
        """Explain why no board was found."""
        return self.search.judged()

    def note_unsolicited(self, line: SerialFormat, data: bytes) -> None:
        """Note unsolicited bytes: no TReX sends any."""
        if data:
            self.search.strange.append((line, data))

    def ask(
        self,
        wire: Transport,
        part: int,
        progress: Callable[[ScanProgress], None],
        cancelled: Callable[[], bool],
    ) -> None:
        """Send the probes of a part until a board answers.

        Raises:
            PortUnavailable: the line is gone.
        """
        plan = self._plans[part]
        if not wire.is_configurable:
            # A flush byte at the rate of the probes does not separate them.
            self.search.fixed = True
            plan = [Attempt(LineSettings())] if part == 0 else []
        for done, attempt in enumerate(plan):
            if cancelled():
                self.search.cancelled = True
                return
            progress(ScanProgress(done, len(plan), attempt.line))
            heard = self._put(wire, attempt)
            if heard is not None:
                self._judge(wire, attempt, heard)
            if self.is_over:
                if self._full:
                    self._probe_each_number(wire, attempt, progress, cancelled)
                return

    def _put(self, wire: Transport, attempt: Attempt) -> ProbeReply | None:
        """Send one probe; return `None` if the port does not support its line settings."""
        try:
            flush(wire, self._settings.timeouts.extra)
            wire.reconfigure(attempt.line)
        except BadRequest:
            self.search.skipped.append(attempt.line)
            return None
        heard = send_probe(wire, attempt, self._settings.timeouts.extra)
        self.search.echo = self.search.echo or heard.echo
        return heard

    def _judge(self, wire: Transport, attempt: Attempt, heard: ProbeReply) -> None:
        found = self._confirm(wire, attempt) if heard.answer is ReplyKind.BOARD else None
        if found is not None:
            self.search.found.append(found)
        elif heard.answer is ReplyKind.SEVERAL:
            self.search.several = attempt.line
        elif heard.answer in {ReplyKind.STRANGE, ReplyKind.BOARD}:
            self.search.strange.append((attempt.line, heard.data))

    def _confirm(self, wire: Transport, attempt: Attempt) -> FoundBoard | None:
        """Read more from a board that answered; its line settings are known now."""
        for polynomial in attempt.polynomials or (DEFAULT_POLYNOMIAL,):
            settings = replace(
                self._settings, line=attempt.line, device_number=None, polynomial=polynomial
            )
            client = TrexClient(wire, settings, echo=self.search.echo)
            try:
                signature = query(client.request, GetSignature())
                number = query(
                    client.request, GetParameter(parameter_number(ParameterKey.DEVICE_NUMBER))
                )
                stored = query(
                    client.request, GetParameter(parameter_number(ParameterKey.UART_SETTINGS))
                )
            except (NoReply, BadReply):
                continue
            note = _note(attempt.line, signature, stored)
            return FoundBoard(settings, signature, number, self.search.echo, note)
        return None

    def _probe_each_number(
        self,
        wire: Transport,
        attempt: Attempt,
        progress: Callable[[ScanProgress], None],
        cancelled: Callable[[], bool],
    ) -> None:
        """Probe each device number; several that answer replace the board that was found."""
        polynomial = self.search.found[0].settings.polynomial if self.search.found else None
        polynomial = polynomial or (attempt.polynomials or (DEFAULT_POLYNOMIAL,))[0]
        by_number: list[FoundBoard] = []
        for number in range(_NUMBERS):
            if cancelled():
                self.search.cancelled = True
                break
            progress(ScanProgress(number, _NUMBERS, attempt.line, number))
            settings = replace(
                self._settings, line=attempt.line, device_number=number, polynomial=polynomial
            )
            client = TrexClient(wire, settings, echo=self.search.echo)
            with contextlib.suppress(NoReply, BadReply):
                signature = client.request(GetSignature())
                by_number.append(FoundBoard(settings, signature, number, self.search.echo))
        if len(by_number) > 1 or not self.search.found:
            self.search.found = by_number


TREX_PROBER = ProberInfo("TReX", TrexProber)
"""Finds TReX boards, which send nothing unsolicited."""


def find(
    settings: PortSettings,
    open_wire: Callable[[PortSettings], Transport] = SerialTransport,
    progress: Callable[[ScanProgress], None] = ignore_step,
    cancelled: Callable[[], bool] = never_cancelled,
    *,
    full: bool = False,
) -> TrexScan:
    """Look for a TReX on a port at any settings until the first answers.

    Args:
        settings: port and timeouts; line settings and framing do not matter.
        open_wire: opens the port.
        progress: called before each probe.
        cancelled: checked before each probe.
        full: try every polynomial, and each device number where something answers. All boards
            on that line must run at its rate then.

    Raises:
        PortUnavailable: the port cannot be opened, or is gone.
    """
    wire = open_wire(settings.at(FLUSH_LINE))
    prober = TrexProber(settings, full=full)
    try:
        prober.note_unsolicited(FLUSH_LINE, listen(wire))
        names = {"": TREX_PROBER.name}
        probe_in_order(wire, {"": prober}, names, progress=progress, cancelled=cancelled)
    finally:
        # A byte that is on its way must not change its rate. And some boards with USB start
        # their loader when a port is closed at 1200 baud.
        wire.wait(FLUSH_LINE.seconds(2) + wire.latency)
        with contextlib.suppress(BadRequest, PortUnavailable):
            wire.reconfigure(LineSettings())
        wire.close()
    return prober.search


def _note(line: LineSettings, signature: Signature, stored: int) -> str:
    """Say how the stored line settings differ from those in use."""
    try:
        kept = LineSettings.from_wire(stored)
    except BadRequest:
        return f"Its UART settings hold {stored:#04x}, which is not a known setting."
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
