"""Moves of the command line: watched motor by motor, and honest about what stops them."""

from collections.abc import Callable, Sequence

from trex_gui.core.cli.console import CommandFailed, Interruption, UsageError, say
from trex_gui.devices.aracna.cli.format import amiss_after_move, amiss_after_speeds
from trex_gui.devices.aracna.cli.session import Talk
from trex_gui.devices.aracna.protocol.joints import factory_limits
from trex_gui.devices.aracna.session.messages import (
    Halt,
    Move,
    Moved,
    Moving,
    Passed,
    Play,
    Report,
    SetSpeeds,
    SpeedsHeld,
    StepBegun,
)

HALTED = "Nothing more is sent. "

NO_STOP = (
    "Nothing on this link stops a motion that runs: the motors go on to where they were "
    "sent{rest}. Only servo power stops them. Ctrl-C again leaves without waiting."
)


class Watch:
    """Tells a person how the motion that runs goes, and what an interruption means for it."""

    def __init__(self, interrupted: Interruption, *, motors: bool = True) -> None:
        self._interrupted = interrupted
        self._motors = motors
        self._told = 0
        self._runs = False
        self._expected = 0.0
        self.halted = False
        self.moved: Moved | None = None
        self.amiss: list[str] = []

    def hear(self, report: Report) -> None:
        """Take a report of the session."""
        match report:
            case Moving(expected=expected):
                self._told, self._runs, self._expected = 0, True, expected
                if self.halted:  # it was on its way already
                    say(self._no_stop())
            case Passed(present=present) if self._motors:
                self._tell(present)
            case Moved(goals=goals, present=present):
                self._runs, self.moved = False, report
                told = amiss_after_move(goals, present)
                self.amiss += [sentence for sentence in told if sentence not in self.amiss]
                if self._motors:
                    self._tell(present)
            case StepBegun(part=part, index=index, round=number, late=late) if not self._motors:
                where = "blend in" if part == "in" else f"round {number + 1}, step {index + 1}"
                lateness = f", {late:.2f} s late" if late >= 0.05 else ""
                say(f"{where}{lateness}")
            case _:
                pass

    def _tell(self, present: Sequence[int]) -> None:
        for motor in range(self._told, len(present)):
            place = present[motor]
            say(f"motor {motor}: {place if place >= 0 else 'could not be read (-1)'}")
        self._told = len(present)

    @property
    def runs(self) -> bool:
        """Whether a motion does whose end was not told yet."""
        return self._runs

    def look(self, talk: Talk) -> Callable[[], None]:
        """Return what notices that the program was asked to end, and halts the robot once."""

        def look() -> None:
            if self._interrupted and not self.halted:
                self.halted = True
                talk.tell(Halt())
                say(HALTED + (self._no_stop() if self._runs else "No motion runs."))

        return look

    def _no_stop(self) -> str:
        return NO_STOP.format(rest=f", {self._expected:.1f} s at most")


def check_limits(goals: Sequence[int]) -> None:
    """Refuse positions that a joint may not take.

    Raises:
        Usage: names each motor and its limits.
    """
    limits = factory_limits(len(goals))
    wrong = [
        f"motor {motor} goes from {limit.low} to {limit.high}, not to {goal}"
        for motor, (goal, limit) in enumerate(zip(goals, limits, strict=True))
        if not limit.allow(goal)
    ]
    if wrong:
        raise UsageError(f"Joint limits: {'; '.join(wrong)}. --no-limits lifts them.")


def set_speeds(talk: Talk, speeds: Sequence[int]) -> list[str]:
    """Give every servo a speed; return what is amiss.

    Raises:
        Refused: the robot does not answer.
    """
    number = talk.next_id()
    talk.tell(SetSpeeds(number, tuple(speeds)))
    held = talk.wait(number)
    assert isinstance(held, SpeedsHeld)  # noqa: S101 - for the type checker
    return amiss_after_speeds(held.requested, held.held)


def move(talk: Talk, watch: Watch, goals: Sequence[int], speeds: Sequence[int]) -> Moved:
    """Send every motor to a goal, at a speed that every servo has taken, and wait.

    Raises:
        Refused: the robot does not answer, waits for a motor, or a servo refuses its speed; or it
            was asked not to go on before the motion began.
    """
    number = talk.next_id()
    talk.tell(Move(number, tuple(goals), tuple(speeds)))
    moved = talk.wait(number, watch.look(talk))
    assert isinstance(moved, Moved)  # noqa: S101 - for the type checker
    return moved


def play(talk: Talk, watch: Watch, wanted: Play) -> None:
    """Play something to its end, or until the program is asked to end and the robot is still.

    Raises:
        Refused: the robot does not answer, or waits for a motor.
    """
    talk.tell(wanted)
    talk.wait(wanted.id, watch.look(talk))
    if watch.runs:
        talk.follow(lambda: not watch.runs)


def conclude(amiss: Sequence[str]) -> None:
    """Tell what is amiss.

    Raises:
        Refused: something is.
    """
    for sentence in amiss:
        say(sentence)
    if amiss:
        raise CommandFailed("Not every motor did as it was told.")
