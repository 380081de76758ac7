"""Which stick or button is meant: the one that the user moves."""

from trex_gui.gamepad.pads import PadState
from trex_gui.gamepad.profile import Axis

FAR = 0.5
"""How far an axis must leave where it stood to be meant; half its way to an end."""


class InputDetector:
    """Compares with the state of the gamepad at the start; triggers rest at an end."""

    def __init__(self, start: PadState) -> None:
        self._start = start

    def axis(self, state: PadState) -> Axis | None:
        """The axis that has moved farthest, if far enough; inverted if that was downwards."""
        moves = [
            (now - before, number)
            for number, (before, now) in enumerate(zip(self._start.axes, state.axes, strict=False))
        ]
        move, number = max(moves, key=lambda each: abs(each[0]), default=(0.0, 0))
        return Axis(number, inverted=move < 0) if abs(move) >= FAR else None

    def button(self, state: PadState) -> int | None:
        """The first button that is down and was not."""
        for number, down in enumerate(state.buttons):
            if down and not self._start.pressed(number):
                return number
        return None
