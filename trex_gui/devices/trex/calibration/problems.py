"""What can be wrong with a channel while it is learned, as codes; see `problem_text`."""

from dataclasses import dataclass
from enum import Enum, auto


class ProblemKind(Enum):
    """What is wrong."""

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
class Problem:
    """What is wrong; nothing can be learned while a `fatal` problem remains.

    Attributes:
        variant: which of the sentences of this kind applies.
        values: quantities that the sentence names, in its order.
    """

    kind: ProblemKind
    variant: str = ""
    values: tuple[object, ...] = ()
    fatal: bool = True


def has_fatal(problems: tuple[Problem, ...]) -> bool:
    """Whether nothing can be learned from what was measured."""
    return any(problem.fatal for problem in problems)
