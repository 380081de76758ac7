"""Request queue between two threads."""

import threading

import pytest

from tests.support.virtual_time import VirtualRuntime
from trex_gui.core.session import RequestQueue
from trex_gui.devices.trex.driving.requests import Stop


class WatchedCondition(threading.Condition):
    """Condition that shows whether a thread waits."""

    def __init__(self) -> None:
        super().__init__()
        self.has_waiter = threading.Event()

    def wait(self, timeout: float | None = None) -> bool:
        self.has_waiter.set()  # `wait` releases the lock that `put` needs
        return super().wait(timeout)


def test_empty_inbox_waits_for_its_timeout(virtual_time: VirtualRuntime) -> None:
    inbox = RequestQueue(virtual_time.condition())
    start = virtual_time.now()
    ended: list[float] = []

    def read() -> None:
        for seconds in (0.0, 0.05):
            assert inbox.get(seconds) is None
            ended.append(virtual_time.now())

    virtual_time.start_thread(read)
    virtual_time.advance(1.0)
    assert ended == [start, start + 0.05]


@pytest.mark.realtime
def test_request_wakes_waiting_reader() -> None:
    condition = WatchedCondition()
    inbox = RequestQueue(condition)
    received: list[object] = []
    reader = threading.Thread(target=lambda: received.append(inbox.get(600.0)), daemon=True)
    reader.start()
    assert condition.has_waiter.wait(30.0)
    inbox.put(Stop(1))
    reader.join(30.0)
    assert received == [Stop(1)]


def test_requests_are_returned_in_order() -> None:
    inbox = RequestQueue()
    for number in range(3):
        inbox.put(Stop(number))
    assert [inbox.get(0.0), inbox.get(0.01), inbox.get(1e-6)] == [Stop(0), Stop(1), Stop(2)]


@pytest.mark.realtime
@pytest.mark.parametrize("seconds", [1e-9, 1e-5])
def test_very_short_wait_ends(seconds: float) -> None:
    """The queue is new, or a request has passed through it."""
    rounds = 4000
    ended: list[int] = []

    def wait() -> None:
        for number in range(rounds):
            inbox = RequestQueue()
            assert inbox.get(seconds) is None
            inbox.put(Stop(number))
            assert inbox.get(seconds) == Stop(number)
            assert inbox.get(seconds) is None
            ended.append(number)

    thread = threading.Thread(target=wait, daemon=True)
    thread.start()
    thread.join(30.0)
    assert len(ended) == rounds
