"""Scan for a TReX whose line settings are unknown: probes, replies and diagnosis."""

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
from trex_gui.devices.trex.client.reading import agreed, board_at, is_several, read_signature
from trex_gui.devices.trex.probe import Attempt, ReplyKind, checksum, send_probe
from trex_gui.devices.trex.protocol.commands import GetParameter, Signature
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.devices.trex.protocol.errors import ErrorCode, TrexBadReplyError
from trex_gui.devices.trex.protocol.framing import DEFAULT_POLYNOMIAL
from trex_gui.devices.trex.protocol.line_settings import Detection, LineSettings, baud_rates
from trex_gui.devices.trex.protocol.parameters import ParameterKey, parameter_number

_LIKELY = (19200, 115200, 9600, 38400, 57600)

_LAST_PROBES = 5
"""Number of final probes of the default settings, since a line may have swallowed replies. Other
likely settings are probed again once. On a silent line all this takes two seconds more."""

NUMBERS = 128  # device numbers that a board can have, from 0 on

_QIK = frozenset({b"1", b"2"})
"""Replies of a Pololu qik, to which 81 is a request for its firmware version.

Ref: qik 2s9v1 User's Guide 5.a, qik 2s12v10 User's Guide 5.b.
"""

_SHOWN = 12  # longest excerpt, in bytes, of an unknown reply


def attempts(*, full: bool = False) -> Iterator[Attempt]:
    """Yield every probe, likely probes first.

    `full` adds every CRC-7 polynomial but the default, which takes some minutes. Ten polynomials
    cannot be probed safely at two of the rates (`UNSAFE`).
    """
    rates = [*_LIKELY, *sorted({*baud_rates()} - {*_LIKELY}, reverse=True)]
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


@dataclass(frozen=True, slots=True)
class FoundBoard:
    settings: ConnectionSettings  # with a device number only if boards share the line
    signature: Signature
    device_number: int | None = None  # number that the board stores, if it was read
    echo: bool = False
    note: str = ""  # a hint for the user; may be empty

    @property
    def name(self) -> str:
        return str(self.signature)


def boards_by_number(
    client: TrexClient, progress: Callable[[int], object], cancelled: Callable[[], bool]
) -> list[FoundBoard]:
    """Return the boards on an open line that reply to a device number, in numerical order.

    `progress` gets each number before it is probed. Boards that share a number are left out. Raises
    PortUnavailable.
    """
    found: list[FoundBoard] = []
    for number in range(NUMBERS):
        if cancelled():
            break
        progress(number)
        with contextlib.suppress(BadReply):
            signature = board_at(client, number)
            if signature is not None:
                settings = replace(client.settings, device_number=number)
                found.append(FoundBoard(settings, signature, number, client.echo))
    return found


class TrexProber:
    """Prober of one line. `found` has several boards only if they share the line."""

    def __init__(
        self,
        settings: PortSettings,
        *,
        full: bool = False,
        known: bool = False,
        plans: Sequence[Sequence[Attempt]] = (),
    ) -> None:
        """Prepare the probes of `plans`, or probes of all settings if it is empty.

        `full` tries every polynomial, and each device number even where one board replies.
        """
        del known  # a probe moves nothing, whatever is connected
        self.found: list[FoundBoard] = []
        self._settings = ConnectionSettings.on(settings)
        self._full = full
        self.echo = False  # whether sent bytes came back
        self._strange: list[tuple[SerialFormat, bytes]] = []  # unknown data, and where
        self._is_loader = False
        self._several: LineSettings | None = None  # settings at which several boards reply
        self._skipped: list[LineSettings] = []  # settings unsupported by the port
        self._asks_numbers = not plans  # if several boards reply at once
        self._is_fixed = False  # the rate is set at the other end, so only one probe was possible
        plan = list(attempts(full=full))
        likely = plan[: len(_LIKELY)]
        again = likely + likely[:1] * (_LAST_PROBES - 1)
        self._plans = plans or (likely, plan[len(_LIKELY) :], again)

    @property
    def parts(self) -> tuple[int, ...]:
        """Number of probes by part: likely rates, all others, likely rates again, or `plans`."""
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
            # Only one probe: a flush byte at the same rate would not separate several.
            self._is_fixed = True
            plan = plan[:1] if part == 0 else []
        for done, attempt in enumerate(plan):
            if cancelled():
                return
            progress(ScanProgress(done, len(plan), attempt.line))
            self._probe(wire, attempt)
            if self.is_over:
                is_shared = self._several is not None and self._asks_numbers
                if is_shared or (self._full and not self._is_loader):
                    self._probe_each_number(wire, attempt, progress, cancelled)
                return

    def recall(self, wire: Transport, settings: ConnectionSettings) -> None:
        """Send one probe for a board that was found at these settings before."""
        self._settings, attempt = settings, Attempt.at(settings)
        if not attempt.is_unsafe:
            self._probe(wire, attempt, settings.device_number)

    def _probe(self, wire: Transport, attempt: Attempt, number: int | None = None) -> None:
        """Send one probe. `number` addresses one board if several boards reply."""
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
            # Its reply to the probe without a checksum was lost.
            attempt = Attempt(replace(attempt.line, detection=Detection.NONE))
        is_board = reply.kind in {ReplyKind.BOARD, ReplyKind.BOARD_WITHOUT_CRC}
        is_one_of_several = number is not None and reply.kind is ReplyKind.SEVERAL
        found = self._confirm(wire, attempt, number) if is_board or is_one_of_several else None
        if found is not None:
            self.found.append(found)
        elif reply.kind is ReplyKind.SEVERAL:
            self._several = attempt.line
        elif reply.kind is ReplyKind.BOOT_LOADER:
            # Noise may look like a boot loader once.
            self._is_loader = send_probe(wire, attempt, extra).kind is ReplyKind.BOOT_LOADER
        elif reply.kind is not ReplyKind.NOTHING and attempt.line not in dict(self._strange):
            self._strange.append((attempt.line, reply.data))

    def _confirm(self, wire: Transport, attempt: Attempt, number: int | None) -> FoundBoard | None:
        """Read a board that responded, at its line settings. `None` if that fails."""
        for polynomial in attempt.polynomials or (DEFAULT_POLYNOMIAL,):
            settings = self._settings_at(attempt.line, polynomial, number)
            client = TrexClient(wire, settings, echo=self.echo)
            try:
                signature = read_signature(client.request, has_crc=client.has_crc)
                stored_number, stored = (
                    agreed(
                        client.request, GetParameter(parameter_number(key)), has_crc=client.has_crc
                    )
                    for key in (ParameterKey.DEVICE_NUMBER, ParameterKey.UART_SETTINGS)
                )
            except (NoReply, BadReply):
                continue
            if is_several(client, stored_number):
                self._several = attempt.line
                return None
            note = _note(attempt.line, signature, stored)
            return FoundBoard(settings, signature, stored_number, self.echo, note)
        return None

    def _probe_each_number(
        self,
        wire: Transport,
        attempt: Attempt,
        progress: Callable[[ScanProgress], None],
        cancelled: Callable[[], bool],
    ) -> None:
        """Probe each device number. If several boards respond, they replace the found board."""
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
    def recognised(self) -> TrexBadReplyError | None:
        """Error that names a known device that replies but cannot be connected to."""
        url = self._settings.label
        if self._is_loader:
            return TrexBadReplyError(ErrorCode.BOOT_LOADER, url)
        if self._several is not None:
            return TrexBadReplyError(ErrorCode.SEVERAL_BOARDS, url, self._several.text())
        if self._strange and all(data in _QIK for _, data in self._strange):
            return TrexBadReplyError(ErrorCode.QIK, url)
        return None

    def diagnosis(self) -> Diagnosis:
        """Explain why no board was found, and what to check."""
        evidence, text = self._evidence()
        if self._skipped:
            rates = sorted({line.baud for line in self._skipped})
            text += tr(" The port cannot be set to {0} baud, so nothing was probed there.").format(
                ", ".join(map(str, rates))
            )
        return Diagnosis(evidence, text)

    def _evidence(self) -> tuple[Evidence, str]:
        url = self._settings.label
        if (recognised := self.recognised) is not None:
            return Evidence.KNOWN, str(recognised)
        if self._strange:
            return self._strange_evidence(url)
        if self.echo:
            return Evidence.ECHO, tr(
                "No TReX responds on {0}: everything sent comes back, and nothing else, "
                "at every rate. Either this is the RS-232 side of a board that is off, or"
                " the adapter's TX and RX are joined."
            ).format(url)
        if self._is_fixed:
            return Evidence.SILENCE, tr(
                "No TReX responds on {0}. Its baud rate is set at the other end of the "
                "network, so only that one could be tried, without parity and without "
                "CRC."
            ).format(url)
        return Evidence.SILENCE, tr(
            "No TReX responds on {0} at any baud rate, with any parity or with CRC. "
            "Check that the board has power (an LED is lit), that the adapter's TX "
            "goes to SI and its RX to SO (or both RS-232 pins, never mixed), and that"
            " ground is connected. A board with a custom CRC polynomial is only found"
            " by the full scan."
        ).format(url)

    def _strange_evidence(self, url: str) -> tuple[Evidence, str]:
        line, data = self._strange[0]
        shown = hex_text(data[:_SHOWN]) + (" …" if len(data) > _SHOWN else "")
        more = len(self._strange) - 1
        often = tr(", and something at {0} more").format(more) if more else ""
        text = tr(
            "Something is connected to {0}, but it does not respond like a TReX: it "
            "sent {1} at {2}{3}. It is another device, or the line is noisy."
        ).format(url, shown, line.text(), often)
        if self.echo:
            text += tr(" It also echoes what is sent.")
        return Evidence.STRANGE, text


def _note(line: LineSettings, signature: Signature, stored: int) -> str:
    """Return a hint if the stored line settings differ from the settings in use."""
    try:
        kept = LineSettings.from_wire(stored)
    except BadRequest:
        return tr("Its UART settings hold {0:#04x}, which is not a known setting.").format(stored)
    if kept == line:
        return ""
    real = kept.real_baud(signature.firmware)
    if real != kept.baud and real == line.baud:
        return tr(
            "It is set to {0} baud, which firmware {1} runs at half the rate: connect at {2}."
        ).format(kept.baud, signature.firmware, line.baud)
    if replace(kept, stop_bits=line.stop_bits) == line:
        return tr("It is set to {0} stop bits; both numbers work on this line.").format(
            kept.stop_bits
        )
    return tr("Switched off and on, it will run at {0}.").format(kept.text())


def recall(wire: Transport, settings: PortSettings, packed: str) -> FoundBoard | None:
    """Probe for a board at the settings of an earlier find. See `core.discovery.Recall`."""
    prober = TrexProber(settings)
    with contextlib.suppress(BadRequest):
        prober.recall(wire, ConnectionSettings.on(settings).unpacked(packed))
    return next(iter(prober.found), None)


TREX_PROBER = ProberInfo("TReX", TrexProber, recall=recall)
"""Prober of TReX boards, which send nothing unsolicited."""
