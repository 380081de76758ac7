"""What the simulated robot says of itself, as its control line `show` tells it."""

import json
from dataclasses import dataclass
from typing import Any

from trex_gui.ui.devices.demo_device import DemoLine

OFF = "off"
"""The state of a board without power."""


@dataclass(frozen=True, slots=True)
class DemoServo:
    """One servo as it is, whatever it has told anybody.

    Attributes:
        position, goal: in units, 0-1023.
        speed: the speed that it holds; 0 is as fast as it can.
        moving: whether it is on its way; one that cannot get there still is.
        torque: whether it holds: not before its first goal, nor without servo power.
        dead: whether it neither hears nor answers.
        blocked: whether something holds it.
        load: the part of its speed that it loses, 0 (nothing) to 1 (it stands).
    """

    position: int
    goal: int
    speed: int
    moving: bool
    torque: bool
    dead: bool
    blocked: bool
    load: float

    @property
    def cannot_move(self) -> bool:
        """Whether it would not get anywhere, though it had power."""
        return self.dead or self.blocked or self.load >= 1

    @property
    def is_whole(self) -> bool:
        """Whether nothing is wrong with it."""
        return not (self.dead or self.blocked or self.load)


@dataclass(frozen=True, slots=True)
class RobotSnapshot:
    """Everything that the panel shows, at one moment.

    Attributes:
        state: what the firmware is at: `off`, `booting`, `idle`, `answering`, `speeds`, `moving`
            or `hung`.
        boots: how often it has started.
        led: whether the LED of the board is lit.
        servo_power: whether the servos have power.
        servos: motor 0 first.
    """

    state: str
    boots: int
    led: bool
    servo_power: bool
    servos: tuple[DemoServo, ...]
    line: DemoLine

    @property
    def power(self) -> bool:
        """Whether the board has power."""
        return self.state != OFF

    @property
    def is_moving(self) -> bool:
        """Whether any servo really moves."""
        return self.servo_power and any(
            servo.moving and not servo.cannot_move for servo in self.servos
        )

    @property
    def is_held_up(self) -> bool:
        """Whether the firmware waits for servos none of which gets any further."""
        waits = any(servo.dead or (servo.moving and servo.cannot_move) for servo in self.servos)
        return self.state == "moving" and not self.is_moving and (waits or not self.servo_power)


def read_snapshot(text: str) -> RobotSnapshot:
    """Read the JSON of `show`."""
    shown: dict[str, Any] = json.loads(text)
    dead = set(shown["dead"])
    return RobotSnapshot(
        state=shown["state"],
        boots=shown["boots"],
        led=shown["led"],
        servo_power=shown["servo_power"],
        servos=tuple(_servo(row, number in dead) for number, row in enumerate(shown["servos"])),
        line=DemoLine(**shown["line"]),
    )


def _servo(shown: dict[str, Any], dead: bool) -> DemoServo:
    return DemoServo(
        position=shown["position"],
        goal=shown["goal"],
        speed=shown["speed"],
        moving=shown["moving"],
        torque=shown["torque"],
        dead=dead,
        blocked=shown["blocked"],
        load=float(shown["load"]),
    )
