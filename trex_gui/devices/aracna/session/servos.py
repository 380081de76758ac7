"""What is known of the servos, and how long a motion takes for all that is known.

There is no question for a position or a speed: only the answers to `.c` and `.v` tell.
"""

from collections.abc import Sequence

from trex_gui.devices.aracna.protocol.units import HIGHEST, speed_for, travel_seconds

ASSUMED_SPEED = 100
"""What a servo is taken to be set to as long as nobody knows: slow, so that no answer is called
late that is not."""

SETTING = 0.055
"""Seconds that a `.v` takes at most: 25 ms of pause, and each servo's register read back."""

TRUST = 2.0
"""Seconds after the answer to a `.v` for which the speeds count as known.

A servo that was without power is as fast as it can be, and no answer but that to a `.v` tells of
it: a short cut near the goal looks like a motion that went well. So they are told anew this often
while something is played or dragged, which takes `SETTING`.
"""

FRESH = 0.5
"""The same for a motion that a person asks for by itself: its speeds are told right before it."""

OFF = 12
"""Units off its goal beyond which a motor may have been without power on its way."""

FAR = 50
"""Units off its goal at which a motor has failed to go there: what the firmware's authors take in
their self-test. Somebody has cut the servo power, or holds it."""

_NEAR = 1.05
"""How much faster than needed a speed may be that is left as it is."""

_THERE = 5
"""Units off its goal at which a motor counts as there; servos are content some units off it."""

MARGIN, ALLOWANCE = 1.25, 1.0
"""What a motion may take longer than without load: a quarter and a second."""


class Servos:
    """Where every motor is and how fast it is set, as far as the robot has said so.

    Attributes:
        present: positions, 0-1023; `None` where that is not known.
        speeds: speed settings, 0-1023 (0: as fast as it can); `None` where not known.
    """

    def __init__(self, motors: int) -> None:
        self.present: tuple[int | None, ...] = (None,) * motors
        self.speeds: tuple[int | None, ...] = (None,) * motors
        self._held_at = 0.0

    def forget_positions(self) -> None:
        """A motion has begun, and where it ends nobody knows yet."""
        self.present = (None,) * len(self.present)

    def forget(self) -> None:
        """The servos may have been without power."""
        self.forget_positions()
        self.forget_speeds()

    def forget_speeds(self) -> None:
        """A servo may have been without power, or have been given a speed that nobody confirms."""
        self.speeds = (None,) * len(self.speeds)

    def doubt(self, now: float, trust: float = TRUST) -> None:
        """Forget the speeds where the servos have not told them for `trust` seconds."""
        if now - self._held_at > trust:
            self.forget_speeds()

    def arrive(self, goals: Sequence[int], present: Sequence[int], now: float) -> None:
        """Take the answer to a `.c`.

        A motor that cannot be read, or is off its goal, makes all speeds doubtful: it may have
        been without power on its way. So does a motion that was long enough for that.
        """
        self.doubt(now)
        if any(value < 0 for value in present) or missed(goals, present, OFF):
            self.forget_speeds()
        self.present = tuple(None if value < 0 else value for value in present)

    def hold(self, speeds: Sequence[int], now: float) -> None:
        """Take the answer to a `.v`."""
        self._held_at = now
        self.speeds = tuple(None if value < 0 else value for value in speeds)

    def seconds_to(self, goals: Sequence[int]) -> float:
        """Return how long the slowest motor needs, without load.

        From an unknown position that is as far as it can be; an unknown speed is the slowest
        that any other motor is known to have, and no more than `ASSUMED_SPEED`.
        """
        known = [speed for speed in self.speeds if speed]
        slowest = min([ASSUMED_SPEED, *known])
        return max(
            travel_seconds(_farthest(start, goal), slowest if speed is None else speed)
            for start, speed, goal in zip(self.present, self.speeds, goals, strict=True)
        )

    def speeds_to(self, goals: Sequence[int], seconds: float) -> tuple[int, ...] | None:
        """Return speeds at which every motor arrives in so many seconds; `None`: as they are.

        What setting them takes is taken off. A motor that is there already keeps its speed. One
        whose position is not known goes no faster than `ASSUMED_SPEED`: nobody knows how far it
        has to go.
        """
        rest = max(seconds - SETTING, seconds / 2)
        wanted: list[int] = []
        fits = True
        for start, speed, goal in zip(self.present, self.speeds, goals, strict=True):
            if start is not None and abs(goal - start) <= _THERE and speed is not None:
                wanted.append(speed)
                continue
            highest = ASSUMED_SPEED if start is None else HIGHEST
            distance = _farthest(start, goal)
            best = min(speed_for(distance, rest), highest)
            wanted.append(best)
            lowest = min(speed_for(distance, seconds), highest)
            fits &= bool(speed) and lowest <= (speed or 0) <= best * _NEAR + 2
        return None if fits else tuple(wanted)


def missed(goals: Sequence[int], present: Sequence[int], by: int = FAR) -> dict[int, int]:
    """Return how far each motor is off its goal that misses it by more units than `by`."""
    return {
        motor: place - goal
        for motor, (goal, place) in enumerate(zip(goals, present, strict=True))
        if place >= 0 and abs(place - goal) > by
    }


def deadline(expected: float) -> float:
    """Return after how many seconds the answer to a motion is late."""
    return expected * MARGIN + ALLOWANCE


def _farthest(start: int | None, goal: int) -> int:
    """Return a distance, or the longest that it can be."""
    return max(goal, HIGHEST - goal) if start is None else abs(goal - start)
