"""The loop that owns a line: messages in, reports out, one transaction at a time.

It knows neither threads nor Qt. Order of service: stop, driving, what was asked, polling.
Nothing that it does on its own may move a motor; a stop is the one motor command that it
may send unasked.
"""

import logging
from collections.abc import Callable
from dataclasses import replace

from trex_gui.link.client import Client
from trex_gui.link.doctor import why_no_board
from trex_gui.link.drives import packets
from trex_gui.link.mailbox import Inbox, Mailbox
from trex_gui.link.messages import (
    Ask,
    Batch,
    Closed,
    Connected,
    Occasion,
    Outcome,
    Progress,
    Reload,
    Report,
    Silent,
    Write,
)
from trex_gui.link.reading import DeviceState, read_everything
from trex_gui.link.schedule import Schedule, Topic, rates
from trex_gui.link.searching import Search
from trex_gui.link.settings import LinkSettings
from trex_gui.link.stopping import ATTEMPTS, send_stop, stop_and_prove
from trex_gui.link.telemetry import ModeSeen, Sample, StatusReader, poll
from trex_gui.link.transport import SerialTransport, Transport
from trex_gui.link.writing import Written, write_all
from trex_gui.protocol.commands import Command, GetMode, ReplyT_co
from trex_gui.protocol.errors import (
    BadReply,
    BadRequest,
    NoReply,
    Rejected,
    TrexError,
)
from trex_gui.protocol.parameters import ParameterSet

log = logging.getLogger(__name__)

FRAME = 1 / 60
"""Seconds between two batches: nobody sees more than one a display frame."""

_DRIVE_INTERVAL = 0.02
"""Least seconds between two motor packets; the board itself updates its motors every 10 ms."""

_LONGEST_DRIVE = 11
"""Bytes of the motor packets that leave together: both motors and auxiliary, expanded, CRC."""

_TICK = 1e-5
"""Shortest wait in seconds: a rounding error in a sum of times must not become a busy loop."""

_FAILURES_TO_SILENCE = 3
_RETRY_INTERVAL = 0.25
_CLOSING_ATTEMPTS = 6


class _Closing(Exception):  # noqa: N818 - no error: the session was asked to end
    pass


class Session:
    """Serves one line from opening it to giving it back.

    `emit` is called with every report, from wherever `run` runs. `may_move` says that motors
    may be turning from an earlier session: then a stop goes out before anything else.
    """

    def __init__(
        self,
        settings: LinkSettings,
        inbox: Inbox,
        emit: Callable[[Report], None],
        open_transport: Callable[[LinkSettings], Transport] = SerialTransport,
        *,
        may_move: bool = False,
    ) -> None:
        self._settings = settings
        self._emit = emit
        self._open_transport = open_transport
        self._mail = Mailbox(inbox)
        self._may_move = may_move
        self._state: DeviceState | None = None
        self._schedule = Schedule()
        self._samples: list[Sample] = []
        self._flushed_at = 0.0
        self._drove_at = 0.0
        self._failures = 0
        self._silent = False
        self._retry_at = 0.0
        self._search = Search()
        self._port_rates: frozenset[int] | None = None

    def run(self) -> None:
        """Serve the line until it is lost or `Close` comes; then report `Closed`.

        Never raises: whatever happens, the motors are stopped if they were driven, the port
        is given back and every request gets its outcome.
        """
        error: TrexError | None = None
        is_open = False
        try:
            _ = self._settings.framing  # impossible settings must not open the port
            transport = self._open_transport(self._settings)
            self._port_rates = transport.rates()
            self._client = Client(transport, self._settings)
            is_open = True
            self._status = StatusReader(transport.clock)
            self._connect()
            while True:
                self._step()
        except _Closing:
            pass
        except TrexError as reason:
            error = reason
        except Exception as reason:
            log.exception("the line session failed")
            error = TrexError(f"The program made a mistake on this line: {reason!r}")
        if is_open:
            self._leave_safely()
        self._finish(error)

    # --- Beginning and end --------------------------------------------------------------

    def _connect(self) -> None:
        echo = False
        try:
            echo = self._client.detect_echo()
            if self._may_move:
                self._stop_and_prove()
            self._read_everything(Occasion.OPENED)
        except (NoReply, BadReply) as error:
            raise why_no_board(self._settings, echo=echo, error=error) from error

    def _read_everything(self, occasion: Occasion) -> None:
        self._state = read_everything(self._request, self._progress)
        self._schedule.start(rates(self._state.source), self._now())
        self._failures = 0
        self._silent = False
        self._search.end()
        self._flush()
        self._emit(
            Connected(
                self._state,
                self._client.echo,
                occasion,
                self._client.settings,
                self._may_move,
                self._port_rates,
            )
        )

    def _leave_safely(self) -> None:
        """Stop what was driven and give the port back, whatever the line does."""
        try:
            if self._may_move or self._mail.stops:
                self._stop(_CLOSING_ATTEMPTS)
            self._client.drain()
        except TrexError:
            log.info("the line was left without a proved stop", exc_info=True)
        except Exception:
            log.exception("leaving the line failed")
        self._flush()
        self._client.close()

    def _finish(self, error: TrexError | None) -> None:
        self._mail.collect()
        reason = error or TrexError("The line was closed before this was done.")
        for waiting in self._mail.abandon():
            self._emit(Outcome(waiting, error=reason))
        self._emit(Closed(error, self._may_move))

    # --- The loop -----------------------------------------------------------------------

    def _step(self) -> None:
        self._collect()
        now = self._now()
        if now - self._flushed_at >= FRAME:
            self._flush()
        if self._serve_urgent():
            return
        if self._mail.jobs:
            self._run(self._mail.jobs.popleft())
        elif self._silent and now >= self._retry_at:
            self._look_again()
        elif not self._silent and (topic := self._schedule.next(now)):
            self._schedule.asked(topic, now)
            self._poll(topic)
        else:
            self._collect(self._seconds_to_wait(now))

    def _collect(self, seconds: float = 0.0) -> None:
        self._mail.collect(seconds)
        if self._mail.closing:
            raise _Closing

    def _seconds_to_wait(self, now: float) -> float:
        moments = [_RETRY_INTERVAL]
        if self._silent:
            moments.append(self._retry_at - now)
        elif (seconds := self._schedule.seconds_to_next(now)) is not None:
            moments.append(seconds)
        if self._samples:
            moments.append(self._flushed_at + FRAME - now)
        if self._mail.drives:
            moments.append(self._drove_at + self._drive_interval - now)
        return max(_TICK, min(moments))

    def _request(self, command: Command[ReplyT_co]) -> ReplyT_co:
        """Run one transaction of a longer piece of work, unless something goes before it."""
        self._collect()
        self._serve_urgent()
        return self._client.request(command)

    def _serve_urgent(self) -> bool:
        """Stop or drive when that is due; return whether the line was used."""
        if self._mail.stops:
            self._stop()
            return True
        if self._mail.drives and self._now() - self._drove_at >= self._drive_interval:
            self._drive()
            return True
        return False

    def _now(self) -> float:
        return self._client.transport.clock()

    # --- Motors -------------------------------------------------------------------------

    @property
    def _drive_interval(self) -> float:
        """Seconds between motor packets; leaves half of a slow line to everything else."""
        return max(_DRIVE_INTERVAL, 2 * self._client.settings.line.seconds(_LONGEST_DRIVE))

    def _drive(self) -> None:
        wishes = self._mail.drives.take()
        if self._silent:
            # A board that comes back must not be met by a wish that is seconds old.
            return
        self._drove_at = self._now()
        self._may_move = True
        try:
            for command in packets(wishes):
                self._client.request(command)
        except BadRequest as error:
            log.warning("a wish that no motor can obey was dropped: %s", error)
        except (NoReply, BadReply) as error:
            # The echo shows that a packet was damaged: the wish still stands.
            self._mail.drives.put_back(wishes)
            self._note_failure(error)

    def _stop(self, attempts: int = ATTEMPTS) -> None:
        """Serve every stop that waits; each gets its outcome, even when the line is lost."""
        stops = self._mail.take_stops()
        try:
            proved = self._stop_and_prove(attempts)
        except Exception:
            self._mail.stops = stops
            raise
        error = (
            None
            if proved
            else NoReply(
                "The stop was sent, but the board does not confirm it. If a motor still turns, "
                "cut its power."
            )
        )
        for stop in stops:
            self._emit(Outcome(stop.id, error=error))

    def _stop_and_prove(self, attempts: int = ATTEMPTS) -> bool:
        stopped = stop_and_prove(self._client, self._status, attempts)
        self._samples += stopped.news
        if stopped.proved:
            self._may_move = False
        return stopped.proved

    # --- What was asked -----------------------------------------------------------------

    def _run(self, job: Ask | Write | Reload) -> None:
        try:
            value: object = None
            match job:
                case _ if self._looks_around:
                    self._refuse()
                case Ask(command=command):
                    self._may_move = self._may_move or command.moves
                    value = self._request(command)
                case Write():
                    value = self._write(job)
                case Reload():
                    returned = Occasion.RETURNED if self._silent else Occasion.RELOADED
                    self._read_everything(returned)
        except (BadRequest, NoReply, BadReply, Rejected) as error:
            self._emit(Outcome(job.id, error=error))
        except Exception:
            # The line ends: this waits for its outcome as everything else that is dropped.
            self._mail.jobs.appendleft(job)
            raise
        else:
            self._emit(Outcome(job.id, value))

    def _write(self, job: Write) -> tuple[Written, ...]:
        """Write until it is done or `Close` comes, which leaves the rest and no value halfway.

        How everything went is told before the line is closed. Motors that may turn do not wait
        for that.
        """
        has_stopped = False

        def is_closing() -> bool:
            self._mail.collect()
            return self._mail.closing

        def request(command: Command[ReplyT_co]) -> ReplyT_co:
            nonlocal has_stopped
            if is_closing() and self._may_move and not has_stopped:
                has_stopped = True
                self._stop(_CLOSING_ATTEMPTS)
            self._serve_urgent()
            return self._client.request(command)

        return write_all(
            request,
            self._specs,
            job.parameters,
            job.calibrations,
            self._progress,
            source=None if self._state is None else self._state.source,
            cancelled=is_closing,
        )

    def _refuse(self) -> None:
        """Let nothing that a person asks reach a board at settings which nobody knows."""
        raise NoReply("No board answers; it is being looked for.")

    @property
    def _specs(self) -> ParameterSet:
        if self._state is None:
            raise NoReply("No board has been read yet.")
        return self._state.specs

    def _progress(self, done: int, total: int, what: str) -> None:
        self._emit(Progress(done, total, what))

    # --- Polling ------------------------------------------------------------------------

    def _poll(self, topic: Topic) -> None:
        try:
            sample = poll(self._client.request, topic, self._now, self._status)
            self._failures = 0
            if sample is not None:
                self._samples.append(sample)
            if isinstance(sample, ModeSeen) and self._state and sample.mode is not self._state.mode:
                # The power was off and a jumper has moved: everything may be different now.
                self._read_everything(Occasion.MODE_CHANGED)
        except (NoReply, BadReply) as error:
            self._note_failure(error)

    def _note_failure(self, error: TrexError) -> None:
        self._failures += 1
        if self._failures >= _FAILURES_TO_SILENCE and not self._silent:
            self._fall_silent(str(error))

    def _fall_silent(self, reason: str) -> None:
        self._silent = True
        self._search.begin()
        self._retry_at = self._now() + _RETRY_INTERVAL
        if self._may_move:
            # It may hear us although we do not hear it.
            send_stop(self._client)
        self._flush()
        self._emit(Silent(reason, replace(self._client.counters)))

    def _look_again(self) -> None:
        """See whether the board is back; if it is, it may have been through a power cycle."""
        try:
            if self._may_move:
                send_stop(self._client)
            if not self._looks_around:
                self._client.request(GetMode())
            elif not self._look_at_next_place():
                return
            if self._may_move:
                self._stop_and_prove()
            self._read_everything(Occasion.RETURNED)
        except (NoReply, BadReply):
            self._retry_at = self._now() + _RETRY_INTERVAL

    @property
    def _looks_around(self) -> bool:
        """Whether a silent board may be at other settings.

        Then nothing goes out but stops and what is harmless to a board at any rate.
        """
        can = self._client.transport.can_be_tuned
        return self._silent and can and (self._search.has_looked or bool(self._mail.expected))

    def _look_at_next_place(self) -> bool:
        """Put one question; return whether the board answered. The session goes on there."""
        found = self._search.look(self._client, self._mail.expected)
        if found is None:
            pause = _RETRY_INTERVAL if self._search.is_round_over else 0.0
            self._retry_at = self._now() + pause
            return False
        if found is not self._client:
            self._client = found
            self._mail.expected = ()
        return True

    def _flush(self) -> None:
        self._flushed_at = self._now()
        if self._samples:
            batch = Batch(tuple(self._samples), replace(self._client.counters))
            self._samples.clear()
            self._emit(batch)
