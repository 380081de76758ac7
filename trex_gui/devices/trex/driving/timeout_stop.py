"""Expected stop of the motors by the board itself when the line falls silent.

The command document says that the serial timeout (0x07) stops the motors. The guide of the twin,
the qik 2s12v10 (5.a), adds that it does so only with shutdown on serial errors set. It is unknown
which of the two holds for the TReX, so UART-Error Shutdown (0x08) counts as needed until the user
has pulled the cable of a driven board.
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
    DOUBTFUL = auto()  # UART-Error Shutdown is off: they may keep turning
    EXPECTED = auto()  # timeout and shutdown are set: they should stop
    TRIED = auto()  # they stopped when the cable was pulled
    FAILED = auto()  # they did not stop when the cable was pulled
    REFUTED = auto()  # they did not stop, perhaps because UART-Error Shutdown was off

    @property
    def is_reliable(self) -> bool:
        return self in {TimeoutStop.EXPECTED, TimeoutStop.TRIED}

    @property
    def may_be_mended(self) -> bool:
        """True if other values of both parameters may let the board stop its motors."""
        return self in {TimeoutStop.OFF, TimeoutStop.DOUBTFUL, TimeoutStop.REFUTED}


@dataclass(frozen=True, slots=True)
class TimeoutTrial:
    """Result of pulling the cable of a driven board, as the user saw it."""

    stopped: bool  # whether the motors stopped by themselves
    shutdown: bool  # whether UART-Error Shutdown was set


def timeout_stop(parameters: Mapping[str, int], trial: TimeoutTrial | None = None) -> TimeoutStop:
    """Return the expected effect for a board that stores these wire values."""
    if not parameters.get(_TIMEOUT):
        return TimeoutStop.OFF
    shutdown = bool(parameters.get(_SHUTDOWN, 0) & 1)  # a mask on the twin, bit 0 for the line
    # One trial may apply to both settings: motors that stop without shutdown also stop with it.
    if trial is not None and shutdown in {trial.shutdown, trial.stopped}:
        if trial.stopped:
            return TimeoutStop.TRIED
        return TimeoutStop.FAILED if trial.shutdown else TimeoutStop.REFUTED
    return TimeoutStop.EXPECTED if shutdown else TimeoutStop.DOUBTFUL


def with_shutdown(timeout: int) -> dict[str, int]:
    """Return the parameters to propose for a serial timeout in tenths of a second, 0 for off."""
    return {_TIMEOUT: timeout, **({_SHUTDOWN: 1} if timeout else {})}


def turning_text(motors: Collection[int]) -> str:
    """Warn that `motors` may still be turning. 3 is the auxiliary; empty means unknown."""
    match [*motors]:
        case [3]:
            return tr("The auxiliary motor may still be turning.")
        case [motor]:
            return tr("Motor {0} may still be turning.").format(motor)
    return tr("Motors may still be turning.")


def remedy_for_silence(stop: TimeoutStop, timeout: str) -> str:
    """Return the remedy after losing a driven board. `timeout` is the serial timeout as text."""
    text = tr("The board should stop {0} after the last byte; if not, cut the power.")
    return text.format(timeout) if stop.is_reliable else tr("Cut the power.")
