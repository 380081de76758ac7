"""Sentences about one channel: what it does, and why its calibration may not work."""

from trex_gui.core.errors import StudioError, sentence
from trex_gui.devices.trex.protocol.calibration import Calibration
from trex_gui.devices.trex.protocol.errors import Rejected, ResultCode
from trex_gui.devices.trex.protocol.flags import InputSource, Mode

CHANNEL_NAMES = {1: "Motor 1", 2: "Motor 2", 3: "Auxiliary", 4: "Flip", 5: "Override"}
"""What each channel does in RC and analog mode, as short as can be."""

SOURCE_NAMES = {InputSource.RC: "RC pulses", InputSource.ANALOG: "analog voltages"}

_TASKS = {
    1: "drives motor 1; with the mix jumper on it steers",
    2: "drives motor 2; with the mix jumper on it drives forward and back",
    3: "drives the auxiliary motor, which turns one way only: both sides of neutral speed it up",
    4: "is the flip switch: motors 1 and 2 change places and directions",
    5: "is the override switch: serial commands control the motors",
}
_MIXED_TASKS = {
    1: ("drives motor 1 (the mix jumper is off)", "steers (the mix jumper is on)"),
    2: ("drives motor 2 (the mix jumper is off)", "drives forward and back (the mix jumper is on)"),
}
_JOINT_TASKS = {
    1: "drives the one motor that both drivers work for (joint mode, no mixing)",
    2: "does nothing in joint mode",
}


def what_it_does(
    channel: int,
    mode: Mode,
    *,
    joint: bool,
    ignored: bool,
    switches_at: str = "",
    mixed: bool | None = None,
) -> str:
    """Say what a channel does now; `switches_at` is where a switch does, such as `below 1.2 V`.

    `mixed`: whether the mix jumper was seen to be on; `None` when that is not known.
    """
    task = _TASKS[channel]
    if mixed is not None and channel in _MIXED_TASKS:
        task = _MIXED_TASKS[channel][mixed]
    if joint:
        task = _JOINT_TASKS.get(channel, task)
    if ignored:
        held = "off" if channel in {4, 5} else "at neutral"
        if mode.is_serial:
            return f"Channel {channel} is ignored in RC and analog mode: it is held {held}."
        return f"Channel {channel} is ignored: it is held {held}, whatever comes in."
    if switches_at:
        task += f" while the input is {switches_at}"
    if mode.is_serial:
        return f"Serial mode: only measured. In RC and analog mode channel {channel} {task}."
    return f"Channel {channel} {task}."


def learned_words(learned: bool) -> str:
    """Say what the board's learned flag (0x95) of a channel means."""
    if learned:
        return "Learned: the board has a calibration of its own for it."
    return "Not learned: it has the factory default calibration."


def way_to(source: InputSource, mode: Mode) -> str:
    """Say how a board in this mode comes to read the inputs as `source`."""
    name = SOURCE_NAMES[source]
    if mode.is_serial:
        return (
            f"The board reads {SOURCE_NAMES[mode.source]} now, and only shows and takes the "
            f"calibrations of those. To see these, let it read {name}: set Channel Input Source, "
            "apply, and switch the board off and on."
        )
    position = "RC" if source is InputSource.RC else "analog"
    return (
        f"The board reads {SOURCE_NAMES[mode.source]} now, and only shows and takes the "
        f"calibrations of those. To see these: switch it off, put the mode jumper to {position}, "
        "switch it on."
    )


def why_not_stored(error: StudioError) -> str:
    """Explain why a calibration was not stored; the board's own codes in full."""
    words = sentence(error)
    if isinstance(error, Rejected) and error.result is ResultCode.BAD_VALUE:
        words += (
            " It takes a calibration only when minimum is not above neutral, neutral is not "
            "above maximum, and minimum and maximum differ."
        )
    if isinstance(error, Rejected) and error.result is ResultCode.NOT_SERIAL_MODE:
        words += " The edits are kept meanwhile."
    return words


def wrong_order(calibration: Calibration, source: InputSource) -> str:
    """Say why the board would reject a calibration, in units; empty if it would not."""
    lowest, middle, highest = (
        source.text(count)
        for count in (calibration.minimum, calibration.neutral, calibration.maximum)
    )
    if calibration.minimum > calibration.neutral:
        return f"Minimum ({lowest}) cannot be above neutral ({middle})."
    if calibration.neutral > calibration.maximum:
        return f"Maximum ({highest}) cannot be below neutral ({middle})."
    if calibration.minimum == calibration.maximum:
        return f"Minimum and maximum cannot both be {lowest}."
    problem = calibration.problem()
    return f"The board would reject this: {problem}." if problem else ""


def beyond_input(calibration: Calibration, source: InputSource) -> str:
    """Say what of a calibration no valid input can be; empty when there is nothing.

    Ref: Pololu TReX User's Guide 4.c: a pulse that is shorter than 0.5 ms or longer than 2.5 ms
    is an error.
    """
    lowest, highest = source.lowest_count, source.highest_count
    what = "a pulse" if source is InputSource.RC else "a voltage"
    limits = f"{what} is {source.text(lowest)} to {source.text(highest)}."
    if not lowest <= calibration.neutral <= highest:
        return (
            f"Neutral ({_exactly(calibration.neutral, source)}) is beyond what the input can be: "
            f"{limits} No position of the stick gives 0 as it should."
        )
    ends = []
    if calibration.minimum < lowest:
        ends.append(f"Minimum ({_exactly(calibration.minimum, source)})")
    if calibration.maximum > highest:
        ends.append(f"{'m' if ends else 'M'}aximum ({_exactly(calibration.maximum, source)})")
    if not ends:
        return ""
    verb, side = ("are", "those sides") if len(ends) > 1 else ("is", "that side")
    return (
        f"{' and '.join(ends)} {verb} beyond what the input can be: {limits} Full output on "
        f"{side} is never reached."
    )


def _exactly(count: int, source: InputSource) -> str:
    """A count as text that differs from its neighbours."""
    if source is InputSource.RC:
        return f"{source.physical(count):.1f}".removesuffix(".0") + " µs"
    return f"{source.physical(count):.3f} V"


def concern(calibration: Calibration, source: InputSource) -> str:
    """Warn of a calibration that the board accepts but that makes no sense; may be empty."""
    if wrong := wrong_order(calibration, source):
        return wrong
    if beyond := beyond_input(calibration, source):
        return beyond
    sides = {
        "minimum": calibration.neutral - calibration.minimum,
        "maximum": calibration.maximum - calibration.neutral,
    }
    flat = [name for name, travel in sides.items() if travel <= calibration.deadband]
    if flat:
        reach = source.text(calibration.deadband)
        return (
            f"The deadband ({reach} to each side of neutral) reaches {' and '.join(flat)}: there "
            "is nothing between 0 and full output on that side."
        )
    return ""
