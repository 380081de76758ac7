"""Texts and figures of the robot's joints."""

from PySide6.QtCore import QCoreApplication

from trex_gui.devices.aracna.protocol.joints import JOINTS, Joint, JointKind, Side
from trex_gui.devices.aracna.protocol.units import degrees, degrees_per_second


def tr(text: str) -> str:
    return QCoreApplication.translate("AracnaWords", text)


def joint_of(motor: int) -> Joint | None:
    """Return the joint of a motor; `None` if the published robot does not have it."""
    return JOINTS[motor] if motor < len(JOINTS) else None


def joint_text(motor: int) -> str:
    """Return motor and joint, such as `0 inner`."""
    joint = joint_of(motor)
    if joint is None:
        return str(motor)
    return f"{motor} {tr('inner') if joint.kind is JointKind.INNER else tr('outer')}"


def side_text(side: Side) -> str:
    return {
        Side.LEFT_FRONT: tr("Front left"),
        Side.RIGHT_FRONT: tr("Front right"),
        Side.RIGHT_BACK: tr("Back right"),
        Side.LEFT_BACK: tr("Back left"),
    }[side]


def spoken_joint(motor: int) -> str:
    """Return motor, joint and leg for screen readers."""
    joint = joint_of(motor)
    if joint is None:
        return tr("Motor {0}").format(motor)
    return tr("Motor {0}, {1} leg").format(joint_text(motor), side_text(joint.side).lower())


def position_text(position: int | None) -> str:
    """Return a position in units and degrees, such as `512 = 150.1°`."""
    return "–" if position is None else f"{position} = {degrees(position):.1f}°"


def signed(number: int) -> str:
    return f"{number:+d}".replace("-", "−") if number else "0"


def speed_text(speed: int) -> str:
    per_second = degrees_per_second(speed)
    return tr("unlimited") if per_second is None else f"{per_second:.0f} °/s"


def assumed_text() -> str:
    return tr("Which leg is which is assumed; even motors are inner joints, odd ones outer.")
