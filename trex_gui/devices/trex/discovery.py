"""Scan for a TReX at unknown line settings."""

import contextlib
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import product

from trex_gui.core.discovery.prober import Diagnosis, Evidence, ProberInfo, ScanProgress, flush
from trex_gui.core.errors import BadReply, BadRequest, NoReply
from trex_gui.core.texts import hex_text
from trex_gui.core.translation import tr
from trex_gui.core.transport.serial_port import Transport
from trex_gui.core.transport.settings import PortSettings, SerialFormat
from trex_gui.devices.trex.client.client import TrexClient
from trex_gui.devices.trex.client.reading import (
    board_at,
    read_reliably,
    read_signature,
    several_reply,
)
from trex_gui.devices.trex.probe import Attempt, ReplyKind, checksum, send_probe
from trex_gui.devices.trex.protocol.commands import GetParameter, Signature
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.devices.trex.protocol.errors import ErrorCode, TrexBadReplyError
from trex_gui.devices.trex.protocol.framing import DEFAULT_POLYNOMIAL
from trex_gui.devices.trex.protocol.line_settings import Detection, LineSettings, baud_rates
from trex_gui.devices.trex.protocol.parameters import ParameterKey, parameter_number

_LIKELY_RATES = (19200, 115200, 9600, 38400, 57600)  # bit/s, in probing order

_LAST_PROBES = 5
"""Number of probes at the default settings at the end of a scan, since a line may lose replies.

The other likely settings are probed once more. On a silent line, all these probes take two seconds.
"""

NUMBERS = 128  # size of the range of device numbers, 0 to 127

_QIK = frozenset({b"1", b"2"})
"""Replies of a Pololu qik to 81, which requests its firmware version.

Ref: qik 2s9v1 User's Guide 5.a, qik 2s12v10 User's Guide 5.b.
"""

_MAX_QUOTED = 12  # bytes of an unknown reply in a message


def attempts(*, full: bool = False) -> Iterator[Attempt]:
    """Yield every probe, likely settings first.

    `full` adds all other CRC-7 polynomials, which takes some minutes. Probes in `probe.UNSAFE` are
    omitted.
    """
    rates = [*_LIKELY_RATES, *sorted({*baud_rates()} - {*_LIKELY_RATES}, reverse=True)]
    for stop_bits in (1, 2):
        for detection in (Detection.NONE, Detection.EVEN, Detection.ODD):
            for baud in rates:
                yield Attempt(LineSettings(baud, detection, stop_bits))
        for baud in rates:
            line = LineSettings(baud, Detection.CRC7, stop_bits)
            yield Attempt(line, (DEFAULT_POLYNOMIAL,))
    if not full:
        return
    by_checksum: dict[int, list[int]] = {}
    for polynomial in range(0x80, 0x100):
        if polynomial != DEFAULT_POLYNOMIAL:
            by_checksum.setdefault(checksum(polynomial), []).append(polynomial)
    for stop_bits, baud, polynomials in product((1, 2), rates, by_checksum.values()):
        attempt = Attempt(LineSettings(baud, Detection.CRC7, stop_bits), tuple(polynomials))
        if not attempt.is_unsafe:
            yield attempt


@dataclass(frozen=True, slots=True)
class FoundBoard:
    settings: ConnectionSettings  # contains a device number only if boards share the line
    signature: Signature
    device_number: int | None = None  # stored number; `None` if it was not read
    echo: bool = False
    note: str = ""  # hint for the user; may be empty

    @property
    def name(self) -> str:
        return str(self.signature)


def boards_by_number(
    client: TrexClient, progress: Callable[[int], object], cancelled: Callable[[], bool]
) -> list[FoundBoard]:
    """Probe each device number, and return the boards in numerical order.

    `progress` is called with each number before it is probed. Boards that share a number are
    omitted.
    """
    boards: list[FoundBoard] = []
    for number in range(NUMBERS):
        if cancelled():
            break
        progress(number)
        with contextlib.suppress(BadReply):
            signature = board_at(client, number)
            if signature is not None:
                settings = replace(client.settings, device_number=number)
                boards.append(FoundBoard(settings, signature, number, client.echo))
    return boards


class TrexProber:
    """Prober for one line. `found` contains more than one board if they share the line."""

    def __init__(
        self,
        settings: PortSettings,
        *,
        full: bool = False,
        known: bool = False,
        plans: Sequence[Sequence[Attempt]] = (),
    ) -> None:
        """Prepare the probes in `plans`. By default, all settings are probed.

        `full` adds every polynomial. It also probes every device number, even if one board replies.
        """
        del known  # irrelevant, because no probe moves a motor
        self.found: list[FoundBoard] = []
        self._settings = ConnectionSettings.on(settings)
        self._full = full
        self.echo = False  # True if sent bytes are echoed
        self._strange: list[tuple[SerialFormat, bytes]] = []  # line settings and unknown data
        self._is_loader = False
        self._several: LineSettings | None = None  # settings at which boards reply at once
        self._skipped: list[LineSettings] = []  # settings that the port does not support
        self._probes_numbers = not plans  # True to probe device numbers if boards reply at once
        self._is_rate_fixed = False  # True if the other end sets the rate and allows one probe only
        plan = list(attempts(full=full))
        likely = plan[: len(_LIKELY_RATES)]
        last_probes = likely + likely[:1] * (_LAST_PROBES - 1)
        self._plans = plans or (likely, plan[len(_LIKELY_RATES) :], last_probes)

    @property
    def parts(self) -> tuple[int, ...]:
        return tuple(len(plan) for plan in self._plans)

    @property
    def is_over(self) -> bool:
        return bool(self.found) or self._several is not None or self._is_loader

    def record_unsolicited(self, line: SerialFormat, data: bytes) -> None:
        self._strange.append((line, data))

    def probe(
        self,
        wire: Transport,
        part: int,
        progress: Callable[[ScanProgress], None],
        cancelled: Callable[[], bool],
    ) -> None:
        plan = list(self._plans[part])
        if not wire.is_configurable:
            # A flush byte at the same rate cannot separate probes, so only one probe is sent.
            self._is_rate_fixed = True
            plan = plan[:1] if part == 0 else []
        for done, attempt in enumerate(plan):
            if cancelled():
                return
            progress(ScanProgress(done, len(plan), attempt.line))
            self._probe(wire, attempt)
            if self.is_over:
                is_shared = self._several is not None and self._probes_numbers
                if is_shared or (self._full and not self._is_loader):
                    self._probe_each_number(wire, attempt, progress, cancelled)
                return

    def recall(self, wire: Transport, settings: ConnectionSettings) -> None:
        self._settings, attempt = settings, Attempt.at(settings)
        if not attempt.is_unsafe:
            self._probe(wire, attempt, settings.device_number)

    def _probe(self, wire: Transport, attempt: Attempt, number: int | None = None) -> None:
        try:
            if attempt.number is None:
                flush(wire, self._settings.timeouts.extra)
            wire.reconfigure(attempt.line)
        except BadRequest:
            self._skipped.append(attempt.line)
            return
        extra = self._settings.timeouts.extra
        reply = send_probe(wire, attempt, extra)
        self.echo = self.echo or reply.echo
        if reply.kind is ReplyKind.BOARD_WITHOUT_CRC:
            # The reply to the earlier probe without a checksum was lost.
            attempt = Attempt(replace(attempt.line, detection=Detection.NONE))
        is_board = reply.kind in {ReplyKind.BOARD, ReplyKind.BOARD_WITHOUT_CRC}
        is_one_of_several = number is not None and reply.kind is ReplyKind.SEVERAL
        board = self._confirm(wire, attempt, number) if is_board or is_one_of_several else None
        if board is not None:
            self.found.append(board)
        elif reply.kind is ReplyKind.SEVERAL:
            self._several = attempt.line
        elif reply.kind is ReplyKind.BOOT_LOADER:
            # Noise may look like a boot loader, but rarely twice in a row.
            self._is_loader = send_probe(wire, attempt, extra).kind is ReplyKind.BOOT_LOADER
        elif reply.kind is not ReplyKind.NOTHING and attempt.line not in dict(self._strange):
            self._strange.append((attempt.line, reply.data))

    def _confirm(self, wire: Transport, attempt: Attempt, number: int | None) -> FoundBoard | None:
        """Return the board that replied, or `None` if it cannot be read."""
        for polynomial in attempt.polynomials or (DEFAULT_POLYNOMIAL,):
            settings = self._settings_at(attempt.line, polynomial, number)
            client = TrexClient(wire, settings, echo=self.echo)
            try:
                signature = read_signature(client.request, has_crc=client.has_crc)
                stored_number, stored = (
                    read_reliably(
                        client.request, GetParameter(parameter_number(key)), has_crc=client.has_crc
                    )
                    for key in (ParameterKey.DEVICE_NUMBER, ParameterKey.UART_SETTINGS)
                )
            except (NoReply, BadReply):
                continue
            if several_reply(client, stored_number):
                self._several = attempt.line
                return None
            note = _line_hint(attempt.line, signature, stored)
            return FoundBoard(settings, signature, stored_number, self.echo, note)
        return None

    def _probe_each_number(
        self,
        wire: Transport,
        attempt: Attempt,
        progress: Callable[[ScanProgress], None],
        cancelled: Callable[[], bool],
    ) -> None:
        """Probe each device number. The boards replace `found` unless they add none."""
        polynomial = (attempt.polynomials or (DEFAULT_POLYNOMIAL,))[0]
        if self.found:
            polynomial = self.found[0].settings.polynomial
        client = TrexClient(wire, self._settings_at(attempt.line, polynomial, None), echo=self.echo)

        def report(number: int) -> None:
            progress(ScanProgress(number, NUMBERS, attempt.line, number))

        by_number = boards_by_number(client, report, cancelled)
        if len(by_number) > 1 or not self.found:
            self.found = by_number

    def _settings_at(
        self, line: LineSettings, polynomial: int, number: int | None
    ) -> ConnectionSettings:
        return replace(self._settings, line=line, polynomial=polynomial, device_number=number)

    # --- Diagnosis ----------------------------------------------------------------------

    @property
    def recognized(self) -> TrexBadReplyError | None:
        """Error about a recognized device to which the program cannot connect."""
        url = self._settings.label
        if self._is_loader:
            return TrexBadReplyError(ErrorCode.BOOT_LOADER, url)
        if self._several is not None:
            return TrexBadReplyError(ErrorCode.SEVERAL_BOARDS, url, self._several.text())
        if self._strange and all(data in _QIK for _, data in self._strange):
            return TrexBadReplyError(ErrorCode.QIK, url)
        return None

    def diagnosis(self) -> Diagnosis:
        """Return the likely cause and its remedy."""
        evidence, text = self._evidence()
        if self._skipped:
            rates = sorted({line.baud for line in self._skipped})
            text += tr(
                " The port does not support {0} baud, so the scan skipped these settings."
            ).format(", ".join(map(str, rates)))
        return Diagnosis(evidence, text)

    def _evidence(self) -> tuple[Evidence, str]:
        url = self._settings.label
        if (recognized := self.recognized) is not None:
            return Evidence.KNOWN, str(recognized)
        if self._strange:
            return self._strange_evidence(url)
        if self.echo:
            return Evidence.ECHO, tr(
                "No TReX responds on {0}: at every rate, everything sent comes back and "
                "nothing else arrives. Either this is the RS-232 side of a board that is "
                "off, or the adapter's TX and RX are joined."
            ).format(url)
        if self._is_rate_fixed:
            return Evidence.SILENCE, tr(
                "No TReX responds on {0}. The baud rate is set at the other end of the "
                "network, so only that rate could be tried, without parity and without CRC."
            ).format(url)
        text = tr(
            "No TReX responds on {0} at any baud rate, with any parity or with CRC. Check "
            "that the board has power (an LED is lit), that the adapter's TX goes to SI and "
            "its RX to SO (an RS-232 adapter: to the RS-232 pins), and that ground is "
            "connected."
        ).format(url)
        if not self._full:
            more = tr("Only the full search finds a board with a custom CRC polynomial.")
            text = f"{text} {more}"
        return Evidence.SILENCE, text

    def _strange_evidence(self, url: str) -> tuple[Evidence, str]:
        line, data = self._strange[0]
        quoted = hex_text(data[:_MAX_QUOTED]) + (" …" if len(data) > _MAX_QUOTED else "")
        other_count = len(self._strange) - 1
        others = tr(", and data at {0} other settings").format(other_count) if other_count else ""
        text = tr(
            "Something is connected to {0}, but it does not respond like a TReX: it sent {1} "
            "at {2}{3}. Either it is another device, or the line is noisy."
        ).format(url, quoted, line.text(), others)
        if self.echo:
            text += tr(" It also echoes what is sent.")
        return Evidence.STRANGE, text


def _line_hint(used: LineSettings, signature: Signature, wire_value: int) -> str:
    try:
        stored = LineSettings.from_wire(wire_value)
    except BadRequest:
        return tr("Its UART settings have the unknown value {0:#04x}.").format(wire_value)
    if stored == used:
        return ""
    real = stored.real_baud(signature.firmware)
    if real != stored.baud and real == used.baud:
        return tr(
            "It is set to {0} baud, but with this setting, firmware {1} runs at half the "
            "rate: connect at {2} baud."
        ).format(stored.baud, signature.firmware, used.baud)
    if replace(stored, stop_bits=used.stop_bits) == used:
        return tr("It is set to {0} stop bits; either number works on this line.").format(
            stored.stop_bits
        )
    return tr("After a power cycle, it will run at {0}.").format(stored.text())


def recall(wire: Transport, settings: PortSettings, packed: str) -> FoundBoard | None:
    """Probe for a board at the settings of an earlier scan. See `prober.Recall`."""
    prober = TrexProber(settings)
    with contextlib.suppress(BadRequest):
        prober.recall(wire, ConnectionSettings.on(settings).unpacked(packed))
    return next(iter(prober.found), None)


TREX_PROBER = ProberInfo("TReX", TrexProber, recall=recall)
