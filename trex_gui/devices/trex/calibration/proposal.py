"""The calibration that fits what was measured, and why it is what it is."""

from dataclasses import dataclass
from math import ceil

from trex_gui.devices.trex.calibration.neutral import Neutral, swing_text
from trex_gui.devices.trex.calibration.problems import Problem, ProblemKind, has_fatal
from trex_gui.devices.trex.calibration.travel import Task, Travel, Way
from trex_gui.devices.trex.protocol.calibration import HIGHEST_CODED, Calibration
from trex_gui.devices.trex.protocol.flags import InputSource

INSIDE = 0.01
"""Share of the way by which an end is put inside what was reached."""

INSIDE_DEVIATIONS = 3.0
"""Standard deviations of the noise that are added to it."""

_IDLE_LEAST = 1 / 3
"""Share of the way to the other end that an end is away from rest to which a channel never goes."""

WHY_THESE_VALUES = (
    "The ends lie 1 % of the way and three times the noise inside what was reached, so that full "
    "output is surely reached. The deadband covers the noise at rest, but not less "
    "than {0}, since a stick does not come back to the very same place each time."
)
"""What the values of all channels have in common; the least deadband is to be filled in."""


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
    wanted = Calibration(
        minimum=max(0, neutral.value - down),
        neutral=neutral.value,
        maximum=min(HIGHEST_CODED, neutral.value + up),
        deadband=neutral.deadband,
    )
    if refused := wanted.problem():
        problems += (Problem(ProblemKind.REFUSED, "MEASURED", (refused,)),)
        return Proposal(channel, neutral.source, None, reversed_now, "", (), problems)
    reasons = tuple(filter(None, (_ends_reason(neutral, travel), neutral.deadband_reason)))
    return Proposal(channel, neutral.source, wanted, reversed_, why, reasons, problems)


def margin(length: int, neutral: Neutral) -> int:
    """Return how far inside an end that was reached the proposed one lies, in counts."""
    return ceil(INSIDE * length + INSIDE_DEVIATIONS * neutral.deviation)


def _inside(neutral: Neutral, travel: Travel, way: Way) -> int:
    """Return how far from rest the end is put that way."""
    length = travel.length(way)
    if travel.reached(way):
        return length - margin(length, neutral)
    return _to_idle_end(neutral, travel, way)


def _to_idle_end(neutral: Neutral, travel: Travel, way: Way) -> int:
    """Return how far from its rest an end is put at which a switch or a throttle rests.

    As far as the input can be: the auxiliary motor turns for both signs alike, and a trim that
    is moved must not be a command for full speed.
    """
    source, other = neutral.source, Way.DOWN if way is Way.UP else Way.UP
    if way is Way.UP:
        limit = source.highest_count - neutral.value
    else:
        limit = neutral.value - source.lowest_count
    return max(limit, ceil(_IDLE_LEAST * travel.length(other)))


def _ends_reason(neutral: Neutral, travel: Travel) -> str:
    margins = [margin(travel.length(way), neutral) for way in Way if travel.reached(way)]
    inside = swing_text(max(margins, default=0), neutral.source).removeprefix("±")
    text = f"What was reached lies up to {inside} further out than these ends."
    if (idle := travel.idle) is not None:
        where, name = ("above", "Maximum") if idle is Way.UP else ("below", "Minimum")
        text += f" It never goes {where} its rest: {name} is put as far out as the input can be."
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
