"""Sentences about a channel and its calibration."""

from trex_gui.core.errors import StudioError
from trex_gui.core.texts import signed_text
from trex_gui.core.translation import Number, tr, tr_noop, with_decimal_point
from trex_gui.devices.trex.calibration.channel_curve import ChannelCurve
from trex_gui.devices.trex.protocol.calibration import Calibration
from trex_gui.devices.trex.protocol.errors import Rejected, ResultCode
from trex_gui.devices.trex.protocol.flags import InputSource, Mode
from trex_gui.devices.trex.settings.board_records import Provenance
from trex_gui.ui.translations import error_sentence, local_time
from trex_gui.ui.units import units

CHANNEL_NAMES = {  # functions of channels in RC and analog mode
    1: tr_noop("Motor 1"),
    2: tr_noop("Motor 2"),
    3: tr_noop("Auxiliary"),
    4: tr_noop("Flip"),
    5: tr_noop("Override"),
}

SOURCE_NAMES = {
    InputSource.RC: tr_noop("RC pulses"),
    InputSource.ANALOG: tr_noop("analog voltages"),
}

_TASKS = {
    1: tr_noop("drives motor 1, or steers when the mix jumper is on"),
    2: tr_noop("drives motor 2, or drives forward and back when the mix jumper is on"),
    3: tr_noop("drives the auxiliary motor, which turns one way only"),
    4: tr_noop("is the flip switch: motors 1 and 2 are swapped and reversed"),
    5: tr_noop("is the override switch: serial commands control the motors"),
}
_MIXED_TASKS = {
    (1, False): tr_noop("drives motor 1 (the mix jumper is off)"),
    (1, True): tr_noop("steers with both motors (the mix jumper is on)"),
    (2, False): tr_noop("drives motor 2 (the mix jumper is off)"),
    (2, True): tr_noop("drives both motors forward and back (the mix jumper is on)"),
}
_JOINT_TASKS = {
    1: tr_noop("drives the single motor that both drivers power (joint mode, no mixing)"),
    2: tr_noop("has no motor: in joint mode both drivers power motor 1"),
}
_SWITCHES = (4, 5)


def input_text(source: InputSource, count: int) -> str:
    """Return the count and its physical value: `1500 µs (3750)`."""
    first, second = units().ordered(source.text(count), str(count))
    return f"{first} ({second})"


def live_text(source: InputSource, count: int | None, curve: ChannelCurve | None) -> str:
    """Return a raw count and the output that it produces."""
    if count is None or curve is None:
        return tr("no signal") if count is None else input_text(source, count)
    output = signed_text(curve.output(count))
    return tr("{0}, output {1}").format(input_text(source, count), output)


def function_text(
    channel: int,
    mode: Mode,
    curve: ChannelCurve | None,
    source: InputSource,
    *,
    joint: bool,
    overridden: bool = False,
    mixed: bool | None = None,
) -> str:
    """Return a sentence about the function of a channel.

    `curve` is for `source`. `mixed` is true if the mix jumper is on. Both are `None` if unknown.
    `overridden` is true if serial commands control a board in RC or analog mode.
    """
    if curve is not None and curve.ignored:
        task = tr("is ignored: it is held at neutral, whatever its input")
        if channel in _SWITCHES:
            task = tr("is ignored: it stays off, whatever its input")
    else:
        task = _TASKS[channel]
        if joint:
            task = _JOINT_TASKS.get(channel, task)
        elif mixed is not None:
            task = _MIXED_TASKS.get((channel, mixed), task)
        task = tr(task)
        if curve is not None and (threshold := curve.threshold(channel)) is not None:
            below, above = tr("below about {0} (inferred)"), tr("above about {0} (inferred)")
            where = (above if curve.reversed_ else below).format(source.text(threshold))
            task = tr("{0} while the input is {1}").format(task, where)
        elif curve is not None and curve.reversed_:
            task = tr("{0}; it is reversed").format(task)
    if mode.is_serial:
        text = tr("In RC and analog mode it {1}.")
    elif overridden and channel not in _SWITCHES:
        text = tr("Has no effect now: serial commands override it. Otherwise it {1}.")
    elif overridden and channel == 5:
        text = tr("On now. It {1}.")
    else:
        text = tr("Channel {0} {1}.")
    return text.format(channel, task)


def source_instructions(source: InputSource, mode: Mode) -> str:
    if mode.is_serial:
        text = tr(
            "The board now reads {0}, so it shows and accepts only the calibrations of this "
            "source. To see the calibrations for {1}, set Channel Input Source, apply, and "
            "switch the board off and on."
        )
    else:
        text = tr(
            "The board now reads {0}, so it shows and accepts only the calibrations of this "
            "source. To see these calibrations, switch the board off, set the mode jumper to "
            "{2}, and switch the board on."
        )
    return text.format(tr(SOURCE_NAMES[mode.source]), tr(SOURCE_NAMES[source]), source.word)


def provenance_text(provenance: Provenance) -> str:
    """Return the origin and time of a calibration, such as `read 2026-03-14 15:09`."""
    text = tr("applied {0}") if provenance.is_applied else tr("read {0}")
    return text.format(local_time(provenance.time))


def write_failure(error: StudioError) -> str:
    result = error.result if isinstance(error, Rejected) else None
    if result is ResultCode.BAD_VALUE:
        return tr(
            "{0} The board accepts a calibration only if minimum is not above neutral, "
            "neutral is not above maximum, and minimum and maximum differ."
        ).format(error_sentence(error))
    if result is ResultCode.NOT_SERIAL_MODE:
        return tr("{0} Your edits are kept.").format(error_sentence(error))
    return error_sentence(error)


def wrong_order(calibration: Calibration, source: InputSource) -> str:
    """Return the reason why the board would reject a calibration, or an empty string."""
    problem = calibration.problem(source.text)
    return tr("The board would reject this: {0}.").format(problem) if problem else ""


def input_range_text(source: InputSource) -> str:
    text = (
        tr("Pulses range from {0} to {1}.")
        if source is InputSource.RC
        else tr("Voltages range from {0} to {1}.")
    )
    return text.format(source.text(source.lowest_count), source.text(source.highest_count))


def unreachable_warning(calibration: Calibration, source: InputSource) -> str:
    """Return sentences about values that no valid input reaches. May be empty.

    Ref: Pololu TReX User's Guide 4.c: a pulse that is shorter than 0.5 ms or longer than 2.5 ms
    is an error.
    """
    lowest, highest = source.lowest_count, source.highest_count
    range_text = input_range_text(source)
    if not lowest <= calibration.neutral <= highest:
        text = tr("Neutral ({0}) is outside the input range. {1} No stick position gives 0.")
        return text.format(_exact_text(calibration.neutral, source), range_text)
    ends = {tr("Minimum"): calibration.minimum, tr("Maximum"): calibration.maximum}
    text = tr(
        "{0} ({1}) is outside the input range. {2} The output never reaches its full value "
        "on that side."
    )
    return " ".join(
        text.format(end, _exact_text(count, source), range_text)
        for end, count in ends.items()
        if not lowest <= count <= highest
    )


def _exact_text(count: int, source: InputSource) -> str:
    if source is InputSource.RC:
        number = f"{source.physical(count):.1f}".removesuffix(".0")
        return f"{with_decimal_point(number)} µs"
    return f"{Number(source.physical(count)):.3f} V"


def calibration_warning(calibration: Calibration, source: InputSource) -> str:
    """Return a warning about an invalid or useless calibration, or an empty string."""
    if text := wrong_order(calibration, source) or unreachable_warning(calibration, source):
        return text
    return deadband_problem(calibration, source, "minimum", "maximum")


def deadband_problem(calibration: Calibration, source: InputSource, *ends: str) -> str:
    """Return a warning if the deadband reaches one of `ends` (`minimum`, `maximum`)."""
    travel = {end: abs(getattr(calibration, end) - calibration.neutral) for end in ends}
    reached = [tr(end) for end in ends if travel[end] <= calibration.deadband]
    if not reached:
        return ""
    return tr(
        "The deadband ({0} to each side of neutral) reaches {1}: no output between 0 and "
        "full is possible."
    ).format(source.text(calibration.deadband), tr(" and ").join(reached))
