"""One sequence: poses by name, each with the time in which it is to be reached."""

from dataclasses import dataclass

SHORTEST_MS = 1
LONGEST_MS = 3_600_000
"""An hour; PyPose itself offers up to 5000 ms."""

USUAL_MS = 500
"""What PyPose proposes for a step."""


def can_be_named(pose_name: str) -> bool:
    """Whether a step can name a pose: a file parts steps by commas, and their times by bars."""
    return not any(sign in pose_name for sign in ",|\r\n")


@dataclass(frozen=True, slots=True)
class SequenceStep:
    """Reach the pose of a name in so many milliseconds (1 to an hour)."""

    pose_name: str
    milliseconds: int = USUAL_MS

    def __post_init__(self) -> None:
        """Refuse what no file can hold.

        Raises:
            ValueError: the time is out of range, or the name has a comma, a bar or a line end.
        """
        if not can_be_named(self.pose_name):
            name = self.pose_name
            raise ValueError(f"a step names a pose without comma, bar or line end, unlike {name!r}")
        if not SHORTEST_MS <= self.milliseconds <= LONGEST_MS:
            raise ValueError(
                f"a step takes {SHORTEST_MS} to {LONGEST_MS} ms, not {self.milliseconds}"
            )


@dataclass(frozen=True, slots=True)
class Sequence:
    """Steps by name; the name has no colon and no line end, for a file's sake."""

    name: str
    steps: tuple[SequenceStep, ...] = ()

    def __post_init__(self) -> None:
        """Refuse what no file can hold.

        Raises:
            ValueError: the name has a colon or a line end.
        """
        if any(sign in self.name for sign in ":\r\n"):
            raise ValueError(
                f"a sequence's name has no colon and no line end, unlike {self.name!r}"
            )

    @property
    def seconds(self) -> float:
        """How long all steps take together, where every motor makes it in time."""
        return sum(step.milliseconds for step in self.steps) / 1000
