"""Requests of a session that have no outcome yet."""

from collections import deque
from collections.abc import Callable
from dataclasses import replace
from typing import TypeVar

from trex_gui.core.errors import StudioError
from trex_gui.core.session import Outcome
from trex_gui.devices.aracna.session.errors import ErrorCode, RobotError
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
"""A request with one outcome: one command, and before a `Move` possibly its speeds."""

JobT = TypeVar("JobT", Move, Drag, Job, "Job | Drag")


class JobQueue:
    """Queued jobs in order, the one in flight, and the newest drag that was not sent yet.

    Every job gets exactly one outcome, reported here. `is_setting_speeds`: only the speeds of the
    motion in flight were sent.
    """

    def __init__(self, report: Callable[[Report], None]) -> None:
        self.drag: Drag | None = None
        self.is_setting_speeds = False
        self._report = report
        self._jobs: deque[Job] = deque()
        self._in_flight: Job | Drag | None = None

    def __bool__(self) -> bool:
        return self.has_queued or self._in_flight is not None

    @property
    def has_queued(self) -> bool:
        return bool(self._jobs) or self.drag is not None

    @property
    def has_jobs(self) -> bool:
        return bool(self._jobs)

    def add(self, job: Job) -> None:
        """Queue a job; the requests that it makes obsolete are dropped."""
        if isinstance(job, SetSpeeds):
            self._replace_speeds(job.speeds)
        if isinstance(job, Move):
            self.drop_drag()
        self._jobs.append(job)

    def drop_drag(self) -> None:
        """Forget the newest drag: another motion replaces it."""
        self.drag = None
        if isinstance(self._in_flight, Drag):
            self._in_flight, self.is_setting_speeds = None, False

    def _replace_speeds(self, speeds: tuple[int, ...]) -> None:
        jobs, self._jobs = self._jobs, deque()
        for job in jobs:
            if isinstance(job, SetSpeeds):
                self._report(Outcome(job.id, error=RobotError(ErrorCode.SUPERSEDED)))
            else:
                self._jobs.append(_with_speeds(job, speeds))
        if self.drag is not None:
            self.drag = _with_speeds(self.drag, speeds)
        if self.is_setting_speeds and self._in_flight is not None:
            self._in_flight = _with_speeds(self._in_flight, speeds)

    def send_next(self, send: Callable[[Job | Drag], bool]) -> None:
        """Send the first job, else the newest drag; a ValueError of `send` is its outcome.

        `send` returns whether it sent only the speeds of a motion, which is then sent again.
        """
        job: Job | Drag | None
        if self._jobs:
            job = self._jobs.popleft()
        else:
            job, self.drag = self.drag, None
        if job is None:
            return
        self._in_flight = job
        try:
            self.is_setting_speeds = send(job)
        except ValueError as error:  # a BadRequest; any other error ends the session
            self.finish(error=error if isinstance(error, StudioError) else StudioError(str(error)))
            return
        if isinstance(job, Drag) and not self.is_setting_speeds:
            self._in_flight = None

    def on_speeds_set(self) -> None:
        """Send the motion in flight next, unless a newer one has replaced it."""
        job, self._in_flight = self._in_flight, None
        self.is_setting_speeds = False
        if isinstance(job, Drag):
            self.drag = self.drag or job
        elif job is not None:
            self._jobs.appendleft(job)

    def finish(self, value: object = None, error: StudioError | None = None) -> bool:
        """End the request in flight; return whether there was one.

        A rejected drag takes the ones that replaced it along, so that it is reported once.
        """
        job, self._in_flight = self._in_flight, None
        self.is_setting_speeds = False
        if isinstance(job, Drag):
            self.drag = None
            if error is not None:
                self.reject_drag(job, error)
        elif job is not None:
            self._report(Outcome(job.id, value, error))
        return job is not None

    def reject(self, request: Request | None, error: StudioError) -> None:
        """Report the outcome of a request that was never queued, if it has one."""
        if isinstance(request, Move | SetSpeeds | SetLed | Play):
            self._report(Outcome(request.id, error=error))

    def reject_drag(self, drag: Drag, error: StudioError) -> None:
        self._report(DragDropped(drag.goals, error))

    def drop(self, reason: StudioError) -> None:
        """Drop everything queued, and a motion in flight of which only the speeds were sent."""
        self.drop_drag()
        if self.is_setting_speeds:
            self.finish(error=reason)
        jobs, self._jobs = self._jobs, deque()
        for job in jobs:
            self._report(Outcome(job.id, error=reason))


def _with_speeds(job: JobT, speeds: tuple[int, ...]) -> JobT:
    if isinstance(job, Move | Drag) and job.speeds is not None:
        return replace(job, speeds=speeds)
    return job
