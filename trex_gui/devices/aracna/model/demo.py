"""Simulated robot of the demo panel."""

import json
from dataclasses import dataclass
from enum import Enum
from typing import Any

from PySide6.QtCore import QObject

from trex_gui.ui.devices.simulator import DemoDevice, DemoLine, Simulator, on_or_off


class FirmwareState(Enum):
    OFF = "off"
    BOOTING = "booting"
    IDLE = "idle"
    ANSWERING = "answering"
    SPEEDS = "speeds"
    MOVING = "moving"


@dataclass(frozen=True, slots=True)
class DemoServo:
    """State of a simulated servo. `alive` is False for a servo that is dead or has no power."""

    position: int
    goal: int
    speed: int
    moving: bool
    torque: bool
    alive: bool
    blocked: bool
    load: float
    dead: bool = False

    @property
    def cannot_move(self) -> bool:
        return self.dead or self.blocked or self.load >= 1


@dataclass(frozen=True, slots=True)
class RobotSnapshot:
    state: FirmwareState
    boots: int
    led: bool
    servo_power: bool
    servos: tuple[DemoServo, ...]
    line: DemoLine

    @property
    def power(self) -> bool:
        return self.state is not FirmwareState.OFF

    @property
    def is_moving(self) -> bool:
        return self.servo_power and any(
            servo.moving and not servo.cannot_move for servo in self.servos
        )

    @property
    def is_stuck(self) -> bool:
        """True if the firmware waits only for servos that cannot move."""
        is_waiting = any(
            servo.dead or (servo.moving and servo.cannot_move) for servo in self.servos
        )
        return (
            self.state is FirmwareState.MOVING
            and not self.is_moving
            and (is_waiting or not self.servo_power)
        )


def read_snapshot(text: str) -> RobotSnapshot:
    fields: dict[str, Any] = json.loads(text)
    servos = enumerate(fields["servos"])
    return RobotSnapshot(
        state=FirmwareState(fields["state"]),
        boots=fields["boots"],
        led=fields["led"],
        servo_power=fields["servo_power"],
        servos=tuple(DemoServo(**row, dead=motor in fields["dead"]) for motor, row in servos),
        line=DemoLine(**fields["line"]),
    )


class DemoRobot(DemoDevice[RobotSnapshot]):
    def __init__(self, simulator: Simulator, parent: QObject | None = None) -> None:
        super().__init__(simulator, read_snapshot, parent)

    def restart(self) -> None:
        """Reset the board, but not its servos."""
        self._send("reset")

    def set_servo_power(self, on: bool) -> None:
        self._send(f"servo power {on_or_off(on)}")

    def set_dead(self, motor: int, dead: bool) -> None:
        self._send(f"servo {motor} {'dead' if dead else 'alive'}")

    def set_blocked(self, motor: int, blocked: bool) -> None:
        self._send(f"servo {motor} {'block' if blocked else 'free'}")

    def lose(self, fault: str) -> None:
        """Lose a part of the next transfer. `fault`: control line after the word `line`."""
        self._send(f"line {fault}")

    def repair(self) -> None:
        self._unsent.clear()
        for motor in range(len(self.snapshot.servos) if self.snapshot is not None else 0):
            self.set_dead(motor, dead=False)
            self.set_blocked(motor, blocked=False)
            self._send(f"servo {motor} load 0")
        self.set_mute(False)
        self.set_noise(0)
        for line in ("line drop 0", "line drop 0 sent", "line cut off", "power on"):
            self._send(line)
