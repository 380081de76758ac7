"""What is done to goals before they are sent: kept within limits, and begun slowly."""

from collections.abc import Sequence
from dataclasses import replace

from PySide6.QtCore import QCoreApplication

from trex_gui.devices.aracna.model.limits import JointLimits
from trex_gui.devices.aracna.model.speeds import FIRST_SPEED
from trex_gui.devices.aracna.protocol.units import HIGHEST, travel_seconds
from trex_gui.devices.aracna.session.messages import Play, Step


def tr(text: str) -> str:
    """Translate a text of this file."""
    return QCoreApplication.translate("Cropping", text)


def cropped_goals_text(goals: Sequence[int], cropped: Sequence[int]) -> str:
    """Say which goals were changed to stay within the limits."""
    pairs = enumerate(zip(goals, cropped, strict=True))
    changes = [
        tr("motor {0} to {1} instead of {2}").format(motor, sent, goal)
        for motor, (goal, sent) in pairs
        if goal != sent
    ]
    return tr("Kept within the limits of the joints: {0}.").format(", ".join(changes))


def within_limits(play: Play, limits: JointLimits) -> tuple[Play, int]:
    """Return what is played with every goal within the limits, and how many steps that changed."""

    def within(steps: tuple[Step, ...]) -> tuple[Step, ...]:
        return tuple(replace(step, goals=limits.crop(step.goals)) for step in steps)

    before = (*play.blend_in, *play.steps, *play.blend_out)
    kept = replace(
        play,
        blend_in=within(play.blend_in),
        steps=within(play.steps),
        blend_out=within(play.blend_out),
    )
    after = (*kept.blend_in, *kept.steps, *kept.blend_out)
    pairs = zip(before, after, strict=True)
    return kept, sum(old.goals != new.goals for old, new in pairs)


def slowly_first(play: Play) -> Play:
    """Return what is played after a slow way to its beginning from wherever the motors are.

    The time is that of the whole travel at the first speed, whatever the time scale.
    """
    first = (*play.blend_in, *play.steps)[0]
    seconds = travel_seconds(HIGHEST, FIRST_SPEED) / play.time_scale
    slow = Step(first.goals, seconds, tr("slowly to the beginning"))
    return replace(play, blend_in=(slow, *play.blend_in))
