"""What was asked of a session and has no outcome yet."""

from collections import deque
from collections.abc import Callable

from trex_gui.aracna.link.messages import Drag, Move, Play, Report, Request, SetLed, SetSpeeds
from trex_gui.link.messages import Outcome
from trex_gui.protocol.errors import TrexError

Job = Move | SetSpeeds | SetLed
"""One line to the robot, with one answer."""


class Waiting:
    """Jobs first come first served, the one that is on its way, and the newest drag.

    Every job gets its outcome through here, and exactly one.

    Attributes:
        drag: the newest that was not sent yet.
    """

    def __init__(self, tell: Callable[[Report], None]) -> None:
        self.drag: Drag | None = None
        self._tell = tell
        self._jobs: deque[Job] = deque()
        self._sent: Job | None = None

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

    def add(self, job: Job) -> None:
        """Let a job wait."""
        self._jobs.append(job)

    def take_drag(self) -> tuple[int, ...]:
        """Return where the newest drag goes; it waits no more."""
        drag, self.drag = self.drag, None
        return () if drag is None else drag.goals

    def send(self, send: Callable[[Job], None]) -> None:
        """Hand the first job to what sends it; what that refuses is its outcome."""
        self._sent = self._jobs.popleft()
        try:
            send(self._sent)
        except ValueError as error:  # a BadRequest; whatever else comes ends the line
            self.answer(error=error if isinstance(error, TrexError) else TrexError(str(error)))

    def answer(self, value: object = None, error: TrexError | None = None) -> None:
        """End the job that is on its way, if one is."""
        job, self._sent = self._sent, None
        if job is not None:
            self._tell(Outcome(job.id, value, error))

    def refuse(self, request: Request | None, error: TrexError) -> None:
        """End a request that never waited; some have no outcome."""
        if isinstance(request, Move | SetSpeeds | SetLed | Play):
            self._tell(Outcome(request.id, error=error))

    def drop(self, reason: TrexError) -> None:
        """Let nothing of what waits be sent; the job that is on its way goes on."""
        self.drag = None
        jobs, self._jobs = self._jobs, deque()
        for job in jobs:
            self._tell(Outcome(job.id, error=reason))
