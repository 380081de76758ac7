"""What happened to a board, in the order in which it happened."""

import pytest
from pytestqt.qtbot import QtBot

from trex_gui.link.client import Counters
from trex_gui.link.messages import Batch
from trex_gui.link.telemetry import StatusNews
from trex_gui.link.writing import Written
from trex_gui.model.connection import Connection
from trex_gui.model.driving.motors import Motors
from trex_gui.model.event_watch import EventWatch
from trex_gui.model.events import MOST_EVENTS, EventKind, Events
from trex_gui.protocol.errors import NoReply
from trex_gui.protocol.flags import Status, UartError


class Scene:
    """Everything that events come of, on a clock that a test sets."""

    def __init__(self) -> None:
        self.now = 0.0
        self.events = Events(clock=lambda: self.now)
        self.motors = Motors()
        self.connection = Connection()
        self.watch = EventWatch(self.events, self.motors, self.connection)

    def see(self, time: float, status: Status, uart: int = 0) -> None:
        self.connection.sampled.emit(
            Batch((StatusNews(time, status, UartError(uart)),), Counters())
        )

    @property
    def told(self) -> list[tuple[float, str, str]]:
        return [(event.time, event.kind.value, event.text) for event in self.events.all]


@pytest.fixture
def scene(qtbot: QtBot) -> Scene:
    return Scene()


def test_a_stop_is_noted_with_its_reason(scene: Scene) -> None:
    scene.motors.press_stop()
    scene.now = 1.5
    scene.motors.stop("the pad was let go")
    assert scene.told == [(0, "stop", "Stop"), (1.5, "stop", "Stop: the pad was let go")]


def test_a_fault_that_lasts_is_one_event_and_one_that_comes_again_another(scene: Scene) -> None:
    for tenth in range(30):
        scene.see(tenth / 10, Status.MOTOR1_FAULT)
    scene.see(9, Status.MOTOR1_FAULT | Status.MOTOR2_OVER_LIMIT)
    assert scene.told == [
        (0, "fault", "Motor 1 fault"),
        (9, "fault", "Motor 1 fault"),
        (9, "over-limit", "Motor 2 over current limit"),
    ]


def test_a_serial_timeout_is_an_event_and_noise_is_not(scene: Scene) -> None:
    scene.see(1, Status.UART_ERROR, UartError.FRAMING)
    scene.see(2, Status.UART_ERROR, UartError.TIMEOUT)
    assert scene.told == [(2, "timeout", "Serial timeout")]


def test_a_line_that_is_lost_is_noted(scene: Scene) -> None:
    scene.connection.silenced.emit()
    scene.now = 3
    scene.connection.left.emit(None)
    assert [(time, kind) for time, kind, _ in scene.told] == [(0, "link"), (3, "link")]


def test_apply_names_what_was_written_and_counts_the_rest(scene: Scene) -> None:
    results = [Written(f"key{number}", number) for number in range(5)]
    results.append(Written("key5", error=NoReply("silence")))
    scene.watch.note_applied(tuple(results), ("A", "B", "C", "D", "E", "F"))
    assert scene.told == [(0, "apply", "Apply: A, B, C and 2 more (1 failed)")]


def test_an_event_that_is_told_late_stands_in_its_place(scene: Scene) -> None:
    for time in (1.0, 3.0, 2.0):
        scene.events.add(EventKind.NOTE, str(time), time)
    assert [event.time for event in scene.events.all] == [1, 2, 3]
    assert [event.time for event in scene.events.between(1.5, 2.5)] == [2]


def test_events_do_not_fill_the_memory(scene: Scene) -> None:
    for number in range(MOST_EVENTS + 5):
        scene.events.add(EventKind.NOTE, "", float(number))
    assert len(scene.events.all) == MOST_EVENTS
    assert scene.events.all[0].time == 5
    scene.events.clear()
    assert not scene.events.all
