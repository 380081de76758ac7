"""Texts of the Motors page."""

from dataclasses import dataclass

from trex_gui.core.texts import signed_text
from trex_gui.core.translation import Number, tr
from trex_gui.core.transport.serial_port import latency_of
from trex_gui.devices.trex.driving.timeout_stop import TimeoutStop
from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.protocol.calibration import FULL_SCALE
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.devices.trex.protocol.driving import Drive
from trex_gui.devices.trex.protocol.parameters import MotorParameter
from trex_gui.devices.trex.session.polling import survives_a_loss
from trex_gui.ui.runtime import now


def setpoint_text(drive: Drive | None) -> str:
    if drive is None:
        return "–"
    if not drive.is_brake:
        return percent_text(drive.speed)
    return tr("brake, {0}").format(percent_text(drive.speed)) if drive.speed else tr("coast")


def percent_text(speed: int) -> str:
    return f"{100 * abs(speed) / FULL_SCALE:.0f} %"


def direction_text(speed: int) -> str:
    """Return a signed speed in words: `forward 64`."""
    if not speed:
        return "0"
    return f"{tr('forward') if speed > 0 else tr('reverse')} {abs(speed)}"


def speed_text(speed: int) -> str:
    """Return a signed speed and its percentage: `forward 64 (50 %)`."""
    return direction_text(speed) + (f" ({percent_text(speed)})" if speed else "")


def report_text(device: Device, motor: int) -> str:
    """Return the board's report on a motor (3: auxiliary)."""
    telemetry, state, parts = device.telemetry, device.state, []
    if motor in {1, 2} and telemetry.motor_currents is not None:
        if device.board.is_joint:
            parts.append(tr("no current sensing in joint mode"))
        else:
            parts += [tr(entry.name) for entry in device.board.errors.recent(motor, now())]
    value = telemetry.remapped_of(motor)
    is_overridden = device.board.serial_controls and state and not state.mode.is_serial
    if is_overridden and value is not None:
        value = abs(value) if motor == 3 else value
        parts.append(tr("channel {0} at {1} (overridden)").format(motor, signed_text(value)))
    return ", ".join(parts)


def limit_text(device: Device, motor: int) -> str:
    if MotorParameter.CURRENT_LIMIT.of(motor) not in device.parameters.values.stored:
        return "–"
    limit = device.current_limit(motor)
    return tr("no limit") if limit is None else tr("limit {0:.1f} A").format(Number(limit))


# --- The serial timeout -----------------------------------------------------------------

_PROPOSED_S = (0.5, 1.0, 2.0, 5.0)  # seconds; a robot at 2 m/s moves 1 m in 0.5 s


@dataclass(frozen=True, slots=True)
class TimeoutWarning:
    text: str
    seconds: float | None  # a better timeout; `None` without a proposal


def timeout_warning(device: Device) -> TimeoutWarning | None:
    if (own := _own_warning(device)) is not None:
        return TimeoutWarning(device.named(own.text), own.seconds)
    for other in device.other_devices:
        if (warning := _own_warning(other)) is not None:
            return TimeoutWarning(other.named(warning.text), None)
    return None


def _own_warning(device: Device) -> TimeoutWarning | None:
    timeout, settings = device.serial_timeout_s, device.settings
    if timeout is None or settings is None:
        return None
    return timeout_warning_on(
        settings, timeout, device.board.timeout_stop, is_guarded=device.connection.is_guarded
    )


def timeout_warning_on(
    settings: ConnectionSettings, timeout: float, stop: TimeoutStop, *, is_guarded: bool
) -> TimeoutWarning | None:
    """Return a warning about a serial timeout, or `None`.

    `timeout` is in seconds. 0 means that it is off.
    """
    latency = latency_of(settings.url) + settings.timeouts.extra

    def survives(seconds: float) -> bool:
        return survives_a_loss(settings.line, seconds, latency)

    better = next(filter(survives, _PROPOSED_S), _PROPOSED_S[-1])
    if timeout == 0 and is_guarded:
        text = tr("Serial timeout is off: motors keep turning if the cable or this computer fails.")
    elif timeout == 0:
        text = tr(
            "Serial timeout is off, and the guardian process could not be started: motors keep "
            "turning if the cable, this computer or this program fails."
        )
    elif stop is TimeoutStop.FAILED:
        text = tr(
            "Serial timeout is on, but did not stop the motors of this board when it was "
            "tested: motors keep turning if the cable or this computer fails."
        )
        return TimeoutWarning(text, None)
    elif stop is TimeoutStop.DOUBTFUL:
        text = tr(
            "UART-Error Shutdown is off: motors may keep turning if the cable or this computer "
            "fails, although the serial timeout is on (twin)."
        )
        better = max(better, timeout)
    elif stop is TimeoutStop.REFUTED:
        text = tr(
            "UART-Error Shutdown is off, and the serial timeout did not stop the motors of "
            "this board when it was tested: motors keep turning if the cable or this "
            "computer fails."
        )
        better = max(better, timeout)
    elif timeout >= better or survives(timeout):
        if is_guarded:
            return None
        text = tr(
            "The guardian process could not be started: if this program fails, motors keep "
            "turning until the serial timeout of {0:g} s expires."
        )
        return TimeoutWarning(text.format(Number(timeout)), None)
    elif "://" in settings.url:
        text = tr(
            "The serial timeout of {0:g} s is short for a network port: one late reply stops "
            "the motors while you drive. Set a longer timeout, or connect the board to this "
            "computer."
        ).format(Number(timeout))
    else:
        text = tr(
            "The serial timeout of {0:g} s is short for {1} baud: one lost reply stops the "
            "motors while you drive. Set a longer timeout or a higher baud rate."
        ).format(Number(timeout), settings.line.baud)
    return TimeoutWarning(text, better)
