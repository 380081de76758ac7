"""The order to put every parameter back, which a board carries out when it starts."""

from collections.abc import Mapping, Sequence

from trex_gui.devices.trex.client.writing import WriteResult
from trex_gui.devices.trex.protocol.parameter_keys import ParameterKey


class PendingReset:
    """Whether a board was told to reset itself and has not started since, as far as it shows."""

    def __init__(self) -> None:
        self._given_at: dict[str, int] | None = None

    @property
    def stands(self) -> bool:
        """Whether what is written now will be wiped at the next start."""
        return self._given_at is not None

    def note_written(self, results: Sequence[WriteResult], stored: Mapping[str, int]) -> None:
        """Look for the order among what was written to a board that stores these parameters."""
        if any(
            result.key == ParameterKey.FACTORY_RESET and result.error is None for result in results
        ):
            self._given_at = dict(stored)

    def note_read(self, stored: Mapping[str, int], *, power_cycled: bool) -> None:
        """Take the board as it shows itself; one that stores other values has started anew."""
        if power_cycled or self._given_at != dict(stored):
            self._given_at = None

    def forget(self) -> None:
        """Take it for carried out."""
        self._given_at = None
