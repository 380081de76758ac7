"""Which parts of a gamepad do what, and how its axes are shaped: dead zone and curve."""

import json
import math
from dataclasses import dataclass
from enum import Enum

from trex_gui.gamepad.pads import Pad

WIDEST_DEAD_ZONE = 0.5
REST = 0.05
"""What counts as at rest at least, of the way to an end, however small the dead zone is.

Inferred: sticks settle within a few hundredths of where they were.
"""


def shape(value: float, dead_zone: float, expo: float) -> float:
    """Return the command (-1 to 1) of an axis at `value` (-1 to 1).

    Args:
        value: the position; beyond its ends it is at its end.
        dead_zone: 0 to `WIDEST_DEAD_ZONE` of the way to an end that count for nothing. Behind it
            the command begins at 0, so that nothing jumps there.
        expo: 0 (in proportion) to 1 (the cube): how much finer the middle is than the ends.
    """
    reach = min(1.0, abs(value))
    if reach <= dead_zone:
        return 0.0
    reach = (reach - dead_zone) / (1.0 - dead_zone)
    return math.copysign((1.0 - expo) * reach + expo * reach**3, value)


def is_at_rest(value: float, dead_zone: float) -> bool:
    """Return whether the axis is near its rest position."""
    return abs(value) <= max(dead_zone, REST)


class Style(Enum):
    """How two axes drive two motors."""

    MIXED = "mixed"
    """One axis is forward, the other turns."""
    TANK = "tank"
    """Each axis is a motor, as the levers of a tank: the first the left one, motor 1."""


@dataclass(frozen=True, slots=True)
class Axis:
    """One axis and its direction; inverted where the hardware counts forward as negative."""

    number: int
    inverted: bool = False


@dataclass(frozen=True, slots=True, kw_only=True)
class GamepadProfile:
    """What drives, and what must be held for it.

    Attributes:
        first: forward, or the left motor.
        second: turn (positive to the right), or the right motor.
        dead_zone: 0 to 0.5 of the way that count for nothing. The default is inferred: worn
            sticks come to rest up to a tenth beside their middle.
        expo: 0 (in proportion) to 1 (fine in the middle).
        hold: the button that must be held to drive; `None`: a stick off its middle drives.
        stop: the button that stops everything; `None`: none does.
    """

    style: Style = Style.MIXED
    first: Axis = Axis(1, inverted=True)  # the left stick, up: that on every pad SDL lists
    second: Axis = Axis(0)
    dead_zone: float = 0.15
    expo: float = 0.3
    hold: int | None = 4
    stop: int | None = 1

    def fits(self, pad: Pad) -> bool:
        """Whether the gamepad has everything that is named here."""
        return all(0 <= axis.number < pad.axes for axis in (self.first, self.second)) and all(
            button is None or 0 <= button < pad.buttons for button in (self.hold, self.stop)
        )

    def to_text(self) -> str:
        """Write it down; `read_profile` reads it."""
        return json.dumps(
            {
                "style": self.style.value,
                "first": [self.first.number, self.first.inverted],
                "second": [self.second.number, self.second.inverted],
                "dead_zone": self.dead_zone,
                "expo": self.expo,
                "hold": self.hold,
                "stop": self.stop,
            }
        )


def default_profile(pad: Pad) -> GamepadProfile:
    """The left stick drives while the left shoulder button is held; the right of four stops.

    Where SDL does not know the kind, buttons have numbers only: the usual ones are taken, and
    with too few buttons the last one is held.
    """
    usual = GamepadProfile()
    forward, turn = pad.axis_of("lefty"), pad.axis_of("leftx")
    hold, stop = pad.button_of("leftshoulder"), pad.button_of("b")
    if hold is None and pad.buttons:
        hold = min(4, pad.buttons - 1)
    if stop is None and pad.buttons > 1 and hold != 1:
        stop = 1
    return GamepadProfile(
        first=usual.first if forward is None else Axis(forward, inverted=True),
        second=usual.second if turn is None else Axis(turn),
        hold=hold,
        stop=stop if stop != hold else None,
    )


def read_profile(text: str) -> GamepadProfile | None:
    """Read what `GamepadProfile.to_text` wrote; `None` for any other text."""
    try:
        found = json.loads(text)
        return GamepadProfile(
            style=Style(found["style"]),
            first=_axis(found["first"]),
            second=_axis(found["second"]),
            dead_zone=_part(found["dead_zone"], WIDEST_DEAD_ZONE),
            expo=_part(found["expo"], 1.0),
            hold=_button(found["hold"]),
            stop=_button(found["stop"]),
        )
    except (ValueError, TypeError, KeyError, RecursionError):
        return None


def _axis(found: object) -> Axis:
    match found:
        case [number, bool(inverted)] if type(number) is int and number >= 0:
            return Axis(number, inverted)
    raise ValueError(found)


def _button(found: object) -> int | None:
    if found is None or (type(found) is int and found >= 0):
        return found
    raise ValueError(found)


def _part(found: object, most: float) -> float:
    if isinstance(found, int | float) and 0 <= found <= most:
        return float(found)
    raise ValueError(found)
