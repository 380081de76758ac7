"""Sorts the requests to a line session: those for the motors go first."""

from collections import deque
from collections.abc import Callable
from dataclasses import dataclass, field

from trex_gui.core.session import Close, Inbox, Outcome
from trex_gui.devices.trex.driving.motor_output import MotorOutput
from trex_gui.devices.trex.driving.requests import Arm, Heartbeat, Stop
from trex_gui.devices.trex.protocol.errors import ErrorCode, TrexRequestError
from trex_gui.devices.trex.session.messages import (
    Job,
    LeaseRequest,
    Request,
    SendPacket,
    SetReconnectCandidates,
    SetWatched,
)
from trex_gui.devices.trex.session.reconnecting import LivenessMonitor


@dataclass(slots=True, eq=False)
class TrexRequestQueue:
    _inbox: Inbox[Request]
    _output: MotorOutput
    _liveness: LivenessMonitor
    _report: Callable[[Outcome], None]
    _clock: Callable[[], float]
    jobs: deque[Job] = field(default_factory=deque)
    is_closing: bool = False  # whether a `Close` came
    is_watched: bool = True  # whether anything shows or records samples
    # Id of the `SelectBoard` that chose the present board; 0 before the first
    selection: int = 0

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
                case Stop():
                    self._output.take(request, self._clock())
                    self._reject_motor_commands()
                case SetReconnectCandidates(settings=settings):
                    self._liveness.expect(settings)
                case SetWatched(watched=watched):
                    self.is_watched = watched
                case _ if isinstance(request, LeaseRequest):
                    pass  # nobody else is at a line of this computer
                case Arm(selection=selection) if selection != self.selection:
                    pass  # meant for another board
                case _ if isinstance(request, Job):
                    self.jobs.append(request)
                case _ if isinstance(request, Heartbeat) or not self.is_closing:
                    self._output.take(request, self._clock())
            request = self._inbox.get(0.0)

    def sees_close(self) -> bool:
        """Sort what has come; return whether a `Close` is or was among it."""
        self.collect()
        return self.is_closing

    def _reject_motor_commands(self) -> None:
        for job in list(self.jobs):
            if isinstance(job, SendPacket) and job.packet.moves:
                self.jobs.remove(job)
                error = TrexRequestError(ErrorCode.OVERTAKEN_BY_STOP)
                self._report(Outcome(job.id, error=error))

    def abandon(self) -> list[int]:
        """Drop everything, and return the ids that have no outcome yet."""
        ids = [request.id for request in (*self._output.take_stops(), *self.jobs)]
        self._output.setpoints.clear()
        self.jobs.clear()
        return ids
