"""Words and figures of the robot's page, the same in drawing, rows and reports."""

from PySide6.QtCore import QCoreApplication

from trex_gui.devices.aracna.model.robot import Robot
from trex_gui.devices.aracna.protocol.joints import JOINTS, Joint, JointKind, Side
from trex_gui.devices.aracna.protocol.units import degrees, degrees_per_second
from trex_gui.ui.devices.connection_state import ConnectionState


def tr(text: str) -> str:
    """Translate a text of this file."""
    return QCoreApplication.translate("AracnaWords", text)


def joint_of(motor: int) -> Joint | None:
    """Return the joint of a motor; `None` of one that the published robot does not have."""
    return JOINTS[motor] if motor < len(JOINTS) else None


def joint_text(motor: int) -> str:
    """Name a motor and its joint: `0 inner`."""
    joint = joint_of(motor)
    if joint is None:
        return str(motor)
    kind = tr("inner") if joint.kind is JointKind.INNER else tr("outer")
    return f"{motor} {kind}"


def side_text(side: Side) -> str:
    """Name a leg."""
    return {
        Side.LEFT_FRONT: tr("Front left"),
        Side.RIGHT_FRONT: tr("Front right"),
        Side.RIGHT_BACK: tr("Back right"),
        Side.LEFT_BACK: tr("Back left"),
    }[side]


def spoken_joint(motor: int) -> str:
    """Name a motor, its joint and its leg for who does not see the table."""
    joint = joint_of(motor)
    if joint is None:
        return tr("Motor {0}").format(motor)
    return tr("Motor {0}, {1} leg").format(joint_text(motor), side_text(joint.side).lower())


def position_text(position: int | None) -> str:
    """Write a position in units and degrees: `512 = 150.1°`."""
    return "–" if position is None else f"{position} = {degrees(position):.1f}°"


def signed(number: int) -> str:
    """Write a difference with its sign."""
    return f"{number:+d}".replace("-", "−") if number else "0"


def speed_text(speed: int) -> str:
    """Write what a speed setting means."""
    per_second = degrees_per_second(speed)
    return tr("as fast as it can") if per_second is None else f"{per_second:.0f} °/s"


def assumed_text() -> str:
    """Say what the drawing takes for granted."""
    return tr("Which leg is which is assumed; even motors are inner joints, odd ones outer.")


def why_not_move(robot: Robot) -> str:
    """Say why a robot cannot be sent anywhere now; empty where it can."""
    if robot.link is not ConnectionState.CONNECTED:
        return tr("There is no robot that could move now.")
    if (stuck := robot.known.stuck) is None:
        return ""
    if stuck.motor is None:
        return tr("The robot does not answer; it listens to nothing until it does.")
    text = tr("The robot waits for motor {0} and listens to nothing until it answers.")
    return text.format(stuck.motor)
