"""What is odd about settings when they are looked at together; the window and trexcmd both ask.

A rule speaks of values that the board takes one by one and that together do something a person
hardly wants. It never forbids: it says what is odd and, where one change is plainly better,
proposes it.
"""

from collections.abc import Callable, Collection, Iterator, Mapping
from dataclasses import dataclass, field, replace
from typing import NamedTuple

from trex_gui.devices.trex.protocol.calibration import Calibration, CalibrationKey
from trex_gui.devices.trex.protocol.device_table import device_table
from trex_gui.devices.trex.protocol.flags import InputSource, channels_in
from trex_gui.devices.trex.protocol.line_settings import Detection, LineSettings, baud_rates
from trex_gui.devices.trex.protocol.parameter_keys import MotorParameter, ParameterKey
from trex_gui.devices.trex.settings.document import Settings

_MOTORS = (1, 2)
_MOTOR_CHANNELS = (1, 2, 3)
_JOINT = 1
_TIMEOUT = "0.5 s"
_ACCELERATION = 10
"""Speed steps per 100 ms: full speed after 1.3 s, gentle and still quick."""

_SHORTEST_PULSE = 1250
"""Counts of 0.4 us: the shortest RC pulse that is valid. Ref: Pololu TReX User's Guide 4.c."""


@dataclass(frozen=True, slots=True)
class Context:
    """What is known beside the settings.

    Attributes:
        drives_from_computer: whether the motors are driven over the serial line.
        port_rates: the baud rates that this computer's port can do; `None`: unknown.
        used_by_line: the line settings now in use, with the rate that really is on the line;
            `None`: unknown.
    """

    drives_from_computer: bool = False
    port_rates: Collection[int] | None = None
    used_by_line: LineSettings | None = None


@dataclass(frozen=True, slots=True)
class LintFinding:
    """One oddity.

    Attributes:
        rule: the rule's stable key, such as `limit_in_joint_mode`.
        message: for people: what is odd, and what it does to them.
        keys: the settings concerned, as a settings file spells them.
        change: wire values by key that end it; empty when a person must decide.
        proposal: the change in words; empty without a change.
    """

    rule: str
    message: str
    keys: tuple[str, ...]
    change: Mapping[str, int] = field(default_factory=dict)
    proposal: str = ""


_NOTHING_MORE = Context()


def advise(settings: Settings, context: Context = _NOTHING_MORE) -> tuple[LintFinding, ...]:
    """Return what is odd about the settings, always in the same order.

    A rule that needs a setting which is not given, or whose value the board would refuse, says
    nothing. Each change may be taken without the others; taken in order, they never quarrel: of
    two for the same setting the later one serves both.
    """
    case = _Case.of(settings, context)
    return tuple(
        LintFinding(rule, odd.message, odd.keys, odd.change, _proposal(case, odd.change))
        for rule, find in RULES.items()
        for odd in find(case)
    )


def accept(settings: Settings, advice: LintFinding) -> Settings:
    """Return the settings with what an advice proposes."""
    return replace(settings, parameters={**settings.parameters, **advice.change})


class _Match(NamedTuple):
    """What a rule found: message, keys and change of the advice."""

    message: str
    keys: tuple[str, ...]
    change: Mapping[str, int]


@dataclass(frozen=True, slots=True)
class _Case:
    """The settings that can be judged: those with values that the board takes."""

    settings: Settings
    context: Context
    wires: Mapping[str, int]

    @classmethod
    def of(cls, settings: Settings, context: Context) -> "_Case":
        given = settings.parameters
        wires = {
            spec.key: given[spec.key]
            for spec in settings.specs.readable
            if spec.key in given and spec.problem(given[spec.key]) is None
        }
        return cls(settings, context, wires)

    @property
    def board(self) -> str:
        """The board in a sentence, such as `TReX Jr with firmware 1.1`."""
        firmware = self.settings.firmware
        return self.settings.product.name + (f" with firmware {firmware}" if firmware else "")

    @property
    def is_joint(self) -> bool:
        return self.wires.get(ParameterKey.MOTOR_MODE) == _JOINT

    @property
    def line(self) -> LineSettings | None:
        """The line as the settings have it."""
        wire = self.wires.get(ParameterKey.UART_SETTINGS)
        return None if wire is None else LineSettings.from_wire(wire)

    def real(self, baud: int) -> int:
        """Return the rate in bit/s that the board runs at when set to `baud`."""
        firmware = self.settings.firmware
        return baud if firmware is None else LineSettings(baud).real_baud(firmware)

    def name(self, key: str) -> str:
        return self.settings.specs[key].name

    def text(self, key: str, wire: int | None = None) -> str:
        """Return a value, the one of the settings if none is given, in physical units."""
        return self.settings.specs[key].text(self.wires[key] if wire is None else wire)

    def default(self, key: str) -> int:
        return self.settings.specs[key].default


def _proposal(case: _Case, change: Mapping[str, int]) -> str:
    """Say a change as an order: `Set Serial Timeout to 0.5 s`."""
    names: dict[str, list[str]] = {}
    for key, wire in change.items():
        names.setdefault(case.text(key, wire), []).append(case.name(key))
    parts = [f"{_joined(of_one)} to {text}" for text, of_one in names.items()]
    return f"Set {_joined(parts)}" if parts else ""


def _joined(words: list[str]) -> str:
    *first, last = words
    return f"{', '.join(first)} and {last}" if first else last


def _channels(mask: int) -> str:
    """Return `Channel 2` or `Channels 2 and 5`."""
    numbers = [str(channel) for channel in channels_in(mask)]
    return f"Channel{'s' if len(numbers) > 1 else ''} {_joined(numbers)}"


# The rules, in the order in which a person reads them: safety, motors, channels, line


def _no_timeout(case: _Case) -> Iterator[_Match]:
    key = ParameterKey.SERIAL_TIMEOUT
    if case.context.drives_from_computer and case.wires.get(key) == 0:
        change: dict[str, int] = {key: case.settings.specs[key].wire(_TIMEOUT)}
        yield _Match(
            f"{case.name(key)} is off while a computer drives the motors: when the cable or the "
            "computer fails, the motors go on as they were told last.",
            (key,),
            change,
        )


def _limit_in_joint_mode(case: _Case) -> Iterator[_Match]:
    keys = [MotorParameter.CURRENT_LIMIT.of(motor) for motor in _MOTORS]
    if set_keys := [key for key in keys if case.is_joint and case.wires.get(key)]:
        limits = _joined([f"{case.name(key)} ({case.text(key)})" for key in set_keys])
        verb = "does" if len(set_keys) == 1 else "do"
        yield _Match(
            f"{limits} {verb} nothing in joint mode, for the board measures no current then. "
            "The motor is not protected by it.",
            (ParameterKey.MOTOR_MODE, *set_keys),
            dict.fromkeys(set_keys, 0),
        )


def _limit_without_gain(case: _Case) -> Iterator[_Match]:
    for motor in () if case.is_joint else _MOTORS:
        limit = MotorParameter.CURRENT_LIMIT.of(motor)
        gain = MotorParameter.CURRENT_LIMIT_P.of(motor)
        if case.wires.get(limit) and case.wires.get(gain) == 0:
            yield _Match(
                f"{case.name(limit)} is {case.text(limit)}, but its proportionality constant P, "
                "how strongly the limiter answers, is 0. Inferred: what the board then does is "
                "documented nowhere, and the limit may have no effect.",
                (limit, gain),
                {gain: case.default(gain)},
            )


def _limit_without_ramp(case: _Case) -> Iterator[_Match]:
    for motor in () if case.is_joint else _MOTORS:
        limit, ramp = MotorParameter.CURRENT_LIMIT.of(motor), MotorParameter.ACCELERATION.of(motor)
        if case.wires.get(limit) and case.wires.get(ramp) == 0:
            yield _Match(
                f"{case.name(limit)} is {case.text(limit)} and {case.name(ramp)} is 0, which "
                "means at once. Inferred: as soon as the current falls below the limit, the "
                "motor jumps back to its full target speed, so it may run in jerks.",
                (limit, ramp),
                {ramp: _ACCELERATION},
            )


def _pwm_above_rating(case: _Case) -> Iterator[_Match]:
    pwm, highest = device_table().pwm, case.settings.product.highest_pwm
    for motor in _MOTORS:
        prescaler = MotorParameter.PWM_PRESCALER.of(motor)
        top = MotorParameter.PWM_MAXIMUM.of(motor)
        if highest is None or not {prescaler, top} <= case.wires.keys():
            continue
        frequencies = [pwm.frequency(n, case.wires[top]) for n in range(len(pwm.divisors))]
        now = frequencies[case.wires[prescaler]]
        if now <= highest:
            continue
        better = [n for n, frequency in enumerate(frequencies) if frequency <= highest]
        message = (
            f"The PWM of motor {motor} runs at {_kilohertz(now)} (inferred), but the motor driver "
            f"of a {case.settings.product.name} is rated for {_kilohertz(highest)}; above that "
            "it gets hot."
        )
        if better:
            gives = _kilohertz(frequencies[better[0]])
            message += f" The prescaler {case.text(prescaler, better[0])} gives {gives}."
        yield _Match(message, (prescaler, top), {prescaler: better[0]} if better else {})


def _kilohertz(hertz: float) -> str:
    return f"{hertz / 1000:.3g} kHz" if hertz < 1e6 else f"{hertz / 1e6:.3g} MHz"


def _required_but_ignored(case: _Case) -> Iterator[_Match]:
    required = case.wires.get(ParameterKey.REQUIRED_CHANNELS)
    ignored = case.wires.get(ParameterKey.IGNORED_CHANNELS)
    if required is None or ignored is None or not (both := required & ignored):
        return
    is_one = len(channels_in(both)) == 1
    yield _Match(
        f"{_channels(both)} {'is' if is_one else 'are'} required and ignored at once: "
        f"{'its signal moves' if is_one else 'their signals move'} nothing, but without "
        f"{'it' if is_one else 'them'} the motors may not run in RC mode (inferred).",
        (ParameterKey.REQUIRED_CHANNELS, ParameterKey.IGNORED_CHANNELS),
        {ParameterKey.REQUIRED_CHANNELS: required & ~ignored},
    )


def _motor_calibrations(case: _Case) -> Iterator[tuple[CalibrationKey, Calibration]]:
    """Yield the calibrations of the channels that drive motors."""
    for key in CalibrationKey:
        found = case.settings.calibrations.get(key)
        if key.channel in _MOTOR_CHANNELS and found is not None and found.problem() is None:
            yield key, found


def _deadband_over_travel(case: _Case) -> Iterator[_Match]:
    for key, found in _motor_calibrations(case):
        ends = {"minimum": found.neutral - found.minimum, "maximum": found.maximum - found.neutral}
        # An end that coincides with neutral is meant so: a channel that goes one way.
        if lost := [end for end, travel in ends.items() if 0 < travel <= found.deadband]:
            where = "on that side there is" if len(lost) == 1 else "there is"
            yield _Match(
                f"The deadband of {key.label} reaches from its neutral to its {_joined(lost)}: "
                f"{where} only standstill or full speed.",
                (key,),
                {},
            )


def _end_out_of_reach(case: _Case) -> Iterator[_Match]:
    for key, found in _motor_calibrations(case):
        lowest = _SHORTEST_PULSE if key.source is InputSource.RC else 0
        highest = key.source.highest_count
        odd = []
        if found.minimum < min(lowest, found.neutral):
            odd.append(f"minimum of {key.label}, {found.minimum}, lies below {lowest}, the lowest")
        if found.maximum > max(highest, found.neutral):
            odd.append(
                f"maximum of {key.label}, {found.maximum}, lies above {highest}, the highest"
            )
        for end in odd:
            yield _Match(
                f"The {end} count that the board measures: full speed on that side is never "
                "reached.",
                (key,),
                {},
            )


def _polynomial_without_crc(case: _Case) -> Iterator[_Match]:
    key, line = ParameterKey.CRC7_POLYNOMIAL, case.line
    if key not in case.wires or line is None or line.detection is Detection.CRC7:
        return
    if case.wires[key] != case.default(key):
        yield _Match(
            f"{case.name(key)} is {case.text(key)} instead of the factory's "
            f"{case.text(key, case.default(key))}, but CRC-7 is not switched on: no packet is "
            "checked with it.",
            (key, ParameterKey.UART_SETTINGS),
            {key: case.default(key)},
        )


def _crc_that_checks_nothing(case: _Case) -> Iterator[_Match]:
    key, line = ParameterKey.CRC7_POLYNOMIAL, case.line
    if case.wires.get(key) == 0 and line is not None and line.detection is Detection.CRC7:
        # Divided by x^7, the seven zero bits behind any packet leave no remainder.
        yield _Match(
            f"With {case.text(key)} as {case.name(key)} the checksum of every packet is 0, so "
            "CRC-7 finds no damage at all.",
            (key, ParameterKey.UART_SETTINGS),
            {key: case.default(key)},
        )


def _half_rate(case: _Case) -> Iterator[_Match]:
    line = case.line
    if line is None or (real := case.real(line.baud)) == line.baud:
        return
    honest: dict[str, int] = {}
    if real in baud_rates():
        honest[ParameterKey.UART_SETTINGS] = replace(line, baud=real).to_wire()
    yield _Match(
        f"A {case.board} set to {line.baud} baud really runs at {real} baud; this was mended in "
        f"firmware {device_table().half_rate_fixed_in}. Programs have to use {real} baud.",
        (ParameterKey.UART_SETTINGS,),
        honest,
    )


def _rate_the_port_lacks(case: _Case) -> Iterator[_Match]:
    line, rates, used = case.line, case.context.port_rates, case.context.used_by_line
    if line is None or rates is None:
        return
    wanted = case.real(line.baud)
    if wanted in rates or (used is not None and used.baud == wanted):
        return
    known = [rate for rate in baud_rates() if rate in rates and case.real(rate) == rate]
    slower = [rate for rate in known if rate <= wanted]
    best = slower[-1] if slower else known[0] if known else None
    if used is not None and used.baud in baud_rates() and case.real(used.baud) == used.baud:
        best = used.baud
    change: dict[str, int] = {}
    if best is not None:
        change[ParameterKey.UART_SETTINGS] = replace(line, baud=best).to_wire()
    yield _Match(
        f"This computer's serial port cannot do {wanted} baud: after the next power cycle it "
        "would not reach the board any more.",
        (ParameterKey.UART_SETTINGS,),
        change,
    )


def _line_will_change(case: _Case) -> Iterator[_Match]:
    line, used = case.line, case.context.used_by_line
    if line is None or used is None:
        return
    real = replace(line, baud=case.real(line.baud))
    if real != used:
        yield _Match(
            f"After the next power cycle the board talks at {real.text()}; now it is "
            f"{used.text()}. Programs that talk to it have to be changed then.",
            (ParameterKey.UART_SETTINGS,),
            {},
        )


RULES: Mapping[str, Callable[[_Case], Iterator[_Match]]] = {
    "no_serial_timeout": _no_timeout,
    "limit_in_joint_mode": _limit_in_joint_mode,
    "limit_without_gain": _limit_without_gain,
    "limit_without_ramp": _limit_without_ramp,
    "pwm_above_rating": _pwm_above_rating,
    "required_but_ignored": _required_but_ignored,
    "deadband_over_travel": _deadband_over_travel,
    "end_out_of_reach": _end_out_of_reach,
    "polynomial_without_crc": _polynomial_without_crc,
    "crc_that_checks_nothing": _crc_that_checks_nothing,
    "half_rate": _half_rate,
    "rate_the_port_lacks": _rate_the_port_lacks,
    "line_will_change": _line_will_change,
}
"""What finds each oddity, by its key."""
