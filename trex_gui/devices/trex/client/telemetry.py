"""Polled values and their samples."""

import contextlib
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from enum import Enum, auto

from trex_gui.core.errors import BadReply, NoReply
from trex_gui.devices.trex.client.client import Requester
from trex_gui.devices.trex.protocol.commands import (
    Command,
    GetCurrents,
    GetMode,
    GetRawChannels,
    GetRemappedChannels,
    GetSerialControl,
    GetStatus,
    GetUartErrors,
)
from trex_gui.devices.trex.protocol.flags import CHANNELS, Mode, Status, UartError


class Topic(Enum):
    """One polled value."""

    CURRENTS = auto()
    RAW = auto()
    REMAPPED = auto()
    STATUS = auto()
    CONTROL = auto()
    MODE = auto()


QUERIES: Mapping[Topic, Command[object]] = {
    Topic.CURRENTS: GetCurrents(),
    Topic.RAW: GetRawChannels(),
    Topic.REMAPPED: GetRemappedChannels(),
    Topic.STATUS: GetStatus(),
    Topic.CONTROL: GetSerialControl(),
    Topic.MODE: GetMode(),
}


@dataclass(frozen=True, slots=True)
class Raw:
    """Raw inputs of channels 1-5 in counts; `None` without a valid signal."""

    time: float
    counts: tuple[int | None, ...]


@dataclass(frozen=True, slots=True)
class Remapped:
    """Remapped inputs of channels 1-5, -127 to 127."""

    time: float
    values: tuple[int, ...]


@dataclass(frozen=True, slots=True)
class Currents:
    """Currents of motors 1 and 2 in counts (`Model.current_unit` ampere each)."""

    time: float
    counts: tuple[int, int]


@dataclass(frozen=True, slots=True)
class LatchedStatus:
    """Status bits and UART error bits that were latched since they were last read."""

    time: float
    status: Status
    uart: UartError

    @property
    def has_line_error(self) -> bool:
        """Whether the line has damaged something; a timeout is no damage.

        Where an error is announced but no kind was read, the query for it was damaged.
        """
        is_unread = Status.UART_ERROR in self.status and not self.uart
        return is_unread or bool(self.uart & ~UartError.TIMEOUT)


@dataclass(frozen=True, slots=True)
class Control:
    """Whether serial commands reach the motors."""

    time: float
    by_serial: bool


@dataclass(frozen=True, slots=True)
class ModeSample:
    """The mode, which only changes with the power."""

    time: float
    mode: Mode


Sample = Raw | Remapped | Currents | LatchedStatus | Control | ModeSample


class StatusReader:
    """Reads the latched bits and loses none of them on a line that damages bytes.

    Reading clears a byte. So when a status did not arrive, or announced UART errors and their
    byte did not arrive, the UART error byte is read the next time.
    """

    def __init__(self, clock: Callable[[], float]) -> None:
        self._clock = clock
        self._uart_due = False

    @property
    def uart_due(self) -> bool:
        """Whether UART error bits may be latched that no status announces any more."""
        return self._uart_due

    def read(self, request: Requester) -> LatchedStatus | None:
        """Read and clear the status, and the UART errors when there may be some.

        Raises:
            NoReply, BadReply: no status came.
            PortUnavailable: the line is gone.
        """
        uart_due, self._uart_due = self._uart_due, True
        status = request(GetStatus())
        uart = UartError(0)
        self._uart_due = uart_due or bool(status & Status.UART_ERROR)
        if self._uart_due:
            with contextlib.suppress(NoReply, BadReply):
                uart = request(GetUartErrors())
                self._uart_due = False
        return LatchedStatus(self._clock(), status, uart) if status or uart else None


def poll(
    request: Requester, topic: Topic, clock: Callable[[], float], reader: StatusReader
) -> Sample | None:
    """Read one topic; return its sample with the time of its reply, `None` if no bit was latched.

    Raises:
        NoReply, BadReply: as every transaction.
        PortUnavailable: the line is gone.
    """
    match topic:
        case Topic.CURRENTS:
            currents = request(GetCurrents())
            return Currents(clock(), currents)
        case Topic.RAW:
            raw = request(GetRawChannels())
            return Raw(clock(), tuple(raw[channel] for channel in CHANNELS))
        case Topic.REMAPPED:
            remapped = request(GetRemappedChannels())
            return Remapped(clock(), tuple(remapped[channel] for channel in CHANNELS))
        case Topic.CONTROL:
            by_serial = request(GetSerialControl())
            return Control(clock(), by_serial)
        case Topic.MODE:
            mode = request(GetMode())
            return ModeSample(clock(), mode)
        case Topic.STATUS:
            return reader.read(request)
