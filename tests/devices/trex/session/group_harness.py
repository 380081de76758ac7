"""Two boards that are driven together in virtual time."""

import math
import random
from collections import deque
from collections.abc import Callable
from dataclasses import replace

from tests.devices.trex.session.helpers import TwoBoards, outcomes, timed_run
from trex_gui.core.session import Close, Outcome
from trex_gui.devices.trex.driving.requests import (
    HEARTBEAT_INTERVAL,
    Arm,
    Heartbeat,
    SetMotor,
    Stop,
)
from trex_gui.devices.trex.protocol.commands import STOP
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.devices.trex.protocol.driving import Drive
from trex_gui.devices.trex.protocol.line_settings import LineSettings
from trex_gui.devices.trex.session.messages import OfBoard, Report, Request, ToBoard
from trex_gui.devices.trex.session.session import TrexSession
from trex_gui.devices.trex.simulator.motors import MotorDirection

GROUP = ConnectionSettings("virtual", device_number=7, group=(7, 9))
FORWARD = SetMotor(1, Drive.at(90))
OPENED = 2.0  # seconds after which both boards have been read


class GroupHarness(TwoBoards):
    """Boards 7 and 9 on one line, driven together from `OPENED`."""

    def __init__(self) -> None:
        super().__init__()
        self.boards = {7: self.seventh, 9: self.ninth}

    def drive(
        self, until: float, actions: dict[float, Request | Callable[[], object]] | None = None
    ) -> None:
        """Schedule setpoints, heartbeats and actions by their times."""
        self.script.at(OPENED, Arm())
        for number in self.boards:
            self.script.at(OPENED, ToBoard(number, FORWARD))
        beats: dict[float, object] = {OPENED + 0.1 * beat: Heartbeat() for beat in range(1, 600)}
        for moment, step in sorted((beats | (actions or {})).items()):
            if moment <= until:
                self.script.at(moment, step)  # type: ignore[arg-type]

    @property
    def moving(self) -> set[int]:
        """Numbers of the boards that drive a motor."""
        return {
            number
            for number, board in self.boards.items()
            if any(
                motor.speed and motor.direction is not MotorDirection.BRAKE
                for motor in board.motors
            )
        }

    def stop_times(self, number: int) -> list[float]:
        """Return the times at which the stops of a board have been sent."""
        framing = replace(GROUP, device_number=number, group=()).framing
        last = framing.encode(STOP[-1])
        seconds = LineSettings().seconds(len(last))
        return [time + seconds for time, data in self.transport.written if data == last]


def reports_of(number: int, reports: list[Report]) -> list[Report]:
    """Return the reports of one board."""
    if number == 7:
        return [report for report in reports if not isinstance(report, OfBoard)]
    return [
        report.report
        for report in reports
        if isinstance(report, OfBoard) and report.number == number
    ]


def stop_delays(count: int, seed: int) -> tuple[list[float], list[float]]:
    """Return the seconds until each random stop is sent to both boards, and until its outcome."""
    chance, harness = random.Random(seed), GroupHarness()
    requested: list[float] = []
    now = OPENED
    for number in range(count):
        harness.script.at(now, Arm())
        for board in harness.boards:
            setpoint = SetMotor(1, Drive.at(chance.randint(-127, 127)))
            harness.script.at(now, ToBoard(board, setpoint))
        now += 0.03 + chance.random() / 14
        requested.append(now)
        harness.script.at(now, Stop(number))
        now += 0.07
    harness.script.at(now, Close())
    reports = timed_run(harness, GROUP)
    assert all(outcome.error is None for outcome in outcomes(each for _, each in reports).values())
    confirmed = {each.id: time for time, each in reports if isinstance(each, Outcome)}
    sent = [
        max(next(time for time in harness.stop_times(number) if time > start) for number in (7, 9))
        for start in requested
    ]
    return (
        [end - start for start, end in zip(requested, sent, strict=True)],
        [confirmed[number] - start for number, start in enumerate(requested)],
    )


_STOP_TIME = 0.06  # seconds from a stop until every motor is at rest
_LOSS_TIME = 0.65  # seconds from the loss of a board until every motor is at rest
_FREEZE_TIME = 0.6  # seconds from the last heartbeat until every motor is at rest
_SHORTEST_LOSS = 1.2  # seconds; a stop may conceal a shorter loss of a board


class RandomSequences:
    """Inbox that arms, drives and stops boards, and loses and returns them, at random.

    Attributes:
        problems: motors that moved without permission, as text.
        sequences: number of times that the motors were armed.
        stops: ids of the stops.
    """

    def __init__(self, harness: GroupHarness, count: int, seed: int) -> None:
        self.problems: list[str] = []
        self.sequences = 0
        self.stops: list[int] = []
        self._harness, self._count, self._chance = harness, count, random.Random(seed)
        self._requests: deque[Request] = deque()
        self._next_at = self._beat_at = OPENED
        self._rest_from = 0.0  # time at which every motor must be at rest
        self._returns: dict[int, float] = {}  # return times of lost boards
        self._lost_at: dict[int, float] = {}
        self._trace: deque[str] = deque(maxlen=12)

    def get(self, seconds: float) -> Request | None:
        line = self._harness.line
        end = line.now + seconds
        while not self._requests and self._next_at <= end:
            line.advance(max(0.0, self._next_at - line.now))
            self._next_at += self._chance.uniform(0.0, 0.04)
            self._act(line.now)
        if self._requests:
            return self._requests.popleft()
        line.advance(max(0.0, end - line.now))
        return None

    def _act(self, now: float) -> None:
        if moving := self._harness.moving if now > self._rest_from else set():
            self.problems.append(f"{now:.3f}: {moving} moves after {list(self._trace)}")
            self._rest_from = math.inf
        if now >= self._beat_at:
            self._beat_at = now + HEARTBEAT_INTERVAL
            self._requests.append(Heartbeat())
        for number in [lost for lost, time in self._returns.items() if now >= time]:
            del self._returns[number], self._lost_at[number]
            board = self._harness.boards[number]
            if board.so_ground:
                board.so_ground = False
            else:
                board.power_on()
            self._trace.append(f"{now:.3f} {number} returns")
        if self.sequences >= self._count:
            self._requests.append(Close())
        elif self._chance.random() < 0.35:
            self._perform(now)

    def _perform(self, now: float) -> None:
        number = self._chance.choice((7, 9))
        kind = self._chance.choice((*("arm", "drive") * 5, "stop", "stop board", "lose", "freeze"))
        if self._beat_at - now > HEARTBEAT_INTERVAL:
            kind = "lose"  # the program hangs
        self._trace.append(f"{now:.3f} {kind} {number}")
        match kind:
            case "arm":
                self.sequences += 1
                detected = min(self._lost_at.values(), default=math.inf) + _LOSS_TIME
                self._rest_from = detected if detected > now else self._rest_from
                self._requests.append(Arm())
            case "drive":
                speed = Drive.at(self._chance.randint(-127, 127))
                motor = self._chance.choice((1, 2))
                self._requests.append(ToBoard(number, SetMotor(motor, speed)))
            case "stop" | "stop board":
                self.stops.append(len(self.stops))
                stop = Stop(self.stops[-1])
                self._requests.append(stop if kind == "stop" else ToBoard(number, stop))
                self._rest_from = min(self._rest_from, now + _STOP_TIME)
            case "lose" if number not in self._returns:
                self._returns[number] = now + self._chance.uniform(_SHORTEST_LOSS, 2.5)
                self._lost_at[number] = now
                self._rest_from = min(self._rest_from, now + _LOSS_TIME)
                board = self._harness.boards[number]
                if self._chance.random() < 0.5:
                    board.power_off()
                else:
                    board.so_ground = True  # the board receives, but its replies are lost
            case "freeze":
                self._beat_at = now + self._chance.uniform(0.7, 1.5)
                self._rest_from = min(self._rest_from, now + _FREEZE_TIME)


def run_sequences(count: int, seed: int) -> list[str]:
    """Return the problems of random sequences, as text."""
    harness = GroupHarness()
    inbox = RandomSequences(harness, count, seed)
    reports, false_confirmations = harness.reports, list[str]()

    def record(report: Report) -> None:
        """Compare each confirmation with the motors at that moment."""
        reports.append(report)
        if isinstance(report, Outcome) and report.error is None and harness.moving:
            false_confirmations.append(
                f"{harness.line.now:.3f}: {harness.moving} moves after a confirmed stop"
            )

    TrexSession(GROUP, inbox, record, lambda _: harness.transport).run()
    found = outcomes(report.report if isinstance(report, OfBoard) else report for report in reports)
    problems = [*inbox.problems, *false_confirmations]
    problems += [f"stop {number} has no outcome" for number in inbox.stops if number not in found]
    problems += ["motors move after the end"] if harness.moving else []
    return problems
