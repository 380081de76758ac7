r"""Finding an Aracna on a port where any device may be, without moving anything.

The probe is `\n.q\n` at 38400 8N1: to an Aracna an empty line and the one query without side
effects, to a TReX at 38400 baud no command. A TReX at another rate may take it for the beginning of
one, which FF at 1200 baud ends before and after, as in the TReX's own probe. The tests check this
for every TReX. At a fixed rate, as behind a plain network port, FF has no effect, and the probe is
a command to some boards: there it is sent only if the user has said that the port leads to an
Aracna.

Opening a port may reset the board, which reports `.h` and does not listen for a second. So the
probe is sent several times.
"""

import contextlib
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field

from trex_gui.core.discovery.prober import (
    Diagnosis,
    Evidence,
    ProberInfo,
    ScanProgress,
    flush,
    ignore_step,
    never_cancelled,
)
from trex_gui.core.discovery.scan import listen, probe_in_order
from trex_gui.core.errors import BadReply, BadRequest, PortUnavailable
from trex_gui.core.transport.serial_port import SerialTransport, Transport
from trex_gui.core.transport.settings import PortSettings, SerialFormat
from trex_gui.devices.aracna.protocol import commands
from trex_gui.devices.aracna.protocol.replies import Reader, Version
from trex_gui.devices.aracna.session.client import LINE
from trex_gui.devices.aracna.session.errors import diagnose, is_boot_message, is_echo

PROBE = commands.EMPTY + commands.QUERY

PROBES = 5
"""How often the probe is sent; with the listening, 3.2 s on a local port."""

_PROBE_INTERVAL = 0.45
_SLICE = 0.02
_KEPT = 48

_HELLO = b"h\r\n"
_RESETS = "Opening this port has reset its board: it answers about a second later."


@dataclass(frozen=True, slots=True)
class FoundRobot:
    settings: PortSettings
    version: Version
    note: str = ""
    device_number = None
    echo = False

    @property
    def name(self) -> str:
        return f"Aracna {self.version.version}"

    @property
    def motors(self) -> int:
        return self.version.motor_count


@dataclass(slots=True)
class AracnaScan:
    """The result of a scan.

    Attributes:
        received: the first bytes that arrived.
        unsupported: the port does not support the robot's line settings.
        fixed_rate: the baud rate is set elsewhere, so no probe was sent.
    """

    settings: PortSettings
    found: list[FoundRobot] = field(default_factory=list)
    received: bytes = b""
    unsupported: bool = False
    fixed_rate: bool = False
    cancelled: bool = False

    def diagnosis(self) -> Diagnosis:
        where, port = self.settings.text(), self.settings.label
        if self.unsupported:
            text = f"No probe for an Aracna was sent: {port} cannot be set to {LINE.text()}."
            return Diagnosis(Evidence.SILENCE, text)
        if self.fixed_rate:
            return Diagnosis(
                Evidence.SILENCE,
                f"No probe for an Aracna was sent on {port}: its baud rate is set at the other end "
                "of the network, and a TReX at another rate could take the probe for a command. If "
                "you know that it is an Aracna, connect once with: "
                f"trex-gui --device aracna --port {self.settings.url}",
            )
        if is_echo(self.received):
            return Diagnosis(
                Evidence.ECHO,
                f"No Aracna answers on {where}: everything sent comes back, and nothing else. "
                "The adapter's TX and RX are joined; an Aracna never echoes.",
            )
        text = str(diagnose(self.settings, self.received))
        if is_boot_message(self.received):
            return Diagnosis(Evidence.KNOWN, text)
        strange = self.received.strip(b"\r\n")
        return Diagnosis(Evidence.STRANGE if strange else Evidence.SILENCE, text)


class AracnaProber:
    """Probes one line for a robot; `search` is the result so far."""

    parts = (PROBES,)

    def __init__(self, settings: PortSettings, *, full: bool = False, known: bool = False) -> None:
        """Probe this port; with only one line setting `full` has no effect."""
        del full
        self._known = known
        self.search = AracnaScan(settings.at(LINE))
        self._reader = Reader()

    @property
    def found(self) -> Sequence[FoundRobot]:
        return self.search.found

    @property
    def is_over(self) -> bool:
        return bool(self.search.found)

    def diagnosis(self) -> Diagnosis:
        return self.search.diagnosis()

    def note_unsolicited(self, line: SerialFormat, data: bytes) -> None:
        """Take bytes that arrived before a probe, such as `.h` after a reset."""
        if line == LINE:
            self._take(data)

    def ask(
        self,
        wire: Transport,
        part: int,
        progress: Callable[[ScanProgress], None],
        cancelled: Callable[[], bool],
    ) -> None:
        """Send the probe until the robot answers, `PROBES` times at most.

        Raises:
            PortUnavailable: the line is gone.
        """
        del part  # there is one
        search = self.search
        extra = search.settings.timeouts.extra
        if not wire.is_configurable and not self._known:
            search.fixed_rate = True
            return
        for done in range(PROBES):
            if cancelled():
                search.cancelled = True
                return
            progress(ScanProgress(done, PROBES, LINE))
            try:
                flush(wire, extra)
                wire.reconfigure(LINE)
            except BadRequest:
                search.unsupported = True
                return
            if done == 0:
                with contextlib.suppress(BadReply):
                    wire.discard()  # replies to other probers
            wire.write(PROBE)
            if self._listen(wire, _PROBE_INTERVAL + wire.latency + extra):
                return

    def _listen(self, wire: Transport, seconds: float) -> bool:
        """Read for so long; return whether a robot has answered."""
        end = wire.clock() + seconds
        while (rest := end - wire.clock()) > 0:
            data = wire.read(1, min(rest, _SLICE))
            try:
                data += wire.discard()
            except BadReply:  # endless data
                data += wire.read(_KEPT, 0.0)
            self._take(data)
            if self.search.found:
                return True
        return False

    def _take(self, data: bytes) -> None:
        search = self.search
        search.received = (search.received + data)[:_KEPT]
        for reply in self._reader.feed(data):
            if isinstance(reply, Version):
                note = _RESETS if _HELLO in search.received else ""
                search.found.append(FoundRobot(search.settings, reply, note))
                return


ARACNA_PROBER = ProberInfo("Aracna", AracnaProber, announces_at=LINE)


def find_aracna(
    settings: PortSettings,
    *,
    progress: Callable[[ScanProgress], None] = ignore_step,
    cancelled: Callable[[], bool] = never_cancelled,
    open_wire: Callable[[PortSettings], Transport] = SerialTransport,
) -> AracnaScan:
    """Scan a port for an Aracna alone; `cancelled` is checked before each probe.

    Raises:
        PortUnavailable: the port cannot be opened, or is gone.
    """
    prober = AracnaProber(settings)
    search = prober.search
    wire = open_wire(search.settings)
    try:
        prober.note_unsolicited(LINE, listen(wire))
        names = {"": ARACNA_PROBER.name}
        probe_in_order(wire, {"": prober}, names, progress=progress, cancelled=cancelled)
    finally:
        # A board at another rate must not keep the beginning of a command.
        with contextlib.suppress(BadRequest, PortUnavailable):
            if not search.found and wire.is_configurable:
                flush(wire, search.settings.timeouts.extra)
            wire.reconfigure(LINE)
        wire.close()
    return search
