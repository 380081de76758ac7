"""The motors over one line: the newest wish goes out in time, a stop goes first and is proved.

Nothing here is sent unasked but a stop.
"""

import logging
from collections.abc import Callable, Sequence

from trex_gui.link.client import Client
from trex_gui.link.drives import DriveSlots, packets
from trex_gui.link.mailbox import Mailbox
from trex_gui.link.messages import Halted, Outcome, SetAuxiliary, SetDrive
from trex_gui.link.stopping import ATTEMPTS, send_stop, stop_and_prove
from trex_gui.link.telemetry import StatusNews, StatusReader
from trex_gui.protocol.errors import BadReply, BadRequest, NoReply
from trex_gui.protocol.flags import Status, UartError

log = logging.getLogger(__name__)

DRIVE_INTERVAL = 0.02
"""Least seconds between two motor packets; the board itself updates its motors every 10 ms."""

REPEATS = (0.15, 0.3, 0.6, 1.2)
"""Seconds after which what stands is sent once more, one after the other, until it is proved.

Motor packets have no reply: a status that was read after one, and is clean, is the proof. The
first is later than the next status of a line that is not slow; where none comes, they become rare.
A status with an error begins anew, at once.
"""

LONGEST_REPEATING = 5.0
"""Seconds after the newest wish from which on it is not repeated any more, proved or not."""

_ROUNDS = 2
"""Packets and clean statuses, one after the other, that prove a wish; see `stopping`.

One does where a repeat could do harm: setting a speed at once goes round the current limiter.
"""

_SHUT_DOWN = Status.MOTOR1_FAULT | Status.MOTOR2_FAULT
"""What the status says when the board has stopped a motor itself."""

CLOSING_ATTEMPTS = 6
"""How often a stop is sent when the line is to be given back: somebody waits for that."""

INSISTING_ATTEMPTS = 4
INSISTING_INTERVAL = 0.25
"""How often, and seconds after which, a stop is sent again that no status has proved yet."""

_LONGEST_DRIVE = 11
"""Bytes of the motor packets that leave together: both motors and auxiliary, expanded, CRC."""

_UNPROVED = (
    "The stop was sent, but the board does not confirm it. If a motor still turns, cut its power."
)


_ABANDONED = (
    "The window did not respond for a second, so the motors were stopped. Press Run motor to go on."
)

_OVERTAKEN = "A stop came before it; nothing was sent."


class Motors:
    """Serves the stops and the wishes that wait in a mailbox, when the session lets it.

    `answer` gets the outcome of every stop, and what was stopped unasked. `take_news` gets the
    latched bits that looking for the proof of one has cleared.

    Attributes:
        may_move: whether motors were driven and no stop was proved since.
    """

    def __init__(
        self,
        mail: Mailbox,
        answer: Callable[[Outcome | Halted], None],
        take_news: Callable[[Sequence[StatusNews]], None],
        *,
        may_move: bool,
    ) -> None:
        self._mail = mail
        self._answer = answer
        self._take_news = take_news
        self._drove_at = 0.0
        self._wished_at = 0.0
        self._standing = DriveSlots()
        self._repeat_at: float | None = None
        self._repeated = 0
        self._proofs = 0
        self._unseen = False
        self._tried_at: float | None = None
        self.may_move = may_move

    def seconds_to_drive(self, client: Client) -> float | None:
        """Return how long what is to be sent must wait still; `None`: there is nothing."""
        if self._mail.drives:
            due = self._drove_at + _interval(client)
        elif self._repeat_at is not None:
            due = max(self._repeat_at, self._drove_at + _interval(client))
        else:
            return None
        return due - client.transport.clock()

    def drive(self, client: Client) -> None:
        """Send the newest wish for each motor; or, where none waits, those that stand once more.

        Raises:
            NoReply, BadReply: the echo shows that a packet was damaged; the wish still stands.
            PortUnavailable: the line is gone.
        """
        wishes = self._mail.drives.take()
        self._drove_at = client.transport.clock()
        if wishes:
            self._wished_at = self._drove_at
            self._repeated = self._proofs = 0
        else:
            wishes = self._standing.take()
            self._repeated += 1
        self._stand(wishes)
        self.may_move = True
        self._tried_at = None
        try:
            for command in packets(wishes):
                client.request(command)
        except BadRequest as error:
            self._rest()
            log.warning("a wish that no motor can obey was dropped: %s", error)
        except (NoReply, BadReply):
            self._mail.drives.put_back(wishes)
            raise

    def _stand(self, wishes: Sequence[SetDrive | SetAuxiliary]) -> None:
        """Remember what is being sent now, for the next repeat if there shall be one."""
        is_late = self._drove_at >= self._wished_at + LONGEST_REPEATING
        if is_late or self._repeated >= len(REPEATS):
            self._rest()
            return
        self._standing.put_all(wishes)
        self._repeat_at = self._drove_at + REPEATS[self._repeated]
        self._unseen = True

    def note_status(
        self, news: StatusNews | None, now: float, *, is_whole: bool, stops_on_error: bool
    ) -> None:
        """Learn from a status that was read: whether what stands has arrived, or must go again.

        `is_whole` says that no error can be waiting behind it, `stops_on_error` that the board
        stops its motors on any. What it has stopped itself is not started again.
        """
        if self._repeat_at is None:
            return
        status = Status(0) if news is None else news.status
        uart = UartError(0) if news is None else news.uart
        is_clean = is_whole and not uart & ~UartError.TIMEOUT
        wishes = self._standing.take()
        if status & _SHUT_DOWN or uart & UartError.TIMEOUT or (stops_on_error and not is_clean):
            wishes = [wish for wish in wishes if _rests(wish)]
        if is_clean and self._unseen:
            self._unseen = False
            self._proofs += 1
        elif not is_clean:
            self._proofs = self._repeated = 0
            self._repeat_at = now
        is_harmless = all(wish.accelerate or _rests(wish) for wish in wishes)
        if not wishes or self._proofs >= (_ROUNDS if is_harmless else 1):
            self._rest()
        else:
            self._standing.put_all(wishes)

    def forget(self) -> None:
        """Send no wish that waits or stands: a stop or the silence of the board came after it."""
        self._mail.drives.clear()
        self._rest()

    def _rest(self) -> None:
        self._standing.clear()
        self._repeat_at = None

    def stop(self, client: Client, status: StatusReader, attempts: int = ATTEMPTS) -> None:
        """Serve every stop that waits; each gets its outcome, even when the line is lost.

        Raises:
            PortUnavailable: the line is gone; the stops wait again, for the end of the session.
        """
        stops = self._mail.take_stops()
        try:
            proved = self.stop_and_prove(client, status, attempts)
        except Exception:
            self._mail.stops = stops
            raise
        for number in self._mail.overtaken:
            self._answer(Outcome(number, error=BadRequest(_OVERTAKEN)))
        self._mail.overtaken.clear()
        for stop in stops:
            self._answer(Outcome(stop.id, error=None if proved else NoReply(_UNPROVED)))

    def stop_and_prove(
        self, client: Client, status: StatusReader, attempts: int = ATTEMPTS
    ) -> bool:
        """Stop unasked, and return whether the board's status proves that it has arrived.

        Raises:
            PortUnavailable: the line is gone.
        """
        self._rest()
        stopped = stop_and_prove(client, status, attempts)
        self._take_news(stopped.news)
        if stopped.proved:
            self.may_move = False
        self._tried_at = None if stopped.proved else client.transport.clock()
        return stopped.proved

    def stop_abandoned(self, client: Client, status: StatusReader) -> None:
        """Stop because nobody seems to be there who could.

        Raises:
            PortUnavailable: the line is gone.
        """
        self._mail.guard.give_up()
        self._mail.drives.clear()
        self._answer(Halted(_ABANDONED, self.stop_and_prove(client, status)))

    def seconds_to_insist(self, client: Client) -> float | None:
        """Return when to send a stop again that is not proved; `None`: the motors stand."""
        if self._tried_at is None or not self.may_move:
            return None
        return self._tried_at + INSISTING_INTERVAL - client.transport.clock()

    def insist(self, client: Client, status: StatusReader) -> None:
        """Send a stop again that is not proved, and tell if it is at last.

        Raises:
            PortUnavailable: the line is gone.
        """
        if self.stop_and_prove(client, status, INSISTING_ATTEMPTS):
            self._answer(Halted("", proved=True))

    def stop_early(self, client: Client) -> None:
        """Send the stops that wait, or are due, on a line of which nothing is known yet.

        They go on waiting for their proof. What may come back as an echo is let pass.

        Raises:
            PortUnavailable: the line is gone.
        """
        self._rest()
        if self.may_move or self._mail.stops:
            send_stop(client)
            client.drain()
            client.transport.wait(client.transport.latency)

    def stop_unheard(self, client: Client) -> None:
        """Stop what may move on a board that does not answer: it may hear us all the same.

        Raises:
            PortUnavailable: the line is gone.
        """
        self._rest()
        if self.may_move:
            send_stop(client)


def _rests(wish: SetDrive | SetAuxiliary) -> bool:
    """Whether a motor that obeys it comes to rest."""
    if isinstance(wish, SetAuxiliary):
        return not wish.speed
    return wish.drive.is_brake or not wish.drive.signed


def _interval(client: Client) -> float:
    """Seconds between motor packets; leaves half of a slow line to everything else."""
    return max(DRIVE_INTERVAL, 2 * client.settings.line.seconds(_LONGEST_DRIVE))
