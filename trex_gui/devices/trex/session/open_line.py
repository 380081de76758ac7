"""The open line of a session, for each of its boards: what reads, writes or drives over it."""

import math
from collections.abc import Callable
from dataclasses import dataclass, replace

from trex_gui.core.errors import BadReply, NoReply, StudioError
from trex_gui.core.session import Closing, Progress
from trex_gui.core.timing import FRAME
from trex_gui.core.transport.guarded import GuardedTransport
from trex_gui.devices.trex.client.client import Counters, TrexClient
from trex_gui.devices.trex.client.telemetry import Sample, StatusReader
from trex_gui.devices.trex.driving.motor_driver import MotorDriver, StopRun, stop_together
from trex_gui.devices.trex.driving.motor_output import MotorOutput, OutputEvent
from trex_gui.devices.trex.driving.requests import MotorsStopped
from trex_gui.devices.trex.protocol.commands import Command, ReplyT_co
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.devices.trex.protocol.errors import ErrorCode, TrexRequestError
from trex_gui.devices.trex.session.messages import (
    Batch,
    BoardReport,
    GuardianChanged,
    NotResponding,
)
from trex_gui.devices.trex.session.polling import Topic
from trex_gui.devices.trex.session.reconnecting import LivenessMonitor
from trex_gui.devices.trex.session.request_queue import BoardQueue, TrexRequestQueue

_MOST_UNANSWERED = 3
"""Unanswered rounds in a row after which one board of several counts as silent.

A stop is repeated with every attempt to find it again."""


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


@dataclass(slots=True, eq=False)
class OpenLine:
    """The line as one board of a session uses it, and the order in which they share it."""

    client: TrexClient
    transport: GuardedTransport
    motors: MotorOutput
    driver: MotorDriver
    status: StatusReader
    liveness: LivenessMonitor
    requests: TrexRequestQueue  # of every board
    queue: BoardQueue
    batcher: SampleBatcher
    emit: Callable[[BoardReport], None]
    # Every board on this line that is driven, this one too
    boards: list["OpenLine"]
    reserved: frozenset[int]  # numbers of other devices, without those of `boards`
    has_driven: bool = False  # since no stop was sent to each board on the line
    is_guarded: bool = False  # as last reported

    @property
    def settings(self) -> ConnectionSettings:
        """How the board is reached now, with the numbers that the user has reserved."""
        return replace(self.client.settings, reserved=self.reserved)

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
        self.requests.collect(seconds)
        for board in self.boards:
            board.client.keepalive_while_waiting = board.motors.is_armed
        if self.requests.is_closing:
            raise Closing

    def serve_motors(self) -> bool:
        """Stop boards or drive one if that is due; return whether the line was used."""
        return self.serve_stops() or self.drive_next()

    def serve_stops(self) -> bool:
        runs = {board: run for board in self.boards for run in board.due_stops()}
        if runs:
            self._stop(runs)
        return bool(runs)

    def drive_next(self) -> bool:
        return any(board.drive() for board in self.boards)

    def stop_and_confirm(self) -> bool:
        """Stop this board unprompted, for good; return whether it has confirmed it."""
        run = self.driver.final_stop()
        self._stop({self: run})
        return run.is_confirmed

    def _stop(self, runs: dict["OpenLine", StopRun]) -> None:
        """Stop boards, and those whose stops become due before all is confirmed."""

        def due() -> list[StopRun]:
            self.requests.collect()
            others = [one for one in self.boards if one not in runs]
            more = {one: run for one in others for run in one.due_stops()}
            for run in more.values():
                run.most_unanswered = _MOST_UNANSWERED
            runs.update(more)
            return list(more.values())

        if len(self.boards) == 1:
            stop_together(list(runs.values()))
            return
        for run in runs.values():
            run.most_unanswered = _MOST_UNANSWERED
        stop_together(list(runs.values()), due)
        for board, run in runs.items():
            for error in run.unanswered:  # nothing may drive the others before it responds again
                board.note_failure(error)

    def due_stops(self) -> list[StopRun]:
        """Return the stop that is due; see `MotorDriver.take_over_stop` for a shared line."""
        if self.motors.quality.is_shared:
            return [self.driver.take_over_stop()]
        if (run := self.driver.due_stop()) is not None:
            return [run]
        left = next((one for one in self.boards if not one.motors.is_armed), None)
        if left is None or not self.motors.is_armed:
            return []
        self.motors.handle(OutputEvent.STOP, self.now())
        run = self.driver.final_stop()
        number = left.client.settings.device_number
        run.end = lambda confirmed: self.emit(
            MotorsStopped(ErrorCode.LEFT_GROUP, confirmed, number)
        )
        return [run]

    def drive(self) -> bool:
        try:
            return self.driver.serve()
        except (NoReply, BadReply) as error:
            self.note_failure(error)
            return True

    def stop_if_moving(self) -> None:
        if self.motors.may_move:
            self.stop_and_confirm()

    def require_alone(self) -> None:
        if len(self.boards) > 1:
            raise TrexRequestError(ErrorCode.IN_GROUP)

    def require_stopped(self) -> None:
        if any(board.motors.is_armed or board.motors.may_move for board in self.boards):
            raise TrexRequestError(ErrorCode.OTHERS_WHILE_DRIVING)

    def note_failure(self, error: StudioError, topic: Topic | None = None) -> None:
        """Note a missing or corrupted reply; a few in a row are a board that does not respond."""
        self.motors.restart.note_lost_reply()
        if self.liveness.note_failure(self.now(), topic):
            self.motors.handle(OutputEvent.NOT_RESPONDING, self.now())
            self.driver.stop_without_reply()
            others = (one for one in self.boards if one is not self)
            self._stop({one: run for one in others for run in one.due_stops()})
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
