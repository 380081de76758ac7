"""Automatic stop by a board whose line falls silent.

Ref: the command documentation says that the serial timeout (0x07) stops the motors. The guide of
the twin (qik 2s12v10, 5.a) says that this requires shutdown on serial errors. The behaviour of the
TReX is unknown, so UART-Error Shutdown (0x08) counts as necessary until the user has pulled the
cable of a driven board.
"""

from collections.abc import Collection, Mapping
from dataclasses import dataclass
from enum import Enum, auto

from trex_gui.core.translation import tr
from trex_gui.devices.trex.protocol.parameters import ParameterKey

_TIMEOUT, _SHUTDOWN = ParameterKey.SERIAL_TIMEOUT, ParameterKey.UART_ERROR_SHUTDOWN


class TimeoutStop(Enum):
    """Expected effect of a silent line on the motors."""

    OFF = auto()  # the serial timeout is off: the motors keep turning
    DOUBTFUL = auto()  # UART-Error Shutdown is off: the motors may keep turning
    EXPECTED = auto()  # timeout and shutdown are set: the motors should stop
    TRIED = auto()  # the motors stopped when the cable was pulled
    FAILED = auto()  # the motors did not stop when the cable was pulled
    REFUTED = auto()  # the motors did not stop, perhaps because UART-Error Shutdown was off

    @property
    def is_reliable(self) -> bool:
        return self in {TimeoutStop.EXPECTED, TimeoutStop.TRIED}

    @property
    def is_fixable(self) -> bool:
        """True if other values of both parameters may make the timeout effective."""
        return self in {TimeoutStop.OFF, TimeoutStop.DOUBTFUL, TimeoutStop.REFUTED}


@dataclass(frozen=True, slots=True)
class TimeoutTrial:
    """Observation by the user after pulling the cable of a driven board."""

    stopped: bool  # True if the motors stopped by themselves
    shutdown: bool  # True if UART-Error Shutdown was set


def timeout_stop(parameters: Mapping[str, int], trial: TimeoutTrial | None = None) -> TimeoutStop:
    if not parameters.get(_TIMEOUT):
        return TimeoutStop.OFF
    shutdown = bool(parameters.get(_SHUTDOWN, 0) & 1)  # bit 0 of a mask on the twin
    # One trial may apply to both values of UART-Error Shutdown. Motors that stop without shutdown
    # also stop with it.
    if trial is not None and shutdown in {trial.shutdown, trial.stopped}:
        if trial.stopped:
            return TimeoutStop.TRIED
        return TimeoutStop.FAILED if trial.shutdown else TimeoutStop.REFUTED
    return TimeoutStop.EXPECTED if shutdown else TimeoutStop.DOUBTFUL


def with_shutdown(timeout: int) -> dict[str, int]:
    """Return the proposed parameters for a timeout in tenths of a second. 0 is off."""
    return {_TIMEOUT: timeout, **({_SHUTDOWN: 1} if timeout else {})}


def turning_text(motors: Collection[int]) -> str:
    """Return a warning that motors may still be turning.

    `motors`: numbers of the motors, 3 for the auxiliary. Empty if unknown.
    """
    match [*motors]:
        case [3]:
            return tr("The auxiliary motor may still be turning.")
        case [motor]:
            return tr("Motor {0} may still be turning.").format(motor)
    return tr("Motors may still be turning.")


def remedy_for_silence(stop: TimeoutStop, timeout: str) -> str:
    """Return the remedy for a lost board that was driven. `timeout`: serial timeout as text."""
    text = tr(
        "The board should stop its motors {0} after the last byte. If it does not, cut the power."
    )
    return text.format(timeout) if stop.is_reliable else tr("Cut the power.")
