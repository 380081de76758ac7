"""Problems of a channel that is learned, as codes. `problem_text` has their sentences."""

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
    """A problem. Nothing can be learned while a `fatal` one remains."""

    kind: ProblemKind
    variant: str = ""  # which of the sentences of this kind applies
    values: tuple[object, ...] = ()  # quantities that the sentence names, in its order
    fatal: bool = True


def has_fatal(problems: tuple[CalibrationProblem, ...]) -> bool:
    return any(problem.fatal for problem in problems)
