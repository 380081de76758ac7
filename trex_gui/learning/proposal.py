"""The calibration that fits what was measured, and why it is what it is."""

from dataclasses import dataclass
from math import ceil

from trex_gui.learning.neutral import Neutral, swing_text
from trex_gui.learning.problems import Kind, Problem, has_fatal
from trex_gui.learning.travel import Task, Travel, Way
from trex_gui.protocol.calibration import Calibration
from trex_gui.protocol.flags import InputSource

INSIDE = 0.01
"""Share of the way by which an end is put inside what was reached."""

INSIDE_DEVIATIONS = 3.0
"""Standard deviations of the noise that are added to it."""

_IDLE_END = 2
"""Deadbands beyond rest at which an end is put that a channel never goes to."""


@dataclass(frozen=True, slots=True)
class Proposal:
    """What to store for one channel.

    Attributes:
        calibration: `None` when nothing can be learned; `problems` say why.
        reversed_: whether the channel should be reversed, and
        reversed_reason: why; empty when it stays as it is.
        reasons: where the values come from.
    """

    channel: int
    source: InputSource
    calibration: Calibration | None
    reversed_: bool
    reversed_reason: str
    reasons: tuple[str, ...]
    problems: tuple[Problem, ...]


def propose(channel: int, neutral: Neutral, travel: Travel, *, reversed_now: bool) -> Proposal:
    """Make a calibration of what was measured; the board takes every one that is made."""
    problems = neutral.problems + travel.problems
    reversed_, why = _reversal(travel, reversed_now=reversed_now)
    if has_fatal(problems):
        return Proposal(channel, neutral.source, None, reversed_now, "", (), problems)
    down, up = _inside(neutral, travel, Way.DOWN), _inside(neutral, travel, Way.UP)
    highest = max(neutral.source.highest_count, neutral.value)
    wanted = Calibration(
        minimum=max(0, neutral.value - down),
        neutral=neutral.value,
        maximum=min(highest, neutral.value + up),
        deadband=neutral.deadband,
    )
    if refused := wanted.problem():
        words = f"The board would not take what was measured: {refused}."
        problems += (Problem(Kind.REFUSED, words),)
        return Proposal(channel, neutral.source, None, reversed_now, "", (), problems)
    reasons = (_ends_reason(neutral, travel), neutral.deadband_reason)
    return Proposal(channel, neutral.source, wanted, reversed_, why, reasons, problems)


def margin(length: int, neutral: Neutral) -> int:
    """Return how far inside an end that was reached the proposed one lies, in counts."""
    return ceil(INSIDE * length + INSIDE_DEVIATIONS * neutral.deviation)


def _inside(neutral: Neutral, travel: Travel, way: Way) -> int:
    """Return how far from rest the end is put that way."""
    length = travel.length(way)
    if travel.reached(way):
        return length - margin(length, neutral)
    return _IDLE_END * travel.deadband  # a switch or a throttle that rests at this end


def _ends_reason(neutral: Neutral, travel: Travel) -> str:
    shares = [margin(travel.length(way), neutral) for way in Way if travel.reached(way)]
    inside = swing_text(max(shares, default=0), neutral.source).removeprefix("±")
    text = (
        f"The ends lie up to {inside} inside what was reached (1 % of the way and three times the "
        "noise), so that full output is surely reached."
    )
    if len(shares) < len(Way):
        text += " The end that it never goes to is put two deadbands beyond its rest."
    return text


def _reversal(travel: Travel, *, reversed_now: bool) -> tuple[bool, str]:
    """Return whether the channel should be reversed, and why where that is a change.

    Inferred: a positive output is forward; a switch is active below its threshold, a reversed
    one above it. A one-way motor takes no notice.
    """
    match travel.task:
        case Task.STICK if travel.first is not None:
            wanted = travel.first is Way.DOWN
            way = "fell" if wanted else "rose"
            words = f"The value {way} when the stick went forward or right first"
        case Task.SWITCH if travel.reached(Way.UP) != travel.reached(Way.DOWN):
            wanted = travel.reached(Way.UP)
            where = "above" if wanted else "below"
            words = f"The other position lies {where} the one at rest, which is to be off"
        case _:
            return reversed_now, ""
    if wanted == reversed_now:
        return wanted, ""
    return wanted, f"{words}: {'reversed' if wanted else 'not reversed'} is suggested."


def check(wanted: Calibration, neutral: Neutral | None) -> tuple[Problem, ...]:
    """Say what is wrong with values that a person has chosen."""
    if refused := wanted.problem():
        return (Problem(Kind.REFUSED, f"The board would not take this: {refused}."),)
    if neutral is not None and wanted.deadband < neutral.noise / 2:
        source = neutral.source
        text = (
            f"At rest the input wavers by {neutral.noise_text}, more than the deadband "
            f"({source.text(wanted.deadband)}): the motor would creep."
        )
        return (Problem(Kind.NOISE, text, fatal=False),)
    return ()
