"""Connections of motors and wheels, and their correction."""

from collections.abc import Mapping
from dataclasses import dataclass
from enum import Enum, StrEnum, auto


class Driver(Enum):
    """Control that drives the robot."""

    ONE_STICK = auto()  # the mix jumper is on: channel 2 drives, channel 1 turns
    TWO_STICKS = auto()  # the mix jumper is off: channel 1 drives motor 1, channel 2 drives motor 2
    COMPUTER = auto()  # serial commands drive the motors

    @property
    def uses_sticks(self) -> bool:
        return self is not Driver.COMPUTER


class Side(StrEnum):
    LEFT = "left"
    RIGHT = "right"


class Movement(Enum):
    """Movement of a wheel while its motor was driven forward."""

    LEFT_FORWARD = Side.LEFT, True
    RIGHT_FORWARD = Side.RIGHT, True
    LEFT_BACKWARD = Side.LEFT, False
    RIGHT_BACKWARD = Side.RIGHT, False
    NOTHING = None, False

    def __init__(self, side: Side | None, forward: bool) -> None:
        self.side, self.forward = side, forward


@dataclass(frozen=True, slots=True)
class Rewiring:
    """Necessary wiring changes, which no setting can replace."""

    exchange_motors: bool  # the wire pairs of motors 1 and 2 are exchanged
    reverse: frozenset[Side]  # sides on which the two wires of the motor are exchanged

    def __bool__(self) -> bool:
        return self.exchange_motors or bool(self.reverse)


@dataclass(frozen=True, slots=True)
class Wiring:
    swapped: bool  # motor 1 drives the right wheel
    backward: frozenset[Side]  # wheels that turn backward when their motor is driven forward

    @classmethod
    def from_movements(cls, movements: Mapping[int, Movement]) -> "Wiring | None":
        """Return the wiring that these movements imply.

        `None` if a movement is missing, or if both motors moved wheels on the same side.
        """
        sides = [movements[motor].side for motor in (1, 2) if motor in movements]
        if set(sides) != {Side.LEFT, Side.RIGHT}:
            return None
        backward = {movement.side for movement in movements.values() if not movement.forward}
        return cls(sides[0] is Side.RIGHT, frozenset(filter(None, backward)))

    def rewiring(self, driver: Driver) -> Rewiring:
        """Return the necessary changes to the wiring.

        The board stores directions of channels (parameter 0x03), not of motors. Serial commands
        ignore these directions. With mixing, the directions can reverse both motors, or exchange
        left and right. Without mixing, they can reverse each motor.
        """
        match driver:
            case Driver.ONE_STICK:
                return Rewiring(False, self.backward if len(self.backward) == 1 else frozenset())
            case Driver.TWO_STICKS:
                return Rewiring(self.swapped, frozenset())
            case Driver.COMPUTER:
                return Rewiring(self.swapped, self.backward)

    def channels_to_reverse(self, driver: Driver) -> frozenset[int]:
        """Return the drive channels to reverse after rewiring.

        Inferred: mixing is motor 1 = forward + turn, motor 2 = forward - turn. Reversing channel 1
        exchanges the motors. Reversing both channels reverses both motors.
        """
        backward = self.backward - self.rewiring(driver).reverse
        match driver:
            case Driver.ONE_STICK:
                is_backward = len(backward) == 2
                reverse = {1: self.swapped != is_backward, 2: is_backward}
            case Driver.TWO_STICKS:
                reverse = {1: Side.LEFT in backward, 2: Side.RIGHT in backward}
            case Driver.COMPUTER:
                reverse = {}
        return frozenset(channel for channel, is_reversed in reverse.items() if is_reversed)
