"""The motors over one line: the newest wish goes out in time, a stop goes first and is proved.

Nothing here is sent unasked but a stop.
"""

import logging
from collections.abc import Callable, Sequence

from trex_gui.core.errors import BadReply, BadRequest, NoReply
from trex_gui.core.session.messages import Outcome
from trex_gui.devices.trex.client.client import TrexClient
from trex_gui.devices.trex.client.telemetry import LatchedStatus, StatusReader
from trex_gui.devices.trex.driving.idle_refresh import IdleRefresh
from trex_gui.devices.trex.driving.setpoint_retry import SetpointRetry
from trex_gui.devices.trex.driving.setpoints import packets
from trex_gui.devices.trex.driving.stopping import ATTEMPTS, send_stop, stop_and_confirm
from trex_gui.devices.trex.session.messages import MotorsStopped, Stop
from trex_gui.devices.trex.session.request_queues import RequestQueues

log = logging.getLogger(__name__)

DRIVE_INTERVAL = 0.02
"""Least seconds between two motor packets; the board itself updates its motors every 10 ms."""

_CLOSING_ATTEMPTS = 6
_CAREFUL_CLOSING_ATTEMPTS = 16
_CLOSING_SECONDS = 0.5
"""How often, and how long, a stop is sent when the line is to be given back: somebody waits.

The second number where the line has damaged bytes: it is the last chance, and wants more rounds.
The window waits for a second; the last round may begin just before this time is over.
"""

INSISTING_ATTEMPTS = 4
INSISTING_INTERVAL = 0.25
"""How often, and seconds after which, a stop is sent again that no status has proved yet."""

_LONGEST_DRIVE = 11
"""Bytes of the motor packets that leave together: both motors and auxiliary, expanded, CRC."""

_UNPROVED = (
    "The stop was sent, but the board does not confirm it. If a motor still turns, cut its power."
)

_DAMAGED = (
    "The stop was sent and the board answers, but the line damages bytes. It is sent again until "
    "the line is quiet. If a motor still turns, cut its power."
)

_ABANDONED = "The window did not respond for a second."

_OVERTAKEN = "A stop came before it; nothing was sent."


class MotorOutput:
    """Serves the stops and the wishes that wait in a mailbox, when the session lets it.

    `answer` gets the outcome of every stop, and what was stopped unasked. `take_news` gets the
    latched bits that looking for the proof of one has cleared.

    Attributes:
        may_move: whether motors were driven and no stop was proved since.
    """

    def __init__(
        self,
        mail: RequestQueues,
        answer: Callable[[Outcome | MotorsStopped], None],
        take_news: Callable[[Sequence[LatchedStatus]], None],
        *,
        may_move: bool,
    ) -> None:
        self._mail = mail
        self._answer = answer
        self._take_news = take_news
        self._drove_at = 0.0
        self._repeating = SetpointRetry()
        self._tried_at: float | None = None
        self._resting = IdleRefresh()
        self._unproved: list[Stop] = []
        self._proof_until = 0.0
        self.may_move = may_move

    def seconds_to_drive(self, client: TrexClient, *, silent: bool = False) -> float | None:
        """Return how long what is to be sent must wait still; `None`: there is nothing.

        A `silent` board is told nothing again.
        """
        interval = _interval(client)
        earliest = self._drove_at + interval
        moments = [earliest] if self._mail.drives else []
        if self._repeating.due is not None:
            moments.append(max(self._repeating.due, earliest))
        rest_at = self._resting.due(client, interval, armed=self._mail.guard.armed)
        if rest_at is not None and not silent:
            moments.append(max(rest_at, earliest))
        return min(moments) - client.transport.clock() if moments else None

    def is_careful(self, client: TrexClient) -> bool:
        """Whether nothing must be asked that a damaged bit makes a motor command."""
        drives = self.may_move or self._mail.guard.armed
        return drives and not self._resting.calm.is_quiet(client)

    def drive(self, client: TrexClient) -> None:
        """Send the newest wish for each motor; or, where none waits, what is to be sent again.

        Raises:
            NoReply, BadReply: the echo shows that a packet was damaged; the wish still stands.
            PortUnavailable: the line is gone.
        """
        now = self._drove_at = client.transport.clock()
        if wishes := self._mail.drives.take():
            self._repeating.begin(wishes, now)
        elif self._repeating.due is not None and self._repeating.due <= now:
            wishes = self._repeating.take(now)
        else:
            for command in self._resting.take(now):
                client.send(command)  # goes before the rest of an answer is awaited
            return
        self.may_move = True
        self._tried_at = None
        self._report_unconfirmed()
        self._resting.note_setpoints(wishes, self._drove_at)
        try:
            for command in packets(wishes):
                client.request(command)
        except BadRequest as error:
            self._repeating.rest()
            log.warning("a wish that no motor can obey was dropped: %s", error)
        except (NoReply, BadReply):
            self._mail.drives.put_back(wishes)
            raise

    def note_status(
        self, news: LatchedStatus | None, now: float, *, is_whole: bool, stops_on_error: bool
    ) -> None:
        """Learn from a status that was read: whether what stands has arrived, or must go again.

        `is_whole` says that no error can be waiting behind it, `stops_on_error` that the board
        stops its motors on any. What it has stopped itself is not started again.
        """
        self._resting.calm.note(news)
        self._repeating.note_status(news, now, is_whole=is_whole, stops_on_error=stops_on_error)

    def forget(self) -> None:
        """Send no wish that waits or stands: a stop or the silence of the board came after it."""
        self._mail.drives.clear()
        self._resting.forget()
        self._repeating.rest()

    def leave(self) -> None:
        """Motors are driven by a command that is no wish: what rests is not known any more."""
        self._resting.leave()
        self.may_move = True

    def stop(self, client: TrexClient, status: StatusReader) -> None:
        """Serve every stop that waits; each gets its outcome, even when the line is lost.

        On a line that damages bytes the outcome comes when it has been quiet for a while, or
        after `Timeouts.stop_confirmation`; the stop is sent again until then.

        Raises:
            PortUnavailable: the line is gone; the stops wait again, for the end of the session.
        """
        stops = self._take_stops()
        try:
            stopped = self._stop(client, status, ATTEMPTS, careful=False, hurries=self._is_to_close)
        except Exception:
            self._mail.stops = stops + self._mail.stops  # others may have come meanwhile
            raise
        if not stopped and self._mail.closing:
            self._mail.stops += stops  # the end of the session has its own way to stop
        elif stopped and self.may_move:
            patience = client.settings.timeouts.stop_confirmation
            self._proof_until = client.transport.clock() + patience
            self._unproved = stops
            self._tell((), None)
        else:
            self._tell(stops, None if stopped else NoReply(_UNPROVED))

    def stop_on_close(self, client: TrexClient, status: StatusReader) -> None:
        """Serve every stop that waits, and stop, before the line is given back.

        Raises:
            PortUnavailable: the line is gone; the stops wait again.
        """
        stops = self._take_stops()
        is_quiet = self._resting.calm.is_quiet(client)
        attempts = _CLOSING_ATTEMPTS if is_quiet else _CAREFUL_CLOSING_ATTEMPTS
        clock = client.transport.clock
        end = clock() + _CLOSING_SECONDS
        try:
            confirmed = self.stop_and_confirm(client, status, attempts, lambda: clock() >= end)
        except Exception:
            self._mail.stops = stops + self._mail.stops  # others may have come meanwhile
            raise
        self._tell(stops, None if confirmed else NoReply(_UNPROVED))

    def _take_stops(self) -> list[Stop]:
        stops, self._unproved = self._unproved + self._mail.take_stops(), []
        return stops

    def _tell(self, stops: Sequence[Stop], error: NoReply | None) -> None:
        for number in self._mail.overtaken:
            self._answer(Outcome(number, error=BadRequest(_OVERTAKEN)))
        self._mail.overtaken.clear()
        for stop in stops:
            self._answer(Outcome(stop.id, error=error))

    def _report_unconfirmed(self) -> None:
        """Tell those whose stop is not proved yet that it is not."""
        stops, self._unproved = self._unproved, []
        self._tell(stops, NoReply(_DAMAGED))

    def _is_to_close(self) -> bool:
        self._mail.collect()
        return self._mail.closing

    def stop_and_confirm(
        self,
        client: TrexClient,
        status: StatusReader,
        attempts: int = ATTEMPTS,
        hurries: Callable[[], bool] | None = None,
    ) -> bool:
        """Stop unasked, and return whether the board's status proves that it has arrived.

        It does not wait for a line that damages bytes to become quiet, but wants more of it.

        Raises:
            PortUnavailable: the line is gone.
        """
        careful = not self._resting.calm.is_quiet(client)
        stopped = self._stop(
            client, status, attempts, careful=careful, hurries=hurries or self._is_to_close
        )
        if stopped:
            self._stand_still()
        return stopped

    def _stop(
        self,
        client: TrexClient,
        status: StatusReader,
        attempts: int,
        *,
        careful: bool,
        hurries: Callable[[], bool],
    ) -> bool:
        """Stop, and return whether clean statuses have followed; on a quiet line that proves it.

        Raises:
            PortUnavailable: the line is gone.
        """
        self._repeating.rest()
        stopped = stop_and_confirm(client, status, attempts, careful=careful, hurries=hurries)
        now = client.transport.clock()
        self._resting.note_stop(now)
        self._drove_at = now
        self._take_news(stopped.news)
        for news in stopped.news:
            self._resting.calm.note(news)
        if stopped.confirmed and self._resting.calm.is_quiet(client):
            self._stand_still()
        else:
            # Where it was heard, one of its packets may have become another one.
            self.may_move |= stopped.confirmed
            self._tried_at = now
        return stopped.confirmed

    def _stand_still(self) -> None:
        self.may_move = False
        self._tried_at = None

    def stop_abandoned(self, client: TrexClient, status: StatusReader) -> None:
        """Stop because nobody seems to be there who could.

        Raises:
            PortUnavailable: the line is gone.
        """
        self._mail.guard.disarm()
        self._mail.drives.clear()
        stopped = self._stop(client, status, ATTEMPTS, careful=False, hurries=self._is_to_close)
        self._answer(MotorsStopped(_ABANDONED, confirmed=stopped and not self.may_move))

    def seconds_to_stop_retry(self, client: TrexClient) -> float | None:
        """Return when to send a stop again that is not proved; `None`: the motors stand."""
        if self._tried_at is None or not self.may_move:
            return None
        return self._tried_at + INSISTING_INTERVAL - client.transport.clock()

    def retry_stop(self, client: TrexClient, status: StatusReader) -> None:
        """Send a stop again that is not proved, and tell if it is at last.

        Raises:
            PortUnavailable: the line is gone.
        """
        stopped = self._stop(
            client, status, INSISTING_ATTEMPTS, careful=False, hurries=self._is_to_close
        )
        if stopped and not self.may_move:
            stops, self._unproved = self._unproved, []
            self._tell(stops, None)
            self._answer(MotorsStopped("", confirmed=True))
        elif self._tried_at is not None and self._tried_at >= self._proof_until:
            self._report_unconfirmed()

    def stop_early(self, client: TrexClient) -> None:
        """Send the stops that wait, or are due, on a line of which nothing is known yet.

        They go on waiting for their proof. What may come back as an echo is let pass.

        Raises:
            PortUnavailable: the line is gone.
        """
        self._repeating.rest()
        if self.may_move or self._mail.stops:
            send_stop(client)
            client.drain()
            client.transport.wait(client.transport.latency)

    def stop_without_reply(self, client: TrexClient) -> None:
        """Stop what may move on a board that does not answer: it may hear us all the same.

        Raises:
            PortUnavailable: the line is gone.
        """
        self._repeating.rest()
        self._report_unconfirmed()
        if self.may_move:
            send_stop(client)


def _interval(client: TrexClient) -> float:
    """Seconds between motor packets; leaves half of a slow line to everything else."""
    return max(DRIVE_INTERVAL, 2 * client.settings.line.seconds(_LONGEST_DRIVE))
