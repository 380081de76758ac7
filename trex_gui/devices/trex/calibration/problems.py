"""Codes of calibration problems. `problem_text` returns their sentences."""

from dataclasses import dataclass
from enum import Enum, auto


class ProblemKind(Enum):
    NO_SIGNAL = auto()
    MOVED = auto()
    JITTER = auto()
    NOISE = auto()
    NEVER_MOVED = auto()
    TOO_LITTLE = auto()
    ONE_DIRECTION = auto()
    END_TOO_NEAR = auto()
    NOT_HELD = auto()
    NEUTRAL_OUTSIDE = auto()
    UNEVEN = auto()
    REFUSED = auto()
    NEUTRAL_MOVED = auto()
    USELESS = auto()
    NEVER_FULL = auto()
    SPEEDS_UP = auto()
    SWITCHES_AT_REST = auto()
    NEVER_SWITCHES = auto()


@dataclass(frozen=True, slots=True)
class CalibrationProblem:
    """Problem of a channel. A `fatal` problem prevents a calibration."""

    kind: ProblemKind
    variant: str = ""  # selects a sentence of this kind
    values: tuple[object, ...] = ()  # values for the placeholders of the sentence
    fatal: bool = True


def has_fatal(problems: tuple[CalibrationProblem, ...]) -> bool:
    return any(problem.fatal for problem in problems)
