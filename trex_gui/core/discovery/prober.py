"""What a search asks of who looks for one kind of device, and what it is told; see `seeking`."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from enum import IntEnum
from typing import Protocol

from trex_gui.core.transport.serial_port import Transport
from trex_gui.core.transport.settings import PortSettings, SerialFormat


@dataclass(frozen=True, slots=True)
class ScanProgress:
    """How far a search is: `done` of `total` questions; `line` is asked on next.

    `number` is the device number that is asked for, where a board has answered already; `kind`
    is what people call the device that is asked for.
    """

    done: int
    total: int
    line: SerialFormat
    number: int | None = None
    kind: str = ""


class Evidence(IntEnum):
    """How much was learned where no device was found."""

    SILENCE = 0
    ECHO = 1
    STRANGE = 2
    KNOWN = 3


@dataclass(frozen=True, slots=True)
class Diagnosis:
    """What was tried for one kind of device, what was heard, and what to look at; for people."""

    telling: Evidence
    text: str


class FoundDevice(Protocol):
    """A device that was found, and how to reach it."""

    @property
    def settings(self) -> PortSettings:
        """What to connect with."""
        ...

    @property
    def name(self) -> str:
        """Which device it is."""
        ...

    @property
    def device_number(self) -> int | None:
        """The number that it answers to, where it has one."""
        ...

    @property
    def echo(self) -> bool:
        """Whether everything sent comes back."""
        ...

    @property
    def note(self) -> str:
        """What else to know of it, for people; may be empty."""
        ...


class Prober(Protocol):
    """Looks for devices of one kind on one open line, and moves nothing.

    Every question has to end whatever a board may have begun to hear before it.
    """

    @property
    def parts(self) -> Sequence[int]:
        """How many questions there are in each part of the search, the probable ones first."""
        ...

    @property
    def found(self) -> Sequence[FoundDevice]:
        """The devices; more than one only where several share the line."""
        ...

    @property
    def is_over(self) -> bool:
        """Whether it is known by now what is there."""
        ...

    def note_unsolicited(self, line: SerialFormat, data: bytes) -> None:
        """Take what came before anything was asked, with the line set so."""
        ...

    def ask(
        self,
        wire: Transport,
        part: int,
        progress: Callable[[ScanProgress], None],
        cancelled: Callable[[], bool],
    ) -> None:
        """Put the questions of a part; `cancelled` is asked before each whether to end.

        Raises:
            PortUnavailable: the line is gone.
        """
        ...

    def diagnosis(self) -> Diagnosis:
        """Say what was tried and heard, where no device was found."""
        ...


class MakeProber(Protocol):
    """Makes a seeker for a port."""

    def __call__(self, settings: PortSettings, *, full: bool, known: bool) -> Prober:
        """Try everything if `full`; `known` says that somebody has led the port to this kind."""
        ...


@dataclass(frozen=True, slots=True)
class ProberInfo:
    """How to look for one kind of device.

    Attributes:
        name: what people call it.
        begin: makes a seeker for a port.
        talks_at: how the line is set on which it tells of itself when it starts; `None`: it
            does not.
    """

    name: str
    begin: MakeProber
    announces_at: SerialFormat | None = None


def ignore_step(step: ScanProgress) -> None:
    """Tell nobody of a step."""
    del step


def never_cancelled() -> bool:
    """Go on."""
    return False
