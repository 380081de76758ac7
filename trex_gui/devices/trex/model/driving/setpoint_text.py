"""Setpoints of the motors and what the board reports of them, as short texts."""

from PySide6.QtCore import QCoreApplication

from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.protocol.calibration import FULL_SCALE
from trex_gui.devices.trex.protocol.driving import Drive


def setpoint_text(drive: Drive | None) -> str:
    """Setpoint of motor 1 or 2; `None`: none since it was armed."""
    if drive is None:
        return _tr("Setpoint: none")
    if drive.is_brake:
        if not drive.speed:
            return _tr("Setpoint: coast")
        return _tr("Setpoint: brake, {0:.0f} %").format(100 * drive.speed / FULL_SCALE)
    return _tr("Setpoint: {0}").format(speed_text(drive.signed))


def speed_text(speed: int) -> str:
    """A signed speed with its share of full: `forward 64 (50 %)`."""
    if not speed:
        return "0"
    direction = _tr("forward") if speed > 0 else _tr("reverse")
    return f"{direction} {abs(speed)} ({100 * abs(speed) / FULL_SCALE:.0f} %)"


def channel_text(device: Device, channel: int) -> str:
    """The command of a channel where channels drive: the board's own view of its speed."""
    telemetry = device.telemetry
    value = telemetry.remapped_of(channel)
    if value is None:
        return _tr("Channel {0}: N/A").format(channel)
    if telemetry.raw is not None and telemetry.raw_of(channel) is None:
        return _tr("Channel {0}: no signal").format(channel)
    if channel == 3:  # drives one way only, whichever side the stick is on
        return _tr("Channel {0}: {1}").format(channel, abs(value))
    return _tr("Channel {0}: {1}").format(channel, speed_text(value))


def report_text(device: Device, motor: int) -> str:
    """What the board says of a motor: who controls it, its current, what it latched of late.

    If channel 5 has handed over to serial, its channel shows what the motor does after that.
    """
    currents = device.telemetry.motor_currents
    if currents is None:
        return _tr("Board: N/A")
    parts = [control_text(device)]
    if device.is_joint:
        parts.append(_tr("no current sensing in joint mode"))
    else:
        parts.append(f"{currents[motor - 1]:.2f} A")
        parts += [entry.name.lower() for entry in device.errors.recent(motor)]
    if (waiting := _waiting_text(device, motor)) is not None:
        parts.append(waiting)
    return _tr("Board: {0}").format(", ".join(filter(None, parts)))


def control_text(device: Device) -> str:
    """Who controls the motors; empty while that is not known."""
    match device.telemetry.serial_controls:
        case True:
            return _tr("serial in control")
        case False:
            return _tr("serial not in control")
        case None:
            return ""


def _waiting_text(device: Device, channel: int) -> str | None:
    """Command of a channel while serial overrides it; in serial mode it drives nothing."""
    state, value = device.state, device.telemetry.remapped_of(channel)
    overrides = device.telemetry.serial_controls and state is not None and not state.mode.is_serial
    if not overrides or value is None:
        return None
    value = abs(value) if channel == 3 else value
    return _tr("channel {0} waits with {1}").format(channel, signed_text(value))


def signed_text(speed: int) -> str:
    """A signed speed, short: `+64`, `−64` or `0`."""
    return f"{speed:+d}".replace("-", "−") if speed else "0"


def auxiliary_report_text(device: Device) -> str:
    """What the board says of the auxiliary motor: nothing but who controls it."""
    if not (control := control_text(device)):
        return _tr("Board: N/A")
    waiting = _waiting_text(device, 3)
    return _tr("Board: {0}").format(", ".join(filter(None, [control, waiting])))


def _tr(text: str) -> str:
    return QCoreApplication.translate("MotorsPage", text)
