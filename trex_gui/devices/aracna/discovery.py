r"""Search for an Aracna, without moving any device.

The probe is `\n.q\n` at 38400 8N1. An Aracna reads it as an empty line followed by its only query.
Neither has a side effect. A TReX at 38400 baud does not find a command in the probe, because the
bytes of the probe follow each other without a pause. (With odd parity, the TReX reads 29 between
two framing errors.) At another rate, a TReX may find the start of a command. Therefore, FF at 1200
baud terminates any incomplete packet before and after the probe, as in the search for a TReX. The
tests check this at every rate of a TReX.

On a port with a fixed rate, such as a plain network port, FF has no effect, and some boards would
read the probe as a command. Such a port is probed only if the user has selected an Aracna for it.

Opening a port may reset the board. The board then reports `.h` and does not listen for a second.
Therefore, the probe is repeated.
"""

from collections.abc import Callable
from dataclasses import dataclass
from enum import Enum

from trex_gui.core.discovery.prober import (
    Diagnosis,
    Evidence,
    ProberInfo,
    ScanProgress,
    flush,
    ignore_step,
    never_cancelled,
)
from trex_gui.core.errors import BadRequest
from trex_gui.core.translation import tr, tr_noop
from trex_gui.core.transport.serial_port import Transport
from trex_gui.core.transport.settings import PortSettings, SerialFormat
from trex_gui.devices.aracna.protocol import commands
from trex_gui.devices.aracna.protocol.replies import Reader, Version
from trex_gui.devices.aracna.session.client import LINE, SAVED_BYTES, read_available
from trex_gui.devices.aracna.session.errors import ErrorCode, diagnose

PROBE = commands.EMPTY + commands.QUERY

MAX_PROBES = 5  # five probes take 3.2 s on a local port
_PROBE_INTERVAL = 0.45  # seconds
_READ_TIMEOUT = 0.02  # seconds

_HELLO = b"h\r\n"
_EVIDENCE: dict[Enum, Evidence] = {
    ErrorCode.NO_ROBOT: Evidence.SILENCE,
    ErrorCode.ECHO: Evidence.ECHO,
    ErrorCode.OTHER_DEVICE: Evidence.STRANGE,
    ErrorCode.BOOT_LOOP: Evidence.KNOWN,
}
_RESETS = tr_noop(
    "Opening this port reset the board. The board responds again after about a second."
)


@dataclass(frozen=True, slots=True)
class FoundRobot:
    settings: PortSettings
    version: Version
    note: str = ""
    device_number = None
    echo = False

    @property
    def name(self) -> str:
        return tr("Aracna {0}").format(self.version.version)

    @property
    def motors(self) -> int:
        return self.version.motor_count


class AracnaProber:
    parts = (MAX_PROBES,)

    def __init__(self, settings: PortSettings, *, full: bool = False, known: bool = False) -> None:
        """`full` has no effect, because an Aracna has only one line setting."""
        del full
        self.found: list[FoundRobot] = []
        self._settings = settings.at(LINE)
        self._known = known
        self._not_sent = ""  # reason why no probe was sent
        self._received = b""
        self._reader = Reader()

    @property
    def is_over(self) -> bool:
        return bool(self.found)

    def record_unsolicited(self, line: SerialFormat, data: bytes) -> None:
        """Handle bytes received before a probe, such as `.h` after a reset."""
        if line == LINE:
            self._handle(data)

    def probe(
        self,
        wire: Transport,
        part: int,
        progress: Callable[[ScanProgress], None],
        cancelled: Callable[[], bool],
    ) -> None:
        del part  # there is only one part
        extra = self._settings.timeouts.extra
        if not wire.is_configurable and not self._known:
            self._not_sent = tr(
                "No probe for an Aracna was sent on {0}: the baud rate is set at the other "
                "end of the network, and a TReX at another rate could mistake the probe for "
                "a command. If you know that the device is an Aracna, connect once with: "
                "trex-gui --device aracna --port {1}"
            ).format(self._settings.label, self._settings.url)
            return
        for done in range(MAX_PROBES):
            if cancelled():
                return
            progress(ScanProgress(done, MAX_PROBES, LINE))
            try:
                flush(wire, extra)
                wire.reconfigure(LINE)
            except BadRequest:
                self._not_sent = tr(
                    "No probe for an Aracna was sent: {0} cannot be set to {1}."
                ).format(self._settings.label, LINE.text())
                return
            if done == 0:
                read_available(wire)  # discards replies to earlier probes for other devices
            wire.write(PROBE)
            self._listen(wire, _PROBE_INTERVAL + wire.latency + extra)
            if self.found:
                return

    def diagnosis(self) -> Diagnosis:
        if self._not_sent:
            return Diagnosis(Evidence.SILENCE, self._not_sent)
        error = diagnose(self._settings, self._received)
        return Diagnosis(_EVIDENCE[error.code], str(error))

    def _listen(self, wire: Transport, seconds: float) -> None:
        end = wire.clock() + seconds
        while not self.found and (remaining := end - wire.clock()) > 0:
            data = wire.read(1, min(remaining, _READ_TIMEOUT))
            self._handle(data + read_available(wire))

    def _handle(self, data: bytes) -> None:
        self._received = (self._received + data)[:SAVED_BYTES]
        for reply in self._reader.feed(data):
            if isinstance(reply, Version):
                note = tr(_RESETS) if _HELLO in self._received else ""
                self.found.append(FoundRobot(self._settings, reply, note))
                return


def recall(wire: Transport, settings: PortSettings, packed: str) -> FoundRobot | None:
    """Probe the port of a known robot. `packed` is unused."""
    del packed
    prober = AracnaProber(settings, known=True)
    prober.probe(wire, 0, ignore_step, never_cancelled)
    return next(iter(prober.found), None)


ARACNA_PROBER = ProberInfo("Aracna", AracnaProber, announces_at=LINE, recall=recall)
