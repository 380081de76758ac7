"""Open line of a session."""

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

# In a group, a board counts as silent after this number of unanswered stops in a row. Each attempt
# to reconnect repeats the stop.
_UNANSWERED_LIMIT = 3


class SampleBatcher:
    """Collects samples and reports them in batches."""

    def __init__(self, report: Callable[[Batch], None]) -> None:
        self._report = report
        self._samples: list[Sample] = []
        self._last_flush = 0.0
        self.interval = FRAME  # minimum time between two batches, in seconds
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
    """Line of one board, with its driver, monitor and queues.

    Stops are served before setpoints.
    """

    client: TrexClient
    transport: GuardedTransport
    motors: MotorOutput
    driver: MotorDriver
    status: StatusReader
    liveness: LivenessMonitor
    requests: TrexRequestQueue  # shared by all boards
    queue: BoardQueue
    batcher: SampleBatcher
    emit: Callable[[BoardReport], None]
    boards: list["OpenLine"]  # all boards of the session
    reserved: frozenset[int]  # numbers of devices outside the session
    has_driven: bool = False  # True after driving, until all boards on the line are stopped
    is_guarded: bool = False  # last reported state of the guardian

    @property
    def settings(self) -> ConnectionSettings:
        return replace(self.client.settings, reserved=self.reserved)

    def now(self) -> float:
        return self.client.transport.clock()

    def request(self, command: Command[ReplyT_co]) -> ReplyT_co:
        """Send due stops or setpoints, then run one transaction."""
        self.collect()
        self.serve_motors()
        return self.client.request(command)

    # --- Urgent work --------------------------------------------------------------------

    def collect(self, seconds: float = 0.0) -> None:
        """Handle new requests. Wait up to `seconds` for the first request.

        Raises:
            Closing: a `Close` was received.
        """
        self.requests.collect(seconds)
        for board in self.boards:
            board.client.keepalive_while_waiting = board.motors.is_armed
        if self.requests.is_closing:
            raise Closing

    def serve_motors(self) -> bool:
        return self.serve_stops() or self.drive_next()

    def serve_stops(self) -> bool:
        runs = {board: run for board in self.boards for run in board.due_stops()}
        if runs:
            self._stop(runs)
        return bool(runs)

    def drive_next(self) -> bool:
        return any(board.drive() for board in self.boards)

    def stop_and_confirm(self) -> bool:
        run = self.driver.final_stop()
        self._stop({self: run})
        return run.is_confirmed

    def _stop(self, runs: dict["OpenLine", StopRun]) -> None:
        """Stop these boards, and other boards whose stops become due meanwhile."""

        def newly_due() -> list[StopRun]:
            self.requests.collect()
            others = [board for board in self.boards if board not in runs]
            added = {board: run for board in others for run in board.due_stops()}
            for run in added.values():
                run.max_unanswered = _UNANSWERED_LIMIT
            runs.update(added)
            return list(added.values())

        if len(self.boards) == 1:
            stop_together(list(runs.values()))
            return
        for run in runs.values():
            run.max_unanswered = _UNANSWERED_LIMIT
        stop_together(list(runs.values()), newly_due)
        for board, run in runs.items():
            for error in run.unanswered:  # the group is not driven until this board responds
                board.record_failure(error)

    def due_stops(self) -> list[StopRun]:
        if self.motors.quality.is_shared:
            return [self.driver.takeover_stop()]
        if (run := self.driver.due_stop()) is not None:
            return [run]
        disarmed = next((board for board in self.boards if not board.motors.is_armed), None)
        if disarmed is None or not self.motors.is_armed:
            return []
        self.motors.handle(OutputEvent.STOP, self.now())
        run = self.driver.final_stop()
        number = disarmed.client.settings.device_number
        run.end = lambda confirmed: self.emit(
            MotorsStopped(ErrorCode.LEFT_GROUP, confirmed, number)
        )
        return [run]

    def drive(self) -> bool:
        try:
            return self.driver.serve()
        except (NoReply, BadReply) as error:
            self.record_failure(error)
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

    def record_failure(self, error: StudioError, topic: Topic | None = None) -> None:
        """Count a failed transaction. After some failures in a row, the board counts as silent."""
        self.motors.restart.record_lost_reply()
        if self.liveness.record_failure(self.now(), topic):
            self.motors.handle(OutputEvent.NOT_RESPONDING, self.now())
            self.driver.stop_without_reply()
            others = (board for board in self.boards if board is not self)
            self._stop({board: run for board in others for run in board.due_stops()})
            self.flush()
            self.emit(NotResponding(str(error), replace(self.client.counters)))

    # --- Reports ------------------------------------------------------------------------

    def flush(self) -> None:
        self.batcher.flush(self.client.counters, self.now())

    def flush_if_due(self, now: float) -> None:
        if self.batcher.seconds_to_next(now) <= 0:
            self.flush()

    def report_progress(self, done: int, total: int, next_step: str) -> None:
        self.emit(Progress(done, total, next_step))

    def report_guardian(self) -> None:
        if self.transport.is_guarded != self.is_guarded:
            self.is_guarded = not self.is_guarded
            self.emit(GuardianChanged(self.is_guarded))
