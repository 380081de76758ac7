"""Bit fields (status, UART errors, channel masks), input sources and modes.

Ref: TReX 1.0 command documentation, 0x82, 0x84, 0x85, 0x86, 0x95.
"""

from collections.abc import Iterable
from enum import Enum, IntFlag
from functools import cache

from trex_gui.core.errors import BadRequest
from trex_gui.core.translation import Number, tr, tr_noop

CHANNELS = (1, 2, 3, 4, 5)
ALL_CHANNELS = 0x1F


class Status(IntFlag):
    """Status byte (0x84). Reading clears it."""

    UART_ERROR = 1 << 0
    MOTOR1_FAULT = 1 << 4
    MOTOR1_OVER_LIMIT = 1 << 5
    MOTOR2_FAULT = 1 << 6
    MOTOR2_OVER_LIMIT = 1 << 7


class UartError(IntFlag):
    """UART error byte (0x85). Reading clears it."""

    SEND_OVERRUN = 1 << 0
    READ_OVERRUN = 1 << 1
    PARITY = 1 << 2
    DATA_OVERRUN = 1 << 3
    FRAMING = 1 << 4
    CRC = 1 << 5
    FORMAT = 1 << 6
    TIMEOUT = 1 << 7


MOTOR_FAULTS = {1: Status.MOTOR1_FAULT, 2: Status.MOTOR2_FAULT}
OVER_LIMITS = {1: Status.MOTOR1_OVER_LIMIT, 2: Status.MOTOR2_OVER_LIMIT}


def stops_motors(bits: Status | UartError, *, errors_stop: bool = False) -> bool:
    """True if the board stops motors because of these bits.

    `errors_stop` is the board's UART-Error Shutdown setting (parameter 0x08).
    """
    if isinstance(bits, UartError):
        return bool(bits & UartError.TIMEOUT or (bits and errors_stop))
    fatal = Status.MOTOR1_FAULT | Status.MOTOR2_FAULT
    return bool(bits & (fatal | Status.UART_ERROR if errors_stop else fatal))


STATUS_MEANING: dict[Status, tuple[str, str]] = {  # name and explanation, highest bit first
    Status.MOTOR2_OVER_LIMIT: (
        tr_noop("Motor 2 over current limit"),
        tr_noop(
            "The current of motor 2 exceeded its limit, so the limiter reduced the speed "
            "of the motor."
        ),
    ),
    Status.MOTOR2_FAULT: (
        tr_noop("Motor 2 fault"),
        tr_noop(
            "The driver of motor 2 shut itself down because of overheating, a short "
            "circuit or low voltage."
        ),
    ),
    Status.MOTOR1_OVER_LIMIT: (
        tr_noop("Motor 1 over current limit"),
        tr_noop(
            "The current of motor 1 exceeded its limit, so the limiter reduced the speed "
            "of the motor."
        ),
    ),
    Status.MOTOR1_FAULT: (
        tr_noop("Motor 1 fault"),
        tr_noop(
            "The driver of motor 1 shut itself down because of overheating, a short "
            "circuit or low voltage."
        ),
    ),
    Status.UART_ERROR: (
        tr_noop("UART error"),
        tr_noop("A serial error occurred; the UART error bits show which."),
    ),
}

UART_MEANING: dict[UartError, tuple[str, str]] = {  # name and explanation, highest bit first
    UartError.TIMEOUT: (
        tr_noop("Serial timeout"),
        tr_noop(
            "No byte arrived within the Serial Timeout. The board should have stopped its motors."
        ),
    ),
    UartError.FORMAT: (
        tr_noop("Format error"),
        tr_noop(
            "A packet contained an unknown command, an unexpected command byte or an invalid "
            "data byte."
        ),
    ),
    UartError.CRC: (
        tr_noop("CRC error"),
        tr_noop("The CRC byte of a packet was wrong; the packet was discarded."),
    ),
    UartError.FRAMING: (
        tr_noop("Framing error"),
        tr_noop("A stop bit was missing: the baud rates differ, or the line is noisy."),
    ),
    UartError.DATA_OVERRUN: (
        tr_noop("Data overrun"),
        tr_noop("A byte arrived while the receive register was still full."),
    ),
    UartError.PARITY: (
        tr_noop("Parity error"),
        tr_noop("A byte had the wrong parity: the parity settings differ, or the line is noisy."),
    ),
    UartError.READ_OVERRUN: (
        tr_noop("Read buffer overrun"),
        tr_noop(
            "More bytes arrived than the board can buffer: something is sending while the "
            "board replies."
        ),
    ),
    UartError.SEND_OVERRUN: (
        tr_noop("Send buffer overrun"),
        tr_noop("A reply was longer than the send buffer."),
    ),
}


def bit_names(bits: Status | UartError) -> list[str]:
    if isinstance(bits, Status):
        return [name for bit, (name, _) in STATUS_MEANING.items() if bit & bits]
    return [name for bit, (name, _) in UART_MEANING.items() if bit & bits]


class InputSource(Enum):
    """Kind of channel input. It determines the unit of raw counts.

    Ref: Pololu TReX User's Guide 4.b: 0.4 us for RC pulses, 4.89 mV (5 V / 1023) for voltages.
    """

    RC = "RC"
    ANALOG = "analog"

    @property
    def word(self) -> str:
        """`RC` or `analog`, in the user's language."""
        return self.value if self is InputSource.RC else tr("analog")

    @property
    def unit(self) -> str:
        return "µs" if self is InputSource.RC else "V"

    @property
    def counts_per_unit(self) -> float:
        """Raw counts per µs (2.5) or per V (204.6)."""
        return 2.5 if self is InputSource.RC else 1023 / 5

    @property
    def highest_count(self) -> int:
        """Highest valid raw count: 6250 (2.5 ms) or 1023 (5 V)."""
        return 6250 if self is InputSource.RC else 1023

    @property
    def lowest_count(self) -> int:
        """Lowest valid raw count: 1250 (0.5 ms) or 0.

        Ref: Pololu TReX User's Guide 4.c: shorter and longer pulses are errors.
        """
        return 1250 if self is InputSource.RC else 0

    def physical(self, count: float) -> float:
        return count / self.counts_per_unit

    def counts(self, physical: float) -> int:
        return round(physical * self.counts_per_unit)

    def text(self, count: float) -> str:
        """Format a raw count as `1500 µs` or `2.50 V`."""
        if self is InputSource.RC:
            return f"{self.physical(count):.0f} µs"
        return f"{Number(self.physical(count)):.2f} V"


class Mode(Enum):
    """Mode set by the mode jumper at power-up. The values are replies to 0x82."""

    RC = "R"
    ANALOG = "A"
    SERIAL_RC = "r"
    SERIAL_ANALOG = "a"

    @property
    def is_serial(self) -> bool:
        """True if the board accepts writes, and serial motor commands without override."""
        return self is Mode.SERIAL_RC or self is Mode.SERIAL_ANALOG

    @property
    def source(self) -> InputSource:
        is_rc = self is Mode.RC or self is Mode.SERIAL_RC  # a set would slow the simulator down
        return InputSource.RC if is_rc else InputSource.ANALOG


@cache
def channels_in(mask: int) -> tuple[int, ...]:
    """Return the channel numbers (1-5) whose bits are set. Bit n is channel n+1."""
    return tuple(channel for channel in CHANNELS if mask >> (channel - 1) & 1)


def channel_mask(channels: Iterable[int]) -> int:
    """Return the mask of channels 1-5. Bit n is channel n+1."""
    mask = 0
    for channel in channels:
        if channel not in CHANNELS:
            raise BadRequest(tr("the channel number must be 1 to 5, not {0}").format(channel))
        mask |= 1 << (channel - 1)
    return mask


def seven_bits(value: int, name: str) -> int:
    """Return `value`. Raise BadRequest with the name of the value if it is not 0-127."""
    if not 0 <= value <= 0x7F:
        raise BadRequest(tr("{0} must be 0 to 127, not {1}").format(name, value))
    return value
