"""Rules for settings that are valid one by one but questionable together.

A rule never forbids. It reports a finding and, where one change is plainly better, proposes it.
"""

from collections.abc import Callable, Collection, Iterator, Mapping
from dataclasses import dataclass, field, replace
from types import MappingProxyType
from typing import NamedTuple

from trex_gui.devices.trex.protocol.calibration import Calibration, CalibrationKey
from trex_gui.devices.trex.protocol.device_table import device_table
from trex_gui.devices.trex.protocol.flags import InputSource, channels_in
from trex_gui.devices.trex.protocol.line_settings import Detection, LineSettings, baud_rates
from trex_gui.devices.trex.protocol.parameters import MotorParameter, ParameterKey
from trex_gui.devices.trex.settings.document import Settings
from trex_gui.devices.trex.settings.finding_texts import LINT_MESSAGES, joined, proposal_text

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
    """What a rule found.

    Attributes:
        rule: the rule's stable key, such as `limit_in_joint_mode`.
        keys: the settings concerned.
        fields: names and values for the message, as text.
        change: wire values by key that resolve it; empty where the user must decide.
        proposed: names and new values of `change`, as text.
        variant: which of several messages of the rule.
    """

    rule: str
    keys: tuple[str, ...]
    fields: Mapping[str, str]
    change: Mapping[str, int] = field(default_factory=dict)
    proposed: tuple[tuple[str, str], ...] = ()
    variant: str = ""

    @property
    def message(self) -> str:
        """Return the finding as a sentence."""
        return LINT_MESSAGES[self.rule + self.variant].format(**self.fields)

    @property
    def proposal(self) -> str:
        """Return the change as a request; empty without one."""
        return proposal_text(self.proposed)


_NOTHING_MORE = Context()


def lint(settings: Settings, context: Context = _NOTHING_MORE) -> tuple[LintFinding, ...]:
    """Check the settings together; the findings are always in the same order.

    A rule is silent if a setting that it needs is missing or invalid. Each change may be made
    without the others; of two changes of one setting the later one resolves both.
    """
    case = _Case.of(settings, context)
    return tuple(
        LintFinding(
            rule,
            found.keys,
            found.fields,
            found.change,
            tuple((case.name(key), case.text(key, wire)) for key, wire in found.change.items()),
            found.variant,
        )
        for rule, find in RULES.items()
        for found in find(case)
    )


def accept(settings: Settings, finding: LintFinding) -> Settings:
    """Return the settings with the change that a finding proposes."""
    return replace(settings, parameters={**settings.parameters, **finding.change})


class _Match(NamedTuple):
    """A finding of a rule."""

    keys: tuple[str, ...]
    fields: Mapping[str, str]
    change: Mapping[str, int] = MappingProxyType({})
    variant: str = ""


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


# The rules, in the order in which the user reads them: safety, motors, channels, line


def _no_timeout(case: _Case) -> Iterator[_Match]:
    key = ParameterKey.SERIAL_TIMEOUT
    if case.context.drives_from_computer and case.wires.get(key) == 0:
        change = {str(key): case.settings.specs[key].wire(_TIMEOUT)}
        yield _Match((key,), {"name": case.name(key)}, change)


def _limit_in_joint_mode(case: _Case) -> Iterator[_Match]:
    keys = [MotorParameter.CURRENT_LIMIT.of(motor) for motor in _MOTORS]
    if set_keys := [key for key in keys if case.is_joint and case.wires.get(key)]:
        limits = joined([f"{case.name(key)} ({case.text(key)})" for key in set_keys])
        change = dict.fromkeys(set_keys, 0)
        yield _Match((ParameterKey.MOTOR_MODE, *set_keys), {"limits": limits}, change)


def _limit_without_gain(case: _Case) -> Iterator[_Match]:
    for motor in () if case.is_joint else _MOTORS:
        limit = MotorParameter.CURRENT_LIMIT.of(motor)
        gain = MotorParameter.CURRENT_LIMIT_P.of(motor)
        if case.wires.get(limit) and case.wires.get(gain) == 0:
            fields = {"limit": case.name(limit), "value": case.text(limit)}
            yield _Match((limit, gain), fields, {gain: case.default(gain)})


def _limit_without_ramp(case: _Case) -> Iterator[_Match]:
    for motor in () if case.is_joint else _MOTORS:
        limit, ramp = MotorParameter.CURRENT_LIMIT.of(motor), MotorParameter.ACCELERATION.of(motor)
        if case.wires.get(limit) and case.wires.get(ramp) == 0:
            fields = {"limit": case.name(limit), "value": case.text(limit), "ramp": case.name(ramp)}
            yield _Match((limit, ramp), fields, {ramp: _ACCELERATION})


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
        fields = {
            "motor": str(motor),
            "now": _kilohertz(now),
            "product": case.settings.product.name,
            "highest": _kilohertz(highest),
        }
        better = [n for n, frequency in enumerate(frequencies) if frequency <= highest]
        if not better:
            yield _Match((prescaler, top), fields)
            continue
        fields["prescaler"] = case.text(prescaler, better[0])
        fields["gives"] = _kilohertz(frequencies[better[0]])
        yield _Match((prescaler, top), fields, {prescaler: better[0]}, ".better")


def _kilohertz(hertz: float) -> str:
    return f"{hertz / 1000:.3g} kHz" if hertz < 1e6 else f"{hertz / 1e6:.3g} MHz"


def _required_but_ignored(case: _Case) -> Iterator[_Match]:
    keys = ParameterKey.REQUIRED_CHANNELS, ParameterKey.IGNORED_CHANNELS
    required, ignored = (case.wires.get(key, 0) for key in keys)
    if both := required & ignored:
        fields = {"channels": joined([f"channel {n}" for n in channels_in(both)])}
        yield _Match(keys, fields, {str(keys[0]): required & ~ignored})


def _motor_calibrations(case: _Case) -> Iterator[tuple[CalibrationKey, Calibration]]:
    """Yield the calibrations of the channels that drive motors."""
    for key in CalibrationKey:
        found = case.settings.calibrations.get(key)
        if key.channel in _MOTOR_CHANNELS and found is not None and found.problem() is None:
            yield key, found


def _deadband_over_travel(case: _Case) -> Iterator[_Match]:
    for key, found in _motor_calibrations(case):
        ends = {"minimum": found.neutral - found.minimum, "maximum": found.maximum - found.neutral}
        # An end equal to neutral is intended: a channel with one direction.
        if lost := [end for end, travel in ends.items() if 0 < travel <= found.deadband]:
            yield _Match((key,), {"channel": key.label, "ends": joined(lost)})


def _end_out_of_reach(case: _Case) -> Iterator[_Match]:
    for key, found in _motor_calibrations(case):
        lowest = _SHORTEST_PULSE if key.source is InputSource.RC else 0
        highest = key.source.highest_count
        if found.minimum < min(lowest, found.neutral):
            fields = {"count": str(found.minimum), "limit": str(lowest)}
            yield _Match((key,), {"channel": key.label, **fields}, variant=".minimum")
        if found.maximum > max(highest, found.neutral):
            fields = {"count": str(found.maximum), "limit": str(highest)}
            yield _Match((key,), {"channel": key.label, **fields}, variant=".maximum")


def _polynomial_without_crc(case: _Case) -> Iterator[_Match]:
    key, line = ParameterKey.CRC7_POLYNOMIAL, case.line
    if key not in case.wires or line is None or line.detection is Detection.CRC7:
        return
    default = case.default(key)
    if case.wires[key] != default:
        fields = {
            "name": case.name(key),
            "value": case.text(key),
            "default": case.text(key, default),
        }
        yield _Match((key, ParameterKey.UART_SETTINGS), fields, {str(key): default})


def _crc_that_checks_nothing(case: _Case) -> Iterator[_Match]:
    key, line = ParameterKey.CRC7_POLYNOMIAL, case.line
    if case.wires.get(key) == 0 and line is not None and line.detection is Detection.CRC7:
        # Divided by x^7, the seven zero bits behind any packet leave no remainder.
        fields = {"name": case.name(key), "value": case.text(key)}
        yield _Match((key, ParameterKey.UART_SETTINGS), fields, {str(key): case.default(key)})


def _half_rate(case: _Case) -> Iterator[_Match]:
    line = case.line
    if line is None or (real := case.real(line.baud)) == line.baud:
        return
    fields = {
        "board": case.board,
        "baud": str(line.baud),
        "real": str(real),
        "fixed_in": device_table().half_rate_fixed_in,
    }
    yield _line_match(fields, replace(line, baud=real) if real in baud_rates() else None)


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
    yield _line_match({"baud": str(wanted)}, None if best is None else replace(line, baud=best))


def _line_will_change(case: _Case) -> Iterator[_Match]:
    line, used = case.line, case.context.used_by_line
    if line is None or used is None:
        return
    real = replace(line, baud=case.real(line.baud))
    if real != used:
        yield _line_match({"new": real.text(), "now": used.text()}, None)


def _line_match(fields: Mapping[str, str], proposed: LineSettings | None) -> _Match:
    key = ParameterKey.UART_SETTINGS
    return _Match((key,), fields, {} if proposed is None else {str(key): proposed.to_wire()})


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
"""What applies each rule, by its key."""
