"""Motors of several boards as the wheels of one robot: side and direction of each wheel."""

import re
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace

from trex_gui.devices.trex.driving.requests import (
    SetAuxiliary,
    SetMotor,
    SetMotors,
    SetpointRequest,
    setpoints_in,
)
from trex_gui.devices.trex.protocol.driving import Drive

_WHEEL = re.compile(r"(\d{1,3})\.([12])\.([12])([+-])")

LEFT, RIGHT = 1, 2  # sides, numbered like the motors of a single board


@dataclass(frozen=True, slots=True)
class Wheel:
    """Motor 1 or 2 of a board, on one side. `is_reversed`: it runs backward to go forward."""

    board: int
    motor: int
    side: int
    is_reversed: bool = False

    def turned(self, drive: Drive | None) -> Drive | None:
        """Return the motor's setpoint for a setpoint of its side."""
        if drive is None or drive.is_brake or not self.is_reversed:
            return drive
        return Drive.at(-drive.signed)


def front_and_back(boards: Iterable[int]) -> tuple[Wheel, ...]:
    """Return the wheels of boards that each drive both sides."""
    return tuple(Wheel(board, side, side) for board in boards for side in (LEFT, RIGHT))


def packed(wheels: Iterable[Wheel]) -> str:
    """Return wheels as a text for the preferences: `7.1.1+ 7.2.2-`."""
    return " ".join(f"{w.board}.{w.motor}.{w.side}{'-' if w.is_reversed else '+'}" for w in wheels)


def unpacked(text: str) -> tuple[Wheel, ...]:
    """Return the wheels of a `packed` text. ValueError if the text is invalid."""
    found = [_WHEEL.fullmatch(word) for word in text.split()]
    wheels = [Wheel(int(m[1]), int(m[2]), int(m[3]), m[4] == "-") for m in found if m is not None]
    if len(wheels) < len(found):
        raise ValueError(f"{text!r} are no wheels")
    return tuple(wheels)


def setpoints_of(
    wheels: Sequence[Wheel], request: SetpointRequest
) -> dict[int, SetMotor | SetMotors]:
    """Return the request to each board for setpoints of the sides."""
    wanted = {one.motor: one for one in setpoints_in(request)}
    found: dict[int, list[SetMotor]] = {}
    for wheel in wheels:
        setpoint = wanted.get(wheel.side)
        if setpoint is None or isinstance(setpoint, SetAuxiliary):
            continue
        drive = wheel.turned(setpoint.drive) or setpoint.drive
        found.setdefault(wheel.board, []).append(replace(setpoint, motor=wheel.motor, drive=drive))
    return {
        board: SetMotors((one[0], one[1])) if len(one) == 2 else one[0]
        for board, one in found.items()
    }
