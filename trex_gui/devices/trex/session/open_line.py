"""The open line of a session: every part that reads, writes or drives over it."""

import math
from collections.abc import Callable
from dataclasses import dataclass, replace

from trex_gui.core.errors import BadReply, NoReply, StudioError
from trex_gui.core.session import Closing, Progress
from trex_gui.core.timing import FRAME
from trex_gui.core.transport.guarded import GuardedTransport
from trex_gui.devices.trex.client.client import Counters, TrexClient
from trex_gui.devices.trex.client.telemetry import Sample, StatusReader
from trex_gui.devices.trex.driving.motor_driver import MotorDriver
from trex_gui.devices.trex.driving.motor_output import MotorOutput, OutputEvent
from trex_gui.devices.trex.protocol.commands import Command, ReplyT_co
from trex_gui.devices.trex.protocol.errors import ErrorCode, TrexRequestError
from trex_gui.devices.trex.session.messages import Batch, GuardianChanged, NotResponding, Report
from trex_gui.devices.trex.session.polling import Topic
from trex_gui.devices.trex.session.reconnecting import LivenessMonitor
from trex_gui.devices.trex.session.request_queue import TrexRequestQueue


class SampleBatcher:
    def __init__(self, report: Callable[[Batch], None]) -> None:
        self._report = report
        self._samples: list[Sample] = []
        self._last_flush = 0.0
        self.interval = FRAME  # least seconds between two batches
        self.add = self._samples.append
        self.extend = self._samples.extend

    def seconds_to_next(self, now: float) -> float:
        return self._last_flush + self.interval - now if self._samples else math.inf

    def flush(self, counters: Counters, now: float) -> None:
        self._last_flush = now
        if self._samples:
            batch = Batch(tuple(self._samples), replace(counters))
            self._samples.clear()
            self._report(batch)


@dataclass(slots=True)
class OpenLine:
    """The parts of a session that share its line, and the order in which they use it."""

    client: TrexClient
    transport: GuardedTransport
    motors: MotorOutput
    driver: MotorDriver
    status: StatusReader
    liveness: LivenessMonitor
    queue: TrexRequestQueue
    batcher: SampleBatcher
    emit: Callable[[Report], None]
    has_driven: bool = False  # since no stop was sent to each board on the line
    is_guarded: bool = False  # as last reported

    def now(self) -> float:
        return self.client.transport.clock()

    def request(self, command: Command[ReplyT_co]) -> ReplyT_co:
        """Run one transaction of a longer operation, after whatever is more urgent."""
        self.collect()
        self.serve_motors()
        return self.client.request(command)

    # --- What is more urgent ------------------------------------------------------------

    def collect(self, seconds: float = 0.0) -> None:
        """Take requests, and wait for one; raise `Closing` at the end."""
        self.queue.collect(seconds)
        self.client.keepalive_while_waiting = self.motors.is_armed
        if self.queue.is_closing:
            raise Closing

    def serve_motors(self) -> bool:
        """Stop or drive if that is due; return whether the line was used."""
        try:
            if self.motors.quality.is_shared:
                self.driver.stop_after_take_over()
                return True
            return self.driver.serve()
        except (NoReply, BadReply) as error:
            self.note_failure(error)
            return True

    def stop_if_moving(self) -> None:
        if self.motors.may_move:
            self.driver.stop_and_confirm()

    def require_stopped(self) -> None:
        if self.motors.is_armed or self.motors.may_move:
            raise TrexRequestError(ErrorCode.OTHERS_WHILE_DRIVING)

    def note_failure(self, error: StudioError, topic: Topic | None = None) -> None:
        """Note a missing or corrupted reply; a few in a row are a board that does not respond."""
        self.motors.restart.note_lost_reply()
        if self.liveness.note_failure(self.now(), topic):
            self.motors.handle(OutputEvent.NOT_RESPONDING, self.now())
            self.driver.stop_without_reply()
            self.flush()
            self.emit(NotResponding(str(error), replace(self.client.counters)))

    # --- Reports ------------------------------------------------------------------------

    def flush(self) -> None:
        self.batcher.flush(self.client.counters, self.now())

    def flush_if_due(self, now: float) -> None:
        """Report the samples of a display frame."""
        if self.batcher.seconds_to_next(now) <= 0:
            self.flush()

    def report_progress(self, done: int, total: int, what: str) -> None:
        self.emit(Progress(done, total, what))

    def report_guardian(self) -> None:
        if self.transport.is_guarded != self.is_guarded:
            self.is_guarded = not self.is_guarded
            self.emit(GuardianChanged(self.is_guarded))
