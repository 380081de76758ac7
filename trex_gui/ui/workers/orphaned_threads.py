"""Threads that did not end when they were to: Qt aborts on destroying one that runs.

Whoever gives a thread up leaves it here. At its end the program asks whether one still runs; it
must not end by itself then.
"""

from trex_gui.ui.runtime import now
from trex_gui.ui.workers.thread import WorkerThread

_kept: list[WorkerThread] = []


def adopt(thread: WorkerThread) -> None:
    """Take a thread that its owner gives up, until it has ended; to be called in its own thread.

    "Its own" is the one that the object lives in. Its owner may be destroyed from now on.
    """
    thread.setParent(None)
    if thread not in _kept:
        _kept.append(thread)


def release(thread: WorkerThread) -> bool:
    """Keep a thread no longer, which has ended; return whether it was kept."""
    if thread not in _kept:
        return False
    _kept.remove(thread)
    return True


def any_running() -> bool:
    """Return whether one still runs; those that have ended are let go."""
    return not wait(0)


def wait(timeout_ms: int) -> bool:
    """Wait for all of them together; return whether they have ended."""
    end = now() + timeout_ms / 1000
    _kept[:] = [thread for thread in _kept if not thread.wait(max(0, round((end - now()) * 1000)))]
    return not _kept
