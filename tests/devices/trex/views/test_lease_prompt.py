"""Pages and prompts of a served board, which one user at a time may drive."""

import time
from collections.abc import Callable
from threading import Event
from typing import Any

import pytest
from PySide6.QtWidgets import QLabel, QPushButton, QTableWidget

from tests.support.window import WindowDriver
from trex_gui.devices.trex.client.client import Counters
from trex_gui.devices.trex.driving.requests import MotorsStopped
from trex_gui.devices.trex.protocol.errors import ErrorCode
from trex_gui.devices.trex.serve.robots import Robots
from trex_gui.devices.trex.session.messages import (
    HandOver,
    LeaseChanged,
    NetworkDelay,
    NotResponding,
    TakeLease,
)

MY_LEASE = LeaseChanged("me", "me", is_mine=True)
LEASE_OF_ALICE = LeaseChanged("me", "alice")
REFUSED = MotorsStopped(ErrorCode.OTHER_DRIVES, confirmed=True)


class ServedWindow:
    """Window of a served board, with its requests for the lease."""

    def __init__(self, window: WindowDriver, monkeypatch: pytest.MonkeyPatch) -> None:
        self.window = window
        self.connection = window.device.connection
        self.requested: list[Any] = []
        submit = self.connection.submit

        def record(request: object) -> bool:
            if isinstance(request, HandOver | TakeLease):
                self.requested.append(request)
                return True
            return submit(request)

        monkeypatch.setattr(self.connection, "submit", record)

    def report(self, report: object) -> None:
        self.connection.handle(report)

    @property
    def question(self) -> str:
        return self.window.window.question.text

    def press(self, name: str) -> None:
        self.window.find(QPushButton, name).click()


@pytest.fixture
def served(connected_window: WindowDriver, monkeypatch: pytest.MonkeyPatch) -> ServedWindow:
    return ServedWindow(connected_window, monkeypatch)


def texts(served: ServedWindow) -> list[str]:
    page = served.window.open_page("boardPage").root
    return [label.text() for label in page.findChildren(QLabel)]


def test_pages_show_driver_and_network_delay(served: ServedWindow) -> None:
    served.report(LEASE_OF_ALICE)
    served.report(NetworkDelay(0.0123))
    assert any("alice drives this robot" in text for text in texts(served))
    assert any("network 12 ms" in text for text in texts(served))
    served.report(MY_LEASE)
    assert not any("drives this robot" in text for text in texts(served))


def test_driver_hands_over_on_request(served: ServedWindow) -> None:
    served.report(MY_LEASE)
    assert not served.question
    served.report(LeaseChanged("me", "me", is_mine=True, waiting=("bob",)))
    assert "bob wants to drive" in served.question
    served.press("handOver")
    assert served.requested == [HandOver("bob")]


def test_prompt_closes_when_no_user_waits(served: ServedWindow) -> None:
    served.report(LeaseChanged("me", "me", is_mine=True, waiting=("bob",)))
    served.report(MY_LEASE)
    assert not served.question


@pytest.mark.parametrize("may_take", [True, False])
def test_owner_may_take_over(served: ServedWindow, may_take: bool) -> None:
    served.report(LeaseChanged("me", "alice", may_take=may_take))
    served.report(REFUSED)
    assert ("alice is driving" in served.question) is may_take
    if may_take:
        served.press("takeOver")
        assert served.requested == [TakeLease()]


def test_user_is_notified_of_the_handover(served: ServedWindow) -> None:
    served.report(LEASE_OF_ALICE)
    served.report(REFUSED)
    assert "Another user drives" in served.window.device.notifier.shown
    served.report(MY_LEASE)
    assert "You may drive now" in served.window.device.notifier.shown


def test_silent_network_is_distinguished_from_a_silent_board(served: ServedWindow) -> None:
    served.report(NotResponding("silent", Counters(), is_network=True))
    assert any("server of the robot does not respond" in text for text in texts(served))
    served.report(NotResponding("silent", Counters()))
    assert any("board does not respond" in text for text in texts(served))


# --- Robots on the network ----------------------------------------------------------------

ROBOT = {"name": "arm", "board": "TReX 1.2", "responds": True, "driver": "alice", "problems": []}


@pytest.fixture
def robots(monkeypatch: pytest.MonkeyPatch) -> list[dict[str, Any]]:
    """Two robots that a search of the network finds."""
    rows = [{**ROBOT, "url": f"trex://10.0.0.{number}/arm"} for number in (1, 2)]
    monkeypatch.setattr(Robots, "find", lambda _: rows)
    return rows


def test_robots_are_listed_and_offered_as_ports(
    window: WindowDriver, robots: list[dict[str, Any]]
) -> None:
    window.trigger("robots")
    window.wait_for_files()
    table = window.find(QTableWidget, "robotsTable")
    cells = [[table.item(row, column).text() for column in range(3)] for row in range(2)]  # type: ignore[union-attr]
    assert cells == [[row["url"], "TReX 1.2", "alice"] for row in robots]
    assert {row["url"] for row in robots} <= {port.url for port in window.program.ports.entries}
    assert window.find(QPushButton, "connectRobot").isEnabled()


@pytest.mark.parametrize(
    ("outcome", "text"),
    [
        (lambda urls: dict.fromkeys(urls, ""), "2 robots stopped"),
        (
            lambda urls: dict.fromkeys(urls, "The stop was sent"),
            "Stop not confirmed: trex://10.0.0.1",
        ),
    ],
)
def test_all_robots_are_stopped_and_named_if_not_confirmed(
    window: WindowDriver,
    robots: list[dict[str, Any]],
    monkeypatch: pytest.MonkeyPatch,
    outcome: Callable[[list[str]], dict[str, str]],
    text: str,
) -> None:
    monkeypatch.setattr(Robots, "stop", lambda _, urls: outcome(urls))
    window.trigger("robots")
    window.wait_for_files()
    window.find(QPushButton, "stopAllRobots").pressed.emit()
    window.wait_for_files()
    assert text in window.text("robotsNote")


@pytest.mark.realtime
def test_end_of_a_search_does_not_hide_an_unconfirmed_stop(
    window: WindowDriver, robots: list[dict[str, Any]], monkeypatch: pytest.MonkeyPatch
) -> None:
    window.trigger("robots")
    window.wait_for_files()
    stopped = Event()

    def find(_robots: Robots) -> list[dict[str, Any]]:
        stopped.wait(10)
        time.sleep(0.05)  # until the result of the stop is reported
        return robots

    def stop(_robots: Robots, urls: list[str]) -> dict[str, str]:
        stopped.set()
        return dict.fromkeys(urls, "No reply.")

    monkeypatch.setattr(Robots, "find", find)
    monkeypatch.setattr(Robots, "stop", stop)
    window.find(QPushButton, "findRobots").click()
    window.find(QPushButton, "stopAllRobots").pressed.emit()
    window.wait_for_files()
    assert window.is_enabled("findRobots")
    assert "Stop not confirmed" in window.text("robotsNote")


@pytest.mark.realtime
@pytest.mark.usefixtures("robots")
def test_closed_dialog_completes_and_reports_a_stop(
    window: WindowDriver, monkeypatch: pytest.MonkeyPatch
) -> None:
    calls: list[str] = []

    def stop(_robots: Robots, urls: list[str]) -> dict[str, str]:
        time.sleep(0.05)
        calls.append("stop")
        return dict.fromkeys(urls, "No reply.")

    monkeypatch.setattr(Robots, "stop", stop)
    monkeypatch.setattr(Robots, "close", lambda _: calls.append("close"))
    window.trigger("robots")
    window.wait_for_files()
    window.find(QPushButton, "stopAllRobots").pressed.emit()
    window.find(QPushButton, "closeRobots").click()
    window.wait(lambda: len(calls) == 2)
    assert calls == ["stop", "close"]
    assert "Stop not confirmed" in window.device.notifier.shown
