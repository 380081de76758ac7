"""What is recorded of an Aracna's session, and what stands in the text of its rows.

The columns hold what was last known; the text of a row says the rest of what was reported, in
words that a person reads and `read_…` understands. Seconds have six digits behind the point.
"""

import re
from collections.abc import Sequence
from dataclasses import dataclass
from functools import lru_cache

from trex_gui.devices.aracna.session.messages import (
    Ending,
    Moved,
    Moving,
    Passed,
    PlayEnded,
    Restarted,
    SpeedsHeld,
    StepBegun,
    Stuck,
)
from trex_gui.devices.trex.recording.recording import Marker

UNKNOWN = "?"
"""Stands for a place that nobody knew."""


@dataclass(frozen=True, slots=True)
class FellSilent:
    """The robot has stopped answering: what was known of it is not known any more."""

    time: float


Row = (
    Moving
    | Passed
    | Moved
    | SpeedsHeld
    | StepBegun
    | PlayEnded
    | Stuck
    | Restarted
    | FellSilent
    | Marker
)
"""What is recorded, mostly as the session reports it; times are of the session's clock."""

_SECONDS = r"(\d{1,12}\.\d{6}) s"
_GOALS = re.compile(rf"{_SECONDS} expected from (.+)")
_SO_FAR = re.compile(r"(\d{1,3}) motors so far")
_ALL = re.compile(rf"all motors in {_SECONDS}")
_ASKED = re.compile(r"asked for (.+)")
_STEP = re.compile(r"(in|steps|out), round ([1-9]\d{0,8}), (-?\d{1,12}\.\d{3}) s late")
_STUCK = re.compile(r"waits for motor (\d{1,3})|does not answer")
_NUMBER = re.compile(r"-1|0|[1-9]\d{0,4}")


@lru_cache(maxsize=4096)  # a recording has few of them, and each a million times
def number_in(text: str) -> int:
    """Return a position or speed as the robot writes it; -1 is a servo that did not answer.

    Raises:
        ValueError: it is none.
    """
    if not _NUMBER.fullmatch(text):
        raise ValueError(f"{text!r} is no number of the robot")
    return int(text)


def goals_text(moving: Moving) -> str:
    """Say how long a motion should take, and from where."""
    starts = " ".join(UNKNOWN if each is None else str(each) for each in moving.starts)
    return f"{moving.expected:.6f} s expected from {starts}"


def read_goals(text: str) -> tuple[float, tuple[int | None, ...]]:
    """Return the seconds and the places that `goals_text` has said.

    Raises:
        ValueError: it has not said this.
    """
    match = _match(_GOALS, text)
    places = match[2].split(" ")
    return float(match[1]), tuple(
        None if place == UNKNOWN else number_in(place) for place in places
    )


def passed_text(passed: Passed) -> str:
    """Say how many motors have answered so far."""
    return f"{len(passed.present)} motors so far"


def moved_text(moved: Moved) -> str:
    """Say that the answer is whole, and how long it took."""
    return f"all motors in {moved.seconds:.6f} s"


def read_present(text: str) -> tuple[int | None, float]:
    """Return how many motors have answered, and after how many seconds all had: `None` and those.

    Raises:
        ValueError: it is not what `passed_text` or `moved_text` say.
    """
    if match := _SO_FAR.fullmatch(text):
        return int(match[1]), 0.0
    return None, float(_match(_ALL, text)[1])


def speeds_text(held: SpeedsHeld) -> str:
    """Say what was asked of the servos; what they hold stands in columns."""
    return f"asked for {_numbers(held.requested)}"


def read_speeds(text: str) -> tuple[int, ...]:
    """Return what `speeds_text` has said was asked.

    Raises:
        ValueError: it has not said this.
    """
    return tuple(map(number_in, _match(_ASKED, text)[1].split(" ")))


def step_text(begun: StepBegun) -> str:
    """Say of which part and round a step is, and how late; its number has a column."""
    return f"{begun.part}, round {begun.round + 1}, {begun.late:.3f} s late"


def read_step(text: str) -> tuple[str, int, float]:
    """Return part, round from 0 on, and lateness (s).

    Raises:
        ValueError: it is not what `step_text` says.
    """
    match = _match(_STEP, text)
    return match[1], int(match[2]) - 1, float(match[3])


def stuck_text(stuck: Stuck) -> str:
    """Say what the robot waits for."""
    return "does not answer" if stuck.motor is None else f"waits for motor {stuck.motor}"


def read_stuck(text: str) -> int | None:
    """Return the motor that is waited for; `None` where the robot did not answer at all.

    Raises:
        ValueError: it is not what `stuck_text` says.
    """
    match = _match(_STUCK, text)
    return None if match[1] is None else int(match[1])


def restart_text(restarted: Restarted) -> str:
    """Say whether something was pending."""
    return "broke off what was pending" if restarted.voided else ""


def read_restart(text: str) -> bool:
    """Return whether something was pending."""
    return bool(text)


def ending_text(ended: PlayEnded) -> str:
    """Say why nothing is played any more, in a word."""
    return ended.why.name.lower()


def read_ending(text: str) -> Ending:
    """Return why nothing is played any more.

    Raises:
        ValueError: it is not what `ending_text` says.
    """
    for why in Ending:
        if why.name.lower() == text:
            return why
    raise ValueError(f"the text {text!r} says nothing of this record")


def _match(pattern: re.Pattern[str], text: str) -> re.Match[str]:
    match = pattern.fullmatch(text)
    if match is None:
        raise ValueError(f"the text {text!r} says nothing of this record")
    return match


def _numbers(values: Sequence[int]) -> str:
    return " ".join(map(str, values))
