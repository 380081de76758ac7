"""Motions of the command line: reported motor by motor, and clear about what stops them."""

from collections.abc import Callable, Sequence

from trex_gui.core.cli import CommandFailed, Interruption, UsageError, say
from trex_gui.devices.aracna.cli.session import CommandSession
from trex_gui.devices.aracna.protocol.joints import factory_limits
from trex_gui.devices.aracna.protocol.units import degrees
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

NEAR = 10
"""Units off its goal within which a motor has reached it: servos stop within a margin."""

NO_STOP = (
    "Nothing on this link stops a running motion: the motors continue to their goals, "
    "{0:.1f} s at most. Only servo power stops them. Ctrl-C again exits without waiting."
)


class MotionMonitor:
    """Reports the running motion to the user, and halts the robot on an interruption.

    Attributes:
        is_moving: whether the end of a motion is awaited.
        halted: whether the program was interrupted.
        moved: the last complete motion.
        faults: what went wrong, as sentences.
    """

    def __init__(self, interrupted: Interruption, *, motors: bool = True) -> None:
        """Report each motor's arrival if `motors` is set, else each step."""
        self._interrupted = interrupted
        self._motors = motors
        self._reported = 0
        self._expected = 0.0
        self.is_moving = False
        self.halted = False
        self.moved: Moved | None = None
        self.faults: list[str] = []

    def take(self, report: Report) -> None:
        match report:
            case Moving(expected=expected):
                self._reported, self.is_moving, self._expected = 0, True, expected
                if self.halted:  # it had been sent already
                    say(NO_STOP.format(expected))
            case Passed(present=present) if self._motors:
                self._report_motors(present)
            case Moved(goals=goals, present=present):
                self.is_moving, self.moved = False, report
                faults = _missed_goals(goals, present)
                self.faults += [fault for fault in faults if fault not in self.faults]
                if self._motors:
                    self._report_motors(present)
            case StepBegun(part=part, index=index, round=number, late=late) if not self._motors:
                where = "blend in" if part == "in" else f"round {number + 1}, step {index + 1}"
                say(f"{where}{f', {late:.2f} s late' if late >= 0.05 else ''}")
            case _:
                pass

    def _report_motors(self, present: Sequence[int]) -> None:
        for motor in range(self._reported, len(present)):
            position = present[motor]
            say(f"motor {motor}: {position if position >= 0 else 'could not be read (-1)'}")
        self._reported = len(present)

    def interruption_check(self, session: CommandSession) -> Callable[[], None]:
        """Return a function that halts the robot once when the program is interrupted."""

        def check() -> None:
            if self._interrupted and not self.halted:
                self.halted = True
                session.submit(Halt())
                state = NO_STOP.format(self._expected) if self.is_moving else "Nothing is moving."
                say(f"Nothing more is sent. {state}")

        return check


def _missed_goals(goals: Sequence[int], present: Sequence[int]) -> list[str]:
    faults = []
    for motor, (goal, position) in enumerate(zip(goals, present, strict=True)):
        if position < 0:
            faults.append(f"Motor {motor}: its position could not be read (-1).")
        elif abs(position - goal) > NEAR:
            off = degrees(abs(position - goal))
            faults.append(f"Motor {motor} is at {position}, not at {goal} ({off:.0f}° off).")
    return faults


def check_limits(goals: Sequence[int]) -> None:
    """Raise a UsageError that names each motor with a position outside its limits."""
    wrong = [
        f"motor {motor} goes from {limit.low} to {limit.high}, not to {goal}"
        for motor, (goal, limit) in enumerate(zip(goals, factory_limits(len(goals)), strict=True))
        if not limit.allow(goal)
    ]
    if wrong:
        raise UsageError(f"Joint limits: {'; '.join(wrong)}. --no-limits lifts them.")


def set_speeds(session: CommandSession, speeds: Sequence[int]) -> list[str]:
    """Set every servo's speed; return what went wrong.

    Raises:
        CommandFailed: the robot does not answer.
    """
    number = session.next_id()
    session.submit(SetSpeeds(number, tuple(speeds)))
    reply = session.wait(number)
    assert isinstance(reply, SpeedsHeld)  # noqa: S101 - for the type checker
    faults = []
    for motor, (requested, held) in enumerate(zip(reply.requested, reply.held, strict=True)):
        if held < 0:
            faults.append(f"Motor {motor} does not answer (-1).")
        elif held != requested:
            faults.append(f"Motor {motor} holds speed {held}, not {requested}.")
    return faults


def move(
    session: CommandSession, monitor: MotionMonitor, goals: Sequence[int], speeds: Sequence[int]
) -> Moved:
    """Move every motor at a speed that every servo has confirmed, and wait.

    Raises:
        CommandFailed: the robot does not answer, waits for a motor, or a servo rejects its speed;
            or the program was interrupted before the motion began.
    """
    number = session.next_id()
    session.submit(Move(number, tuple(goals), tuple(speeds)))
    moved = session.wait(number, monitor.interruption_check(session))
    assert isinstance(moved, Moved)  # noqa: S101 - for the type checker
    return moved


def play(session: CommandSession, monitor: MotionMonitor, request: Play) -> None:
    """Play to the end, or until the program is interrupted and the robot has stopped moving.

    Raises:
        CommandFailed: the robot does not answer, or waits for a motor.
    """
    session.submit(request)
    session.wait(request.id, monitor.interruption_check(session))
    if monitor.is_moving:
        session.wait_until(lambda: not monitor.is_moving)


def report_faults(faults: Sequence[str]) -> None:
    for fault in faults:
        say(fault)
    if faults:
        raise CommandFailed("Not every motor did as commanded.")
