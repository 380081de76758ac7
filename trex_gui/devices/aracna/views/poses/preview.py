"""What would be played, and what is to be said of it before."""

from collections import defaultdict
from collections.abc import Sequence as Many
from dataclasses import dataclass, field

from PySide6.QtCore import QCoreApplication

from trex_gui.core.errors import BadRequest
from trex_gui.devices.aracna.poses.gaits import Gait
from trex_gui.devices.aracna.poses.playing import Cropped, blend_in, blend_out, crops_of, steps_of
from trex_gui.devices.aracna.poses.pose import Pose
from trex_gui.devices.aracna.poses.project import missing_poses
from trex_gui.devices.aracna.poses.sequence import Sequence
from trex_gui.devices.aracna.poses.travel import Late, Present, estimated_seconds, late_motors
from trex_gui.devices.aracna.protocol.joints import Limits
from trex_gui.devices.aracna.session.messages import Play
from trex_gui.devices.aracna.views.poses.play_bar import PlayChoices

_LONG = 60.0


@dataclass(frozen=True, slots=True)
class Preview:
    """One look at a sequence or gait.

    Attributes:
        play: what would be asked of the robot; `None` where it cannot be played.
        text: how long it is, what is cropped and too fast, or why it cannot be played.
        alarming: whether the text says that something is not as written.
        notes: what to say of steps, by their index.
    """

    play: Play | None = None
    text: str = ""
    alarming: bool = False
    notes: dict[int, str] = field(default_factory=dict)


def preview(
    played: Sequence | Gait | None,
    poses: Many[Pose],
    limits: Many[Limits],
    present: Present,
    choices: PlayChoices,
) -> Preview:
    """Look at what would be played so."""
    if played is None:
        return Preview(text=tr("Choose a sequence or a gait to play it."))
    try:
        steps = steps_of(played, poses, limits)
    except BadRequest as error:
        notes = {}
        if isinstance(played, Sequence):
            missing = missing_poses(played, poses)
            notes = {
                number: tr("not defined")
                for number, step in enumerate(played.steps)
                if step.pose_name in missing
            }
        return Preview(text=tr("Cannot be played: {0}.").format(error), alarming=True, notes=notes)
    play = Play(
        0,
        steps,
        choices.rounds,
        blend_in(played, poses, limits, present) if choices.blend_in else (),
        blend_out(limits, poses) if choices.blend_out else (),
        choices.time_scale,
    )
    scaled = steps_of(played, poses, limits, choices.time_scale)
    start = play.blend_in[-1].goals if play.blend_in else present
    late = late_motors(scaled, start, again=choices.rounds != 1)
    crops = crops_of(played, poses, limits)
    notes = _notes(late, crops)
    first = estimated_seconds(scaled, start)
    sentences = [_length(len(steps), first, choices.rounds)]
    if crops:
        sentences.append(tr("Positions outside the limits are cropped."))
    if late:
        sentences.append(tr("Some motors cannot make it in time."))
    return Preview(play, " ".join(sentences), bool(late), notes)


def _notes(late: Many[Late], crops: Many[Cropped]) -> dict[int, str]:
    """Return what to say of steps, what is too fast first."""
    found: dict[int, list[str]] = defaultdict(list)
    for step in sorted({one.step for one in late}):
        slow = [one for one in late if one.step == step]
        words = tr("needs {0:.2f} s: motor {1}")
        motors = ", ".join(str(one.motor) for one in slow)
        found[step].append(words.format(max(one.needed for one in slow), motors))
    for step in sorted({one.step for one in crops}):
        motors = ", ".join(str(one.motor) for one in crops if one.step == step)
        found[step].append(tr("limited: motor {0}").format(motors))
    return {step: "; ".join(words) for step, words in found.items()}


def _length(steps: int, seconds: float, rounds: int) -> str:
    count = tr("1 step") if steps == 1 else tr("{0} steps").format(steps)
    if rounds == 1:
        return tr("{0}, {1}.").format(count, _duration(seconds))
    if rounds == 0:
        return tr("{0}, {1} a round, until it is ended.").format(count, _duration(seconds))
    whole = _duration(seconds * rounds)
    return tr("{0}, {1} a round, {2} in all.").format(count, _duration(seconds), whole)


def _duration(seconds: float) -> str:
    if seconds < _LONG:
        return tr("{0:.1f} s").format(seconds)
    minutes, rest = divmod(round(seconds), 60)
    return tr("{0} min {1:02d} s").format(minutes, rest)


def tr(text: str) -> str:
    """Translate a text of this file."""
    return QCoreApplication.translate("preview", text)
