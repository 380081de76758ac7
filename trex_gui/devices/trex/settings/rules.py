"""Rules for questionable combinations of valid settings.

A rule does not forbid anything. It reports a finding and may propose a change.
"""

from collections.abc import Callable, Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from types import MappingProxyType
from typing import NamedTuple

from trex_gui.core.translation import Number, tr
from trex_gui.devices.trex.driving.timeout_stop import with_shutdown
from trex_gui.devices.trex.protocol.calibration import Calibration, CalibrationKey
from trex_gui.devices.trex.protocol.device_table import device_table
from trex_gui.devices.trex.protocol.flags import InputSource, channels_in
from trex_gui.devices.trex.protocol.line_settings import Detection, LineSettings, baud_rates
from trex_gui.devices.trex.protocol.parameters import MotorParameter, ParameterKey
from trex_gui.devices.trex.settings.document import Settings

_MOTORS = (1, 2)
_MOTOR_CHANNELS = (1, 2, 3)
_JOINT = 1
_TIMEOUT = "0.5 s"
_ACCELERATION = 10  # speed steps per 100 ms; gentle, but reaches full speed in 1.3 s
_SHORTEST_PULSE = 1250  # counts of 0.4 us. Ref: Pololu TReX User's Guide 4.c


@dataclass(frozen=True, slots=True)
class Context:
    drives_from_computer: bool = False  # True if the motors are driven over the serial line
    port_rates: Collection[int] | None = None  # baud rates of this computer's port; `None`: unknown
    active_line: LineSettings | None = None  # with the real baud rate; `None`: unknown


@dataclass(frozen=True, slots=True)
class LintFinding:
    rule: str  # the rule's stable key, such as `limit_in_joint_mode`
    keys: tuple[str, ...]  # of the affected settings
    message: str  # one or more sentences
    change: Mapping[str, int]  # key → proposed wire value; empty if the user must decide
    proposal: str  # `change` as text, such as `Set Serial Timeout to 0.5 s`; may be empty

    @property
    def text(self) -> str:
        return f"{self.message} {self.proposal}." if self.proposal else self.message


_NO_CONTEXT = Context()


def lint(settings: Settings, context: Context = _NO_CONTEXT) -> tuple[LintFinding, ...]:
    """Check the settings for questionable combinations. The order of findings is fixed.

    A rule reports nothing if a setting that it needs is missing or invalid. Each change can be
    applied on its own. If two findings change the same setting, the later change resolves both.
    """
    case = _Case(settings.without_invalid(forced=False), context)
    return tuple(
        LintFinding(rule, keys, message, change, _proposal_text(case, change))
        for rule, find in RULES.items()
        for keys, message, change in find(case)
    )


def accept_proposals(settings: Settings) -> tuple[Settings, tuple[LintFinding, ...]]:
    """Apply the changes that the rules propose.

    Returns the changed settings and the accepted findings. A change can cause a new finding, so
    the rules run repeatedly. Each rule changes a setting only once.
    """
    accepted: dict[tuple[str, tuple[str, ...]], LintFinding] = {}
    for _ in RULES:
        new = {
            (finding.rule, finding.keys): finding
            for finding in lint(settings)
            if finding.change and (finding.rule, finding.keys) not in accepted
        }
        if not new:
            break
        accepted |= new
        changes = {key: wire for finding in new.values() for key, wire in finding.change.items()}
        settings = replace(settings, parameters={**settings.parameters, **changes})
    return settings, tuple(accepted.values())


def _proposal_text(case: "_Case", change: Mapping[str, int]) -> str:
    names: dict[str, list[str]] = {}
    for key, wire in change.items():
        names.setdefault(case.text(key, wire), []).append(case.name(key))
    parts = [
        tr("{0} to {1}", "set a parameter").format(_joined(equal), value)
        for value, equal in names.items()
    ]
    return tr("Set {0}").format(_joined(parts)) if parts else ""


def _joined(words: Sequence[str]) -> str:
    """Return `a`, `a and b` or `a, b and c`."""
    *first, last = words
    return tr("{0} and {1}").format(", ".join(first), last) if first else last


class _Match(NamedTuple):
    keys: tuple[str, ...]
    message: str
    change: Mapping[str, int] = MappingProxyType({})


@dataclass(frozen=True, slots=True)
class _Case:
    settings: Settings
    context: Context

    @property
    def wires(self) -> Mapping[str, int]:
        return self.settings.parameters

    @property
    def is_joint(self) -> bool:
        return self.wires.get(ParameterKey.MOTOR_MODE) == _JOINT

    @property
    def line(self) -> LineSettings | None:
        wire = self.wires.get(ParameterKey.UART_SETTINGS)
        return None if wire is None else LineSettings.from_wire(wire)

    def real(self, baud: int) -> int:
        """Return the real baud rate of a board that is set to `baud`."""
        firmware = self.settings.firmware
        return baud if firmware is None else LineSettings(baud).real_baud(firmware)

    def name(self, key: str) -> str:
        return self.settings.specs[key].name

    def text(self, key: str, wire: int | None = None) -> str:
        """Return a value in physical units. By default, it is the value in the settings."""
        return self.settings.specs[key].text(self.wires[key] if wire is None else wire)

    def default(self, key: str) -> int:
        return self.settings.specs[key].default


# The rules, in the order in which the user sees them: safety, motors, channels, line


def _no_timeout(case: _Case) -> Iterator[_Match]:
    key = ParameterKey.SERIAL_TIMEOUT
    if case.context.drives_from_computer and case.wires.get(key) == 0:
        change = with_shutdown(case.settings.specs[key].wire(_TIMEOUT))
        change = {name: wire for name, wire in change.items() if case.wires.get(name) != wire}
        text = tr(
            "{name} is off while a computer drives the motors: if the cable or the computer fails, "
            "the motors keep running at their last setpoint."
        )
        keys = key, *(name for name in change if name != key)
        yield _Match(keys, text.format(name=case.name(key)), change)


def _timeout_without_shutdown(case: _Case) -> Iterator[_Match]:
    timeout, shutdown = ParameterKey.SERIAL_TIMEOUT, ParameterKey.UART_ERROR_SHUTDOWN
    if case.wires.get(timeout) and case.wires.get(shutdown) == 0:
        text = tr(
            "{timeout} of {seconds} may not stop the motors if the cable or the computer "
            "fails: {shutdown} is off (twin)."
        ).format(
            timeout=case.name(timeout), seconds=case.text(timeout), shutdown=case.name(shutdown)
        )
        yield _Match((timeout, shutdown), text, {shutdown: 1})


def _limit_in_joint_mode(case: _Case) -> Iterator[_Match]:
    keys = [MotorParameter.CURRENT_LIMIT.of(motor) for motor in _MOTORS]
    if set_keys := [key for key in keys if case.is_joint and case.wires.get(key)]:
        limits = _joined([f"{case.name(key)} ({case.text(key)})" for key in set_keys])
        text = tr(
            "No effect in joint mode: {limits}. In this mode the board measures no current, "
            "so the motor is not protected."
        ).format(limits=limits)
        yield _Match((ParameterKey.MOTOR_MODE, *set_keys), text, dict.fromkeys(set_keys, 0))


def _limits_with_zero(case: _Case, parameter: MotorParameter) -> Iterator[tuple[str, str]]:
    """Yield two keys for each motor whose current limit is active and whose `parameter` is 0."""
    for motor in () if case.is_joint else _MOTORS:
        limit, key = MotorParameter.CURRENT_LIMIT.of(motor), parameter.of(motor)
        if case.wires.get(limit) and case.wires.get(key) == 0:
            yield limit, key


def _limit_without_gain(case: _Case) -> Iterator[_Match]:
    for limit, gain in _limits_with_zero(case, MotorParameter.CURRENT_LIMIT_P):
        text = tr(
            "{limit} is {value}, but its proportionality constant P, which sets how strongly "
            "the limiter reacts, is 0. Therefore, the limit may have no effect (inferred)."
        ).format(limit=case.name(limit), value=case.text(limit))
        yield _Match((limit, gain), text, {gain: case.default(gain)})


def _limit_without_ramp(case: _Case) -> Iterator[_Match]:
    for limit, ramp in _limits_with_zero(case, MotorParameter.ACCELERATION):
        text = tr(
            "{limit} is {value} and {ramp} is 0, so the speed changes at once. As soon as "
            "the current falls below the limit, the motor jumps back to its full target "
            "speed, so it may run in jerks (inferred)."
        ).format(limit=case.name(limit), value=case.text(limit), ramp=case.name(ramp))
        yield _Match((limit, ramp), text, {ramp: _ACCELERATION})


def _pwm_above_rating(case: _Case) -> Iterator[_Match]:
    pwm, highest = device_table().pwm, case.settings.product.highest_pwm
    for motor in _MOTORS:
        prescaler = MotorParameter.PWM_PRESCALER.of(motor)
        maximum = MotorParameter.PWM_MAXIMUM.of(motor)
        if highest is None or not {prescaler, maximum} <= case.wires.keys():
            continue
        frequencies = [pwm.frequency(n, case.wires[maximum]) for n in range(len(pwm.divisors))]
        now = frequencies[case.wires[prescaler]]
        if now <= highest:
            continue
        text = tr(
            "The PWM of motor {motor} runs at {now} (inferred), but the motor driver of a "
            "{product} is rated for {highest}. Above this frequency, the driver gets hot."
        ).format(
            motor=motor,
            now=_kilohertz(now),
            product=case.settings.product.name,
            highest=_kilohertz(highest),
        )
        change = {}
        better = (n for n, frequency in enumerate(frequencies) if frequency <= highest)
        if (wire := next(better, None)) is not None:
            effect = tr("Prescaler {0} gives {1}.")
            text += " " + effect.format(case.text(prescaler, wire), _kilohertz(frequencies[wire]))
            change = {prescaler: wire}
        yield _Match((prescaler, maximum), text, change)


def _kilohertz(hertz: float) -> str:
    if hertz < 1e6:
        return f"{Number(hertz / 1000):.3g} kHz"
    return f"{Number(hertz / 1e6):.3g} MHz"


def _required_but_ignored(case: _Case) -> Iterator[_Match]:
    keys = ParameterKey.REQUIRED_CHANNELS, ParameterKey.IGNORED_CHANNELS
    required, ignored = (case.wires.get(key, 0) for key in keys)
    if both := required & ignored:
        text = tr(
            "Both required and ignored: {channels}. The signal controls nothing, but without "
            "the signal the motors may not run in RC mode (inferred)."
        )
        channels = _joined([tr("channel {0}").format(n) for n in channels_in(both)])
        yield _Match(keys, text.format(channels=channels), {keys[0]: required & ~ignored})


def _motor_calibrations(case: _Case) -> Iterator[tuple[CalibrationKey, Calibration]]:
    items = case.settings.calibration_items()
    return ((key, calibration) for key, calibration in items if key.channel in _MOTOR_CHANNELS)


def _deadband_over_travel(case: _Case) -> Iterator[_Match]:
    for key, calibration in _motor_calibrations(case):
        ends = {
            tr("minimum"): calibration.neutral - calibration.minimum,
            tr("maximum"): calibration.maximum - calibration.neutral,
        }
        # If an end equals neutral, the user wants the channel to have only one direction.
        if lost := [end for end, travel in ends.items() if 0 < travel <= calibration.deadband]:
            text = tr(
                "The deadband of {channel} reaches from neutral to its {ends}: there is "
                "nothing between standstill and full speed on that side."
            )
            yield _Match((key,), text.format(channel=key.label, ends=_joined(lost)))


def _end_out_of_reach(case: _Case) -> Iterator[_Match]:
    for key, calibration in _motor_calibrations(case):
        lowest = _SHORTEST_PULSE if key.source is InputSource.RC else 0
        highest = key.source.highest_count
        text = tr(
            "The {end} of {channel}, {count}, is beyond {limit}, the last count that the "
            "board measures: full speed on that side is never reached."
        )
        ends = []
        if calibration.minimum < min(lowest, calibration.neutral):
            ends.append((tr("minimum"), calibration.minimum, lowest))
        if calibration.maximum > max(highest, calibration.neutral):
            ends.append((tr("maximum"), calibration.maximum, highest))
        for end, count, limit in ends:
            message = text.format(end=end, channel=key.label, count=count, limit=limit)
            yield _Match((key,), message)


def _polynomial_without_crc(case: _Case) -> Iterator[_Match]:
    key, line = ParameterKey.CRC7_POLYNOMIAL, case.line
    if key not in case.wires or line is None or line.detection is Detection.CRC7:
        return
    default = case.default(key)
    if case.wires[key] != default:
        text = tr(
            "{name} is {value} instead of the default {default}, but CRC-7 is not switched "
            "on: no packet is checked with it."
        ).format(name=case.name(key), value=case.text(key), default=case.text(key, default))
        yield _Match((key, ParameterKey.UART_SETTINGS), text, {key: default})


def _crc_that_checks_nothing(case: _Case) -> Iterator[_Match]:
    key, line = ParameterKey.CRC7_POLYNOMIAL, case.line
    if case.wires.get(key) == 0 and line is not None and line.detection is Detection.CRC7:
        # The polynomial is x^7, and a packet with seven zero bits appended leaves no remainder.
        text = tr(
            "With {value} as {name} the checksum of every packet is 0, so CRC-7 detects no errors "
            "at all."
        ).format(name=case.name(key), value=case.text(key))
        yield _Match((key, ParameterKey.UART_SETTINGS), text, {key: case.default(key)})


def _half_rate(case: _Case) -> Iterator[_Match]:
    line = case.line
    if line is None or (real := case.real(line.baud)) == line.baud:
        return
    text = tr(
        "A {board} set to {baud} baud really runs at {real} baud; firmware {fixed_in} corrects "
        "this. Programs must use {real} baud."
    ).format(
        board=tr("{0} with firmware {1}").format(
            case.settings.product.name, case.settings.firmware
        ),
        baud=line.baud,
        real=real,
        fixed_in=device_table().half_rate_fixed_in,
    )
    yield _line_match(text, replace(line, baud=real) if real in baud_rates() else None)


def _rate_the_port_lacks(case: _Case) -> Iterator[_Match]:
    line, rates, used = case.line, case.context.port_rates, case.context.active_line
    if line is None or rates is None:
        return
    real = case.real(line.baud)
    if real in rates or (used is not None and used.baud == real):
        return
    known = [rate for rate in baud_rates() if rate in rates and case.real(rate) == rate]
    slower = [rate for rate in known if rate <= real]
    best = slower[-1] if slower else known[0] if known else None
    if used is not None and used.baud in baud_rates() and case.real(used.baud) == used.baud:
        best = used.baud
    text = tr(
        "This computer's serial port does not support {baud} baud: after the next power "
        "cycle, the computer could no longer reach the board."
    ).format(baud=real)
    yield _line_match(text, None if best is None else replace(line, baud=best))


def _line_will_change(case: _Case) -> Iterator[_Match]:
    line, used = case.line, case.context.active_line
    if line is None or used is None:
        return
    real = replace(line, baud=case.real(line.baud))
    if real != used:
        text = tr(
            "After the next power cycle, the line settings of the board will be {new} "
            "instead of {now}. Programs that use the board must then use the new line "
            "settings."
        )
        yield _line_match(text.format(new=real.text(), now=used.text()))


def _line_match(text: str, proposed: LineSettings | None = None) -> _Match:
    key = ParameterKey.UART_SETTINGS
    return _Match((key,), text, {} if proposed is None else {key: proposed.to_wire()})


RULES: Mapping[str, Callable[[_Case], Iterator[_Match]]] = {
    "no_serial_timeout": _no_timeout,
    "timeout_without_shutdown": _timeout_without_shutdown,
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
