"""Why no bench test can begin, in words for people."""

from PySide6.QtCore import QCoreApplication

from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.model.driving.motors import Motors
from trex_gui.ui.devices.connection_state import ConnectionState

HOLDER = "bench"
"""By which the motors know that a bench test has them."""


def tr(text: str) -> str:
    """Translate a text of this file."""
    return QCoreApplication.translate("bench_obstacle", text)


def obstacle(device: Device, *, ignore_wishes: bool = False) -> str:
    """Return what stands in the way of a test, and what to do; empty when nothing does.

    With `ignore_wishes` motors may be driven: a test does so itself.
    """
    motors = device.motors
    if device.link is ConnectionState.NOT_RESPONDING:
        return tr("The board does not answer.")
    if device.link is not ConnectionState.CONNECTED:
        return tr("Connect to a board to test its motors.")
    if device.is_joint:
        return tr("In joint mode the board senses no current: nothing would end a test of itself.")
    if device.applying:
        return tr("Settings are being written.")
    if device.telemetry.serial_controls is False:
        return tr("{0} A test needs serial control.").format(device.control_text)
    if motors.locked_for:
        return tr("Stop was pressed: the motors are locked for {0:.0f} s more.").format(
            max(1.0, motors.locked_for)
        )
    if not motors.armed:
        return tr("Nothing is sent yet. Put the robot on blocks, then press Run motor.")
    if motors.holder not in {"", HOLDER}:
        return tr("Another control drives the motors now.")
    if not ignore_wishes and _something_runs(motors):
        return tr("Motors are driven already ({0}): bring them to rest first.").format(motors.text)
    if device.telemetry.motor_currents is None:
        return tr("No current was read yet.")
    return ""


def _something_runs(motors: Motors) -> bool:
    drives = (motors.drive(motor) for motor in (1, 2))
    moving = any(drive and not drive.is_brake and drive.speed for drive in drives)
    return moving or motors.auxiliary > 0
