"""The log of stops and of what was applied."""

import pytest
from pytestqt.qtbot import QtBot

from trex_gui.core.errors import NoReply
from trex_gui.core.events import EventKind
from trex_gui.devices.trex.board import WriteResult
from trex_gui.devices.trex.model.board_events import BoardEvents
from trex_gui.devices.trex.model.motors import Motors
from trex_gui.ui.event_log import MOST_EVENTS


class EventSetup:
    """The event log and the motors that it watches."""

    def __init__(self) -> None:
        self.motors = Motors()
        self.events = BoardEvents(self.motors)

    @property
    def logged(self) -> list[tuple[str, str]]:
        return [(event.kind.value, event.text) for event in self.events.all]


@pytest.fixture
def setup(qtbot: QtBot) -> EventSetup:
    return EventSetup()


def test_stop_is_logged_with_its_reason(setup: EventSetup) -> None:
    setup.motors.press_stop()
    setup.motors.stop("the pad was let go")
    assert setup.logged == [("stop", "Stop"), ("stop", "Stop: the pad was let go")]


def test_apply_event_names_three_settings_and_counts_the_rest(setup: EventSetup) -> None:
    results = [WriteResult(f"key{number}", number) for number in range(5)]
    results.append(WriteResult("key5", error=NoReply("silence")))
    setup.events.note_applied(tuple(results), ("A", "B", "C", "D", "E", "F"))
    assert setup.logged == [("apply", "Apply: A, B, C and 2 more (1 failed)")]


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
