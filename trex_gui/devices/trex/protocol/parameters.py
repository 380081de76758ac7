"""Configuration parameters, read from the device table.

Only this module converts wire values (0-127) to text in physical units.
"""

import difflib
import math
import re
from collections.abc import Collection, Iterable, Iterator, Mapping
from dataclasses import dataclass, field
from enum import IntEnum, StrEnum
from functools import cache, cached_property
from typing import Any

from trex_gui.core.decimals import DECIMAL, decimal, quantity
from trex_gui.core.errors import BadRequest
from trex_gui.core.translation import cached_text, tr, tr_noop, with_decimal_point
from trex_gui.devices.trex.protocol.device_table import (
    HIGHEST_WIRE,
    Model,
    device_table,
    version_key,
)
from trex_gui.devices.trex.protocol.flags import channel_mask, channels_in
from trex_gui.devices.trex.protocol.line_settings import LineSettings


class ParameterKey(StrEnum):
    AUX_ACCELERATION = "aux_acceleration"
    CHANNEL_INPUT_SOURCE = "channel_input_source"
    CRC7_POLYNOMIAL = "crc7_polynomial"
    DEVICE_NUMBER = "device_number"
    FACTORY_RESET = "factory_reset"
    IGNORED_CHANNELS = "ignored_channels"
    MOTOR_MODE = "motor_mode"
    PARABOLIC_CHANNELS = "parabolic_channels"
    REQUIRED_CHANNELS = "required_channels"
    REVERSED_CHANNELS = "reversed_channels"
    SERIAL_TIMEOUT = "serial_timeout"
    UART_ERROR_SHUTDOWN = "uart_error_shutdown"
    UART_RESPONSE_DELAY = "uart_response_delay"
    UART_SETTINGS = "uart_settings"


class MotorParameter(StrEnum):
    """Key of a motor parameter, without `motor1_` or `motor2_`."""

    ACCELERATION = "acceleration"
    BRAKE_DURATION = "brake_duration"
    CURRENT_LIMIT = "current_limit"
    CURRENT_LIMIT_P = "current_limit_p"
    DEADBAND_BRAKE_PWM = "deadband_brake_pwm"
    PWM_MAXIMUM = "pwm_maximum"
    PWM_PRESCALER = "pwm_prescaler"

    def of(self, motor: int) -> str:
        return f"motor{motor}_{self}"


_NAMES = {"motor1": tr_noop("Motor 1"), "motor2": tr_noop("Motor 2")}


def other_motor_key(key: str) -> str | None:
    motor, _, rest = key.partition("_")
    other = {"motor1": "motor2", "motor2": "motor1"}.get(motor)
    return other and f"{other}_{rest}"


def motor_name(key: str) -> str:
    """Return the name of the motor in a key, such as `Motor 1`, or an empty string."""
    return tr(_NAMES.get(key.partition("_")[0], ""))


def pwm_keys(key: str) -> tuple[str, ...]:
    """Return both PWM keys of a motor if `key` is one of them, else only `key`."""
    for part in (MotorParameter.PWM_PRESCALER, MotorParameter.PWM_MAXIMUM):
        if key.endswith(part) and motor_name(key):
            motor = key.removesuffix(part)
            return motor + MotorParameter.PWM_PRESCALER, motor + MotorParameter.PWM_MAXIMUM
    return (key,)


FULL_SPEED_S = 12.7  # seconds to full speed (127) at one speed step per 100 ms


def acceleration_wire(seconds: float) -> int:
    """Return the wire value whose time to full speed is closest to `seconds`. 0 means no ramp."""
    if seconds <= 0:
        return 0
    longer = max(1, min(int(FULL_SPEED_S / seconds), HIGHEST_WIRE - 1))
    return min(longer, longer + 1, key=lambda wire: abs(FULL_SPEED_S / wire - seconds))


@cached_text
def ramp_seconds(wire: int) -> str:
    """Return the seconds to full speed, with enough decimals to identify the wire value."""
    texts = (f"{FULL_SPEED_S / wire:.{decimals}f}" for decimals in range(1, 5))
    return with_decimal_point(
        next(text for text in texts if acceleration_wire(float(text)) == wire)
    )


_TIME = re.compile(rf"({DECIMAL})\s*(m?)s(?:\s+to full speed)?", re.IGNORECASE)
_TIME_TOLERANCE = 1.01  # factor by which a time may exceed its limits
_ROUNDING = 0.01  # fraction of a step by which a number may exceed its limits


class Grade(IntEnum):
    """Grade of evidence, strongest first. `resources/trex_parameters.toml` explains each grade."""

    SOURCED = 0
    TWIN = 1
    INFERRED = 2

    @property
    def mark(self) -> str:
        """Suffix for a sentence, such as ` (twin)`. Empty for a sourced fact."""
        return f" {tr(_MARKS[self])}" if self in _MARKS else ""


_MARKS = {Grade.TWIN: tr_noop("(twin)"), Grade.INFERRED: tr_noop("(inferred)")}


class ParameterKind(StrEnum):
    """Encoding of a parameter, which determines its editor."""

    NUMBER = "number"
    CHOICE = "choice"
    CHANNELS = "channels"
    ACCELERATION = "acceleration"
    PWM_MAXIMUM = "pwm_maximum"
    POLYNOMIAL = "polynomial"
    UART = "uart"
    RESET = "reset"


# Kinds without open values (see `is_open`). Undocumented line settings could make a board
# unreachable.
_NEVER_OPEN = {ParameterKind.UART, ParameterKind.POLYNOMIAL, ParameterKind.RESET}


@dataclass(frozen=True, slots=True, kw_only=True)
class ParameterSpec:
    """Entry in the parameter table for one model.

    `minimum`, `maximum` and `default` are wire values. The physical value is the wire value times
    `scale`, in `unit`.
    """

    number: int
    key: str
    name: str
    short_name: str  # name without the motor
    kind: ParameterKind
    description: str
    group: str
    task: str
    subject: str
    minimum: int
    maximum: int
    default: int
    unit: str = ""
    scale: float = 1
    zero: str = ""  # meaning of the wire value 0, such as `off`; empty if it is ordinary
    choices: Mapping[int, str] = field(default_factory=dict)
    valid: frozenset[int] = frozenset()  # allowed wire values
    needs_power_cycle: bool = False
    since: str = "1.0"  # first firmware version with this parameter
    grades: Mapping[str, Grade] = field(default_factory=dict)  # field of the table → evidence
    doubt: str = ""  # argument against an inferred default
    section: str = ""  # section of the user's guide, such as `4.c`; empty if unknown

    @property
    def readable(self) -> bool:
        """True if 0x9F can read the parameter. Only the factory reset is write-only."""
        return self.kind is not ParameterKind.RESET

    def grade(self, *fields: str) -> Grade:
        """Return the weakest evidence for these fields of the table."""
        return max(self.grades.get(name, Grade.SOURCED) for name in fields)

    @property
    def limits_mark(self) -> str:
        return self.grade("min", "max").mark

    def is_open(self, wire: int) -> bool:
        """True if this wire value is excluded only by a limit that is not sourced."""
        if self.kind in _NEVER_OPEN or not 0 <= wire <= HIGHEST_WIRE or wire in self.valid:
            return False
        return self.grade("min" if wire < self.minimum else "max") > Grade.SOURCED

    @property
    def has_open_values(self) -> bool:
        return any(map(self.is_open, (0, HIGHEST_WIRE)))

    def problem(self, wire: int, *, forced: bool = False) -> str | None:
        """Return the reason a value is not allowed, or `None`. `forced` allows open values."""
        if wire in self.valid or (forced and self.is_open(wire)):
            return None
        return tr("{0} must be {1}, not {2}").format(self.name, self.range_text(), wire)

    def check(self, wire: int, *, forced: bool = False) -> int:
        if problem := self.problem(wire, forced=forced):
            raise BadRequest(problem)
        return wire

    def short_range(self) -> str:
        match self.kind:
            case ParameterKind.CHOICE:
                return ", ".join(self.choices.values())
            case ParameterKind.CHANNELS:
                return tr("any of 1 to 5")
            case ParameterKind.UART:
                return tr("baud, error detection, stop bits")
            case ParameterKind.ACCELERATION:
                fast, slow = ramp_seconds(self.maximum), ramp_seconds(1)
                return tr("{0} to {1} s to full speed, or {2}").format(fast, slow, self.zero)
            case _ if self.minimum == self.maximum:
                return self.text(self.minimum)
        return tr("{0} to {1}").format(self.text(self.minimum), self.text(self.maximum))

    def range_text(self) -> str:
        match self.kind:
            case ParameterKind.CHOICE:
                return tr(" or ").join(f"{wire} ({word})" for wire, word in self.choices.items())
            case ParameterKind.CHANNELS:
                return tr("channels 1 to 5 (wire value 0 to {0})").format(self.maximum)
            case ParameterKind.UART:
                return tr("a baud rate, error detection and stop bits (low four bits 0 to 10)")
            case ParameterKind.ACCELERATION:
                return tr("{0} (wire value {1} to {2})").format(
                    self.short_range(), self.minimum, self.maximum
                )
            case _ if self.minimum == self.maximum:
                return str(self.minimum)
        low, high = self.text(self.minimum), self.text(self.maximum)
        if low == str(self.minimum) and high == str(self.maximum):
            return tr("{0} to {1}").format(low, high)
        return tr("{0} to {1} (wire value {2} to {3})").format(
            low, high, self.minimum, self.maximum
        )

    def text(self, wire: int) -> str:
        """Return a wire value (0-127, allowed or not) in physical units."""
        match self.kind:
            case ParameterKind.CHANNELS:
                if wire <= self.maximum:
                    return channels_text(channels_in(wire))
                return tr("wire {0}").format(wire)
            case ParameterKind.CHOICE:
                return self.choices.get(wire, tr("wire {0}").format(wire))
            case ParameterKind.POLYNOMIAL:
                return f"0x{0x80 | wire:02X}"
            case ParameterKind.PWM_MAXIMUM:
                return str(device_table().pwm.maximum(wire))
            case ParameterKind.UART:
                line = _line_settings(wire)
                return line.text() if line else tr("wire {0}").format(wire)
            case ParameterKind.ACCELERATION if wire:
                return tr("{0} s to full speed").format(ramp_seconds(wire))
        if wire == 0 and self.zero:
            return self.zero
        number = f"{wire * self.scale:.{self.decimals}f}"
        if "." in number:
            number = number.rstrip("0").rstrip(".")
        return f"{with_decimal_point(number)} {self.unit}".rstrip()

    def wire(self, text: str) -> int:
        """Parse a value such as `1.5 s`, `1.5` or `off`. Raise a BadRequest that names the limits.

        A quantity between two steps is rounded, but never to 0 if 0 has a special meaning such as
        off. A ramp is a time to full speed (`1.3 s`) or a number of speed steps (`10 per 100 ms`).
        """
        text = text.strip()
        for wire in sorted(self.valid):
            if text.casefold() == self.text(wire).casefold():
                return wire
        value: int | None
        if self.kind is ParameterKind.CHANNELS:
            value = self._wire_of_channels(text)
        elif self.kind is ParameterKind.ACCELERATION and (time := _TIME.fullmatch(text)):
            value = self._wire_of_time(decimal(time[1]) / (1000 if time[2] else 1))
        else:
            value = self._wire_of_number(text)
        if value is None or value not in self.valid:
            shortened = (text if len(text) <= 40 else f"{text[:40]}…") or tr("an empty text")
            message = tr("{0} must be {1}, not {2}")
            raise BadRequest(message.format(self.name, self._range_in_words(), shortened))
        return value

    def _range_in_words(self) -> str:
        if self.kind is ParameterKind.CHOICE:
            return tr(" or ").join(self.choices.values())
        if self.kind is ParameterKind.CHANNELS:
            return tr("none, or any of channels 1 to 5, such as 1, 3")
        if self.kind is ParameterKind.UART:
            return tr("written as {0}, with a baud rate that the board supports").format(
                self.text(self.default)
            )
        return self.short_range()

    @property
    def decimals(self) -> int:
        return max(0, math.ceil(-math.log10(self.scale)))

    def _wire_of_time(self, seconds: float) -> int | None:
        shortest = FULL_SPEED_S / self.maximum / _TIME_TOLERANCE
        if seconds and not shortest <= seconds <= FULL_SPEED_S * _TIME_TOLERANCE:
            return None
        return acceleration_wire(seconds)

    def _wire_of_number(self, text: str) -> int | None:
        steps = self._steps(text)
        if steps is None or not math.isfinite(steps):
            return None
        wire = round(steps)
        is_quantity = bool(self.unit) or self.kind is ParameterKind.PWM_MAXIMUM
        if wire != steps and not is_quantity:  # a plain number must be exact
            return None
        if not self.minimum - _ROUNDING <= steps <= self.maximum + _ROUNDING:
            return None
        return 1 if self.zero and wire == 0 < steps else wire

    def _steps(self, text: str) -> float | None:
        is_coded = self.kind in {ParameterKind.POLYNOMIAL, ParameterKind.UART}
        if is_coded and text.lower().startswith("0x"):
            try:
                value = float(int(text, 16))
            except (ValueError, OverflowError):
                return None
        elif (number := quantity(text, self.unit)) is not None:
            value = number
        else:
            return None
        if self.kind is ParameterKind.PWM_MAXIMUM:
            pwm = device_table().pwm
            return (value - pwm.offset) / pwm.scale
        if self.kind is ParameterKind.POLYNOMIAL and 0x80 <= value <= 0xFF:
            return value - 0x80
        return value / self.scale

    @staticmethod
    def _wire_of_channels(text: str) -> int | None:
        if text.casefold() in {"none", ""}:
            return 0
        words = re.sub("^channels?", "", text.casefold())
        parts = [part for part in re.split(r"[\s,;+]+", words) if part]
        try:
            return channel_mask(map(int, parts)) if parts else None
        except ValueError:
            return None


def channels_text(channels: Collection[int]) -> str:
    if not channels:
        return tr("none", "channels")
    text = tr("channel {0}") if len(channels) == 1 else tr("channels {0}")
    return text.format(", ".join(map(str, channels)))


def _line_settings(wire: int) -> LineSettings | None:
    try:
        return LineSettings.from_wire(wire)
    except BadRequest:
        return None


@dataclass(frozen=True)
class ParameterSet:
    """Parameters of a model with one firmware version, sorted by number."""

    model: Model
    firmware: str
    specs: tuple[ParameterSpec, ...]

    def __iter__(self) -> Iterator[ParameterSpec]:
        return iter(self.specs)

    @property
    def readable(self) -> tuple[ParameterSpec, ...]:
        return tuple(spec for spec in self.specs if spec.readable)

    @cached_property
    def readable_by_key(self) -> Mapping[str, ParameterSpec]:
        return {spec.key: spec for spec in self.readable}

    def __getitem__(self, key: str) -> ParameterSpec:
        """Return the parameter with this key or name.

        Raises:
            BadRequest: there is no such parameter. The message suggests a similar key.
        """
        for spec in self.specs:
            if key == spec.key:  # fast path, because sessions look up hundreds of keys a second
                return spec
        normal = key.strip().lower().replace("-", "_").replace(" ", "_")
        for spec in self.specs:
            if normal in {spec.key, spec.name.lower().replace("-", "_").replace(" ", "_")}:
                return spec
        similar = difflib.get_close_matches(normal, [spec.key for spec in self.specs], n=1)
        hint = tr("; did you mean {0}?").format(similar[0]) if similar else ""
        text = tr("{0} {1} has no parameter {2!r}{3}")
        raise BadRequest(text.format(self.model.name, self.firmware, key, hint))

    def number(self, number: int) -> ParameterSpec | None:
        return next((spec for spec in self.specs if spec.number == number), None)


@cached_text
def parameters_of(model_key: str, firmware: str) -> ParameterSet:
    """Return the parameters of a model (`trex`, `trexjr`) with a firmware version (`1.2`)."""
    table = device_table()
    model = table.model(model_key)
    specs = tuple(
        _read_spec(row, model)
        for row in table.rows
        if model.key in row["models"] and version_key(row["since"]) <= version_key(firmware)
    )
    return ParameterSet(model, firmware, specs)


def unconfirmed_defaults(specs: Iterable[ParameterSpec]) -> str:
    """Return the names of parameters with unsourced defaults, each with its evidence mark."""
    graded = ((spec.name, spec.grade("default").mark) for spec in specs)
    return ", ".join(name + mark for name, mark in graded if mark)


@cache
def parameter_number(key: str) -> int:
    for row in device_table().rows:
        if row["key"] == key:
            number: int = row["number"]
            return number
    raise BadRequest(tr("the table has no parameter {0!r}").format(key))


def _read_spec(row: Mapping[str, Any], model: Model) -> ParameterSpec:
    scale = row["scale"]
    source = row["source"]
    names = {grade.name.lower(): grade for grade in Grade}
    grades = {name: names[origin] for name, origin in source.items() if origin in names}
    default = source.get(f"default_{model.key}", source.get("default", "inferred"))
    grades["default"] = names[default]
    kind = ParameterKind(row["kind"])
    valid = frozenset(range(row["min"], row["max"] + 1))
    if kind is ParameterKind.UART:
        valid = frozenset(filter(_line_settings, valid))
    return ParameterSpec(
        number=row["number"],
        key=row["key"],
        name=tr(row["name"]),
        short_name=tr(re.sub("^Motor [12] ", "", row["name"])),
        kind=kind,
        description=tr(row["description"]),
        group=row["group"],
        task=row.get("task", row["group"]),
        subject=row.get("subject", row["group"]),
        minimum=row["min"],
        maximum=row["max"],
        default=row.get(f"default_{model.key}", row["min"]),
        unit=row["unit"],
        scale=scale[model.key] if isinstance(scale, dict) else scale,
        zero=tr(row.get("zero", ""), row.get("zero_of", "")),
        choices={int(wire, 0): tr(word) for wire, word in row.get("values", {}).items()},
        valid=valid,
        needs_power_cycle=row["needs_reset"],
        since=row["since"],
        grades=grades,
        doubt=tr(row.get("doubt", "")),
        section=source.get(f"guide_{model.key}", ""),
    )
