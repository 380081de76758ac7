"""A session in a thread of its own, driven from a plain program line by line."""

import itertools
from collections.abc import Callable, Iterator
from types import TracebackType
from typing import Self

from trex_gui.core.cli.console import CommandFailed
from trex_gui.core.cli.host import host
from trex_gui.core.cli.options import required_port
from trex_gui.core.errors import StudioError
from trex_gui.core.session.messages import Close, Closed, Outcome
from trex_gui.core.session.request_queue import RequestQueue
from trex_gui.core.timing import Timeouts
from trex_gui.core.transport.settings import PortSettings
from trex_gui.devices.aracna.session.client import LINE
from trex_gui.devices.aracna.session.messages import (
    Connected,
    NotResponding,
    Report,
    Request,
    Stuck,
)
from trex_gui.devices.aracna.session.session import AracnaSession

_LOOK = 0.1
"""Seconds between two looks whether the program was asked to end."""


def settings_of(port: str | None, patience: float) -> PortSettings:
    """Return how to reach a robot.

    Raises:
        Usage: no port is given.
    """
    return PortSettings(required_port(port), LINE, timeouts=Timeouts(extra=patience))


class Talk:
    """One open line to a robot that has answered.

    Attributes:
        robot: what it has said of itself.
    """

    robot: Connected

    def __init__(
        self,
        settings: PortSettings,
        hear: Callable[[Report], None] = lambda _report: None,
        interrupted: Callable[[], bool] = lambda: False,
    ) -> None:
        """Prepare a line.

        Args:
            settings: how to reach the robot.
            hear: is given every report.
            interrupted: whether not to go on, where nothing was sent yet.
        """
        self._host = host()
        self._inbox = RequestQueue(self._host.condition())
        self._reports = RequestQueue(self._host.condition())
        self._ids = itertools.count(1)
        self._hear = hear
        self._interrupted = interrupted
        self._session = AracnaSession(
            settings, self._inbox, self._reports.put, self._host.open_transport
        )

    def __enter__(self) -> Self:
        """Open the line.

        Raises:
            Refused: the port cannot be opened, no Aracna answers, or it was asked not to go on.
        """
        self._join = self._host.start_thread(self._session.run)
        try:
            for report in self._heard(self._may_go_on):
                if isinstance(report, Connected):
                    self.robot = report
                    break
        except BaseException:
            self._close()
            raise
        return self

    def _may_go_on(self) -> None:
        if self._interrupted():
            raise CommandFailed("Broken off before anything was sent.")

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        """Give the port back."""
        self._close()

    def _close(self) -> None:
        self._inbox.put(Close())
        self._join()

    def tell(self, request: Request) -> None:
        """Hand a request to the session and wait for nothing."""
        self._inbox.put(request)

    def next_id(self) -> int:
        """Return a number that no request has yet."""
        return next(self._ids)

    def follow(self, is_over: Callable[[], bool]) -> None:
        """Hear reports until something has come of them.

        Raises:
            Refused: the line is lost, or the robot waits for a motor that does not arrive.
        """
        for report in self._heard():
            _complain(report)
            if is_over():
                return

    def wait(self, number: int, look: Callable[[], None] = lambda: None) -> object:
        """Return what came of a request; `look` is called every tenth of a second.

        Raises:
            Refused: it went wrong, or the robot waits for a motor that does not arrive.
        """
        for report in self._heard(look):
            match report:
                case Outcome(id=of, value=value, error=error) if of == number:
                    if error is not None:
                        raise CommandFailed(error) from error
                    return value
                case _:
                    _complain(report)
        raise AssertionError  # the reports end with `Closed`, which is an error

    def _heard(self, look: Callable[[], None] = lambda: None) -> Iterator[Report]:
        while True:
            look()
            report = self._reports.get(_LOOK)
            if report is None:
                continue
            if isinstance(report, Closed):
                error = report.error or StudioError("The line was closed.")
                raise CommandFailed(error) from error
            self._hear(report)
            yield report


def _complain(report: Report) -> None:
    match report:
        case Stuck(motor=motor):
            raise CommandFailed(_stuck(motor))
        case NotResponding(error=reason):
            raise CommandFailed(reason)
        case _:
            pass


def _stuck(motor: int | None) -> str:
    if motor is None:
        return "The robot does not answer any more. Its motors may go on to their goals."
    return (
        f"The robot waits for motor {motor}, which does not arrive: it is blocked, has no power or "
        "does not answer, or the board itself has no power. Until it arrives, or the board is "
        "reset, the robot reads nothing. "
        "Only servo power stops its motors."
    )
