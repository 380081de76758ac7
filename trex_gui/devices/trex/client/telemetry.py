"""What is asked again and again, and the samples that come of it."""

import contextlib
from collections.abc import Callable
from dataclasses import dataclass

from trex_gui.core.errors import BadReply, NoReply
from trex_gui.devices.trex.client.client import Requester
from trex_gui.devices.trex.client.schedule import Topic
from trex_gui.devices.trex.protocol.commands import (
    GetCurrents,
    GetMode,
    GetRawChannels,
    GetRemappedChannels,
    GetSerialControl,
    GetStatus,
    GetUartErrors,
)
from trex_gui.devices.trex.protocol.flags import CHANNELS, Mode, Status, UartError


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
    """Status bits and UART error bits that were latched since the last look."""

    time: float
    status: Status
    uart: UartError

    @property
    def has_line_error(self) -> bool:
        """Whether the line has damaged something; a timeout is no damage.

        Where an error is announced and its kind is not told, the question for it was damaged.
        """
        untold = Status.UART_ERROR in self.status and not self.uart
        return untold or bool(self.uart & ~UartError.TIMEOUT)


@dataclass(frozen=True, slots=True)
class Control:
    """Whether serial commands reach the motors."""

    time: float
    by_serial: bool


@dataclass(frozen=True, slots=True)
class ModeSample:
    """The mode, looked at once in a while: it changes with the power."""

    time: float
    mode: Mode


Sample = Raw | Remapped | Currents | LatchedStatus | Control | ModeSample


class StatusReader:
    """Reads the latched bits and loses none of them on a line that damages bytes.

    Reading clears a byte. So when the status was asked for and did not arrive, or announced
    UART errors whose byte did not arrive, the UART error byte is asked for the next time.
    """

    def __init__(self, clock: Callable[[], float]) -> None:
        self._clock = clock
        self._uart_due = False

    @property
    def uart_due(self) -> bool:
        """Whether UART error bits may be waiting that no status announces any more."""
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
    """Ask for one topic; the sample bears the time at which its reply was in.

    `None` when the status has no news.

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
