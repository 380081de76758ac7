"""Infer the mix jumper from the channel values: no command reads it.

Ref: a user's measurement (Pololu forum, viewtopic 9053): the jumper alters the remapped values in
serial mode, too. Inferred: by which sums; so only values that fit either way are taken.
"""

from trex_gui.devices.trex.protocol.calibration import FULL_SCALE

_NEAR = 10
"""How far values of two moments may differ while a stick moves."""

_ENOUGH = 5
"""Values in a row that must say the same."""


def is_mixed(outputs: tuple[int, int], answered: tuple[int, int]) -> bool | None:
    """Return whether channels 1 and 2 were mixed; `None` if unknown.

    `outputs` is what each channel makes of its input by itself, `answered` what the board says.
    At neutral both are the same, mixed or not.
    """
    turn, forward = outputs
    mixed = _clipped(forward + turn), _clipped(forward - turn)
    if _distance(outputs, mixed) <= 3 * _NEAR:
        return None
    if _distance(outputs, answered) <= _NEAR:
        return False
    return True if _distance(mixed, answered) <= _NEAR else None


class MixWatch:
    """Remembers what was last seen of the jumper; it may be moved at any time."""

    def __init__(self) -> None:
        self._mixed: bool | None = None
        self._doubt: bool | None = None
        self._count = 0

    @property
    def mixed(self) -> bool | None:
        """Whether the jumper was on when a stick was last off neutral; `None`: never seen."""
        return self._mixed

    def feed(self, outputs: tuple[int, int], answered: tuple[int, int]) -> None:
        """Take what two channels make of their inputs, and what the board says of them."""
        seen = is_mixed(outputs, answered)
        if seen is None:
            return
        self._count = self._count + 1 if seen is self._doubt else 1
        self._doubt = seen
        if self._count >= _ENOUGH:
            self._mixed = seen

    def forget(self) -> None:
        """Forget what was seen: it may be another board."""
        self._mixed = self._doubt = None


def _clipped(value: int) -> int:
    return max(-FULL_SCALE, min(FULL_SCALE, value))


def _distance(first: tuple[int, int], second: tuple[int, int]) -> int:
    return max(abs(first[0] - second[0]), abs(first[1] - second[1]))
