"""A robot and a session that is run from a script, in virtual time."""

from collections import deque
from collections.abc import Callable
from typing import Any, TypeVar

from tests.support.aracna import AracnaStage
from trex_gui.aracna.link.messages import Counted, Report, Request
from trex_gui.aracna.link.session import AracnaSession
from trex_gui.link.messages import Close
from trex_gui.link.settings import LinkSettings

KindT = TypeVar("KindT")

Act = Request | Callable[[], object]


class Scene:
    """What happens when, counted from when the session begins; the line closes in the end.

    An act is a request, or a function that is called: to turn a knob of the robot.
    """

    def __init__(self, *, booted: bool = True, **options: Any) -> None:
        self.stage = AracnaStage(booted=booted, **options)
        self.line = self.stage.line
        self.begun = self.line.now
        self.reports: list[Report] = []
        self.times: list[float] = []
        self._acts: deque[tuple[float, Act]] = deque()
        self._when: deque[tuple[Callable[[Report], bool], Act]] = deque()
        self._now: deque[Request] = deque()
        self._end = 0.0
        self._closed = False

    def at(self, time: float, act: Act) -> "Scene":
        """Do this so many seconds after the session has begun; times must not go back."""
        self._acts.append((self.begun + time, act))
        return self.until(time)

    def on(self, is_it: Callable[[Report], bool], act: Act) -> "Scene":
        """Do this on the first report of a kind; those that wait for one wait in order."""
        self._when.append((is_it, act))
        return self

    def until(self, time: float) -> "Scene":
        """Close no earlier."""
        self._end = max(self._end, self.begun + time)
        return self

    def run(self) -> list[Report]:
        """Run it all; return what was reported."""
        AracnaSession(
            LinkSettings("virtual"), self, self._hear, lambda _settings: self.stage.transport
        ).run()
        return self.reports

    def of(self, kind: type[KindT]) -> list[KindT]:
        """Return the reports of a kind."""
        return [report for report in self.reports if isinstance(report, kind)]

    def when(self, kind: type) -> list[float]:
        """Return when the reports of a kind came, in seconds since the session began."""
        return [
            time - self.begun
            for time, report in zip(self.times, self.reports, strict=True)
            if isinstance(report, kind)
        ]

    @property
    def kinds(self) -> list[str]:
        """Return the names of all reports, in order; counts are told whenever it is time."""
        return [type(report).__name__ for report in self.reports if not isinstance(report, Counted)]

    def get(self, seconds: float) -> Request | None:
        end = self.line.now + seconds
        while True:
            if self._now:
                return self._now.popleft()
            time, act = self._acts[0] if self._acts else (self._end, None)
            if self._closed or time > end:
                self.line.advance(end - self.line.now)
                return None
            self.line.advance(max(0.0, time - self.line.now))
            if act is None:
                self._closed = True
                return Close()
            self._acts.popleft()
            self._do(act)

    def _do(self, act: Act) -> None:
        if callable(act):
            act()
        else:
            self._now.append(act)

    def _hear(self, report: Report) -> None:
        self.reports.append(report)
        self.times.append(self.line.now)
        while self._when and self._when[0][0](report):
            self._do(self._when.popleft()[1])
            break
