"""The loop that owns a line: messages in, reports out, one transaction at a time.

It knows neither threads nor Qt. Order of service: stop, driving, what was asked, polling.
Nothing that it does on its own may move a motor; a stop is the one motor command that it
may send unasked.
"""

import logging
from collections.abc import Callable
from dataclasses import replace

from trex_gui.core.errors import BadReply, BadRequest, NoReply, StudioError
from trex_gui.core.session.messages import Closed, Outcome, Progress
from trex_gui.core.transport.serial_port import SerialTransport, Transport
from trex_gui.devices.trex.client.client import TrexClient
from trex_gui.devices.trex.client.reading import DeviceState, read_everything
from trex_gui.devices.trex.client.schedule import Topic
from trex_gui.devices.trex.client.telemetry import LatchedStatus, ModeSample, StatusReader, poll
from trex_gui.devices.trex.client.writing import WriteResult, write_all
from trex_gui.devices.trex.discovery.diagnosis import diagnose
from trex_gui.devices.trex.driving.arming import ArmingWatchdog
from trex_gui.devices.trex.driving.motors import MotorOutput
from trex_gui.devices.trex.protocol.commands import Command, GetMode, ReplyT_co
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.devices.trex.protocol.errors import Rejected
from trex_gui.devices.trex.protocol.line_settings import LineSettings, baud_rates
from trex_gui.devices.trex.protocol.parameter_keys import ParameterKey
from trex_gui.devices.trex.protocol.parameters import ParameterSet
from trex_gui.devices.trex.session.liveness import LivenessMonitor
from trex_gui.devices.trex.session.messages import (
    Connected,
    NotResponding,
    ReadReason,
    Reload,
    Report,
    RunCommand,
    Write,
)
from trex_gui.devices.trex.session.polling import Polling
from trex_gui.devices.trex.session.request_queues import Inbox, RequestQueues
from trex_gui.devices.trex.session.sample_batcher import SampleBatcher

log = logging.getLogger(__name__)

_TICK = 1e-5
"""Shortest wait in seconds: a rounding error in a sum of times must not become a busy loop."""


class _Closing(Exception):  # noqa: N818 - no error: the session was asked to end
    pass


def _known(*moments: float | None) -> list[float]:
    return [seconds for seconds in moments if seconds is not None]


class TrexSession:
    """Serves one line from opening it to giving it back.

    `emit` is called with every report, from wherever `run` runs. `may_move` says that motors
    may be turning from an earlier session: then a stop goes out before anything else.
    """

    def __init__(
        self,
        settings: ConnectionSettings,
        inbox: Inbox,
        emit: Callable[[Report], None],
        open_transport: Callable[[ConnectionSettings], Transport] = SerialTransport,
        *,
        may_move: bool = False,
    ) -> None:
        self._settings = settings
        self._emit = emit
        self._open_transport = open_transport
        self._mail = RequestQueues(inbox, guard=ArmingWatchdog(timeouts=settings.timeouts))
        self._batches = SampleBatcher(emit)
        self._motors = MotorOutput(self._mail, emit, self._batches.extend, may_move=may_move)
        self._presence = LivenessMonitor(settings.timeouts)
        self._state: DeviceState | None = None
        self._polling = Polling()
        self._port_rates: frozenset[int] | None = None

    def run(self) -> None:
        """Serve the line until it is lost or `Close` comes; then report `Closed`.

        Never raises: whatever happens, the motors are stopped if they were driven, the port
        is given back and every request gets its outcome.
        """
        error: StudioError | None = None
        is_open = False
        try:
            _ = self._settings.framing  # impossible settings must not open the port
            transport = self._open_transport(self._settings)
            self._port_rates = transport.rates(baud_rates())
            self._client = TrexClient(transport, self._settings)
            self._mail.guard.clock = transport.clock
            is_open = True
            self._status = StatusReader(transport.clock)
            self._connect()
            while True:
                self._step()
        except _Closing:
            pass
        except StudioError as reason:
            error = reason
        except BaseException as reason:  # whatever ends this thread, motors come first
            log.exception("the line session failed")
            error = StudioError(f"The program made a mistake on this line: {reason!r}")
        if is_open:
            self._leave_safely()
        self._finish(error)

    # --- Beginning and end --------------------------------------------------------------

    def _connect(self) -> None:
        echo = False
        try:
            echo = self._client.detect_echo(self._stop_early)
            if self._motors.may_move:
                self._motors.stop_and_confirm(self._client, self._status)
            self._read_everything(ReadReason.OPENED)
        except (NoReply, BadReply) as error:
            raise diagnose(self._settings, echo=echo, error=error) from error

    def _stop_early(self) -> None:
        self._mail.collect()
        self._motors.stop_early(self._client)

    def _read_everything(self, occasion: ReadReason) -> None:
        """Read everything and tell it. But on a mere reload nothing drives meanwhile.

        Whoever drives does not know yet that the board was without power, or is another one, and
        goes on wishing; when it is told, every motor stands and has to be armed anew.
        """
        if occasion.power_cycled:
            self._give_up_driving()
        self._state = read_everything(self._request, self._progress)
        if occasion is not ReadReason.RELOADED:
            if occasion.power_cycled or self._mail.guard.armed:
                self._give_up_driving()
            if self._motors.may_move:
                self._motors.stop_and_confirm(self._client, self._status)
        self._polling.start(self._state, self._now())
        self._presence.begin()
        self._mail.guard.is_reachable = True
        self._flush()
        self._emit(
            Connected(
                self._state,
                self._client.echo,
                occasion,
                self._client.settings,
                self._motors.may_move,
                self._port_rates,
            )
        )

    def _give_up_driving(self) -> None:
        """Drop what is wished until somebody arms the motors again."""
        self._mail.guard.disarm()
        self._motors.forget()

    def _leave_safely(self) -> None:
        """Stop what was driven and give the port back, whatever the line does."""
        try:
            if self._motors.may_move or self._mail.stops:
                self._motors.stop_on_close(self._client, self._status)
            self._client.drain()
        except StudioError:
            log.info("the line was left without a proved stop", exc_info=True)
        except Exception:
            log.exception("leaving the line failed")
        try:
            self._flush()
        except Exception:  # whoever is told may be what went wrong; the port is given back
            log.exception("the last samples could not be told")
        self._client.close()

    def _finish(self, error: StudioError | None) -> None:
        self._mail.collect()
        reason = error or StudioError("The line was closed before this was done.")
        for waiting in self._mail.abandon():
            self._emit(Outcome(waiting, error=reason))
        self._emit(Closed(error, self._motors.may_move))

    # --- The loop -----------------------------------------------------------------------

    def _step(self) -> None:
        self._collect()
        now = self._now()
        due = self._batches.seconds_to_next(now)
        if due is not None and due <= 0:
            self._flush()
        if self._serve_urgent():
            return
        if self._mail.jobs:
            self._run(self._mail.jobs.popleft())
        elif self._presence.silent and now >= self._presence.retry_at:
            self._look_again()
        elif self._presence.silent:
            self._collect(self._seconds_to_wait(now))
        elif topic := self._next_topic(now):
            self._poll(topic)
        else:
            self._collect(self._seconds_to_wait(now))

    def _next_topic(self, now: float) -> Topic | None:
        self._client.feeds_timeout = self._mail.guard.armed
        careful = self._motors.is_careful(self._client)
        return self._polling.next(now, self._line, armed=self._mail.guard.armed, careful=careful)

    def _has_to_retry_stop(self) -> bool:
        seconds = self._motors.seconds_to_stop_retry(self._client)
        return not self._presence.silent and seconds is not None and seconds <= 0

    def _collect(self, seconds: float = 0.0) -> None:
        self._mail.collect(seconds)
        if self._mail.closing:
            raise _Closing

    def _seconds_to_wait(self, now: float) -> float:
        moments = [self._settings.timeouts.retry]
        if self._presence.silent:
            moments.append(self._presence.retry_at - now)
        else:
            moments += _known(
                self._polling.seconds_to_next(now, armed=self._mail.guard.armed),
                self._motors.seconds_to_stop_retry(self._client),
            )
        moments += _known(
            self._batches.seconds_to_next(now),
            self._seconds_to_drive(),
            self._mail.guard.seconds_to_alarm,
        )
        return max(_TICK, min(moments))

    def _seconds_to_drive(self) -> float | None:
        return self._motors.seconds_to_drive(self._client, silent=self._presence.silent)

    def _request(self, command: Command[ReplyT_co]) -> ReplyT_co:
        """Run one transaction of a longer piece of work, unless something goes before it."""
        self._collect()
        self._serve_urgent()
        return self._client.request(command)

    def _serve_urgent(self) -> bool:
        """Stop or drive when that is due; return whether the line was used."""
        if self._mail.stops:
            self._motors.stop(self._client, self._status)
            return True
        if self._mail.guard.is_abandoned:
            self._motors.stop_abandoned(self._client, self._status)
            return True
        if self._has_to_retry_stop():
            self._motors.retry_stop(self._client, self._status)
            return True
        seconds = self._seconds_to_drive()
        if seconds is None or seconds > 0:
            return False
        self._drive()
        return True

    def _drive(self) -> None:
        if self._presence.silent:
            # A board that comes back must not be met by a wish that is seconds old.
            self._motors.forget()
            return
        try:
            self._motors.drive(self._client)
        except (NoReply, BadReply) as error:
            self._note_failure(error)

    def _now(self) -> float:
        return self._client.transport.clock()

    # --- What was asked -----------------------------------------------------------------

    def _run(self, job: RunCommand | Write | Reload) -> None:
        try:
            value: object = None
            match job:
                case _ if self._presence.is_scanning(self._client, self._mail.expected):
                    self._refuse()
                case RunCommand(command=command):
                    self._mail.guard.check(command)
                    if command.moves:
                        # At once: behind a stop that comes now it would start what was stopped.
                        self._motors.leave()
                        value = self._client.request(command)
                    else:
                        value = self._request(command)
                case Write():
                    value = self._write(job)
                case Reload():
                    returned = ReadReason.RETURNED if self._presence.silent else ReadReason.RELOADED
                    self._read_everything(returned)
        except (BadRequest, NoReply, BadReply, Rejected) as error:
            self._emit(Outcome(job.id, error=error))
        except Exception:
            # The line ends: this waits for its outcome as everything else that is dropped.
            self._mail.jobs.appendleft(job)
            raise
        else:
            self._emit(Outcome(job.id, value))

    def _write(self, job: Write) -> tuple[WriteResult, ...]:
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
            if is_closing() and self._motors.may_move and not has_stopped:
                has_stopped = True
                self._motors.stop_on_close(self._client, self._status)
            self._serve_urgent()
            return self._client.request(command)

        results = write_all(
            request,
            self._specs,
            job.parameters,
            job.calibrations,
            self._progress,
            source=None if self._state is None else self._state.source,
            cancelled=is_closing,
        )
        for written in results:
            if written.what == ParameterKey.SERIAL_TIMEOUT and isinstance(written.stored, int):
                self._polling.take(written.stored, self._known_state)
        return results

    def _refuse(self) -> None:
        """Let nothing that a person asks reach a board at settings which nobody knows."""
        raise NoReply("No board answers; it is being looked for.")

    @property
    def _known_state(self) -> DeviceState:
        if self._state is None:
            raise NoReply("No board has been read yet.")
        return self._state

    @property
    def _specs(self) -> ParameterSet:
        return self._known_state.specs

    @property
    def _line(self) -> LineSettings:
        return self._client.settings.line

    def _progress(self, done: int, total: int, what: str) -> None:
        self._emit(Progress(done, total, what))

    # --- Polling ------------------------------------------------------------------------

    def _poll(self, topic: Topic) -> None:
        try:
            sample = poll(self._request, topic, self._now, self._status)
            self._presence.note_answer()
            if topic is Topic.STATUS:
                self._note_status(sample if isinstance(sample, LatchedStatus) else None)
            if sample is not None:
                self._batches.add(sample)
            if (
                isinstance(sample, ModeSample)
                and self._state
                and sample.mode is not self._state.mode
            ):
                # The power was off and a jumper has moved: everything may be different now.
                if self._motors.may_move:
                    self._motors.stop_and_confirm(self._client, self._status)
                self._read_everything(ReadReason.MODE_CHANGED)
        except (NoReply, BadReply) as error:
            self._note_failure(error)

    def _note_status(self, news: LatchedStatus | None) -> None:
        values = {} if self._state is None else self._state.parameters
        self._motors.note_status(
            news,
            self._now(),
            is_whole=not self._status.uart_due,
            stops_on_error=bool(values.get(ParameterKey.UART_ERROR_SHUTDOWN)),
        )

    def _note_failure(self, error: StudioError) -> None:
        if self._presence.note_failure(self._now()):
            self._give_up_driving()
            self._mail.guard.is_reachable = False
            self._motors.stop_without_reply(self._client)
            self._flush()
            self._emit(NotResponding(str(error), replace(self._client.counters)))

    # --- Silence ------------------------------------------------------------------------

    def _look_again(self) -> None:
        """See whether the board is back; if it is, it may have been through a power cycle."""
        try:
            self._motors.stop_without_reply(self._client)
            if not self._presence.is_scanning(self._client, self._mail.expected):
                self._client.request(GetMode())
            elif not self._look_at_next_place():
                return
            if self._motors.may_move:
                self._motors.stop_and_confirm(self._client, self._status)
            self._read_everything(ReadReason.RETURNED)
        except (NoReply, BadReply):
            self._presence.retry_later(self._now())

    def _look_at_next_place(self) -> bool:
        """Put one question; return whether the board answered. The session goes on there."""
        found = self._presence.look(self._client, self._mail.expected)
        if found is None:
            return False
        if found is not self._client:
            self._client = found
            self._mail.expected = ()
        return True

    def _flush(self) -> None:
        self._batches.tell(self._client.counters, self._now())
