"""Requests on their way into a session, sorted by how urgent they are."""

from collections import deque
from dataclasses import dataclass, field
from typing import Protocol

from trex_gui.core.session.messages import Close
from trex_gui.devices.trex.driving.arming import ArmingWatchdog
from trex_gui.devices.trex.driving.setpoints import SetpointSlots
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.devices.trex.session.messages import (
    Arm,
    Heartbeat,
    Reload,
    Request,
    RunCommand,
    SetAuxiliary,
    SetMotor,
    SetMotors,
    SetReconnectCandidates,
    Stop,
    Write,
)


class Inbox(Protocol):
    """Where requests come from."""

    def get(self, seconds: float) -> Request | None:
        """Return the next request, waiting up to `seconds` for one; else `None`."""
        ...


@dataclass(slots=True)
class RequestQueues:
    """What waits to be served.

    Attributes:
        stops: stops that were asked for and not yet sent.
        drives: the newest wish for each motor.
        jobs: everything else, first come first served.
        guard: whether wishes are let through, and whether somebody is still there.
        overtaken: ids of motor commands that a stop has overtaken.
        expected: settings at which to look for a board that has fallen silent.
        closing: whether the session was asked to end.
    """

    inbox: Inbox
    stops: list[Stop] = field(default_factory=list)
    drives: SetpointSlots = field(default_factory=SetpointSlots)
    jobs: deque[RunCommand | Write | Reload] = field(default_factory=deque)
    guard: ArmingWatchdog = field(default_factory=ArmingWatchdog)
    overtaken: list[int] = field(default_factory=list)
    expected: tuple[ConnectionSettings, ...] = ()
    closing: bool = False

    def collect(self, seconds: float = 0.0) -> None:
        """Sort everything that has come, waiting up to `seconds` for the first of it.

        A stop wipes out the wishes that came before it, and those after it until an `Arm` comes:
        they may have been on their way before whoever wished them knew of it. `Close` wipes out
        all that come after it, too: what is still written then moves nothing.
        """
        request = self.inbox.get(max(seconds, 0.0))
        while request is not None:
            match request:
                case Close():
                    self.closing = True
                    self.drives.clear()
                case Stop():
                    self._take_stop(request)
                case Arm():
                    if not self.closing:
                        self.guard.arm()
                case Heartbeat(sent=sent):
                    self.guard.heartbeat_received(sent)
                case SetMotor() | SetMotors() | SetAuxiliary():
                    self.guard.heartbeat_received()
                    if not self.closing and not self.guard.drops_setpoints:
                        self.drives.put(request)
                case SetReconnectCandidates(settings=settings):
                    self.expected = settings
                case RunCommand() | Write() | Reload():
                    self.jobs.append(request)
            request = self.inbox.get(0.0)

    def _take_stop(self, stop: Stop) -> None:
        self.stops.append(stop)
        self.guard.stop(stop.lockout)
        self.drives.clear()
        late = [job for job in self.jobs if isinstance(job, RunCommand) and job.command.moves]
        for job in late:
            self.jobs.remove(job)
            self.overtaken.append(job.id)

    def take_stops(self) -> list[Stop]:
        """Return the stops that wait, and forget them."""
        stops, self.stops = self.stops, []
        return stops

    def abandon(self) -> list[int]:
        """Forget everything, and return the ids that still wait for an outcome."""
        ids = [*self.overtaken, *(request.id for request in (*self.stops, *self.jobs))]
        self.overtaken.clear()
        self.stops.clear()
        self.drives.clear()
        self.jobs.clear()
        return ids
