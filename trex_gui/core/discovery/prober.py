"""Interface between the scan of a port and each kind of device."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from enum import IntEnum
from typing import Protocol

from trex_gui.core.transport.serial_port import Transport
from trex_gui.core.transport.settings import PortSettings, SerialFormat


@dataclass(frozen=True, slots=True)
class ScanProgress:
    """Progress of a scan: `done` of `total` probes. `line`: settings of the next probe."""

    done: int
    total: int
    line: SerialFormat
    number: int | None = None  # device number being probed, once a board has responded
    kind: str = ""  # name of the device kind being probed for


class Evidence(IntEnum):
    """Strength of the evidence when no device was found."""

    SILENCE = 0
    ECHO = 1
    STRANGE = 2
    KNOWN = 3


@dataclass(frozen=True, slots=True)
class Diagnosis:
    """Report on a device kind that was not found: attempts, received bytes, checks to do."""

    evidence: Evidence
    text: str


class FoundDevice(Protocol):
    """A device that was found, and how to reach it.

    Attributes:
        device_number: the number that the device responds to; `None` if it has no number.
        echo: True if all sent bytes come back.
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
    """Searches an open line for devices of one kind, without moving anything.

    Every probe must first end any packet that a board may have begun to receive.

    Attributes:
        parts: number of probes in each part of the scan, likely probes first.
        is_over: True once the connected device is known.
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
        """Report attempts and received bytes, if no device was found."""


class MakeProber(Protocol):
    def __call__(self, settings: PortSettings, *, full: bool, known: bool) -> Prober:
        """Create a prober. `full`: try all. `known`: the user has named this kind for the port."""


Recall = Callable[[Transport, PortSettings, str], FoundDevice | None]
"""Probe only at the packed settings of a device that was found before.

Raises PortUnavailable.
"""


@dataclass(frozen=True, slots=True)
class ProberInfo:
    """One kind of device. `announces_at`: line settings of its start message, if it sends one.

    Kinds that a scan finds soon enough need no `recall`.
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
"""Separator of two probes on a line where any device may be listening.

A device at another baud rate reads a probe as other bytes and may keep them as the start of a
packet. A later probe, harmless by itself, could complete it into a motor command. FF at 1200 baud
ends any packet that has begun. A TReX at that rate ignores it, and a TReX at another rate receives
a byte that no packet may contain.
"""


def flush(wire: Transport, extra: float = 0.0) -> None:
    """End any packet that a device has begun. `extra`: seconds to add to the wire's own delay."""
    wire.reconfigure(FLUSH_LINE)
    wire.write(FLUSH_BYTE)
    wire.wait(FLUSH_LINE.seconds(len(FLUSH_BYTE)) + wire.latency + extra)
