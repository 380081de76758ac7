"""One device at a time, whatever kind it is of."""

import pytest
from PySide6.QtCore import QObject, Signal

from trex_gui.link.settings import LinkSettings
from trex_gui.model.connection import Link
from trex_gui.model.kinds import Kind
from trex_gui.model.ports import Port, PortKind
from trex_gui.model.switchboard import Switchboard


class Road(QObject):
    """A way whose link does what the test says; see `switchboard.Way`."""

    changed = Signal()
    progressed = Signal(int, int, str)
    stop_told = Signal(str)

    def __init__(self, key: str) -> None:
        super().__init__()
        self.kind = Kind(key, key.title())
        self.link = Link.NONE
        self.starting = False
        self.port: Port | None = None
        self.done: list[str] = []

    status = line_text = unstopped = ""
    demo_in_use = has_line_settings = is_busy = False

    def connect_to(self, port: Port) -> None:
        self.done.append(f"connect {port.url}")
        self.port = port
        self.become(Link.UP)

    def connect_with(self, port: Port, settings: LinkSettings) -> None:
        self.done.append(f"with {settings.short}")
        self.connect_to(port)

    def leave(self) -> None:
        self.done.append("leave")
        if self.link is not Link.NONE:
            self.become(Link.CLOSING)

    def press_stop(self) -> None:
        self.done.append("stop")

    def stop_because(self, reason: str) -> str:
        self.done.append(f"stop: {reason}")
        return f"{reason}, so {self.kind.name} is told." if self.link is not Link.NONE else ""

    def begin_to_shut_down(self) -> None:
        self.done.append("begin to shut down")

    def shut_down(self) -> bool:
        self.done.append("shut down")
        return self.kind.key != "first"

    def become(self, link: Link) -> None:
        self.link = link
        self.changed.emit()


def port(url: str, device: str) -> Port:
    return Port(PortKind.TYPED, url, url, device)


@pytest.fixture
def roads(qapp: QObject) -> tuple[Road, Road]:
    return Road("first"), Road("second")


@pytest.fixture
def board(roads: tuple[Road, Road]) -> Switchboard:
    return Switchboard(roads)


def test_the_first_is_in_use_until_another_is_asked_for(
    board: Switchboard, roads: tuple[Road, Road]
) -> None:
    assert board.current is roads[0]
    assert board.is_idle
    board.connect_to(port("a", "first"))
    assert roads[0].done == ["connect a"]
    assert not board.is_idle


def test_the_device_before_is_left_first_and_awaited(
    board: Switchboard, roads: tuple[Road, Road]
) -> None:
    first, second = roads
    board.connect_to(port("a", "first"))
    board.connect_to(port("b", "second"))
    assert first.done[-1] == "leave"
    assert (second.done, board.current) == ([], first)
    first.become(Link.NONE)
    assert second.done == ["connect b"]
    assert board.current is second


def test_one_that_is_idle_is_left_too_since_it_may_wait_for_a_search(
    board: Switchboard, roads: tuple[Road, Road]
) -> None:
    board.connect_to(port("b", "second"))
    assert roads[0].done == ["leave"]
    assert roads[1].done == ["connect b"]


def test_leaving_forgets_what_was_to_come_next(
    board: Switchboard, roads: tuple[Road, Road]
) -> None:
    first, second = roads
    board.connect_to(port("a", "first"))
    board.connect_to(port("b", "second"))
    board.leave()
    first.become(Link.NONE)
    assert second.done == []


def test_the_newest_choice_counts(board: Switchboard, roads: tuple[Road, Road]) -> None:
    first, second = roads
    board.connect_to(port("a", "first"))
    board.connect_to(port("b", "second"))
    board.connect_with(port("c", "second"), LinkSettings(""))
    first.become(Link.NONE)
    assert second.done == ["with 19200 8N1", "connect c"]


def test_a_stop_reaches_every_device(board: Switchboard, roads: tuple[Road, Road]) -> None:
    board.press_stop()
    assert [road.done for road in roads] == [["stop"], ["stop"]]


def test_every_line_is_shut_down_though_one_does_not_end(
    board: Switchboard, roads: tuple[Road, Road]
) -> None:
    assert not board.shut_down()
    assert [road.done[-1] for road in roads] == ["shut down", "shut down"]


def test_no_line_waits_for_another_before_it_is_told_to_end(
    board: Switchboard, roads: tuple[Road, Road], monkeypatch: pytest.MonkeyPatch
) -> None:
    first, second = roads
    told: list[list[str]] = []

    def shut_down() -> bool:
        told.append(list(second.done))
        return True

    monkeypatch.setattr(first, "shut_down", shut_down)
    assert board.shut_down()
    assert told == [["begin to shut down"]]


def test_what_every_device_has_left_turning_is_told(
    board: Switchboard, roads: tuple[Road, Road]
) -> None:
    assert board.unstopped == ""
    roads[1].unstopped = "The second may turn."
    assert board.unstopped == "The second may turn."
    roads[0].unstopped = "The first may turn."
    assert board.unstopped == "The first may turn.\nThe second may turn."


@pytest.fixture
def told(board: Switchboard) -> list[str]:
    """What was told of stops that nobody asked for."""
    told: list[str] = []
    board.stop_told.connect(told.append)
    return told


def test_a_stop_that_nobody_asked_for_reaches_all_and_is_told_in_the_words_of_the_one_in_use(
    board: Switchboard, roads: tuple[Road, Road], told: list[str]
) -> None:
    board.connect_to(port("b", "second"))
    board.stop_because("It rains")
    assert [road.done[-1] for road in roads] == ["stop: It rains"] * 2
    assert told == ["It rains, so Second is told."]


def test_what_becomes_known_later_of_a_stop_is_told_for_the_device_in_use_only(
    board: Switchboard, roads: tuple[Road, Road], told: list[str]
) -> None:
    roads[1].stop_told.emit("The second stands.")
    assert told == []
    roads[0].stop_told.emit("The first stands.")
    assert told == ["The first stands."]


def test_with_nothing_connected_a_reason_is_told_only_where_it_is_news_by_itself(
    board: Switchboard, told: list[str]
) -> None:
    board.stop_because("It rains")
    assert told == []
    board.stop_because("The roof fell in", is_news=True)
    assert told == ["The roof fell in."]
