"""Conditions for driving a motor while a button is held."""

from trex_gui.core.translation import tr
from trex_gui.devices.trex.model.device import Device
from trex_gui.ui.devices.connection import ConnectionState


def held_drive_blocker(
    device: Device, holder: str, *, is_driving: bool, wheels_are_free: bool = False
) -> str:
    """Return why no motor can be driven now and what to do, for the user. Empty if one can.

    `holder` is the name by which the motors will be acquired, `is_driving` whether it drives now,
    `wheels_are_free` whether the user has confirmed that the wheels are off the ground.
    """
    motors = device.motors
    drives = [motors.drive(motor) for motor in (1, 2)]
    is_moving = any(drive and not drive.is_brake and drive.speed for drive in drives)
    if device.link is ConnectionState.NOT_RESPONDING:
        return tr("The board does not respond.")
    if not device.is_connected:
        return tr("Connect to a board first.")
    if device.writer.running:
        return tr("Settings are being written.")
    if device.board.serial_controls is False:
        return tr("{0} A test needs serial control.").format(device.board.control_text)
    if motors.locked_for:
        text = tr("After a stop the motors are locked for another {0:.0f} s.")
        return text.format(max(1.0, motors.locked_for))
    if not motors.armed and wheels_are_free:
        return tr("Arm the motors first.")
    if not motors.armed:
        return tr("Put the robot on blocks, then arm the motors.")
    if motors.holder not in {"", holder}:
        return tr("Another control drives now.")
    if not is_driving and (is_moving or motors.auxiliary > 0):
        return tr("Bring the motors to rest first ({0}).").format(motors.text)
    return ""
