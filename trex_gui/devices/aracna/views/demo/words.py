"""What the state of the simulated robot means, in short sentences."""

from PySide6.QtCore import QCoreApplication

from trex_gui.devices.aracna.model.demo_snapshot import DemoServo, RobotSnapshot
from trex_gui.devices.aracna.protocol.units import degrees
from trex_gui.ui.devices.demo.rows import Columns


def tr(text: str) -> str:
    """Translate a text of the panel."""
    return QCoreApplication.translate("AracnaDemo", text)


def columns() -> Columns:
    """Return the longest texts in the columns of the panel."""
    return Columns(tr("Noise"), "5.0\u00a0%")


def state_text(snapshot: RobotSnapshot) -> str:
    """Say what the firmware does, and what it waits for."""
    if snapshot.is_held_up:
        if not snapshot.servo_power:
            return tr("Moving, for ever: it waits for servos that have no power.")
        return tr("Moving, for ever: it waits for a servo that cannot arrive.")
    return {
        "off": tr("The power is off: nothing answers, nothing holds."),
        "booting": tr("Booting: it blinks for a second and reads nothing."),
        "idle": tr("Idle: it listens."),
        "answering": tr("Idle: it listens."),  # for a moment only; it would flicker
        "speeds": tr("Setting speeds: it reads back what the servos hold."),
        "moving": tr("Moving: it reads nothing before every servo has arrived."),
        "hung": tr("Hung in a line that it could not read. Restart the board."),
    }.get(snapshot.state, snapshot.state)


def power_text(snapshot: RobotSnapshot) -> tuple[str, bool]:
    """Say what servo power does, and whether that is urgent: something moves."""
    if not snapshot.power:
        return tr("The robot's switch is off: board and servos have no power."), False
    if not snapshot.servo_power:
        return tr("Off: no servo moves, holds or answers."), True
    text = tr("The only thing that stops a running motion: the link has no stop.")
    return text, snapshot.is_moving


def servo_text(servo: DemoServo, powered: bool) -> str:
    """Say where a servo is and what it does: `512 = 150.1°, on its way to 600`."""
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
        doing = tr("cannot get to {0}").format(servo.goal)
    else:
        doing = tr("on its way to {0}").format(servo.goal)
    return f"{where}, {doing}"
