"""Profile of a gamepad, and the setpoints computed from its state."""

import json
import math
from dataclasses import asdict, astuple, dataclass
from enum import Enum, auto

from trex_gui.gamepad.pads import Pad, PadState

MAX_DEAD_ZONE = 0.5
REST = 0.05
"""Deflection (0 to 1) up to which a stick counts as at rest, even with a smaller dead zone.

Inferred: sticks settle within a few hundredths of their previous position.
"""


def shape(value: float, dead_zone: float, expo: float) -> float:
    """Return the command (-1 to 1) for an axis at `value` (-1 to 1).

    The command is 0 within `dead_zone` (0 to `MAX_DEAD_ZONE`) and grows from 0 at the edge of the
    dead zone. `expo`: 0 (linear) to 1 (cubic, finer in the middle).
    """
    deflection = min(1.0, abs(value))
    if deflection <= dead_zone:
        return 0.0
    deflection = (deflection - dead_zone) / (1.0 - dead_zone)
    return math.copysign((1.0 - expo) * deflection + expo * deflection**3, value)


class Style(Enum):
    MIXED = "mixed"  # one axis drives forward, the other axis turns
    TANK = "tank"  # each axis drives one motor; the axis `first` drives the left motor, motor 1


@dataclass(frozen=True, slots=True)
class Axis:
    """Number and direction of an axis. `inverted`: the hardware reports forward as negative."""

    number: int
    inverted: bool = False


@dataclass(frozen=True, slots=True, kw_only=True)
class GamepadProfile:
    """Functions of the axes and buttons of a gamepad.

    Attributes:
        first: axis for forward, or for the left motor.
        second: axis for turning (positive to the right), or for the right motor.
        dead_zone: 0 to `MAX_DEAD_ZONE`. The default is inferred: worn sticks come to rest up to
            a tenth of their range away from the centre.
        expo: 0 (linear) to 1 (cubic).
        hold: button that must be held to drive. `None`: moving a stick is enough.
        stop: button that stops all motors.
    """

    style: Style = Style.MIXED
    first: Axis = Axis(1, inverted=True)  # left stick, vertical, on every gamepad that SDL knows
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
    """Return the default profile for a gamepad.

    It uses the left stick, the left shoulder button (hold) and the right face button (stop). If SDL
    does not know the gamepad, the profile uses the default numbers. If such a gamepad has too few
    buttons, its last button is the hold button.
    """
    default = GamepadProfile()
    forward, turn = (pad.part_number("a", part) for part in ("lefty", "leftx"))
    hold, stop = (pad.part_number("b", part) for part in ("leftshoulder", "b"))
    if hold is None and pad.buttons:
        hold = min(4, pad.buttons - 1)
    if stop is None and pad.buttons > 1:
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
        values = json.loads(text)
        return GamepadProfile(
            style=Style(values["style"]),
            first=_axis(values["first"]),
            second=_axis(values["second"]),
            dead_zone=_number(values["dead_zone"], MAX_DEAD_ZONE),
            expo=_number(values["expo"], 1.0),
            hold=_button(values["hold"]),
            stop=_button(values["stop"]),
        )
    except (ValueError, TypeError, KeyError, RecursionError):
        return None


def _axis(value: object) -> Axis:
    match value:
        case [number, bool(inverted)] if type(number) is int and number >= 0:
            return Axis(number, inverted)
    raise ValueError(value)


def _button(value: object) -> int | None:
    if value is None or (type(value) is int and value >= 0):
        return value
    raise ValueError(value)


def _number(value: object, maximum: float) -> float:
    if isinstance(value, int | float) and type(value) is not bool and 0 <= value <= maximum:
        return float(value)
    raise ValueError(value)


class DriveCondition(Enum):
    """Condition that must be met before a gamepad drives."""

    REST = auto()  # each stick must first be at rest
    RELEASE = auto()  # the hold button must first be released
    HOLD = auto()  # the hold button must be held
    MOVE = auto()  # a stick must leave its centre, if there is no hold button
    NOTHING = auto()  # the gamepad drives


@dataclass(frozen=True, slots=True)
class PilotRequest:
    """Setpoints from a gamepad, -1 to 1. `turn` is positive to the right."""

    forward: float
    turn: float
    waits_for: DriveCondition
    stop: bool  # True if the stop button has just been pressed

    @property
    def drives(self) -> bool:
        """True if the gamepad drives, even at speed 0."""
        return self.waits_for is DriveCondition.NOTHING


class Pilot:
    """Computes setpoints from the state and the profile of a gamepad.

    Some gamepads report random values until a stick is touched. An axis is therefore ignored until
    it has been at rest. After `reset`, the hold button must be released and pressed again.
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
        self._released = self._released or not state.is_pressed(profile.hold)
        first, second = (self._value(axis, state) for axis in (profile.first, profile.second))
        stop_is_down = state.is_pressed(profile.stop)
        stop = stop_is_down and not self._stop_was_down
        self._stop_was_down = stop_is_down
        waits_for = self._wait_condition(state, moved=bool(first or second))
        if profile.style is Style.TANK:
            return PilotRequest((first + second) / 2, (first - second) / 2, waits_for, stop)
        return PilotRequest(first, second, waits_for, stop)

    def _value(self, axis: Axis, state: PadState) -> float:
        if axis.number not in self._rested:
            return 0.0
        value = shape(state.axis(axis.number), self._profile.dead_zone, self._profile.expo)
        return -value if axis.inverted and value else value

    def _wait_condition(self, state: PadState, *, moved: bool) -> DriveCondition:
        if not {self._profile.first.number, self._profile.second.number} <= self._rested:
            return DriveCondition.REST
        if self._profile.hold is None:
            return DriveCondition.NOTHING if moved else DriveCondition.MOVE
        if not state.is_pressed(self._profile.hold):
            return DriveCondition.HOLD
        return DriveCondition.NOTHING if self._released else DriveCondition.RELEASE
