"""The sentences of findings about settings files and settings, filled with their fields."""

from collections.abc import Mapping, Sequence

READER_MESSAGES: Mapping[str, str] = {
    "unterminated": "the last line has no end; was the file cut short?",
    "more_errors": "{count} more errors are not listed",
    "key_is_no_name": "a name belongs before the colon, not a list or a group",
    "repeated": "was given in line {first} already",
    "repeated_in_group": "{name} was given in line {first} already",
    "product_missing": "the first setting is {wanted}; this file has none",
    "product_not_first": "must be the first setting of the file",
    "product_misspelt": "{models}, not {given}; did you mean {model}?",
    "product_unknown": "{models}, not {given}; these are not settings of a TReX",
    "firmware_invalid": "a version such as {newest}, not {given}",
    "firmware_unknown": "versions {oldest} to {newest} are known, {given} is not",
    "not_a_setting": "is a command to the board, not a setting",
    "value_invalid": "{allowed}, not {given}{hint}",
    "needs_firmware": "a {product} has it from firmware {since} on, these are for {firmware}",
    "key_unknown": "there is no such setting{guess}",
    "calibration_layout": "is written {layout}, not {given}",
    "field_unknown": "a calibration has no {field!r}{guess}",
    "field_invalid": "{field} is 0 to {highest}, not {given}",
    "field_missing": "{fields} is missing",
    "fields_missing": "{fields} are missing",
    "calibration_invalid": "{problem}",
    "parameter_missing": "1 of {total} parameters is missing: {names}",
    "parameters_missing": "{count} of {total} parameters are missing: {names}",
}
"""By the code of a finding."""

LINT_MESSAGES: Mapping[str, str] = {
    "no_serial_timeout": (
        "{name} is off while a computer drives the motors: if the cable or the computer fails, "
        "the motors keep running at their last setpoint."
    ),
    "limit_in_joint_mode": (
        "No effect in joint mode: {limits}. The board measures no current then, so the motor is "
        "not protected."
    ),
    "limit_without_gain": (
        "{limit} is {value}, but its proportionality constant P, how strongly the limiter reacts, "
        "is 0. Inferred: the behaviour of the board is not documented, and the limit may have no "
        "effect."
    ),
    "limit_without_ramp": (
        "{limit} is {value} and {ramp} is 0, which means at once. Inferred: as soon as the "
        "current falls below the limit, the motor jumps back to its full target speed, so it may "
        "run in jerks."
    ),
    "pwm_above_rating": (
        "The PWM of motor {motor} runs at {now} (inferred), but the motor driver of a {product} "
        "is rated for {highest}; above that it gets hot."
    ),
    "pwm_above_rating.better": (
        "The PWM of motor {motor} runs at {now} (inferred), but the motor driver of a {product} "
        "is rated for {highest}; above that it gets hot. The prescaler {prescaler} gives {gives}."
    ),
    "required_but_ignored": (
        "Both required and ignored: {channels}. The signal moves nothing, but without it the "
        "motors may not run in RC mode (inferred)."
    ),
    "deadband_over_travel": (
        "The deadband of {channel} reaches from neutral to its {ends}: there is nothing between "
        "standstill and full speed on that side."
    ),
    "end_out_of_reach.minimum": (
        "The minimum of {channel}, {count}, is below {limit}, the lowest count that the board "
        "measures: full speed on that side is never reached."
    ),
    "end_out_of_reach.maximum": (
        "The maximum of {channel}, {count}, is above {limit}, the highest count that the board "
        "measures: full speed on that side is never reached."
    ),
    "polynomial_without_crc": (
        "{name} is {value} instead of the default {default}, but CRC-7 is not switched on: no "
        "packet is checked with it."
    ),
    "crc_that_checks_nothing": (
        "With {value} as {name} the checksum of every packet is 0, so CRC-7 finds no damage at all."
    ),
    "half_rate": (
        "A {board} set to {baud} baud really runs at {real} baud; firmware {fixed_in} corrects "
        "this. Programs must use {real} baud."
    ),
    "rate_the_port_lacks": (
        "This computer's serial port does not support {baud} baud: after the next power cycle it "
        "could not reach the board any more."
    ),
    "line_will_change": (
        "After the next power cycle the line settings of the board are {new}; now they are {now}. "
        "Change the programs that use the board then."
    ),
}
"""By rule, or by rule and variant."""


def proposal_text(values: Sequence[tuple[str, str]]) -> str:
    """Return a change as a request, such as `Set Serial Timeout to 0.5 s`; empty for none.

    Args:
        values: names of parameters with their new values in physical units.
    """
    names: dict[str, list[str]] = {}
    for name, value in values:
        names.setdefault(value, []).append(name)
    parts = [f"{joined(equal)} to {value}" for value, equal in names.items()]
    return f"Set {joined(parts)}" if parts else ""


def joined(words: Sequence[str]) -> str:
    """Return `a`, `a and b` or `a, b and c`."""
    *first, last = words
    return f"{', '.join(first)} and {last}" if first else last
