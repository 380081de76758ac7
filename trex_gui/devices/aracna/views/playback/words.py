"""What a recorded robot did at one time, in sentences."""

from PySide6.QtCore import QCoreApplication

from trex_gui.devices.aracna.model.recorded import Moment
from trex_gui.devices.aracna.session.messages import StepBegun


def tr(text: str) -> str:
    """Translate a text of this file."""
    return QCoreApplication.translate("AracnaRecorded", text)


def doing_text(moment: Moment, time: float) -> tuple[str, bool]:
    """Say what the robot did at a time of the session's clock, and whether that is alarming."""
    known = moment.known
    if known.stuck is not None:
        return _stuck_text(known.stuck.motor), True
    if known.moving is not None:
        begun, expected = known.moving.time, known.moving.expected
        text = tr("Moving for {0:.1f} s of about {1:.1f} s; motor {2} is waited for.").format(
            max(time - begun, 0.0), expected, known.waited_for
        )
        return _with_step(text, moment.step), False
    if known.unsure:
        return tr("Not known: what was sent last goes on to its goal."), True
    if known.is_lost:
        return tr("The answer was lost (or no motor answered): positions are not known."), True
    if all(place is None for place in known.present):
        return tr("Where the motors were was not known yet."), False
    return _with_step(tr("At rest."), moment.step), False


def _stuck_text(motor: int | None) -> str:
    if motor is None:
        return tr("The robot did not answer.")
    return tr("Stuck: the robot waited for motor {0} and listened to nothing.").format(motor)


def _with_step(text: str, step: StepBegun | None) -> str:
    if step is None:
        return text
    parts = {"in": tr("on the way in"), "out": tr("on the way out")}
    where = parts.get(step.part) or tr("step {0}, round {1}").format(step.index + 1, step.round + 1)
    return tr("{0} Playing: {1}.").format(text, where)
