"""Keys that are held, made into a wish to go forward and to turn. Pure."""

from enum import Enum, auto

TURN_WHILE_GOING = 0.5
"""How much of a turn is wished while a key for forward or back is held, too.

With a full turn one side would stand still; half of one leaves a curve that can be steered.
"""


class Heading(Enum):
    """What a key is for."""

    FORWARD = auto()
    BACK = auto()
    LEFT = auto()
    RIGHT = auto()


class HeldKeys:
    """The keys that are down; two for the same heading count once, opposite ones cancel."""

    def __init__(self) -> None:
        self._down: dict[int, Heading] = {}

    def press(self, key: int, heading: Heading) -> None:
        """Take a key that went down; `key` tells it from all others, whatever it is called."""
        self._down[key] = heading

    def release(self, key: int) -> bool:
        """Take a key that went up; return whether it was one of those held."""
        return self._down.pop(key, None) is not None

    def clear(self) -> None:
        """Let go of all."""
        self._down.clear()

    def __bool__(self) -> bool:
        return bool(self._down)

    @property
    def wish(self) -> tuple[float, float]:
        """Forward and turn, -1 to 1 each; forward and right are positive."""
        forward = self._along(Heading.FORWARD, Heading.BACK)
        turn = self._along(Heading.RIGHT, Heading.LEFT)
        return forward, turn * TURN_WHILE_GOING if forward else turn

    def _along(self, there: Heading, back: Heading) -> float:
        held = set(self._down.values())
        return float((there in held) - (back in held))
