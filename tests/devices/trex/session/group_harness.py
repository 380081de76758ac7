"""Two boards that are driven together in virtual time."""

import math
import random
from collections import deque
from collections.abc import Callable
from dataclasses import replace

from tests.devices.trex.session.helpers import outcomes, run_for
from tests.devices.trex.simulator.ports import a_board
from tests.support.virtual import SessionHarness
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
OPENED = 2.0  # seconds after which both boards were read


class GroupHarness(SessionHarness):
    """Boards 7 and 9 on one line, driven forward from `OPENED`."""

    def __init__(self) -> None:
        self.seventh, self.ninth = a_board(7), a_board(9)
        super().__init__(self.seventh, self.ninth)
        self.boards = {7: self.seventh, 9: self.ninth}

    def drive(
        self, until: float, also: dict[float, Request | Callable[[], object]] | None = None
    ) -> None:
        """Drive with heartbeats. Run other actions at their times."""
        self.script.at(OPENED, Arm())
        for number in self.boards:
            self.script.at(OPENED, ToBoard(number, FORWARD))
        beats: dict[float, object] = {OPENED + 0.1 * one: Heartbeat() for one in range(1, 600)}
        for moment, step in sorted((beats | (also or {})).items()):
            if moment <= until:
                self.script.at(moment, step)  # type: ignore[arg-type]

    @property
    def moving(self) -> set[int]:
        return {
            number
            for number, board in self.boards.items()
            if any(one.speed and one.direction is not MotorDirection.BRAKE for one in board.motors)
        }

    def stops_of(self, number: int) -> list[float]:
        """Return the end times of the stops of a board."""
        framing = replace(GROUP, device_number=number, group=()).framing
        last = framing.encode(STOP[-1])
        seconds = LineSettings().seconds(len(last))
        return [time + seconds for time, data in self.transport.written if data == last]


def of(number: int, reports: list[Report]) -> list[Report]:
    """Return the reports of one board."""
    if number == 7:
        return [one for one in reports if not isinstance(one, OfBoard)]
    return [one.report for one in reports if isinstance(one, OfBoard) and one.number == number]


def stop_delays(presses: int, seed: int) -> tuple[list[float], list[float]]:
    """Return the seconds from each press to the end of the last stop, and to its outcome."""
    chance, harness = random.Random(seed), GroupHarness()
    pressed: list[float] = []
    now = OPENED
    for number in range(presses):
        harness.script.at(now, Arm())
        for one in harness.boards:
            harness.script.at(now, ToBoard(one, SetMotor(1, Drive.at(chance.randint(-127, 127)))))
        now += 0.03 + chance.random() / 14
        pressed.append(now)
        harness.script.at(now, Stop(number))
        now += 0.07
    ended: dict[int, float] = {}
    reports = harness.reports

    class Timed(list[Report]):
        def append(self, report: Report) -> None:
            super().append(report)
            if isinstance(report, Outcome):
                ended[report.id] = harness.line.now

    harness.reports = Timed(reports)
    run_for(harness, now, GROUP)
    assert all(one.error is None for one in outcomes(harness.reports).values())
    first = [
        max(next(time for time in harness.stops_of(number) if time > press) for number in (7, 9))
        for press in pressed
    ]
    return (
        [end - press for end, press in zip(first, pressed, strict=True)],
        [ended[number] - press for number, press in enumerate(pressed)],
    )


_PRESSED = 0.06  # seconds until a stop has brought every motor to rest
_LOST = 0.65  # the same after a board was lost
_FROZEN = 0.6  # the same after the last heartbeat
_ABSENT = 1.2  # shortest absence of a board: a shorter one may pass unnoticed beside a stop


class RandomSequences:
    """An inbox that arms, drives, stops, loses boards and returns them, at random.

    Attributes:
        problems: motors that moved when nothing allowed it, in lines for people.
        sequences: how often the motors were armed.
        stops: ids of the stops.
    """

    def __init__(self, harness: GroupHarness, count: int, seed: int) -> None:
        self.problems: list[str] = []
        self.sequences = 0
        self.stops: list[int] = []
        self._stage, self._count, self._chance = harness, count, random.Random(seed)
        self._requests: deque[Request] = deque()
        self._next_at = self._beat_at = OPENED
        self._rest_from = 0.0  # when every motor has to be at rest
        self._returns: dict[int, float] = {}  # when boards that are lost come back
        self._lost_at: dict[int, float] = {}
        self._trace: deque[str] = deque(maxlen=12)

    def get(self, seconds: float) -> Request | None:
        line = self._stage.line
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
        if moving := self._stage.moving if now > self._rest_from else set():
            self.problems.append(f"{now:.3f}: {moving} moves after {list(self._trace)}")
            self._rest_from = math.inf
        if now >= self._beat_at:
            self._beat_at = now + HEARTBEAT_INTERVAL
            self._requests.append(Heartbeat())
        for number in [one for one, at in self._returns.items() if now >= at]:
            del self._returns[number], self._lost_at[number]
            board = self._stage.boards[number]
            if board.so_ground:
                board.so_ground = False
            else:
                board.power_on()
            self._trace.append(f"{now:.3f} {number} returns")
        if self.sequences >= self._count:
            self._requests.append(Close())
        elif self._chance.random() < 0.35:
            self._happen(now)

    def _happen(self, now: float) -> None:
        number = self._chance.choice((7, 9))
        kind = self._chance.choice((*("arm", "drive") * 5, "stop", "stop one", "lose", "freeze"))
        if self._beat_at - now > HEARTBEAT_INTERVAL:
            kind = "lose"  # the program hangs
        self._trace.append(f"{now:.3f} {kind} {number}")
        match kind:
            case "arm":
                self.sequences += 1
                noticed = min(self._lost_at.values(), default=math.inf) + _LOST
                self._rest_from = noticed if noticed > now else self._rest_from
                self._requests.append(Arm())
            case "drive":
                speed = Drive.at(self._chance.randint(-127, 127))
                motor = self._chance.choice((1, 2))
                self._requests.append(ToBoard(number, SetMotor(motor, speed)))
            case "stop" | "stop one":
                self.stops.append(len(self.stops))
                stop = Stop(self.stops[-1])
                self._requests.append(stop if kind == "stop" else ToBoard(number, stop))
                self._rest_from = min(self._rest_from, now + _PRESSED)
            case "lose" if number not in self._returns:
                self._returns[number] = now + self._chance.uniform(_ABSENT, 2.5)
                self._lost_at[number] = now
                self._rest_from = min(self._rest_from, now + _LOST)
                board = self._stage.boards[number]
                if self._chance.random() < 0.5:
                    board.power_off()
                else:
                    board.so_ground = True  # it hears, and is not heard
            case "freeze":
                self._beat_at = now + self._chance.uniform(0.7, 1.5)
                self._rest_from = min(self._rest_from, now + _FROZEN)


def run_sequences(count: int, seed: int) -> list[str]:
    """Return the failures of random sequences."""
    harness = GroupHarness()
    inbox = RandomSequences(harness, count, seed)
    reports, untrue = harness.reports, list[str]()

    def record(report: Report) -> None:
        """Compare a confirmation with the boards at that moment."""
        reports.append(report)
        if isinstance(report, Outcome) and report.error is None and harness.moving:
            untrue.append(f"{harness.line.now:.3f}: {harness.moving} moves after a confirmed stop")

    TrexSession(GROUP, inbox, record, lambda _: harness.transport).run()
    every = [one.report if isinstance(one, OfBoard) else one for one in reports]
    found, ended = [*inbox.problems, *untrue], outcomes(every)
    found += [f"stop {number} has no outcome" for number in inbox.stops if number not in ended]
    found += ["motors may move, unreported"] if harness.moving else []
    return found
