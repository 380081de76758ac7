"""Requests of a session: those for the motors go to the motor output, the others wait in order."""

from collections import deque
from collections.abc import Callable

from trex_gui.core.session import Close, Inbox, Outcome
from trex_gui.devices.trex.driving.motor_output import MotorOutput
from trex_gui.devices.trex.driving.requests import (
    Arm,
    Heartbeat,
    SetAuxiliary,
    SetMotor,
    SetMotors,
    Stop,
)
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.devices.trex.protocol.errors import ErrorCode, TrexRequestError
from trex_gui.devices.trex.session.messages import (
    Job,
    Reload,
    Request,
    RunCommand,
    SetReconnectCandidates,
    Write,
)


class TrexRequestQueue:
    """Sorts requests by urgency.

    Attributes:
        jobs: first come, first served.
        candidates: settings at which to look for a board that does not respond.
        is_closing: whether a `Close` came.
    """

    def __init__(
        self,
        inbox: Inbox[Request],
        output: MotorOutput,
        report: Callable[[Outcome], None],
        clock: Callable[[], float],
    ) -> None:
        self.jobs: deque[Job] = deque()
        self.candidates: tuple[ConnectionSettings, ...] = ()
        self.is_closing = False
        self._inbox = inbox
        self._output = output
        self._report = report
        self._clock = clock

    def collect(self, seconds: float = 0.0) -> None:
        """Sort every request that has come, waiting up to `seconds` for the first.

        A stop drops setpoints that came before it, and those that come until an `Arm`: they may
        have been sent before their sender knew of it. `Close` drops all setpoints.
        """
        request = self._inbox.get(max(seconds, 0.0))
        while request is not None:
            match request:
                case Close():
                    self.is_closing = True
                    self._output.setpoints.clear()
                case Arm() | SetMotor() | SetMotors() | SetAuxiliary():
                    if not self.is_closing:
                        self._output.take(request, self._clock())
                case Stop():
                    self._output.take(request, self._clock())
                    self._reject_motor_commands()
                case Heartbeat():
                    self._output.take(request, self._clock())
                case SetReconnectCandidates(settings=settings):
                    self.candidates = settings
                case RunCommand() | Write() | Reload():
                    self.jobs.append(request)
            request = self._inbox.get(0.0)

    def _reject_motor_commands(self) -> None:
        for job in list(self.jobs):
            if isinstance(job, RunCommand) and job.command.moves:
                self.jobs.remove(job)
                error = TrexRequestError(ErrorCode.OVERTAKEN_BY_STOP)
                self._report(Outcome(job.id, error=error))

    def abandon(self) -> list[int]:
        """Drop everything, and return the ids that have no outcome yet."""
        ids = [request.id for request in (*self._output.take_stops(), *self.jobs)]
        self._output.setpoints.clear()
        self.jobs.clear()
        return ids
