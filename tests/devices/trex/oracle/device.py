"""Replies of a TReX to every query and write, without motors, loads or time."""

import tomllib
from collections.abc import Iterator, Mapping, Sequence
from enum import IntFlag
from functools import cache
from pathlib import Path
from typing import NamedTuple

from tests.devices.trex.oracle.framing import Framer, Packet, UartError, sealed
from tests.devices.trex.oracle.remapping import (
    ANALOG_DEFAULT,
    INVALID,
    RC_DEFAULT,
    Calibration,
    coded,
    motors,
    remapped,
    switched_on,
)

_TABLE = Path(__file__).parents[4] / "resources" / "trex_parameters.toml"
_FORMAT_BYTES = b"\x55\x2a"
_CHANNELS = range(5)
_FLIP, _OVERRIDE = 3, 4
_FACTORY_RESET = 0x7F
_UART_SETTINGS = 0x7E

OK, BAD_NUMBER, BAD_VALUE, NOT_SERIAL = 0, 1, 2, 3


class Status(IntFlag):
    """Bit of the status byte that a stream of bytes can set."""

    NONE = 0
    UART_ERROR = 0x01


class Parameter(NamedTuple):
    number: int
    key: str
    minimum: int
    maximum: int
    default: int | None  # None for a write-only parameter
    since: str

    def allows(self, value: int) -> bool:
        if self.number == _UART_SETTINGS and value & 0x0F > 10:
            return False
        return self.minimum <= value <= self.maximum


@cache
def table(model: str, firmware: str) -> dict[int, Parameter]:
    """Return the parameters of a model with a firmware version, by number."""
    rows = tomllib.loads(_TABLE.read_text(encoding="utf-8"))["parameter"]
    parameters = (
        Parameter(
            row["number"],
            row["key"],
            row["min"],
            row["max"],
            row.get(f"default_{model}"),
            row["since"],
        )
        for row in rows
        if model in row["models"]
    )
    return {each.number: each for each in parameters if each.since <= firmware}


class Oracle:
    """Board that replies to bytes.

    The caller sets the measured values: `raw` for the channels, and `measured` for currents and for
    the motor bits of the status byte. `measured` is the reply of the other board.
    """

    def __init__(
        self,
        model: str = "trex",
        firmware: str = "1.2",
        mode: str = "serial",
        mix: bool = False,
        parameters: Mapping[str, int] | None = None,
        calibrations: Mapping[tuple[str, int], Calibration] | None = None,
        raw: Sequence[int | None] = (None,) * 5,
    ) -> None:
        """Keys of `calibrations`: "rc" or "analog", channel 1-5. None in `raw`: invalid signal."""
        self.model = model
        self.firmware = firmware
        self.mode = mode
        self.mix = mix
        self.raw = raw
        self.measured = b""
        self.safe_start = False
        self.wrote = False
        self._known = table(model, firmware)
        self._stored = self._factory()
        self._stored.update((self._number(key), value) for key, value in (parameters or {}).items())
        self._calibrations = {
            "rc": [RC_DEFAULT for _ in _CHANNELS],
            "analog": [ANALOG_DEFAULT for _ in _CHANNELS],
        }
        for (source, channel), calibration in (calibrations or {}).items():
            self._calibrations[source][channel - 1] = calibration
        self.power_cycle()

    def power_cycle(self) -> None:
        if _FACTORY_RESET in self._stored:
            self._stored = self._factory()
        self.uart_errors = UartError.NONE
        self.status = Status.NONE
        self._silent: float | None = None  # seconds since the last byte, None before the first byte
        self._joint = self.stored("motor_mode") == 1
        self._serial_source = "analog" if self.stored("channel_input_source") == 1 else "rc"
        polynomial = 0x80 | self.stored("crc7_polynomial")
        with_crc = self.stored("uart_settings") >> 5 == 0b01
        self._framer = Framer(self.stored("device_number"), polynomial if with_crc else None)

    def stored(self, key: str) -> int:
        return self._stored[self._number(key)]

    @property
    def polynomial(self) -> int | None:
        """Polynomial of the CRC of packets. None without a CRC."""
        return self._framer.polynomial

    @property
    def source(self) -> str:
        """Kind of signal, "rc" or "analog", whose calibrations are in use."""
        return self._serial_source if self.mode == "serial" else self.mode

    def pause(self, seconds: float) -> None:
        """Let time pass on the line, which may exceed the serial timeout."""
        if self._silent is None:
            return
        self._silent += seconds
        timeout = self.stored("serial_timeout") * 0.1
        if timeout and self._silent > timeout and self._serial_controls():
            self._latch(UartError.TIMEOUT)

    def feed(self, byte: int) -> bytes:
        """Receive a byte. Return the whole reply if the byte completes a request."""
        self._silent = 0.0
        self.wrote = False
        packet, error = self._framer.feed(byte)
        if error:
            self._latch(error)
        reply = self._answer(packet) if packet else b""
        # Inferred: a reply without data has no CRC.
        return sealed(reply, self.polynomial) if reply else b""

    def _answer(self, packet: Packet) -> bytes:
        command, data = packet
        match command:
            case 0x81:
                return ({"trex": "TReX", "trexjr": "TReXJr"}[self.model] + self.firmware).encode()
            case 0x82:
                return self._mode_letter().encode()
            case 0x83:
                return bytes([self._serial_controls()])
            case 0x84:
                status, self.status = self.status, Status.NONE
                return bytes([status | (self.measured.ljust(1, b"\0")[0] & 0xF0)])
            case 0x85:
                errors, self.uart_errors = self.uart_errors, UartError.NONE
                return bytes([errors])
            case 0x86 | 0x87:
                return self._channel_values(command, data[0])
            case 0x8D | 0x8E | 0x8F:
                return self.measured.ljust(2, b"\0")[: 2 if command == 0x8F else 1]
            case 0x90 | 0x91 | 0x92 | 0x93 | 0x94:
                return b"".join(_two_bytes(value) for value in self._active()[command - 0x90])
            case 0x95:
                default = ANALOG_DEFAULT if self.source == "analog" else RC_DEFAULT
                changed = [calibration != default for calibration in self._active()]
                return bytes([sum(differs << n for n, differs in enumerate(changed))])
            case 0x9F:
                return self._get_parameter(data[0])
            case 0xA0 | 0xA1 | 0xA2 | 0xA3 | 0xA4:
                return self._set_calibration(command - 0xA0, data)
            case 0xAF:
                return self._set_parameter(data)
        return b""  # the motor commands and the null command

    def _channel_values(self, command: int, mask: int) -> bytes:
        if mask > 0x1F:
            return self._format_error()  # inferred: a missing channel is an illogical request
        if command == 0x86:
            values = [_two_bytes(raw) for raw in self._raw()]
        else:
            values = [bytes([coded(value)]) for value in self._remapped()]
        return b"".join(value for n, value in enumerate(values) if mask >> n & 1)

    def _remapped(self) -> Iterator[int]:
        channels = [
            remapped(
                raw,
                calibration,
                ignored=self._has_channel("ignored_channels", n),
                reverse=self._has_channel("reversed_channels", n),
                parabolic=self._has_channel("parabolic_channels", n),
            )
            for n, (raw, calibration) in enumerate(zip(self._raw(), self._active(), strict=True))
        ]
        yield from motors(
            channels[0], channels[1], mix=self.mix, joint=self._joint, flip=self._switch(_FLIP)
        )
        yield from channels[2:]

    def _get_parameter(self, number: int) -> bytes:
        known = self._known.get(number)
        if known is None or known.default is None:
            return self._format_error()  # inferred: not documented
        return bytes([self._stored[number]])

    def _set_parameter(self, data: bytes) -> bytes:
        number, value = data[:2]
        if data[2:] != _FORMAT_BYTES:
            return self._format_error()
        known = self._known.get(number)
        if self.mode != "serial":
            return bytes([NOT_SERIAL])
        if known is None:
            return bytes([BAD_NUMBER])
        if not known.allows(value):
            return bytes([BAD_VALUE])
        self._stored[number] = value
        self._framer.device_number = self.stored("device_number")
        self.wrote = True
        return bytes([OK])

    def _set_calibration(self, channel: int, data: bytes) -> bytes:
        if data[8:] != _FORMAT_BYTES:
            return self._format_error()
        if self.mode != "serial":
            return bytes([NOT_SERIAL])
        # Inferred, strongly: a data byte carries seven bits, so two of them carry fourteen.
        values = (low | high << 7 for low, high in zip(data[0:8:2], data[1:8:2], strict=True))
        calibration = Calibration(*values)
        if not calibration.allowed:
            return bytes([BAD_VALUE])
        self._active()[channel] = calibration
        self.wrote = True
        return bytes([OK])

    def _format_error(self) -> bytes:
        self._latch(UartError.FORMAT)
        return b""

    def _latch(self, error: UartError) -> None:
        self.uart_errors |= error
        self.status |= Status.UART_ERROR

    def _mode_letter(self) -> str:
        letter = self.source[0]
        return letter if self.mode == "serial" else letter.upper()

    def _serial_controls(self) -> bool:
        return self.mode == "serial" or (self._switch(_OVERRIDE) and not self.safe_start)

    def _switch(self, channel: int) -> bool:
        return switched_on(
            self._raw()[channel],
            self._active()[channel],
            ignored=self._has_channel("ignored_channels", channel),
            reverse=self._has_channel("reversed_channels", channel),
        )

    def _raw(self) -> list[int]:
        return [INVALID if raw is None else raw for raw in self.raw]

    def _active(self) -> list[Calibration]:
        return self._calibrations[self.source]

    def _has_channel(self, key: str, channel: int) -> bool:
        """Return whether a mask parameter includes a channel."""
        return bool(self.stored(key) >> channel & 1)

    def _number(self, key: str) -> int:
        return next(known.number for known in self._known.values() if known.key == key)

    def _factory(self) -> dict[int, int]:
        defaults = ((known.number, known.default) for known in self._known.values())
        return {number: default for number, default in defaults if default is not None}


def _two_bytes(value: int) -> bytes:
    return value.to_bytes(2, "little")
