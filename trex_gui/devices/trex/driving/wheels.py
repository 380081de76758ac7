"""Motors of several boards as the wheels of one robot."""

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

LEFT, RIGHT = 1, 2  # numbered like the motors of a single board


@dataclass(frozen=True, slots=True)
class Wheel:
    board: int
    motor: int  # 1 or 2
    side: int  # LEFT or RIGHT
    is_reversed: bool = False  # True if the motor runs backward to move the robot forward

    def motor_drive(self, drive: Drive | None) -> Drive | None:
        """Return the setpoint of the motor for a setpoint of its side."""
        if drive is None or drive.is_brake or not self.is_reversed:
            return drive
        return Drive.at(-drive.signed)


def both_sides_of_each(boards: Iterable[int]) -> tuple[Wheel, ...]:
    """Return the wheels of boards that each drive both sides, such as one board per axle."""
    return tuple(Wheel(board, side, side) for board in boards for side in (LEFT, RIGHT))


def packed(wheels: Iterable[Wheel]) -> str:
    """Return the wheels as text for the preferences, such as `7.1.1+ 7.2.2-`."""
    return " ".join(f"{w.board}.{w.motor}.{w.side}{'-' if w.is_reversed else '+'}" for w in wheels)


def unpacked(text: str) -> tuple[Wheel, ...]:
    """Return the wheels of a `packed` text. Raise `ValueError` if the text is invalid."""
    matches = [_WHEEL.fullmatch(word) for word in text.split()]
    wheels = [Wheel(int(m[1]), int(m[2]), int(m[3]), m[4] == "-") for m in matches if m is not None]
    if len(wheels) < len(matches):
        raise ValueError(f"{text!r} is not a list of wheels")
    return tuple(wheels)


def setpoints_of(
    wheels: Sequence[Wheel], request: SetpointRequest
) -> dict[int, SetMotor | SetMotors]:
    """Return the request for each board. In `request`, motors 1 and 2 stand for the sides."""
    by_side = {setpoint.motor: setpoint for setpoint in setpoints_in(request)}
    by_board: dict[int, list[SetMotor]] = {}
    for wheel in wheels:
        setpoint = by_side.get(wheel.side)
        if setpoint is None or isinstance(setpoint, SetAuxiliary):
            continue
        drive = wheel.motor_drive(setpoint.drive) or setpoint.drive
        motor = replace(setpoint, motor=wheel.motor, drive=drive)
        by_board.setdefault(wheel.board, []).append(motor)
    return {
        board: SetMotors((motors[0], motors[1])) if len(motors) == 2 else motors[0]
        for board, motors in by_board.items()
    }
