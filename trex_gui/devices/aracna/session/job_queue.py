"""Queue of requests that have no outcome yet."""

from collections import deque
from collections.abc import Callable
from dataclasses import replace

from trex_gui.core.errors import BadRequest, StudioError
from trex_gui.core.session import Outcome
from trex_gui.devices.aracna.session.errors import ErrorCode, RobotError
from trex_gui.devices.aracna.session.messages import Move, Play, Report, Request, SetLed, SetSpeeds

Job = Move | SetSpeeds | SetLed  # one command; a `Move` may send its speeds first


class JobQueue:
    """Queued jobs in order, and the job in flight.

    Every job gets exactly one outcome. `is_setting_speeds`: True while only the speeds of the
    motion in flight have been sent.
    """

    def __init__(self, report: Callable[[Report], None]) -> None:
        self.is_setting_speeds = False
        self._report = report
        self._queued: deque[Job] = deque()
        self._in_flight: Job | None = None

    def __bool__(self) -> bool:
        return self.has_queued or self._in_flight is not None

    @property
    def has_queued(self) -> bool:
        return bool(self._queued)

    def add(self, job: Job) -> None:
        """Queue a job.

        New speeds replace queued speeds and precede motions. A new motion replaces a queued motion.
        """
        superseded = [queued for queued in self._queued if type(queued) is type(job)]
        for queued in superseded if isinstance(job, Move | SetSpeeds) else ():
            self._queued.remove(queued)
            self._supersede(queued)
        if isinstance(job, SetSpeeds):
            self._queued = deque(_with_speeds(queued, job.speeds) for queued in self._queued)
            if self.is_setting_speeds and self._in_flight is not None:
                self._in_flight = _with_speeds(self._in_flight, job.speeds)
            self._queued.appendleft(job)
        else:
            self._queued.append(job)

    def _supersede(self, job: Job) -> None:
        self._report(Outcome(job.id, error=RobotError(ErrorCode.SUPERSEDED)))

    def send_next(self, send: Callable[[Job], bool]) -> None:
        """Send the first job. A BadRequest from `send` becomes the outcome of the job.

        `send` returns True if it sent only the speeds of a motion. The goals then follow.
        """
        self._in_flight = job = self._queued.popleft()
        try:
            self.is_setting_speeds = send(job)
        except BadRequest as error:  # any other error ends the session
            self.finish(error=error)

    def on_speeds_set(self) -> None:
        """Queue the motion in flight as the next job, unless it was replaced."""
        job, self._in_flight = self._in_flight, None
        self.is_setting_speeds = False
        if job is not None and any(isinstance(queued, Move) for queued in self._queued):
            self._supersede(job)
        elif job is not None:
            self._queued.appendleft(job)

    def finish(self, value: object = None, error: StudioError | None = None) -> bool:
        """End the job in flight. Return False if no job was in flight."""
        job, self._in_flight = self._in_flight, None
        self.is_setting_speeds = False
        if job is not None:
            self._report(Outcome(job.id, value, error))
        return job is not None

    def reject(self, request: Request | None, error: StudioError) -> None:
        if isinstance(request, Job | Play):
            self._report(Outcome(request.id, error=error))

    def drop(self, reason: StudioError) -> None:
        """Drop queued jobs, and a motion whose goals were not sent."""
        if self.is_setting_speeds:
            self.finish(error=reason)
        jobs, self._queued = self._queued, deque()
        for job in jobs:
            self._report(Outcome(job.id, error=reason))


def _with_speeds(job: Job, speeds: tuple[int, ...]) -> Job:
    if isinstance(job, Move) and job.speeds is not None:
        return replace(job, speeds=speeds)
    return job
