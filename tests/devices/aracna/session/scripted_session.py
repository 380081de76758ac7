"""Scripted session with a simulated robot in virtual time."""

from collections import deque
from collections.abc import Callable
from typing import Any, TypeVar

from tests.support.aracna import AracnaHarness
from trex_gui.core.errors import StudioError
from trex_gui.core.session import Close, Outcome
from trex_gui.core.transport.settings import PortSettings
from trex_gui.devices.aracna.session.messages import LineStats, Report, Request
from trex_gui.devices.aracna.session.session import AracnaSession

KindT = TypeVar("KindT")

Action = Request | Callable[[], object] | str


class ScriptedSession:
    """Session that performs actions at set times and then closes.

    An action is a request, a control line of the robot, or a function.
    """

    def __init__(self, *, booted: bool = True, **options: Any) -> None:
        self.stage = AracnaHarness(booted=booted, **options)
        self.line = self.stage.line
        self.started_at = self.line.now
        self.reports: list[Report] = []
        self.times: list[float] = []
        self._actions: deque[tuple[float, Action]] = deque()
        self._when: deque[tuple[Callable[[Report], bool], Action]] = deque()
        self._due: deque[Request] = deque()
        self._end = 0.0
        self._closed = False

    def at(self, time: float, action: Action) -> "ScriptedSession":
        """Add an action at a time (s) after the start. Times must not decrease."""
        self._actions.append((self.started_at + time, action))
        return self.until(time)

    def on(self, matches: Callable[[Report], bool], action: Action) -> "ScriptedSession":
        """Add an action for the next matching report. Actions are performed in order."""
        self._when.append((matches, action))
        return self

    def until(self, time: float) -> "ScriptedSession":
        """Extend the session to a time (s) after the start."""
        self._end = max(self._end, self.started_at + time)
        return self

    def run(self) -> "ScriptedSession":
        AracnaSession(
            PortSettings("virtual"), self, self._record, lambda _settings: self.stage.transport
        ).run()
        return self

    def of(self, kind: type[KindT]) -> list[KindT]:
        return [report for report in self.reports if isinstance(report, kind)]

    def when(self, kind: type) -> list[float]:
        """Return the times of reports of a kind, in seconds since the start."""
        return [
            time - self.started_at
            for time, report in zip(self.times, self.reports, strict=True)
            if isinstance(report, kind)
        ]

    @property
    def errors(self) -> dict[int, StudioError | None]:
        """Error of each finished request, by id."""
        return {outcome.id: outcome.error for outcome in self.of(Outcome)}

    @property
    def kinds(self) -> list[str]:
        """Return the names of all reports in order, except `LineStats`."""
        return [
            type(report).__name__ for report in self.reports if not isinstance(report, LineStats)
        ]

    def get(self, seconds: float) -> Request | None:
        end = self.line.now + seconds
        while True:
            if self._due:
                return self._due.popleft()
            time, action = self._actions[0] if self._actions else (self._end, None)
            if self._closed or time > end:
                self.line.advance(end - self.line.now)
                return None
            self.line.advance(max(0.0, time - self.line.now))
            if action is None:
                self._closed = True
                return Close()
            self._actions.popleft()
            self._do(action)

    def _do(self, action: Action) -> None:
        if isinstance(action, str):
            self.stage.do(action)
        elif callable(action):
            action()
        else:
            self._due.append(action)

    def _record(self, report: Report) -> None:
        self.reports.append(report)
        self.times.append(self.line.now)
        if self._when and self._when[0][0](report):
            self._do(self._when.popleft()[1])
