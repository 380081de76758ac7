"""Session of a command, and reports on a port for `trexcmd list` and `trexcmd find`."""

import itertools
from collections.abc import Iterator, Mapping, Sequence
from typing import Any, Self

from trex_gui.core.cli import CommandFailed, Interruption, required_port, say
from trex_gui.core.discovery.prober import Evidence
from trex_gui.core.discovery.scan import scan_port
from trex_gui.core.errors import StudioError
from trex_gui.core.host import host
from trex_gui.core.plugin import PortAnswer, PortReports
from trex_gui.core.session import Close, Closed, Outcome, RequestQueue
from trex_gui.core.texts import counted
from trex_gui.core.timing import Timeouts
from trex_gui.core.transport.settings import PortSettings
from trex_gui.devices.aracna.discovery import ARACNA_PROBER, FoundRobot
from trex_gui.devices.aracna.session.client import LINE
from trex_gui.devices.aracna.session.errors import (
    ErrorCode,
    RobotError,
    missed_goals,
    rejected_speeds,
)
from trex_gui.devices.aracna.session.messages import (
    Connected,
    Halt,
    Move,
    Moved,
    Moving,
    NotResponding,
    Play,
    Progress,
    Report,
    SetLed,
    SetSpeeds,
    SpeedsHeld,
    StepStarted,
    Stuck,
)
from trex_gui.devices.aracna.session.session import AracnaSession

NO_STOP = (
    "No command stops a running motion: the motors continue to their goals, for at most "
    "{0:.1f} s. To stop the motors now, cut the servo power. To exit without waiting, press "
    "Ctrl-C again."
)

_CHECK_INTERVAL = 0.1  # seconds between checks for an interruption


def port_settings(port: str | None, extra_time: float) -> PortSettings:
    return PortSettings(required_port(port), LINE, timeouts=Timeouts(extra=extra_time))


class CommandSession:
    """Session with a connected robot. Prints the progress of motions.

    Methods raise CommandFailed if the line is lost, the robot waits for a motor, or the request is
    rejected.
    """

    robot: Connected

    def __init__(
        self,
        settings: PortSettings,
        interrupted: Interruption | None = None,
        *,
        report_motors: bool = True,
    ) -> None:
        """`report_motors`: True to print the position of each motor, False to print each step."""
        self._host = host()
        self._inbox = RequestQueue(self._host.condition())
        self._reports = RequestQueue(self._host.condition())
        self._ids = itertools.count(1)
        self._session = AracnaSession(
            settings, self._inbox, self._reports.put, self._host.open_transport
        )
        self._is_connected = False
        self._interrupted = interrupted
        self._report_motors = report_motors
        self._reported_motors = 0
        self._expected_seconds = 0.0
        self._is_moving = False
        self.halted = False
        self.moved: Moved | None = None
        self.faults: list[str] = []  # problems, as sentences

    def __enter__(self) -> Self:
        """Connect. Raises CommandFailed after a failure or an interruption."""
        self._join = self._host.start_thread(self._session.run)
        try:
            for report in self._received():
                if isinstance(report, Connected):
                    self.robot, self._is_connected = report, True
                    break
        except BaseException:
            self._close()
            raise
        return self

    def __exit__(self, *_: object) -> None:
        self._close()

    def _close(self) -> None:
        self._inbox.put(Close())
        self._join()

    def set_speeds(self, speeds: Sequence[int]) -> tuple[int, ...]:
        """Set the servos' speeds. Return their reported speeds."""
        reply = self._result(SetSpeeds(next(self._ids), tuple(speeds)))
        assert isinstance(reply, SpeedsHeld)  # noqa: S101 - for the type checker
        if (error := rejected_speeds(reply.requested, reply.held)) is not None:
            self.faults.append(str(error))
        return reply.held

    def set_led(self, *, on: bool) -> bool:
        return bool(self._result(SetLed(next(self._ids), on)))

    def report_faults(self) -> None:
        for fault in self.faults:
            say(fault)
        if self.faults:
            raise CommandFailed("Some motors did not execute the command.")

    def _result(self, request: SetSpeeds | SetLed | Move | Play) -> object:
        self._inbox.put(request)
        for report in self._received():
            match report:
                case Outcome(id=number, value=value, error=error) if number == request.id:
                    if error is not None:
                        raise CommandFailed(error) from error
                    return value
                case _:
                    _raise_fault(report)
        raise AssertionError  # unreachable: `Closed` is an error

    def _received(self) -> Iterator[Report]:
        while True:
            self._check_interruption()
            report = self._reports.get(_CHECK_INTERVAL)
            if report is None:
                continue
            if isinstance(report, Closed):
                error = report.error or StudioError("The line was closed.")
                raise CommandFailed(error) from error
            self._handle(report)
            yield report

    def move(self, goals: Sequence[int], speeds: Sequence[int]) -> tuple[int, ...]:
        """Move every motor after its speed is confirmed. Return the final positions."""
        moved = self._result(Move(next(self._ids), tuple(goals), tuple(speeds)))
        assert isinstance(moved, Moved)  # noqa: S101 - for the type checker
        return moved.present

    def play(self, play: Play) -> None:
        """Play to the end. After an interruption, wait until the robot stops."""
        self._result(play)
        for report in self._received() if self._is_moving else ():
            _raise_fault(report)
            if not self._is_moving:
                break

    def _check_interruption(self) -> None:
        if not self._interrupted or self.halted:
            return
        if not self._is_connected:
            raise CommandFailed("Cancelled before anything was moved.")
        self.halted = True
        self._inbox.put(Halt())
        state = NO_STOP.format(self._expected_seconds) if self._is_moving else "Nothing is moving."
        say(f"Nothing more is sent. {state}")

    def _handle(self, report: Report) -> None:
        match report:
            case Moving(expected=expected):
                self._reported_motors, self._is_moving, self._expected_seconds = 0, True, expected
                if self.halted:  # the motion was sent before the halt
                    say(NO_STOP.format(expected))
            case Progress(present=present) if self._report_motors:
                self._say_positions(present)
            case Moved(goals=goals, present=present):
                self._is_moving, self.moved = False, report
                faults = map(str, missed_goals(goals, present).values())
                self.faults += [fault for fault in faults if fault not in self.faults]
                if self._report_motors:
                    self._say_positions(present)
            case StepStarted(_, part, index, number, late) if not self._report_motors:
                title = "blend in" if part == "in" else f"round {number + 1}, step {index + 1}"
                say(f"{title}{f', {late:.2f} s late' if late >= 0.05 else ''}")

    def _say_positions(self, present: Sequence[int]) -> None:
        for motor in range(self._reported_motors, len(present)):
            position = present[motor]
            say(f"motor {motor}: {position if position >= 0 else 'could not be read (-1)'}")
        self._reported_motors = len(present)


def _raise_fault(report: Report) -> None:
    match report:
        case Stuck(motor=None):
            raise CommandFailed(
                "The robot no longer responds. Its motors may continue to their goals."
            )
        case Stuck(motor=motor):
            error = RobotError(ErrorCode.MOTOR_STUCK, motor)
            raise CommandFailed(
                f"{error} The motor is blocked, has no power or does not respond, or the board has "
                "no power. To stop the other motors, cut the servo power."
            )
        case NotResponding(error=error):
            raise CommandFailed(error)


def _identify(url: str, options: Mapping[str, Any]) -> PortAnswer:
    settings = PortSettings(url, timeouts=Timeouts(extra=options["extra_timeout"]))
    scan = scan_port(settings, {"aracna": ARACNA_PROBER}, open_wire=host().open_transport)
    if scan.error is not None:
        raise scan.error
    for found in scan.found:
        assert isinstance(found, FoundRobot)  # noqa: S101 - for the type checker
        text = f"{found.name}, {counted(found.motors, 'motor')}"
        return PortAnswer(text, "Aracna", str(found.version.version))
    texts = [report.text for report in scan.diagnoses if report.evidence > Evidence.ECHO]
    return PortAnswer("".join(texts))


def _describe(found: FoundRobot) -> str:
    text = f"{found.name}, {counted(found.motors, 'motor')}, on {found.settings.text()}."
    return f"{text} {found.note}".strip()


def _row(found: FoundRobot) -> dict[str, Any]:
    return {
        "product": "Aracna",
        "firmware": str(found.version.version),
        "detection": found.settings.line.parity.name.lower(),
        "polynomial": None,
        "options": f"--port {found.settings.url}",
    }


PORT_REPORTS = PortReports(_identify, _describe, _row)
