"""Samples of polled values, and reading the latched status bits."""

import contextlib
from collections.abc import Callable
from dataclasses import dataclass

from trex_gui.core.errors import BadReply, NoReply
from trex_gui.devices.trex.client.client import Requester
from trex_gui.devices.trex.protocol.commands import GetStatus, GetUartErrors
from trex_gui.devices.trex.protocol.flags import Mode, Status, UartError


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
    """Status bits and UART error bits that were latched since they were last read.

    `is_earlier`: the bits were latched before the board was connected or selected, or by the
    search for it.
    """

    time: float
    status: Status
    uart: UartError
    is_earlier: bool = False

    @property
    def has_line_error(self) -> bool:
        """Whether the line has corrupted bytes; a timeout does not count.

        An announced error of unknown kind counts: the query for its kind was corrupted.
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
    """The mode, which only changes with a power cycle."""

    time: float
    mode: Mode


Sample = Raw | Remapped | Currents | LatchedStatus | Control | ModeSample


class StatusReader:
    """Reads the latched bits and loses none of them on a line that corrupts bytes.

    Reading clears a byte. So when a status did not arrive, or announced UART errors and their
    byte did not arrive, the UART error byte is read the next time.
    """

    def __init__(self, clock: Callable[[], float]) -> None:
        self._clock = clock
        self.uart_due = False  # bits may be latched that no status announces any more
        self._is_first = True

    def begin(self) -> None:
        """Count what is read next as older: the board was searched for, or selected only now."""
        self._is_first = True

    def read(self, request: Requester) -> LatchedStatus | None:
        """Read and clear the status, and the UART errors when there may be some.

        Raises:
            NoReply, BadReply: no status arrived.
            PortUnavailable: the line is gone.
        """
        uart_due, self.uart_due = self.uart_due, True
        status = request(GetStatus())
        uart = UartError(0)
        self.uart_due = uart_due or bool(status & Status.UART_ERROR)
        if self.uart_due:
            with contextlib.suppress(NoReply, BadReply):
                uart = request(GetUartErrors())
                self.uart_due = False
        is_earlier, self._is_first = self._is_first, self._is_first and self.uart_due
        return LatchedStatus(self._clock(), status, uart, is_earlier) if status or uart else None
