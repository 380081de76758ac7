"""Event log of a board, and message log of a workspace."""

from datetime import datetime

import pytest
from PySide6.QtGui import QGuiApplication
from PySide6.QtWidgets import QPlainTextEdit
from pytestqt.qtbot import QtBot

from tests.support.window import WidgetDriver
from trex_gui.core.errors import NoReply
from trex_gui.core.events import Event, EventKind
from trex_gui.devices.trex.board import WriteResult
from trex_gui.devices.trex.model.device import Device
from trex_gui.ui.diagnostics.place import LogPage
from trex_gui.ui.help.messages import MessageHelp
from trex_gui.ui.log import MAX_ENTRIES, MAX_EVENTS, EventLog, Log
from trex_gui.ui.notifier import Notifier
from trex_gui.ui.widgets.view import copy_lines

NOON = datetime(2026, 11, 23, 12, 0, 0).astimezone().timestamp()


class Clocks:
    """Session clock and wall clock, set together."""

    now = 100.0

    def time(self) -> float:
        return NOON + self.now - 100


@pytest.fixture
def clocks(monkeypatch: pytest.MonkeyPatch) -> Clocks:
    clocks = Clocks()
    monkeypatch.setattr("trex_gui.ui.log.now", lambda: clocks.now)
    monkeypatch.setattr("trex_gui.ui.log.time", clocks)
    return clocks


def lines(log: Log) -> list[str]:
    return [entry.line for entry in log.entries]


def test_entries_have_the_times_of_their_events(qtbot: QtBot, clocks: Clocks) -> None:
    log, events = Log(), EventLog()
    log.follow(events)
    clocks.now = 103
    events.put(Event(101.0, EventKind.STOP, "Stop: Esc"))
    events.add(EventKind.FAULT, "Motor 1 fault", is_problem=True)
    log.add("Saved\nin  a file.")
    events.clear()
    assert lines(log) == [
        "2026-11-23 12:00:01  Stop: Esc",
        "2026-11-23 12:00:03  ⚠ Motor 1 fault",
        "2026-11-23 12:00:03  Saved in a file.",
    ]


def test_message_repeated_at_once_is_logged_once(qtbot: QtBot, clocks: Clocks) -> None:
    log = Log()
    log.add("Gone.", is_problem=True)
    log.add("Gone.", is_problem=True)
    clocks.now += 5
    log.add("Gone.", is_problem=True)
    assert [entry.time.second for entry in log.entries] == [0, 5]


def test_messages_of_another_notifier_are_logged_but_not_shown(qtbot: QtBot) -> None:
    window, plot = Notifier(), Notifier()
    window.forward_log(plot)
    logged: list[tuple[str, bool]] = []
    shown: list[str] = []
    window.logged.connect(lambda *message: logged.append(message))
    window.info.connect(shown.append)
    plot.info.emit("The picture was written.")
    plot.report("Nothing was written.", ())
    window.delayed_info.emit("Later.")
    qtbot.waitUntil(lambda: len(logged) == 3)
    assert logged == [
        ("The picture was written.", False),
        ("Nothing was written.", True),
        ("Later.", False),
    ]
    assert shown == ["Later."]


def test_log_is_bounded(qtbot: QtBot, clocks: Clocks) -> None:
    log = Log()
    for number in range(MAX_ENTRIES + 3):
        log.add(f"{number} " + "long " * 1000)
    assert len(log.entries) == MAX_ENTRIES
    assert log.entries[0].text.startswith("3 ")
    assert len(log.entries[0].text) < 2100


def test_lines_are_filtered_and_copied(qtbot: QtBot, clocks: Clocks) -> None:
    log, notifier = Log(), Notifier()
    page = LogPage(log, "trex", MessageHelp({}))
    qtbot.addWidget(page)
    driver = WidgetDriver(page, qtbot)
    text = driver.find(QPlainTextEdit, "trexLog")

    def shown() -> list[str]:
        return [line[21:] for line in text.toPlainText().splitlines()]

    log.add("Stop: Esc")
    page.show()
    log.add("The line is gone.", is_problem=True)
    log.add("The board stopped responding", is_problem=True)
    assert shown() == ["Stop: Esc", "⚠ The line is gone.", "⚠ The board stopped responding"]
    page.search(" STOP")
    assert shown() == ["Stop: Esc", "⚠ The board stopped responding"]
    driver.click("trexLogProblems")
    log.add("Stop: screen locked")
    assert shown() == ["⚠ The board stopped responding"]
    copy_lines(page.lines(), notifier)
    line = "2026-11-23 12:00:00  ⚠ The board stopped responding\n"
    assert QGuiApplication.clipboard().text() == line
    driver.click("trexLogProblems")
    page.search("")
    assert len(shown()) == 4


def test_stops_and_applied_settings_are_events(qtbot: QtBot) -> None:
    device = Device()
    device.motors.press_stop()
    device.motors.stop("the gamepad was unplugged")
    results = [WriteResult(f"key{number}", number) for number in range(5)]
    results.append(WriteResult("key5", error=NoReply("silence")))
    device.writer.finished.emit(tuple(results))
    assert [(event.kind.value, event.text) for event in device.events.all] == [
        ("stop", "Stop"),
        ("stop", "Stop: the gamepad was unplugged"),
        ("apply", "Apply: key0, key1, key2 and 2 more (1 failed)"),
    ]


def test_events_are_sorted_by_time_and_the_oldest_dropped(qtbot: QtBot) -> None:
    events = EventLog()
    for time in (1.0, 3.0, 2.0):
        events.put(Event(time, EventKind.NOTE, str(time)))
    assert [event.time for event in events.all] == [1, 2, 3]
    for number in range(4, MAX_EVENTS + 6):
        events.put(Event(float(number), EventKind.NOTE, ""))
    assert len(events.all) == MAX_EVENTS
    assert events.all[0].time == 6
    events.clear()
    assert not events.all
