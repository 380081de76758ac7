"""Drive status, and reasons why a held control cannot drive."""

from collections.abc import Iterable

from trex_gui.core.translation import tr
from trex_gui.devices.trex.board.drive_status import (
    AUXILIARY,
    DriveInputs,
    DriveStatus,
    MotorSetpoint,
    motor_setpoint,
)
from trex_gui.devices.trex.driving.blockers import DriveBlocker
from trex_gui.devices.trex.model.device import Device
from trex_gui.ui.devices.connection import ConnectionState
from trex_gui.ui.runtime import now

_LINKS = {
    ConnectionState.DISCONNECTED: DriveBlocker.NO_BOARD,
    ConnectionState.CONNECTING: DriveBlocker.OPENING,
    ConnectionState.CONNECTED: None,
    ConnectionState.NOT_RESPONDING: DriveBlocker.SILENT,
    ConnectionState.DISCONNECTING: DriveBlocker.CLOSING,
}


def drive_inputs(device: Device) -> DriveInputs:
    motors, link = device.main.motors, _LINKS[device.link]
    return DriveInputs(
        board=device.board.inputs(now()),
        link=device.board.silence if link is DriveBlocker.SILENT else link,
        may_move=device.may_move,
        driven=frozenset(device.driving.driven),
        lost_board=device.driving.lost_board,
        silence_remedy=device.board.silence_remedy,
        other_driver=device.main.board.other_driver,
        other_speeds=device.board.other_speeds,
        undrivable=device.main.driving.undrivable_board(),
        reaches_several=device.driving.reaches_several,
        locked_for=motors.locked_for,
        is_available=motors.is_available,
        armed=motors.armed,
        stop_reason=motors.stop_reason,
    )


def setpoint_of(device: Device, motor: int, inputs: DriveInputs) -> MotorSetpoint:
    if motor == AUXILIARY:
        sent = 0 if device.main is not device else device.motors.auxiliary
    else:
        drive = device.drive_of(motor)
        sent = drive.signed if drive else 0
    return motor_setpoint(motor, inputs, device.board.newest, sent)


def fault_text(statuses: Iterable[DriveStatus]) -> str:
    return " ".join(status.text for status in statuses if status.blocker is DriveBlocker.FAULT)


def held_drive_blocker(device: Device, holder: str) -> str:
    """Return the reason why `holder` cannot drive, or an empty string."""
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
        text = tr("The motors were stopped and stay locked for another {0:.0f} s.")
        return text.format(max(1.0, motors.locked_for))
    if not motors.armed:
        return tr("Put the robot on blocks, then arm the motors.")
    if motors.holder not in {"", holder}:
        return tr("Another control is driving now.")
    if not motors.holder and (is_moving or motors.auxiliary > 0):
        return tr("Stop the motors first ({0}).").format(motors.text)
    return ""
