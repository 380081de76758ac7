"""Who may drive at this moment: not after a stop, and not when nobody is there any more."""

import math
import time
from collections.abc import Callable
from dataclasses import dataclass, field

from trex_gui.core.errors import BadRequest
from trex_gui.core.timing import Timeouts
from trex_gui.devices.trex.protocol.commands import Command

HEARTBEAT_INTERVAL = 0.25
"""Seconds between two signs of life of whoever has armed the motors."""


@dataclass(slots=True)
class ArmingWatchdog:
    """Remembers stops, and whether whoever has armed the motors is still there.

    Attributes:
        clock: seconds, as for every time here.
        armed: whether somebody has armed the motors and none has stopped them since.
        is_reachable: whether the board answers; who arms it while it does not cannot know that
            yet, and is told by the silence that nothing is armed.
    """

    clock: Callable[[], float] = time.monotonic
    timeouts: Timeouts = field(default_factory=Timeouts)
    armed: bool = False
    is_reachable: bool = True
    _awaits_arm: bool = False
    _locked_until: float = -math.inf
    _heard_at: float = -math.inf

    @property
    def is_locked(self) -> bool:
        """Whether motor commands that are asked for are refused, since a stop came before."""
        return self.clock() < self._locked_until

    @property
    def drops_setpoints(self) -> bool:
        """Whether wishes are dropped: motors were stopped, and nobody has armed them since."""
        return self._awaits_arm or self.is_locked

    @property
    def seconds_to_alarm(self) -> float | None:
        """How long nothing may be heard still; `None` while nothing is armed."""
        return self._heard_at + self.timeouts.heartbeat - self.clock() if self.armed else None

    @property
    def is_abandoned(self) -> bool:
        """Whether motors are armed and nobody seems to be there."""
        seconds = self.seconds_to_alarm
        return seconds is not None and seconds <= 0

    def check(self, command: Command[object]) -> None:
        """Let a command pass, unless it moves a motor while motors are locked.

        Raises:
            BadRequest: it does.
        """
        if command.moves and self.is_locked:
            raise BadRequest("The motors are locked for a while after a stop; nothing was sent.")

    def arm(self) -> None:
        """Let wishes through: requests keep their order, so this is younger than any stop.

        But not to a board that is silent; when it is back, it has to be armed anew.
        """
        if not self.is_reachable:
            return
        self.armed = True
        self._awaits_arm = False
        self._locked_until = -math.inf
        self._heard_at = self.clock()

    def heartbeat_received(self, sent: float | None = None) -> None:
        """Somebody is there, or was when that was `sent`; now, where it does not tell.

        Whoever has been silent for too long stays lost: where window and line stood still together,
        what the window says first when both go on must not hide it.
        """
        at = self.clock() if sent is None else sent
        if at - self._heard_at <= self.timeouts.heartbeat:
            self._heard_at = max(self._heard_at, at)

    def stop(self, lockout: float) -> None:
        """Drop every wish until somebody arms the motors again.

        For `lockout` seconds what is asked for and moves a motor is refused, too.
        """
        self.armed = False
        self._awaits_arm = True
        if lockout > 0:
            self._locked_until = max(self._locked_until, self.clock() + lockout)

    def disarm(self) -> None:
        """Drop every wish until somebody arms the motors again: those of the lost are late."""
        self.armed = False
        self._awaits_arm = True
        self._locked_until = math.inf
