"""What is wrong with the board's serial timeout, for who is about to drive: off, or too short."""

from dataclasses import dataclass

from PySide6.QtCore import QCoreApplication

from trex_gui.core.transport.serial_port import latency_of
from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.devices.trex.session.polling import survives_a_loss

_OFFERED_S = (0.5, 1.0, 2.0, 5.0)
"""Seconds offered, the first that this line can keep fed: in 0.5 s a robot at 2 m/s goes a metre,
and no line that works is silent for so long."""


@dataclass(frozen=True, slots=True)
class Weakness:
    """What is wrong, as a sentence or two, and how many seconds would be better."""

    text: str
    seconds: float


def weakness_of_timeout(device: Device) -> Weakness | None:
    """Return what is wrong with it; `None` where it is fine, or nothing is known of it."""
    timeout, settings = device.serial_timeout_s, device.settings
    return None if timeout is None or settings is None else weakness_on(settings, timeout)


def weakness_on(settings: ConnectionSettings, timeout: float) -> Weakness | None:
    """Return what is wrong with a timeout of so many seconds on such a line, 0 for none at all."""
    better = _offered(settings)
    if timeout == 0:
        text = _tr(
            "Serial timeout is off: motors keep turning if the cable, this computer or this "
            "program fails."
        )
        return Weakness(text, better)
    if timeout >= better or _keeps(settings, timeout):
        return None
    if "://" in settings.url:
        text = _tr(
            "Serial timeout of {0:g} s is short for a network port: one answer that is late stops "
            "the motors while you drive. Set a longer one, or connect the board to this computer."
        ).format(timeout)
    else:
        text = _tr(
            "Serial timeout of {0:g} s is short for {1} baud: one answer that is lost stops the "
            "motors while you drive. Set a longer one, or a faster baud rate."
        ).format(timeout, settings.line.baud)
    return Weakness(text, better)


def _keeps(settings: ConnectionSettings, timeout: float) -> bool:
    latency = latency_of(settings.url) + settings.timeouts.extra
    return survives_a_loss(settings.line, timeout, latency)


def _offered(settings: ConnectionSettings) -> float:
    fitting = (seconds for seconds in _OFFERED_S if _keeps(settings, seconds))
    return next(fitting, _OFFERED_S[-1])


def _tr(text: str) -> str:
    return QCoreApplication.translate("TimeoutNotice", text)
