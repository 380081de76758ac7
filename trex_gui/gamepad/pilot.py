"""Setpoints of a gamepad: none before its sticks were centred and its button was pressed."""

from dataclasses import dataclass
from enum import Enum

from trex_gui.gamepad.pads import PadState
from trex_gui.gamepad.profile import Axis, GamepadProfile, Style, is_at_rest, shape


class Waits(Enum):
    """What a gamepad has to do before it drives."""

    REST = "rest"  # a stick was not at rest yet
    RELEASE = "release"  # the button that is to be held was down all along
    HOLD = "hold"
    MOVE = "move"  # no button need be held: a stick has to leave its middle
    NOTHING = "nothing"


@dataclass(frozen=True, slots=True)
class PilotRequest:
    """The setpoints of a gamepad at one moment.

    Attributes:
        forward: -1 to 1.
        turn: -1 to 1, positive to the right.
        waits: why it does not drive; `NOTHING` while it does.
        stop: the stop button was pressed just now.
    """

    forward: float
    turn: float
    waits: Waits
    stop: bool

    @property
    def drives(self) -> bool:
        """Whether it drives, be it with the sticks in the middle."""
        return self.waits is Waits.NOTHING


class Pilot:
    """Reads one gamepad by one profile.

    Some gamepads give random values for a stick until it is touched. So both axes must have been
    seen at rest before they count, and the button must go down after `begin`.
    """

    def __init__(self, profile: GamepadProfile) -> None:
        self._profile = profile
        self._stop_was_down = False
        self.begin()

    def begin(self) -> None:
        """Forget what was seen, as after the motors were armed."""
        self._rested: set[int] = set()
        self._released = False

    def take(self, state: PadState) -> PilotRequest:
        """Take what the gamepad shows now."""
        profile = self._profile
        for axis in (profile.first, profile.second):
            if is_at_rest(state.axis(axis.number), profile.dead_zone):
                self._rested.add(axis.number)
        self._released = self._released or not state.pressed(profile.hold)
        first, second = (
            self._axis_value(profile.first, state),
            self._axis_value(profile.second, state),
        )
        stop_is_down = state.pressed(profile.stop)
        stop = stop_is_down and not self._stop_was_down
        self._stop_was_down = stop_is_down
        waits = self._waits(state, moved=bool(first or second))
        if profile.style is Style.TANK:
            return PilotRequest((first + second) / 2, (first - second) / 2, waits, stop)
        return PilotRequest(first, second, waits, stop)

    def _axis_value(self, axis: Axis, state: PadState) -> float:
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
