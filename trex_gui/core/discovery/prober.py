"""Interface between the scan of a port and each kind of device."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from enum import IntEnum
from typing import Protocol

from trex_gui.core.transport.serial_port import Transport
from trex_gui.core.transport.settings import PortSettings, SerialFormat


@dataclass(frozen=True, slots=True)
class ScanProgress:
    """Progress of a scan: `done` of `total` probes. `line` belongs to the next one."""

    done: int
    total: int
    line: SerialFormat
    number: int | None = None  # the device number that is probed, once a board has responded
    kind: str = ""  # name of the kind of device that is probed for


class Evidence(IntEnum):
    """Amount of evidence where no device was found."""

    SILENCE = 0
    ECHO = 1
    STRANGE = 2
    KNOWN = 3


@dataclass(frozen=True, slots=True)
class Diagnosis:
    """Tries for one kind of device, received bytes, and what to check."""

    evidence: Evidence
    text: str


class FoundDevice(Protocol):
    """A device that was found, and how to reach it.

    Attributes:
        device_number: the number that it responds to, if it has one.
        echo: whether everything sent comes back.
        note: a remark for the user; may be empty.
    """

    @property
    def settings(self) -> PortSettings: ...
    @property
    def name(self) -> str: ...
    @property
    def device_number(self) -> int | None: ...
    @property
    def echo(self) -> bool: ...
    @property
    def note(self) -> str: ...


class Prober(Protocol):
    """Looks for devices of one kind on one open line, and moves nothing.

    Every probe has to end whatever a board may have begun to receive before it.

    Attributes:
        parts: number of probes in each part of the scan, the likely ones first.
        is_over: whether it is known by now what is connected.
    """

    @property
    def parts(self) -> Sequence[int]: ...
    @property
    def found(self) -> Sequence[FoundDevice]: ...
    @property
    def is_over(self) -> bool: ...

    def record_unsolicited(self, line: SerialFormat, data: bytes) -> None: ...

    def probe(
        self,
        wire: Transport,
        part: int,
        progress: Callable[[ScanProgress], None],
        cancelled: Callable[[], bool],
    ) -> None:
        """Send the probes of a part. `cancelled` is called before each. Raises PortUnavailable."""

    def diagnosis(self) -> Diagnosis:
        """Report what was tried and received, if no device was found."""


class MakeProber(Protocol):
    def __call__(self, settings: PortSettings, *, full: bool, known: bool) -> Prober:
        """Try everything if `full`. `known`: the user has said that the port has this kind."""


Recall = Callable[[Transport, PortSettings, str], FoundDevice | None]
"""Probe only where a device was found before: the text is what its settings packed.

Raises PortUnavailable.
"""


@dataclass(frozen=True, slots=True)
class ProberInfo:
    """One kind of device. `announces_at`: line settings of its start message, if it sends one.

    Without `recall` it is found soon enough.
    """

    name: str
    begin: MakeProber
    announces_at: SerialFormat | None = None
    recall: Recall | None = None


def ignore_step(_step: ScanProgress) -> None:
    pass


def never_cancelled() -> bool:
    return False


FLUSH_BYTE = b"\xff"
FLUSH_LINE = SerialFormat(1200)
"""They separate two probes on a line where any device may be listening.

A device at another baud rate takes what is sent for other bytes and may keep them as the start of a
packet: together with a later probe, harmless by itself, they could form a motor command. FF at
1200 baud ends whatever has begun: a TReX at that rate ignores it, one at any other rate receives a
byte that no packet may contain.
"""


def flush(wire: Transport, extra: float = 0.0) -> None:
    """End what any device may have begun to receive, within the wire's time and `extra` seconds."""
    wire.reconfigure(FLUSH_LINE)
    wire.write(FLUSH_BYTE)
    wire.wait(FLUSH_LINE.seconds(len(FLUSH_BYTE)) + wire.latency + extra)
