"""Estimates of each servo's position and speed, and of motion times.

Position and speed cannot be queried. Only the replies to `.c` and `.v` contain them.
"""

from collections.abc import Sequence

from trex_gui.devices.aracna.protocol.joints import (
    HIGHEST,
    Limits,
    clamp,
    speed_for,
    travel_seconds,
)
from trex_gui.devices.aracna.session.errors import missed_goals

ASSUMED_SPEED = 100  # for a servo of unknown speed; low, so that no timeout expires early
SET_SPEEDS_TIME = 0.055  # maximum seconds for a `.v`, including a pause of 25 ms and the read-back

SPEED_VALIDITY = 2.0
"""Validity of reported speeds during a drag or a sequence, in seconds.

After a loss of power, a servo's speed is unlimited, and only the reply to a `.v` shows that.
Therefore, speeds are set again after this time. Setting them takes `SET_SPEEDS_TIME`."""

SPEED_VALIDITY_BEFORE_MOVE = 0.5  # validity in seconds before a single `Move`

_MAX_RATIO, _MAX_EXCESS = 1.05, 2  # a speed may exceed the needed speed by 5 % and two units
_ARRIVED = 5  # units; a motor this close to its goal needs no motion
_MARGIN, _ALLOWANCE = 1.25, 1.0  # factor on the time without load, and extra seconds


class ServoEstimates:
    """Last known positions and speeds (`None`: unknown), and joint limits."""

    def __init__(self, motors: int = 0) -> None:
        self.limits: tuple[Limits, ...] = ()
        self.reset(motors)

    def reset(self, motors: int) -> None:
        self.present: tuple[int | None, ...] = (None,) * motors
        self.speeds: tuple[int | None, ...] = (None,) * motors
        self.reported_speeds: tuple[int, ...] | None = None  # last complete report, never expires
        self._speeds_reported_at = 0.0

    def clamp(self, goals: Sequence[int]) -> tuple[int, ...]:
        return clamp(goals, self.limits)

    def clear_positions(self) -> None:
        self.present = (None,) * len(self.present)

    def clear_speeds(self) -> None:
        """Clear speeds after a possible loss of power or an unconfirmed speed."""
        self.speeds = (None,) * len(self.speeds)

    def clear(self) -> None:
        """Clear positions and speeds after a possible loss of power."""
        self.clear_positions()
        self.clear_speeds()

    def expire_speeds(self, now: float, validity: float = SPEED_VALIDITY) -> None:
        if now - self._speeds_reported_at > validity:
            self.clear_speeds()

    def on_positions(self, goals: Sequence[int], present: Sequence[int], now: float) -> None:
        """Record the reply to a `.c`.

        Speeds expire after a long motion. They become unknown if a motor is unreadable or off its
        goal, since it may have lost power.
        """
        self.expire_speeds(now)
        if missed_goals(goals, present):
            self.clear_speeds()
        self.present = tuple(None if value < 0 else value for value in present)

    def on_speeds(self, speeds: Sequence[int], now: float) -> None:
        self._speeds_reported_at = now
        self.speeds = tuple(None if value < 0 else value for value in speeds)
        if None not in self.speeds:
            self.reported_speeds = tuple(speeds)

    def seconds_to(self, goals: Sequence[int]) -> float:
        """Return the seconds that the slowest motor needs, without load.

        An unknown position counts as the farthest from the goal. An unknown speed counts as the
        slowest known speed, but at most `ASSUMED_SPEED`.
        """
        slowest = min([ASSUMED_SPEED, *(speed for speed in self.speeds if speed)])
        return max(
            travel_seconds(_distance(start, goal), slowest if speed is None else speed)
            for start, speed, goal in zip(self.present, self.speeds, goals, strict=True)
        )

    def speeds_to(self, goals: Sequence[int], seconds: float) -> tuple[int, ...] | None:
        """Return the speeds for a motion of `seconds`. `None`: the present speeds are suitable.

        The time includes setting the speeds. A motor at its goal keeps its speed. A motor at an
        unknown position gets at most `ASSUMED_SPEED`.
        """
        remaining = max(seconds - SET_SPEEDS_TIME, seconds / 2)
        speeds: list[int] = []
        fits = True
        for start, speed, goal in zip(self.present, self.speeds, goals, strict=True):
            if start is not None and abs(goal - start) <= _ARRIVED and speed is not None:
                speeds.append(speed)
                continue
            highest = ASSUMED_SPEED if start is None else HIGHEST
            distance = _distance(start, goal)
            best = min(speed_for(distance, remaining), highest)
            speeds.append(best)
            lowest = min(speed_for(distance, seconds), highest)
            fits &= bool(speed) and lowest <= (speed or 0) <= best * _MAX_RATIO + _MAX_EXCESS
        return None if fits else tuple(speeds)


def move_timeout(expected: float) -> float:
    return expected * _MARGIN + _ALLOWANCE


def _distance(start: int | None, goal: int) -> int:
    return max(goal, HIGHEST - goal) if start is None else abs(goal - start)
