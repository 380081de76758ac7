"""Events of the operating system stop the motors."""

import os
import signal
import sys
import threading
from collections.abc import Iterator
from types import SimpleNamespace
from typing import Any

import pytest
from PySide6.QtCore import Qt
from pytestqt.qtbot import QtBot

from tests.core.transport.test_driven import left
from trex_gui.supervisor import (
    ExceptionWatch,
    SafetySupervisor,
    StopBroadcaster,
    SuspendDetector,
    slept_so_far,
)
from trex_gui.system.signals import SignalWatch

pytestmark = pytest.mark.realtime


def test_stop_is_sent_in_calling_thread_and_reported_in_gui(qtbot: QtBot) -> None:
    sent_from: list[int] = []
    stopper = StopBroadcaster(lambda: sent_from.append(threading.get_ident()))
    thread = threading.Thread(target=lambda: stopper.stop("why"))
    with qtbot.waitSignal(stopper.stopped) as reports:
        thread.start()
        thread.join()
        assert sent_from, "before the window has heard of it"
    assert sent_from != [threading.get_ident()]
    assert reports.args == ["why"]


def test_board_that_is_left_running_counts_as_an_unconfirmed_stop() -> None:
    manager = SimpleNamespace(unconfirmed_stop="")
    watching: Any = SimpleNamespace(_program=SimpleNamespace(device_manager=manager))
    assert not SafetySupervisor.report_unconfirmed_stop(watching)
    left("/dev/ttyNONE")
    assert SafetySupervisor.report_unconfirmed_stop(watching)


def test_stop_raised_by_a_report_is_sent_but_not_reported(
    qtbot: QtBot, monkeypatch: pytest.MonkeyPatch
) -> None:
    sent: list[int] = []
    reports: list[str] = []
    reported: list[BaseException] = []
    stopper = StopBroadcaster(lambda: sent.append(1))

    def fail(reason: str) -> None:
        reports.append(reason)
        raise ValueError("always")

    stopper.stopped.connect(fail)
    monkeypatch.setattr(sys, "excepthook", lambda _kind, error, _trace: reported.append(error))
    watch = ExceptionWatch(stopper.stop)
    try:
        stopper.stop("why")
        assert reports == [], "whoever stops is not held up"
        qtbot.waitUntil(lambda: bool(reported))
        assert (len(sent), reports, len(reported)) == (2, ["why"], 1)
        stopper.stop("again")  # reported after all queued reports
        qtbot.waitUntil(lambda: len(reported) == 2)
        assert (len(sent), reports) == (4, ["why", "again"])
    finally:
        watch.close()


def test_stop_from_other_thread_during_report_is_reported(qtbot: QtBot) -> None:
    reports: list[str] = []
    stopper = StopBroadcaster(lambda: None)

    def stop_elsewhere(reason: str) -> None:
        reports.append(reason)
        if len(reports) == 1:
            thread = threading.Thread(target=lambda: stopper.stop("elsewhere"))
            thread.start()
            thread.join()

    stopper.stopped.connect(stop_elsewhere)
    stopper.stop("here")
    qtbot.waitUntil(lambda: reports == ["here", "elsewhere"])


# --- Signals ----------------------------------------------------------------------------


class RecordingSignalWatch:
    """Signal watch that records its actions."""

    def __init__(self, grace: float = 0.05) -> None:
        self.acted = threading.Event()
        self.acts = 0
        self.fails = False
        self.ended_with: list[int] = []
        self.ended = threading.Event()
        self.stops: list[str] = []
        self.stood_still = threading.Event()
        self.watch = SignalWatch(
            self._act, self._rest, grace=grace, end=self._end, suspend=self._stand_still
        )

    def _rest(self) -> None:
        self.stops.append("rest")

    def _stand_still(self) -> None:
        self.stops.append("stand still")
        self.stood_still.set()

    def _act(self) -> None:
        self.acts += 1
        self.acted.set()
        if self.fails:
            raise RuntimeError("on purpose")

    def _end(self, code: int) -> None:
        self.ended_with.append(code)
        self.ended.set()


@pytest.fixture
def ending() -> Iterator[RecordingSignalWatch]:
    ending = RecordingSignalWatch()
    yield ending
    ending.watch.close()


@pytest.mark.skipif(sys.platform == "win32", reason="POSIX signals")
def test_signal_acts_while_gui_thread_is_blocked(ending: RecordingSignalWatch) -> None:
    os.kill(os.getpid(), signal.SIGTERM)
    assert ending.acted.wait(15), "this thread waits and returns to no event loop"


@pytest.mark.skipif(sys.platform == "win32", reason="POSIX signals")
@pytest.mark.parametrize("fails", [False, True])
def test_signals_end_window_that_does_not_close_even_if_their_action_fails(
    ending: RecordingSignalWatch, qtbot: QtBot, *, fails: bool
) -> None:
    ending.fails = fails
    for number in (signal.SIGTERM, signal.SIGHUP):
        ending.ended.clear()
        with qtbot.waitSignal(ending.watch.caught) as reports:
            os.kill(os.getpid(), number)
        assert reports.args == [number]
        assert ending.ended.wait(15)
    assert ending.ended_with == [128 + signal.SIGTERM, 128 + signal.SIGHUP]


@pytest.mark.skipif(sys.platform == "win32", reason="POSIX signals")
def test_second_ctrl_c_stops_again_and_ends_closing_window(qtbot: QtBot) -> None:
    ending = RecordingSignalWatch(grace=60)

    def pass_one_on(
        _: int,
    ) -> None:  # in the watching thread, because a second signal at once counts as the first
        os.kill(os.getpid(), signal.SIGINT)

    ending.watch.caught.connect(pass_one_on, Qt.ConnectionType.DirectConnection)
    try:
        with qtbot.waitSignal(ending.watch.caught):
            os.kill(os.getpid(), signal.SIGTERM)
        assert not ending.ended.wait(0.4)
        assert ending.acts == 1
        os.kill(os.getpid(), signal.SIGTERM)  # not from a key
        assert not ending.ended.wait(0.4)
        os.kill(os.getpid(), signal.SIGINT)
        assert ending.ended.wait(15)
        assert (ending.acts, ending.ended_with) == (2, [128 + signal.SIGINT])
    finally:
        ending.watch.close()


def test_closing_restores_sigint_handler(ending: RecordingSignalWatch) -> None:
    ending.watch.close()
    assert signal.getsignal(signal.SIGINT) is signal.default_int_handler
    ending.watch = SignalWatch(lambda: None, lambda: None)


@pytest.mark.skipif(sys.platform == "win32", reason="POSIX signals")
def test_ctrl_z_stops_motors_before_it_suspends(ending: RecordingSignalWatch) -> None:
    for _ in range(2):  # again after the process was resumed
        ending.stops.clear()
        ending.stood_still.clear()
        os.kill(os.getpid(), signal.SIGTSTP)
        assert ending.stood_still.wait(15)
        assert ending.stops == ["rest", "stand still"]
    assert ending.acts == 0, "it does not end"


@pytest.mark.skipif(sys.platform == "win32", reason="POSIX signals")
def test_ignored_signal_stays_ignored() -> None:
    before = signal.signal(signal.SIGHUP, signal.SIG_IGN)
    try:
        watch = SignalWatch(lambda: None, lambda: None)
        assert signal.getsignal(signal.SIGHUP) is signal.SIG_IGN
        watch.close()
        assert signal.getsignal(signal.SIGHUP) is signal.SIG_IGN
    finally:
        signal.signal(signal.SIGHUP, before)


# --- Mistakes ---------------------------------------------------------------------------


def test_exception_stops_before_it_is_reported(monkeypatch: pytest.MonkeyPatch) -> None:
    order: list[str] = []
    monkeypatch.setattr(sys, "excepthook", lambda *_: order.append("reported"))
    watch = ExceptionWatch(order.append)
    try:
        sys.excepthook(ValueError, ValueError("x"), None)
    finally:
        watch.close()
    assert order[1] == "reported"
    assert "ValueError" in order[0]


def test_exception_is_reported_even_if_stop_fails(monkeypatch: pytest.MonkeyPatch) -> None:
    reported: list[object] = []
    monkeypatch.setattr(sys, "excepthook", lambda *args: reported.append(args))

    def fail(_: str) -> None:
        raise RuntimeError

    watch = ExceptionWatch(fail)
    try:
        with pytest.raises(RuntimeError):
            sys.excepthook(ValueError, ValueError("x"), None)
    finally:
        watch.close()
    assert reported


# --- Sleep ------------------------------------------------------------------------------


def test_wake_after_sleep_is_reported_once(qtbot: QtBot) -> None:
    slept = 100.0
    watch = SuspendDetector(lambda: slept)
    reports: list[str] = []
    watch.woke.connect(reports.append)
    watch.poll()
    slept = 100.3
    watch.poll()
    assert reports == []
    slept = 130.0
    watch.poll()
    watch.poll()
    assert len(reports) == 1
    assert "asleep" in reports[0]


def test_time_asleep_is_not_negative() -> None:
    assert slept_so_far() >= -0.01
