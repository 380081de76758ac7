"""Polled values: their samples, the table of polls, and the reader of latched bits."""

import contextlib
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, replace
from typing import Any, Self, TypeVar

from trex_gui.core.errors import BadReply, NoReply
from trex_gui.core.recording.kinds import Column, Physical, SampleKind
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
from trex_gui.devices.trex.protocol.flags import (
    CHANNELS,
    STATUS_MEANING,
    UART_MEANING,
    InputSource,
    Mode,
    Status,
    UartError,
    bit_names,
    stops_motors,
)


@dataclass(frozen=True, slots=True)
class Sample:
    """Polled value. A sample is false if it has nothing to report."""

    time: float  # arrival of the reply in seconds on the session's clock

    def __bool__(self) -> bool:
        return True


@dataclass(frozen=True, slots=True)
class Raw(Sample):
    """Raw inputs of channels 1-5 in counts. `None` without a valid signal."""

    counts: tuple[int | None, ...]


@dataclass(frozen=True, slots=True)
class Remapped(Sample):
    """Remapped inputs of channels 1-5, -127 to 127."""

    values: tuple[int, ...]


@dataclass(frozen=True, slots=True)
class Currents(Sample):
    """Currents of motors 1 and 2 in counts of `Model.current_unit` amperes."""

    counts: tuple[int, int]


@dataclass(frozen=True, slots=True)
class LatchedStatus(Sample):
    """Status and UART error bits latched since the last reading. False if no bit is set."""

    status: Status
    uart: UartError
    is_earlier: bool = False  # True if latched during the scan, or before the board was selected
    is_whole: bool = True  # False if unread errors may be latched

    def __bool__(self) -> bool:
        return bool(self.status or self.uart)

    @property
    def is_clean(self) -> bool:
        """True if the line has corrupted nothing since the last status."""
        return self.is_whole and not self.has_line_error

    @property
    def has_line_error(self) -> bool:
        """True if the line has corrupted bytes. A timeout does not count."""
        is_unread = Status.UART_ERROR in self.status and not self.uart  # reading the bits failed
        return is_unread or bool(self.uart & ~UartError.TIMEOUT)

    @property
    def names(self) -> tuple[str, ...]:
        return (*bit_names(self.status), *bit_names(self.uart))

    def stops_motors(self, *, on_error: bool = False) -> bool:
        """Return True if the board has stopped motors. `on_error`: UART-Error Shutdown is set."""
        latched = self.status, self.uart
        return any(stops_motors(bits, errors_stop=on_error) for bits in latched)


@dataclass(frozen=True, slots=True)
class Control(Sample):
    by_serial: bool  # True if serial commands control the motors, not channels


@dataclass(frozen=True, slots=True)
class ModeSample(Sample):
    mode: Mode  # changes only at a power cycle


SampleT = TypeVar("SampleT", bound=Sample)


@dataclass(slots=True)
class Newest:
    """Newest sample of each kind."""

    samples: dict[type[Sample], Any] = field(default_factory=dict)

    def __copy__(self) -> Self:
        return replace(self, samples=self.samples.copy())

    def __getitem__(self, kind: type[SampleT]) -> SampleT:
        """Return the newest sample. Raise `KeyError` if there is none yet."""
        sample: SampleT = self.samples[kind]
        return sample

    def get(self, kind: type[SampleT]) -> SampleT | None:
        return self.samples.get(kind)

    def update(self, sample: Sample) -> None:
        self.samples[type(sample)] = sample


# --- The table of polled values ---------------------------------------------------------


@dataclass(frozen=True, slots=True)
class PolledValue:
    query: Command[Any]
    rate: float  # polls per second
    # Creates a sample from a time and a reply; `None` if `StatusReader` reads the value
    sample: Callable[[float, Any], Sample] | None
    # Columns of recordings, CSV and `trexcmd stream`, for an input source and amperes per count
    kind: Callable[[InputSource, float], SampleKind]
    analog_rate: float | None = None  # different rate with analog inputs
    # Different rate while no sample is shown or recorded and no motor moves
    unwatched_rate: float | None = None


def _raw_column(channel: int, source: InputSource) -> Column:
    unit, digits = ("us", 1) if source is InputSource.RC else ("V", 4)
    physical = Physical(f"channel_{channel}_{unit}", 1 / source.counts_per_unit, digits)
    description = f"channel {channel}: counts, {source.unit}; NULL without a valid signal"
    return Column(f"channel_{channel}_raw", "INTEGER", description, physical, optional=True)


def _current_column(motor: int, current_unit: float) -> Column:
    physical = Physical(f"motor_{motor}_current_A", current_unit, 4)
    description = f"current of motor {motor}: counts, A"
    return Column(f"motor_{motor}_current_counts", "INTEGER", description, physical)


def _bit_column(byte: str, bit: Status | UartError, meaning: str) -> Column:
    return Column(f"{byte}_{bit.name}".lower(), "INTEGER", f"1: {meaning}")


def _unpack_status(time: float, *values: int) -> LatchedStatus:
    status, uart = Status(0), UartError(0)
    for bit, value in zip((*Status, *UartError), values, strict=True):
        if value and isinstance(bit, Status):
            status |= bit
        elif value and isinstance(bit, UartError):
            uart |= bit
    return LatchedStatus(time, status, uart)


POLLED: Mapping[type[Sample], PolledValue] = {
    Raw: PolledValue(
        GetRawChannels(),
        rate=50.0,
        unwatched_rate=2.0,
        sample=lambda time, reply: Raw(time, tuple(reply.values())),
        kind=lambda source, _: SampleKind(
            "raw",
            Raw,
            tuple(_raw_column(channel, source) for channel in CHANNELS),
            pack=lambda raw: raw.counts,
            unpack=lambda time, *counts: Raw(time, counts),
            held=True,
        ),
    ),
    Remapped: PolledValue(
        GetRemappedChannels(),
        rate=50.0,
        unwatched_rate=2.0,
        sample=lambda time, reply: Remapped(time, tuple(reply.values())),
        kind=lambda *_: SampleKind(
            "remapped",
            Remapped,
            tuple(
                Column(f"channel_{channel}_remapped", "INTEGER", f"channel {channel}: -127 to 127")
                for channel in CHANNELS
            ),
            pack=lambda remapped: remapped.values,
            unpack=lambda time, *values: Remapped(time, values),
            held=True,
        ),
    ),
    Currents: PolledValue(
        GetCurrents(),
        rate=80.0,
        analog_rate=50.0,
        unwatched_rate=20.0,  # the plot of currents needs a curve without gaps
        sample=Currents,
        kind=lambda _, current_unit: SampleKind(
            "currents",
            Currents,
            (_current_column(1, current_unit), _current_column(2, current_unit)),
            pack=lambda currents: currents.counts,
            unpack=lambda time, *counts: Currents(time, counts),
            held=True,
        ),
    ),
    LatchedStatus: PolledValue(
        GetStatus(),
        rate=10.0,  # slow, since bits remain latched until the next poll
        sample=None,
        kind=lambda *_: SampleKind(
            "status",
            LatchedStatus,
            (
                *(_bit_column("status", bit, STATUS_MEANING[bit][0]) for bit in Status),
                *(_bit_column("uart", bit, UART_MEANING[bit][0]) for bit in UartError),
            ),
            pack=lambda latched: (
                *(int(bit in latched.status) for bit in Status),
                *(int(bit in latched.uart) for bit in UartError),
            ),
            unpack=_unpack_status,
        ),
    ),
    Control: PolledValue(
        GetSerialControl(),
        rate=10.0,
        sample=Control,
        kind=lambda *_: SampleKind(
            "control",
            Control,
            (Column("serial_controls", "INTEGER", "1: serial commands reach the motors"),),
            pack=lambda control: (int(control.by_serial),),
            unpack=lambda time, value: Control(time, bool(value)),
            held=True,
        ),
    ),
    ModeSample: PolledValue(
        GetMode(),
        rate=1.0,
        sample=ModeSample,
        kind=lambda *_: SampleKind(
            "mode",
            ModeSample,
            (Column("mode", "TEXT", "R, A: RC, analog; r, a: serial with RC, analog inputs"),),
            pack=lambda sample: (sample.mode.value,),
            unpack=lambda time, value: ModeSample(time, Mode(value)),
            held=True,
        ),
    ),
}
"""Values that are polled while a board is connected.

Ref: command documentation 0x86 (inputs at about 50 Hz), 0x8D (currents at 50 Hz with analog inputs,
at about 80 Hz with RC inputs).
"""


# --- Status -----------------------------------------------------------------------------


class StatusReader:
    """Reads the latched bits without losing any on a line that corrupts bytes.

    Reading a byte clears its bits. After a lost status or lost UART errors, the next reading
    therefore includes the UART errors. The first reading also includes them, because a guardian or
    another program may have read the status.
    """

    def __init__(self, clock: Callable[[], float]) -> None:
        self._clock = clock
        self.reset()

    def reset(self) -> None:
        """Mark the next bits as latched earlier. Call this after a scan or a selection."""
        self._is_first = self.uart_due = True  # the status may not reveal latched UART errors

    def read(self, request: Requester) -> LatchedStatus:
        """Read and clear the status and any UART errors.

        Raises:
            NoReply, BadReply: no valid status arrived.
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
        return LatchedStatus(self._clock(), status, uart, is_earlier, is_whole=not self.uart_due)


def poll(
    request: Requester, topic: type[Sample], clock: Callable[[], float], reader: StatusReader
) -> Sample:
    """Read one polled value. Raises the errors of `TrexClient.request`."""
    polled = POLLED[topic]
    if polled.sample is None:
        return reader.read(request)
    reply = request(polled.query)
    return polled.sample(clock(), reply)
