"""Interface between the scan of a port and each kind of device."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from enum import IntEnum
from typing import Protocol

from trex_gui.core.transport.serial_port import Transport
from trex_gui.core.transport.settings import PortSettings, SerialFormat


@dataclass(frozen=True, slots=True)
class ScanProgress:
    """Progress of a scan: `done` of `total` probes are complete."""

    done: int
    total: int
    line: SerialFormat  # line settings of the next probe
    number: int | None = None  # device number to probe, once a device has responded
    kind: str = ""  # name of the kind of device to probe


class Evidence(IntEnum):
    """Strength of the evidence that a device is connected."""

    SILENCE = 0
    ECHO = 1
    STRANGE = 2  # bytes that are not a valid reply
    KNOWN = 3  # replies that identify the device or the problem


@dataclass(frozen=True, slots=True)
class Diagnosis:
    """Report on a failed search: attempts, received bytes and suggestions."""

    evidence: Evidence
    text: str


class FoundDevice(Protocol):
    """Device that a scan has found, with its connection settings.

    Attributes:
        device_number: `None` if the device has no number.
        echo: True if all sent bytes come back.
        note: remark for the user, or an empty string.
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
    """Searches a line for one kind of device. Never moves a motor.

    Each probe must first terminate an incomplete packet that a board may have received.

    Attributes:
        parts: number of probes in each part of the scan. The first part has the likely probes.
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
        """Send the probes of one part. Raises PortUnavailable.

        `progress` and `cancelled` are called before each probe.
        """

    def diagnosis(self) -> Diagnosis: ...


class CreateProber(Protocol):
    def __call__(self, settings: PortSettings, *, full: bool, known: bool) -> Prober:
        """Create a prober.

        `full`: probe all settings. `known`: this kind of device is already known for the port.
        """


Recall = Callable[[Transport, PortSettings, str], FoundDevice | None]
"""Probes a device only at its packed settings. Raises PortUnavailable."""


@dataclass(frozen=True, slots=True)
class ProberInfo:
    name: str
    create: CreateProber
    announces_at: SerialFormat | None = None  # line settings of the device's start-up message
    recall: Recall | None = None  # `None` if a scan is fast enough


def ignore_step(_step: ScanProgress) -> None:
    pass


def never_cancelled() -> bool:
    return False


FLUSH_BYTE = b"\xff"
FLUSH_LINE = SerialFormat(1200)
"""Separator between two probes, because any device may be listening.

A device at another baud rate may read a probe as the start of a packet. A later probe that is
harmless on its own could turn that packet into a motor command. FF at 1200 baud terminates an
incomplete packet. A TReX at that rate ignores FF, and a TReX at another rate receives a byte that
no packet may contain.
"""


def flush(wire: Transport, extra: float = 0.0) -> None:
    """Terminate an incomplete packet in a device. `extra`: additional waiting time (s)."""
    wire.reconfigure(FLUSH_LINE)
    wire.write(FLUSH_BYTE)
    wire.wait(FLUSH_LINE.seconds(len(FLUSH_BYTE)) + wire.latency + extra)
