"""The inbox of a session, between two threads."""

import threading
import time

import pytest

from trex_gui.link.inbox import QueueInbox
from trex_gui.link.messages import Stop

pytestmark = pytest.mark.realtime


def test_empty_inbox_waits_for_its_timeout() -> None:
    inbox = QueueInbox()
    for _ in range(20):  # a busy computer adds to some
        begun = time.monotonic()
        assert inbox.get(0.0) is None
        assert inbox.get(0.05) is None
        took = time.monotonic() - begun
        assert took >= 0.05
        if took < 0.5:
            break
    assert took < 0.5


def test_request_wakes_waiting_reader() -> None:
    inbox = QueueInbox()
    timer = threading.Timer(0.05, inbox.put, [Stop(1)])
    begun = time.monotonic()
    timer.start()
    assert inbox.get(40.0) == Stop(1)
    assert time.monotonic() - begun < 30.0
    timer.join()


def test_requests_are_taken_in_order() -> None:
    inbox = QueueInbox()
    for number in range(3):
        inbox.put(Stop(number))
    assert [inbox.get(0.0), inbox.get(0.01), inbox.get(1e-6)] == [Stop(0), Stop(1), Stop(2)]


@pytest.mark.parametrize("seconds", [1e-9, 1e-6, 1e-5])
def test_very_short_wait_ends(seconds: float) -> None:
    """A new one, and one that a request has come through, which is what a session waits at."""
    rounds = 4000
    ended: list[int] = []

    def wait() -> None:
        for number in range(rounds):
            inbox = QueueInbox()
            assert inbox.get(seconds) is None
            inbox.put(Stop(number))
            assert inbox.get(seconds) == Stop(number)
            assert inbox.get(seconds) is None
            ended.append(number)

    thread = threading.Thread(target=wait, daemon=True)
    thread.start()
    thread.join(30.0)
    assert len(ended) == rounds
