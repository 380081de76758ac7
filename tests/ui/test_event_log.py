"""What happened to a board, in the order in which it happened."""

import pytest
from pytestqt.qtbot import QtBot

from trex_gui.core.errors import NoReply
from trex_gui.devices.trex.client.reading import DeviceState
from trex_gui.devices.trex.client.telemetry import LatchedStatus
from trex_gui.devices.trex.client.writing import WriteResult
from trex_gui.devices.trex.model.board_events import BoardEvents
from trex_gui.devices.trex.model.connection import Connection
from trex_gui.devices.trex.model.motors import Motors
from trex_gui.devices.trex.protocol.commands import Signature
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.devices.trex.protocol.device_table import device_table
from trex_gui.devices.trex.protocol.flags import Mode, Status, UartError
from trex_gui.devices.trex.session.messages import Connected, ReadReason
from trex_gui.ui.event_log import MOST_EVENTS, EventKind

BOARD = DeviceState(
    Signature(device_table().model("trex"), "1.2"), Mode.SERIAL_RC, True, {}, {}, calibrated=0
)


class EventSetup:
    """The event log and the models that it watches, on a clock that a test sets."""

    def __init__(self) -> None:
        self.now = 0.0
        self.motors = Motors()
        self.connection = Connection()
        self.events = BoardEvents(self.motors, self.connection, clock=lambda: self.now)

    def see(self, time: float, status: Status, uart: int = 0) -> None:
        self.events.note_status(LatchedStatus(time, status, UartError(uart)))

    @property
    def logged(self) -> list[tuple[float, str, str]]:
        return [(event.time, event.kind.value, event.text) for event in self.events.all]


@pytest.fixture
def setup(qtbot: QtBot) -> EventSetup:
    return EventSetup()


def test_stop_is_logged_with_its_reason(setup: EventSetup) -> None:
    setup.motors.press_stop()
    setup.now = 1.5
    setup.motors.stop("the pad was let go")
    assert setup.logged == [(0, "stop", "Stop"), (1.5, "stop", "Stop: the pad was let go")]


def test_lasting_fault_is_one_event_and_recurring_fault_two(setup: EventSetup) -> None:
    for tenth in range(30):
        setup.see(tenth / 10, Status.MOTOR1_FAULT)
    setup.see(9, Status.MOTOR1_FAULT | Status.MOTOR2_OVER_LIMIT)
    assert setup.logged == [
        (0, "fault", "Motor 1 fault"),
        (9, "fault", "Motor 1 fault"),
        (9, "over-limit", "Motor 2 over current limit"),
    ]


def test_serial_timeout_is_an_event_and_framing_error_is_not(setup: EventSetup) -> None:
    setup.see(1, Status.UART_ERROR, UartError.FRAMING)
    setup.see(2, Status.UART_ERROR, UartError.TIMEOUT)
    assert setup.logged == [(2, "timeout", "Serial timeout")]


def test_connection_is_logged_from_its_beginning_to_its_end(setup: EventSetup) -> None:
    setup.connection.line_closed.emit(None)
    assert not setup.logged, "it was never connected"
    for now in (1, 5):
        setup.now = now
        setup.connection.device_read.emit(
            Connected(BOARD, False, ReadReason.OPENED, ConnectionSettings("/dev/ttyUSB0"))
        )
        setup.connection.not_responding.emit()
        setup.connection.line_closed.emit(None)
    where = "/dev/ttyUSB0 at 19200 baud, no error detection, 1 stop bit"
    assert setup.logged == [
        (5, "link", f"Connected to TReX 1.2 on {where}."),
        (5, "link", "The board stopped responding"),
        (5, "link", "Disconnected"),
    ]


def test_apply_event_names_three_settings_and_counts_the_rest(setup: EventSetup) -> None:
    results = [WriteResult(f"key{number}", number) for number in range(5)]
    results.append(WriteResult("key5", error=NoReply("silence")))
    setup.events.note_applied(tuple(results), ("A", "B", "C", "D", "E", "F"))
    assert setup.logged == [(0, "apply", "Apply: A, B, C and 2 more (1 failed)")]


def test_late_event_is_sorted_by_time(setup: EventSetup) -> None:
    for time in (1.0, 3.0, 2.0):
        setup.events.add(EventKind.NOTE, str(time), time)
    assert [event.time for event in setup.events.all] == [1, 2, 3]


def test_oldest_events_are_dropped_beyond_the_limit(setup: EventSetup) -> None:
    for number in range(MOST_EVENTS + 5):
        setup.events.add(EventKind.NOTE, "", float(number))
    assert len(setup.events.all) == MOST_EVENTS
    assert setup.events.all[0].time == 5
    setup.events.clear()
    assert not setup.events.all
