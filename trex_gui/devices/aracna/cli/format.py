"""What the commands say of motors: where they are, and which did not do as they were told."""

from collections.abc import Sequence

from trex_gui.devices.aracna.protocol.units import degrees

NEAR = 10
"""Units off its goal at which a motor has reached it: servos stop within a margin of some."""


def listed(values: Sequence[int]) -> str:
    """Return one value a motor as a line to paste behind a command."""
    return " ".join(map(str, values))


def amiss_after_move(goals: Sequence[int], present: Sequence[int]) -> list[str]:
    """Return a sentence for each motor that is not where it was sent."""
    told = []
    for motor, (goal, place) in enumerate(zip(goals, present, strict=True)):
        if place < 0:
            told.append(f"Motor {motor}: its position could not be read (-1).")
        elif abs(place - goal) > NEAR:
            off = degrees(abs(place - goal))
            told.append(f"Motor {motor} is at {place}, not at {goal} ({off:.0f}° off).")
    return told


def amiss_after_speeds(wanted: Sequence[int], held: Sequence[int]) -> list[str]:
    """Return a sentence for each servo that does not hold the speed it was given."""
    told = []
    for motor, (want, has) in enumerate(zip(wanted, held, strict=True)):
        if has < 0:
            told.append(f"Motor {motor} does not answer (-1).")
        elif has != want:
            told.append(f"Motor {motor} holds speed {has}, not {want}.")
    return told
