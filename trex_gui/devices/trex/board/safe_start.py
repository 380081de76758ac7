"""Whether safe-start may hold the motors that channels drive."""

from trex_gui.devices.trex.client.reading import DeviceState
from trex_gui.devices.trex.client.telemetry import Currents, Newest, Remapped
from trex_gui.devices.trex.driving.board_reasons import NOISE_COUNTS, BoardInputs
from trex_gui.devices.trex.protocol.calibration import NEARLY_NEUTRAL


class SafeStart:
    """Remembers whether sticks were at rest, or motors drew current, since the board came.

    Inferred: the board has no flag for safe-start. It begins at power-up and when a required
    channel falls silent, and ends when the channels that drive are near neutral, all at once;
    how near is inferred, too. Ref: TReX Jr User's Guide 4.e.
    """

    def __init__(self) -> None:
        self._is_over = False

    def begin(self) -> None:
        self._is_over = False

    def may_hold(self, state: DeviceState, newest: Newest, *, joint: bool) -> bool:
        """Return whether a channel commands a speed, no current flows and nothing shows why."""
        is_commanded = bool(_commands(state, newest, joint=joint))
        return is_commanded and Currents in newest.samples and not self._is_over and not joint

    def take(
        self, state: DeviceState, newest: Newest, inputs: BoardInputs | None, *, joint: bool
    ) -> None:
        """Follow the newest samples."""
        values = _commands(state, newest, joint=joint)
        if not values or (inputs is not None and inputs.lacks_signal):
            self._is_over = False
        elif all(abs(value) <= NEARLY_NEUTRAL for value in values) or _flows(newest):
            self._is_over = True


def _commands(state: DeviceState, newest: Newest, *, joint: bool) -> tuple[int, ...]:
    """Return the commands of the channels that drive; empty if none does, or unknown."""
    sample = newest.get(Remapped)
    if state.mode.is_serial or sample is None:
        return ()
    first, second, third, *_ = sample.values
    return (first, third) if joint else (first, second, third)


def _flows(newest: Newest) -> bool:
    sample = newest.get(Currents)
    return sample is not None and max(sample.counts) > NOISE_COUNTS
