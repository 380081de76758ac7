"""What was asked of a session and has no outcome yet."""

from collections import deque
from collections.abc import Callable
from dataclasses import replace
from typing import TypeVar

from trex_gui.core.errors import StudioError
from trex_gui.core.session.messages import Outcome
from trex_gui.devices.aracna.session.messages import (
    Drag,
    DragDropped,
    Move,
    Play,
    Report,
    Request,
    SetLed,
    SetSpeeds,
)

Job = Move | SetSpeeds | SetLed
"""What has one outcome. A line to the robot, and before a `Move` perhaps one with its speeds."""

JobT = TypeVar("JobT", Move, SetLed, Drag, Job, "Job | Drag")


class RequestQueue:
    """Jobs first come first served, the one that is on its way, and the newest drag.

    Every job gets its outcome through here, and exactly one.

    Attributes:
        drag: the newest that was not sent yet.
    """

    def __init__(self, tell: Callable[[Report], None], clock: Callable[[], float]) -> None:
        self.drag: Drag | None = None
        self._tell = tell
        self._clock = clock
        self._jobs: deque[Job] = deque()
        self._sent: Job | Drag | None = None
        self._prepares = False  # only the speeds of what was sent are on their way

    def __bool__(self) -> bool:
        """Whether anything waits or is on its way."""
        return self.has_more or self._sent is not None

    @property
    def has_more(self) -> bool:
        """Whether anything waits to be sent."""
        return bool(self._jobs) or self.drag is not None

    @property
    def has_jobs(self) -> bool:
        """Whether a job waits to be sent."""
        return bool(self._jobs)

    @property
    def is_preparing(self) -> bool:
        """Whether what is on its way are the speeds of a motion."""
        return self._prepares

    def add(self, job: Job) -> None:
        """Let a job wait; what it makes obsolete waits no more."""
        if isinstance(job, SetSpeeds):
            self._change_speeds(job)
        if isinstance(job, Move):
            self.drop_drag()
        self._jobs.append(job)

    def drop_drag(self) -> None:
        """Somebody wants something else than to go where was dragged to."""
        self.drag = None
        if isinstance(self._sent, Drag):
            self._sent, self._prepares = None, False

    def _change_speeds(self, job: SetSpeeds) -> None:
        """Let all that waits go at the newest speeds."""
        jobs, self._jobs = self._jobs, deque()
        for one in jobs:
            if isinstance(one, SetSpeeds):
                self._tell(Outcome(one.id, error=StudioError("Other speeds were chosen since.")))
            else:
                self._jobs.append(_at(one, job.speeds))
        if self.drag is not None:
            self.drag = _at(self.drag, job.speeds)
        if self._prepares and self._sent is not None:
            self._sent = _at(self._sent, job.speeds)

    def send(self, send: Callable[[Job | Drag], bool]) -> None:
        """Hand the first job to what sends it; what that refuses is its outcome.

        `send` returns whether only the speeds of a motion went out; it is to be sent again then.
        """
        self._hand(self._jobs.popleft(), send)

    def send_drag(self, send: Callable[[Job | Drag], bool]) -> None:
        """Hand the newest drag to what sends it."""
        drag, self.drag = self.drag, None
        if drag is not None:
            self._hand(drag, send)

    def _hand(self, job: Job | Drag, send: Callable[[Job | Drag], bool]) -> None:
        self._sent = job
        try:
            self._prepares = send(job)
        except ValueError as error:  # a BadRequest; whatever else comes ends the line
            self.answer(error=error if isinstance(error, StudioError) else StudioError(str(error)))
            return
        if isinstance(job, Drag) and not self._prepares:
            self._sent = None

    def go_on(self) -> None:
        """The speeds of a motion are set: it is sent next, where no newer one takes its place."""
        job, self._sent = self._sent, None
        self._prepares = False
        if isinstance(job, Drag):
            self.drag = self.drag or job
        elif job is not None:
            self._jobs.appendleft(job)

    def answer(self, value: object = None, error: StudioError | None = None) -> bool:
        """End what is on its way; return whether there was anything.

        With a drag that is not sent go those that replaced it: it is told once.
        """
        job, self._sent = self._sent, None
        self._prepares = False
        if isinstance(job, Drag):
            self.drag = None
            if error is not None:
                self.refuse_drag(job, error)
        elif job is not None:
            self._tell(Outcome(job.id, value, error))
        return job is not None

    def refuse(self, request: Request | None, error: StudioError) -> None:
        """End a request that never waited; some have no outcome."""
        if isinstance(request, Move | SetSpeeds | SetLed | Play):
            self._tell(Outcome(request.id, error=error))

    def refuse_drag(self, drag: Drag, error: StudioError) -> None:
        """Tell that a drag is not sent."""
        self._tell(DragDropped(self._clock(), drag.goals, error))

    def drop(self, reason: StudioError) -> None:
        """Let nothing of what waits be sent; the job that is on its way goes on.

        A motion of which only the speeds are on their way is not.
        """
        self.drop_drag()
        if self._prepares:
            self.answer(error=reason)
        jobs, self._jobs = self._jobs, deque()
        for job in jobs:
            self._tell(Outcome(job.id, error=reason))


def _at(job: JobT, speeds: tuple[int, ...]) -> JobT:
    """Return a motion that goes at other speeds, where it goes at any; else what it is."""
    if isinstance(job, Move | Drag) and job.speeds is not None:
        return replace(job, speeds=speeds)
    return job
