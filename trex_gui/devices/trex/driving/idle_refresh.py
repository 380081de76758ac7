"""What is at rest stays there: on a line that damages bytes, rests are sent again.

A motor that shall rest can be started by damage that nobody notices: its own packet, or a
question, arrives as another motor command. A question that became a command has no answer, so
every failed transaction is followed by the rests at once. A packet that became another one is
told by nothing but what else the line damages: the rests are repeated until it is quiet.
"""

from collections.abc import Sequence

from trex_gui.devices.trex.client.client import TrexClient
from trex_gui.devices.trex.driving.line_quality import QUIET, LineQuality
from trex_gui.devices.trex.driving.setpoints import packets
from trex_gui.devices.trex.protocol.commands import Command, Drive, DriveMotor
from trex_gui.devices.trex.session.messages import SetAuxiliary, SetMotor

REST_INTERVAL = 0.1
"""Seconds between two repeats of the rests while the line is not quiet; after damage, none.

One of them may itself arrive as a command to drive, and the next one ends that.
"""

_MOTORS = (1, 2)


def is_idle(wish: SetMotor | SetAuxiliary) -> bool:
    """Whether a motor that obeys it comes to rest."""
    if isinstance(wish, SetAuxiliary):
        return not wish.speed
    return wish.drive.is_brake or not wish.drive.signed


class IdleRefresh:
    """Remembers which motors rest, and when to tell them so again.

    Motors that were never driven rest too, from the first wish, arming or stop on: they are
    braked. Before that nothing is sent, whatever the line does.

    Attributes:
        calm: what is known of the line.
    """

    def __init__(self) -> None:
        self.calm = LineQuality()
        self._is_in_charge = False
        self._wished: dict[int, SetMotor] = {}
        self._auxiliary = SetAuxiliary(0)
        self._auxiliary_at_risk = False
        self._answers_since: int | None = None
        self._sent_at = 0.0
        self._seen = 0

    def note_setpoints(self, wishes: Sequence[SetMotor | SetAuxiliary], now: float) -> None:
        """These are being sent."""
        self._is_in_charge = True
        for wish in wishes:
            if isinstance(wish, SetAuxiliary):
                self._auxiliary = wish
            else:
                self._wished[wish.motor] = wish
        self._note_packets(packets(wishes), now)

    def note_stop(self, now: float) -> None:
        """A stop has been sent: everything rests, braked fully."""
        self.forget()
        self._is_in_charge = True
        self._endanger_auxiliary()
        self._sent_at = now

    def forget(self) -> None:
        """No motor shall move any more, whatever was wished."""
        self._wished.clear()
        self._auxiliary = SetAuxiliary(0)

    def leave(self) -> None:
        """Motors are driven by commands that are none of ours: say nothing until a wish or stop."""
        self._is_in_charge = False

    def due(self, client: TrexClient, interval: float, *, armed: bool) -> float | None:
        """Return when the rests are to be sent, on the line's clock; `None`: they are not."""
        self._is_in_charge = self._is_in_charge or armed
        if self.calm.is_quiet(client):
            self._watch_auxiliary(client.counters.answers)
            self._seen = self.calm.damages
            return None
        if not self._is_in_charge:
            return None
        return self._sent_at + (interval if self.calm.damages > self._seen else REST_INTERVAL)

    def take(self, now: float) -> list[Command[None]]:
        """Return what tells every resting motor to rest, and count it as sent.

        A packet for each: that for both motors is one bit away from one for the auxiliary motor.
        The auxiliary motor is left alone unless a packet was sent that may have started it: its
        own, at any damaged bit of the speed, is more dangerous than none.
        """
        self._seen = self.calm.damages
        wished = [self._wished.get(motor, SetMotor(motor, Drive.brake())) for motor in _MOTORS]
        wishes: list[SetMotor | SetAuxiliary] = [wish for wish in wished if is_idle(wish)]
        if self._auxiliary_at_risk and is_idle(self._auxiliary):
            self._endanger_auxiliary()
            wishes.append(self._auxiliary)
        commands = [command for wish in wishes for command in packets([wish])]
        self._sent_at = now
        return commands

    def _note_packets(self, commands: Sequence[Command[None]], now: float) -> None:
        self._sent_at = now
        if not all(isinstance(command, DriveMotor) for command in commands):
            self._endanger_auxiliary()

    def _endanger_auxiliary(self) -> None:
        """Note that a packet was sent which damage makes a speed of the auxiliary motor."""
        self._auxiliary_at_risk = True
        self._answers_since = None

    def _watch_auxiliary(self, answers: int) -> None:
        """Let the line be quiet behind that packet, too: noise may have begun with it."""
        if self._answers_since is None:
            self._answers_since = answers
        if answers - self._answers_since >= QUIET:
            self._auxiliary_at_risk = False
