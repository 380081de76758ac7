"""Whether the motors follow the setpoints of the window, and which drivers have shut down."""

from trex_gui.core.translation import tr, tr_noop
from trex_gui.devices.trex.board.drive_status import DriveInputs
from trex_gui.devices.trex.driving.blockers import DriveBlocker, Reason
from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.protocol.flags import MOTOR_FAULTS
from trex_gui.ui.devices.connection import ConnectionState
from trex_gui.ui.runtime import now

_DOUBTFUL = tr_noop("{0} Doubtful: the line is noisy and has no CRC.")

_LINKS = {
    ConnectionState.DISCONNECTED: DriveBlocker.NO_BOARD,
    ConnectionState.CONNECTING: DriveBlocker.OPENING,
    ConnectionState.CONNECTED: None,
    ConnectionState.NOT_RESPONDING: DriveBlocker.SILENT,
    ConnectionState.DISCONNECTING: DriveBlocker.CLOSING,
}


def drive_inputs(device: Device) -> DriveInputs:
    motors = device.motors
    return DriveInputs(
        board=device.board.inputs(now()),
        link=_LINKS[device.link],
        may_move=device.may_move,
        driven=frozenset(device.driving.driven),
        lost_board=device.driving.lost_board,
        silence_remedy=device.board.silence_remedy,
        reaches_several=device.driving.reaches_several,
        locked_for=motors.locked_for,
        is_available=motors.is_available,
        armed=motors.armed,
        stop_reason=motors.stop_reason,
    )


def recent_fault_text(device: Device) -> str:
    """Return which motor drivers have shut down recently, as sentences; empty if none has."""
    recent = {
        motor: entry
        for motor, bit in MOTOR_FAULTS.items()
        for entry in device.board.errors.recent(motor, now())
        if entry.bit is bit
    }
    if not recent or not device.is_connected:
        return ""
    text = " ".join(Reason(DriveBlocker.FAULT, (motor,)).text() for motor in recent)
    if all(entry.is_doubtful for entry in recent.values()):
        text = tr(_DOUBTFUL).format(text)
    return text
