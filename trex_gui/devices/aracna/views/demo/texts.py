"""Texts for the state of the simulated robot."""

from PySide6.QtCore import QCoreApplication

from trex_gui.devices.aracna.model.demo import DemoServo, FirmwareState, RobotSnapshot
from trex_gui.devices.aracna.protocol.units import degrees


def tr(text: str) -> str:
    return QCoreApplication.translate("AracnaDemo", text)


def state_text(snapshot: RobotSnapshot) -> str:
    if snapshot.is_held_up:
        if not snapshot.servo_power:
            return tr("Moving indefinitely: waiting for servos that have no power.")
        return tr("Moving indefinitely: waiting for a servo that is blocked or dead.")
    return {
        FirmwareState.OFF: tr("The power is off: no reply, and no servo holds."),
        FirmwareState.BOOTING: tr("Booting: blinks for a second and reads nothing."),
        FirmwareState.IDLE: tr("Idle: waiting for commands."),
        FirmwareState.ANSWERING: tr("Idle: waiting for commands."),  # too short to show
        FirmwareState.SPEEDS: tr("Setting speeds: reading them back from the servos."),
        FirmwareState.MOVING: tr("Moving: reads nothing until every servo has arrived."),
        FirmwareState.HUNG: tr("Hung because of an invalid command. Restart the board."),
    }[snapshot.state]


def power_text(snapshot: RobotSnapshot) -> tuple[str, bool]:
    """Return what servo power does, and whether that is urgent: a servo moves."""
    if not snapshot.power:
        return tr("The robot's switch is off: board and servos have no power."), False
    if not snapshot.servo_power:
        return tr("Off: no servo moves, holds or replies."), True
    text = tr("The only way to stop a motion: the protocol has no stop command.")
    return text, snapshot.is_moving


def servo_text(servo: DemoServo, powered: bool) -> str:
    """Return position and state of a servo: `512 = 150.1°, moving to 600`."""
    where = f"{servo.position} = {degrees(servo.position):.1f}°"
    if not powered:
        doing = tr("no power")
    elif servo.dead:
        doing = tr("dead")
    elif not servo.torque:
        doing = tr("limp until its first goal")
    elif not servo.moving:
        doing = tr("holds")
    elif servo.cannot_move:
        doing = tr("cannot reach {0}").format(servo.goal)
    else:
        doing = tr("moving to {0}").format(servo.goal)
    return f"{where}, {doing}"
