"""A session driven from a command, and what list and find report of an Aracna."""

import itertools
from collections.abc import Callable, Iterator, Mapping
from typing import Any, Self

from trex_gui.core.cli import CommandFailed, required_port
from trex_gui.core.discovery.prober import Evidence
from trex_gui.core.errors import StudioError
from trex_gui.core.host import host
from trex_gui.core.plugin import PortAnswer, PortReports
from trex_gui.core.session import Close, Closed, Outcome, RequestQueue
from trex_gui.core.timing import Timeouts
from trex_gui.core.transport.settings import PortSettings
from trex_gui.devices.aracna.discovery import FoundRobot, find_aracna
from trex_gui.devices.aracna.session.client import LINE
from trex_gui.devices.aracna.session.messages import (
    Connected,
    NotResponding,
    Report,
    Request,
    Stuck,
)
from trex_gui.devices.aracna.session.session import AracnaSession

_CHECK_INTERVAL = 0.1
"""Seconds between two checks for an interruption."""


def port_settings(port: str | None, extra_time: float) -> PortSettings:
    """Return the settings of a robot's port; UsageError if no port is given."""
    return PortSettings(required_port(port), LINE, timeouts=Timeouts(extra=extra_time))


class CommandSession:
    """An open line to a robot that has answered; `robot` is its answer.

    Its methods raise CommandFailed if the line is lost or the robot waits for a motor.
    """

    robot: Connected

    def __init__(
        self,
        settings: PortSettings,
        on_report: Callable[[Report], None] = lambda _report: None,
        interrupted: Callable[[], bool] = lambda: False,
    ) -> None:
        """Prepare a line; `interrupted` ends the attempt to connect."""
        self._host = host()
        self._inbox = RequestQueue(self._host.condition())
        self._reports = RequestQueue(self._host.condition())
        self._ids = itertools.count(1)
        self._on_report = on_report
        self._interrupted = interrupted
        self._session = AracnaSession(
            settings, self._inbox, self._reports.put, self._host.open_transport
        )

    def __enter__(self) -> Self:
        """Connect; CommandFailed if that fails or was interrupted."""
        self._join = self._host.start_thread(self._session.run)
        try:
            for report in self._received(self._check_interruption):
                if isinstance(report, Connected):
                    self.robot = report
                    break
        except BaseException:
            self._close()
            raise
        return self

    def _check_interruption(self) -> None:
        if self._interrupted():
            raise CommandFailed("Cancelled before anything was sent.")

    def __exit__(self, *_: object) -> None:
        self._close()

    def _close(self) -> None:
        self._inbox.put(Close())
        self._join()

    def submit(self, request: Request) -> None:
        self._inbox.put(request)

    def next_id(self) -> int:
        return next(self._ids)

    def wait_until(self, condition: Callable[[], bool]) -> None:
        for report in self._received():
            _check(report)
            if condition():
                return

    def wait(self, number: int, check: Callable[[], None] = lambda: None) -> object:
        """Return the outcome of a request; `check` is called every tenth of a second."""
        for report in self._received(check):
            match report:
                case Outcome(id=of, value=value, error=error) if of == number:
                    if error is not None:
                        raise CommandFailed(error) from error
                    return value
                case _:
                    _check(report)
        raise AssertionError  # the reports end with `Closed`, which is an error

    def _received(self, check: Callable[[], None] = lambda: None) -> Iterator[Report]:
        while True:
            check()
            report = self._reports.get(_CHECK_INTERVAL)
            if report is None:
                continue
            if isinstance(report, Closed):
                error = report.error or StudioError("The line was closed.")
                raise CommandFailed(error) from error
            self._on_report(report)
            yield report


def _check(report: Report) -> None:
    match report:
        case Stuck(motor=None):
            raise CommandFailed(
                "The robot no longer answers. Its motors may continue to their goals."
            )
        case Stuck(motor=motor):
            raise CommandFailed(
                f"The robot waits for motor {motor}, which does not arrive: it is blocked, has no "
                "power or does not answer, or the board itself has no power. Until it arrives, or "
                "the board is reset, the robot reads nothing. Only servo power stops its motors."
            )
        case NotResponding(error=error):
            raise CommandFailed(error)
        case _:
            pass


def _identify(url: str, options: Mapping[str, Any]) -> PortAnswer:
    settings = PortSettings(url, timeouts=Timeouts(extra=options["extra_timeout"]))
    search = find_aracna(settings, open_wire=host().open_transport)
    if search.found:
        [found] = search.found
        text = f"{found.name}, {found.motors} motors"
        return PortAnswer(text, "Aracna", str(found.version.version))
    diagnosis = search.diagnosis()
    return PortAnswer(diagnosis.text if diagnosis.evidence > Evidence.ECHO else "")


def _describe(found: FoundRobot) -> str:
    text = f"{found.name}, {found.motors} motors, on {found.settings.text()}."
    return f"{text} {found.note}".strip()


def _row(found: FoundRobot) -> dict[str, Any]:
    """Return the same keys as for a TReX."""
    line = found.settings.line
    return {
        "port": found.settings.url,
        "product": "Aracna",
        "firmware": str(found.version.version),
        "baud": line.baud,
        "detection": line.parity.name.lower(),
        "polynomial": None,
        "stop_bits": line.stop_bits,
        "device_number": None,
        "echo": False,
        "note": found.note,
        "options": f"--port {found.settings.url}",
    }


PORT_REPORTS = PortReports(_identify, _describe, _row)
