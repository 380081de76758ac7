"""A halt that nobody asked for, in words: this link has no stop, and none is claimed."""

from PySide6.QtCore import QCoreApplication

from trex_gui.devices.aracna.model.robot import Robot
from trex_gui.ui.devices.connection_state import ConnectionState
from trex_gui.ui.event_log import EventKind


def tr(text: str) -> str:
    """Translate a text of this file."""
    return QCoreApplication.translate("UnaskedHalt", text)


def halt_because(robot: Robot, reason: str) -> str:
    """Send nothing more, because of `reason`, a clause without a full stop.

    Return what that means, in sentences that begin with the reason; empty where no robot is
    connected and none was left with a motion that still runs. Times are the program's own
    reckoning, in seconds; see `ObservedRobot.remaining`.
    """
    left = robot.remaining()
    if robot.link is ConnectionState.DISCONNECTED:
        text = tr("{0}. No robot is connected; the motion goes on to its goal (about {1:.0f} s).")
        return text.format(reason, max(left, 1)) if left > 0 else ""
    at_rest = _is_at_rest(robot)
    robot.events.add(EventKind.NOTE, f"{reason}.")
    robot.halt()
    if left > 0:
        text = tr(
            "{0}. Nothing more is sent; the motion that runs goes on to its goal (about {1:.0f} s)."
        )
        return text.format(reason, max(left, 1))
    if at_rest:
        return tr("{0}. Nothing more is sent to the robot.").format(reason)
    return tr("{0}. Nothing more is sent; a motion that runs goes on to its goal.").format(reason)


def _is_at_rest(robot: Robot) -> bool:
    """Whether the robot has said that all its motors stand, and nothing was asked of it since."""
    known = robot.known
    goes_on = known.moving is not None or known.play is not None or robot.dragging
    return robot.link is ConnectionState.CONNECTED and not goes_on and not known.may_move_unseen
