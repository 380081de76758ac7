"""Calibration from measurements, with reasons for its values."""

from dataclasses import dataclass
from math import ceil

from trex_gui.core.translation import tr, tr_noop
from trex_gui.devices.trex.calibration.neutral import Neutral, deadband_floor, swing_text
from trex_gui.devices.trex.calibration.problems import CalibrationProblem, ProblemKind, has_fatal
from trex_gui.devices.trex.calibration.travel import Task, Travel, Way
from trex_gui.devices.trex.protocol.calibration import HIGHEST_CODED, Calibration

_MARGIN = 0.01  # distance from the proposed to the measured end, as a fraction of the travel
_MARGIN_DEVIATIONS = 3.0  # standard deviations of the noise, added to `_MARGIN`
_MIN_IDLE = 1 / 3  # minimum distance of an unreached end, as a fraction of the reached travel

WHY_THESE_VALUES = tr_noop(
    "The proposed ends lie inside the measured ends by 1 % of the travel plus three times "
    "the noise, so that full output is reliably reached. The deadband covers the noise at "
    "rest, but is at least {0}, because a stick does not return to exactly the same position "
    "each time."
)
"""Reasons common to all channels. `{0}` is the smallest deadband."""


@dataclass(frozen=True, slots=True)
class Proposal:
    calibration: Calibration | None  # `None` if a problem is fatal
    reversed_: bool  # True if the channel should be reversed
    reversed_reason: str  # empty if the direction stays unchanged
    reasons: tuple[str, ...]  # explanations of the values
    problems: tuple[CalibrationProblem, ...]


def propose(neutral: Neutral, travel: Travel, *, reversed_now: bool) -> Proposal:
    problems = neutral.problems + travel.problems
    if has_fatal(problems):
        return Proposal(None, reversed_now, "", (), problems)
    calibration = Calibration(
        minimum=max(0, neutral.value - _distance(neutral, travel, Way.DOWN)),
        neutral=neutral.value,
        maximum=min(HIGHEST_CODED, neutral.value + _distance(neutral, travel, Way.UP)),
        deadband=neutral.deadband,
    )
    if problem := calibration.problem():
        problems += (CalibrationProblem(ProblemKind.REFUSED, "MEASURED", (problem,)),)
        return Proposal(None, reversed_now, "", (), problems)
    reasons = [_ends_reason(neutral, travel)]
    if neutral.noise > deadband_floor(neutral.source):
        text = tr("At rest the noise is {0}, so the deadband is twice this value.")
        reasons.append(text.format(neutral.noise_text))
    reversed_, reversed_reason = _reversal(travel, reversed_now=reversed_now)
    return Proposal(calibration, reversed_, reversed_reason, tuple(reasons), problems)


def _margin(length: int, neutral: Neutral) -> int:
    return ceil(_MARGIN * length + _MARGIN_DEVIATIONS * neutral.deviation)


def _distance(neutral: Neutral, travel: Travel, way: Way) -> int:
    """Return the distance of the proposed end from rest, in counts.

    If a switch or a throttle rests at an end, the limit of the input replaces this end. Otherwise,
    a changed trim could command full speed, since the auxiliary motor turns for either sign
    (inferred).
    """
    length = travel.length(way)
    if travel.has_reached(way):
        return length - _margin(length, neutral)
    source, other = neutral.source, Way(-way.value)
    limit = source.highest_count if way is Way.UP else source.lowest_count
    return max(abs(limit - neutral.value), ceil(_MIN_IDLE * travel.length(other)))


def _ends_reason(neutral: Neutral, travel: Travel) -> str:
    margins = [_margin(travel.length(way), neutral) for way in Way if travel.has_reached(way)]
    inside = swing_text(max(margins), neutral.source).removeprefix("±")
    text = tr("The measured ends are up to {0} beyond the proposed ends.").format(inside)
    if (idle := travel.idle) is not None:
        text += " " + (
            tr(
                "The signal never goes above its rest position, so maximum is set to the "
                "limit of the input."
            )
            if idle is Way.UP
            else tr(
                "The signal never goes below its rest position, so minimum is set to the "
                "limit of the input."
            )
        )
    return text


def _reversal(travel: Travel, *, reversed_now: bool) -> tuple[bool, str]:
    """Return whether the channel should be reversed, and the reason for a change.

    A switch is active below its threshold (User's Guide 4.a). Inferred: a positive output is
    forward, a reversed switch is active above its threshold, and reversal makes no difference to a
    one-way motor.
    """
    match travel.task:
        case Task.STICK if travel.first is not None:
            reversed_ = travel.first is Way.DOWN
            observation = (
                tr("The value fell when the stick first went forward or right")
                if reversed_
                else tr("The value rose when the stick first went forward or right")
            )
        case Task.SWITCH if travel.has_reached(Way.UP) != travel.has_reached(Way.DOWN):
            reversed_ = travel.has_reached(Way.UP)
            observation = (
                tr(
                    "The value is higher in the other position than at rest, where the switch "
                    "should be off"
                )
                if reversed_
                else tr(
                    "The value is lower in the other position than at rest, where the switch "
                    "should be off"
                )
            )
        case _:
            return reversed_now, ""
    if reversed_ == reversed_now:
        return reversed_, ""
    text = (
        tr("{0}, so the channel should be reversed.")
        if reversed_
        else tr("{0}, so the channel should not be reversed.")
    )
    return reversed_, text.format(observation)
