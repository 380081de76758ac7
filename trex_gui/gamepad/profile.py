"""Profile of a gamepad, and the setpoints computed from its state."""

import json
import math
from dataclasses import asdict, astuple, dataclass
from enum import Enum, auto

from trex_gui.gamepad.pads import Pad, PadState

WIDEST_DEAD_ZONE = 0.5
REST = 0.05
"""Deflection (0 to 1) that counts as at rest even with a smaller dead zone.

Inferred: sticks settle within a few hundredths of their previous position.
"""


def shape(value: float, dead_zone: float, expo: float) -> float:
    """Return the command (-1 to 1) of an axis at `value` (-1 to 1).

    The command is 0 within `dead_zone` (0 to `WIDEST_DEAD_ZONE`) and grows from 0 at its edge.
    `expo`: 0 (linear) to 1 (cubic, finer in the middle).
    """
    reach = min(1.0, abs(value))
    if reach <= dead_zone:
        return 0.0
    reach = (reach - dead_zone) / (1.0 - dead_zone)
    return math.copysign((1.0 - expo) * reach + expo * reach**3, value)


class Style(Enum):
    MIXED = "mixed"  # one axis drives forward, the other turns
    TANK = "tank"  # each axis drives a motor; `first` drives the left motor, motor 1


@dataclass(frozen=True, slots=True)
class Axis:
    """Axis and its direction. Inverted if the hardware counts forward as negative."""

    number: int
    inverted: bool = False


@dataclass(frozen=True, slots=True, kw_only=True)
class GamepadProfile:
    """Functions of the axes and buttons of a gamepad.

    Attributes:
        first: forward, or the left motor.
        second: turn (positive to the right), or the right motor.
        dead_zone: 0 to `WIDEST_DEAD_ZONE`. The default is inferred: worn sticks come to rest up to
            a tenth off their centre.
        expo: 0 (linear) to 1 (cubic).
        hold: button that must be held to drive. `None`: moving a stick is enough.
        stop: button that stops all motors.
    """

    style: Style = Style.MIXED
    first: Axis = Axis(1, inverted=True)  # left stick, up, on every pad that SDL knows
    second: Axis = Axis(0)
    dead_zone: float = 0.15
    expo: float = 0.3
    hold: int | None = 4
    stop: int | None = 1

    def fits(self, pad: Pad) -> bool:
        return all(0 <= axis.number < pad.axes for axis in (self.first, self.second)) and all(
            button is None or 0 <= button < pad.buttons for button in (self.hold, self.stop)
        )

    def to_text(self) -> str:
        axes = {"first": astuple(self.first), "second": astuple(self.second)}
        return json.dumps({**asdict(self), **axes, "style": self.style.value})


def default_profile(pad: Pad) -> GamepadProfile:
    """Return a profile with the left stick, left shoulder (hold) and right face button (stop).

    For a pad that SDL does not know, use the default numbers. With too few buttons, hold the last.
    """
    default = GamepadProfile()
    forward, turn = (pad.part_number("a", part) for part in ("lefty", "leftx"))
    hold, stop = (pad.part_number("b", part) for part in ("leftshoulder", "b"))
    if hold is None and pad.buttons:
        hold = min(4, pad.buttons - 1)
    if stop is None and pad.buttons > 1 and hold != 1:
        stop = 1
    return GamepadProfile(
        first=default.first if forward is None else Axis(forward, inverted=True),
        second=default.second if turn is None else Axis(turn),
        hold=hold,
        stop=stop if stop != hold else None,
    )


def read_profile(text: str) -> GamepadProfile | None:
    """Parse the result of `GamepadProfile.to_text`. `None` for invalid text."""
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
    if type(found) is bool:
        raise ValueError(found)
    if isinstance(found, int | float) and 0 <= found <= most:
        return float(found)
    raise ValueError(found)


class Waits(Enum):
    """Condition that a gamepad has to meet before it drives."""

    REST = auto()  # each stick has to be at rest once
    RELEASE = auto()  # the hold button has to be released first
    HOLD = auto()  # the hold button has to be held
    MOVE = auto()  # without a hold button, a stick has to leave its middle
    NOTHING = auto()  # the gamepad drives


@dataclass(frozen=True, slots=True)
class PilotRequest:
    """Setpoints of a gamepad, -1 to 1. `turn` is positive to the right."""

    forward: float
    turn: float
    waits: Waits
    stop: bool  # True if the stop button has just been pressed

    @property
    def drives(self) -> bool:
        """True if the gamepad drives, even at speed 0."""
        return self.waits is Waits.NOTHING


class Pilot:
    """Computes the setpoints of a gamepad by its profile.

    Some gamepads report random values until a stick is touched. Therefore both axes must be at rest
    once before they count, and the hold button must be pressed after `reset`.
    """

    def __init__(self, profile: GamepadProfile) -> None:
        self._profile = profile
        self._stop_was_down = False
        self.reset()

    def reset(self) -> None:
        self._rested: set[int] = set()
        self._released = False

    def update(self, state: PadState) -> PilotRequest:
        profile = self._profile
        for axis in (profile.first, profile.second):
            if abs(state.axis(axis.number)) <= max(profile.dead_zone, REST):
                self._rested.add(axis.number)
        self._released = self._released or not state.pressed(profile.hold)
        first, second = (self._value(axis, state) for axis in (profile.first, profile.second))
        stop_is_down = state.pressed(profile.stop)
        stop = stop_is_down and not self._stop_was_down
        self._stop_was_down = stop_is_down
        waits = self._waits(state, moved=bool(first or second))
        if profile.style is Style.TANK:
            return PilotRequest((first + second) / 2, (first - second) / 2, waits, stop)
        return PilotRequest(first, second, waits, stop)

    def _value(self, axis: Axis, state: PadState) -> float:
        if axis.number not in self._rested:
            return 0.0
        value = shape(state.axis(axis.number), self._profile.dead_zone, self._profile.expo)
        return -value if axis.inverted and value else value

    def _waits(self, state: PadState, *, moved: bool) -> Waits:
        if not {self._profile.first.number, self._profile.second.number} <= self._rested:
            return Waits.REST
        if self._profile.hold is None:
            return Waits.NOTHING if moved else Waits.MOVE
        if not state.pressed(self._profile.hold):
            return Waits.HOLD
        return Waits.NOTHING if self._released else Waits.RELEASE
