"""Events of the operating system stop the motors."""

import os
import signal
import sys
import threading
from collections.abc import Iterator
from contextlib import closing
from types import SimpleNamespace
from typing import Any

import pytest
from PySide6.QtCore import Qt
from pytestqt.qtbot import QtBot

from tests.core.transport.test_driven import write_driven_file
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
    senders: list[int] = []
    stopper = StopBroadcaster(lambda: senders.append(threading.get_ident()))
    thread = threading.Thread(target=lambda: stopper.stop("reason"))
    with qtbot.waitSignal(stopper.stopped) as reports:
        thread.start()
        thread.join()
        assert senders, "the stop is sent before the window is notified"
    assert senders != [threading.get_ident()]
    assert reports.args == ["reason"]


def test_running_board_counts_as_an_unconfirmed_stop(capsys: pytest.CaptureFixture[str]) -> None:
    manager = SimpleNamespace(unconfirmed_stop="")
    supervisor: Any = SimpleNamespace(_program=SimpleNamespace(device_manager=manager))
    assert not SafetySupervisor.report_unconfirmed_stop(supervisor)
    write_driven_file("/dev/ttyNONE")
    assert SafetySupervisor.report_unconfirmed_stop(supervisor)
    assert capsys.readouterr().err.startswith("Motors may still be turning")


def test_stop_raised_by_a_report_is_sent_but_not_reported(
    qtbot: QtBot, monkeypatch: pytest.MonkeyPatch
) -> None:
    sent: list[int] = []
    reports: list[str] = []
    errors: list[BaseException] = []
    stopper = StopBroadcaster(lambda: sent.append(1))

    def fail(reason: str) -> None:
        reports.append(reason)
        raise ValueError("always")

    stopper.stopped.connect(fail)
    monkeypatch.setattr(sys, "excepthook", lambda _kind, error, _trace: errors.append(error))
    with closing(ExceptionWatch(stopper.stop)):
        stopper.stop("first")
        assert reports == [], "the caller does not wait for the report"
        qtbot.waitUntil(lambda: bool(errors))
        assert (len(sent), reports, len(errors)) == (2, ["first"], 1)
        stopper.stop("second")  # reported after all queued reports
        qtbot.waitUntil(lambda: len(errors) == 2)
        assert (len(sent), reports) == (4, ["first", "second"])


def test_stop_of_another_thread_during_a_report_is_reported(qtbot: QtBot) -> None:
    reports: list[str] = []
    stopper = StopBroadcaster(lambda: None)

    def stop_in_thread(reason: str) -> None:
        reports.append(reason)
        if len(reports) == 1:
            thread = threading.Thread(target=lambda: stopper.stop("thread"))
            thread.start()
            thread.join()

    stopper.stopped.connect(stop_in_thread)
    stopper.stop("test")
    qtbot.waitUntil(lambda: reports == ["test", "thread"])


# --- Signals ----------------------------------------------------------------------------


class RecordingSignalWatch:
    """Signal watch, with records of its actions."""

    def __init__(self, grace: float = 0.05) -> None:
        self.stopped = threading.Event()
        self.stops = 0
        self.fails = False
        self.exit_codes: list[int] = []
        self.ended = threading.Event()
        self.steps: list[str] = []
        self.suspended = threading.Event()
        self.watch = SignalWatch(
            self._stop,
            lambda: self.steps.append("stop"),
            grace=grace,
            end=self._end,
            suspend=self._suspend,
        )

    def _suspend(self) -> None:
        self.steps.append("suspend")
        self.suspended.set()

    def _stop(self) -> None:
        self.stops += 1
        self.stopped.set()
        if self.fails:
            raise RuntimeError("on purpose")

    def _end(self, code: int) -> None:
        self.exit_codes.append(code)
        self.ended.set()


@pytest.fixture
def recorder() -> Iterator[RecordingSignalWatch]:
    recorder = RecordingSignalWatch()
    yield recorder
    recorder.watch.close()


@pytest.mark.skipif(sys.platform == "win32", reason="POSIX signals")
def test_signal_stops_motors_while_gui_thread_is_blocked(recorder: RecordingSignalWatch) -> None:
    os.kill(os.getpid(), signal.SIGTERM)
    assert recorder.stopped.wait(15), "the GUI thread runs no event loop here"


@pytest.mark.skipif(sys.platform == "win32", reason="POSIX signals")
@pytest.mark.parametrize("fails", [False, True])
def test_signals_end_an_open_window_even_if_the_stop_fails(
    recorder: RecordingSignalWatch, qtbot: QtBot, *, fails: bool
) -> None:
    recorder.fails = fails
    for number in (signal.SIGTERM, signal.SIGHUP):
        recorder.ended.clear()
        with qtbot.waitSignal(recorder.watch.caught) as reports:
            os.kill(os.getpid(), number)
        assert reports.args == [number]
        assert recorder.ended.wait(15)
    assert recorder.exit_codes == [128 + signal.SIGTERM, 128 + signal.SIGHUP]


@pytest.mark.skipif(sys.platform == "win32", reason="POSIX signals")
def test_second_ctrl_c_stops_again_and_ends_closing_window(qtbot: QtBot) -> None:
    recorder = RecordingSignalWatch(grace=60)

    def send_ctrl_c(_: int) -> None:
        os.kill(os.getpid(), signal.SIGINT)

    # Sent by the watching thread: a second signal at the same time counts as the first one.
    recorder.watch.caught.connect(send_ctrl_c, Qt.ConnectionType.DirectConnection)
    with closing(recorder.watch):
        with qtbot.waitSignal(recorder.watch.caught):
            os.kill(os.getpid(), signal.SIGTERM)
        assert not recorder.ended.wait(0.4)
        assert recorder.stops == 1
        os.kill(os.getpid(), signal.SIGTERM)  # no key sends this signal
        assert not recorder.ended.wait(0.4)
        os.kill(os.getpid(), signal.SIGINT)
        assert recorder.ended.wait(15)
        assert (recorder.stops, recorder.exit_codes) == (2, [128 + signal.SIGINT])


def test_close_restores_the_sigint_handler(recorder: RecordingSignalWatch) -> None:
    recorder.watch.close()
    assert signal.getsignal(signal.SIGINT) is signal.default_int_handler
    recorder.watch = SignalWatch(lambda: None, lambda: None)


@pytest.mark.skipif(sys.platform == "win32", reason="POSIX signals")
def test_ctrl_z_stops_motors_before_it_suspends(recorder: RecordingSignalWatch) -> None:
    for _ in range(2):  # the second time after the process was resumed
        recorder.steps.clear()
        recorder.suspended.clear()
        os.kill(os.getpid(), signal.SIGTSTP)
        assert recorder.suspended.wait(15)
        assert recorder.steps == ["stop", "suspend"]
    assert recorder.stops == 0, "the program does not end"


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


# --- Internal errors --------------------------------------------------------------------


def test_exception_stops_before_it_is_reported(monkeypatch: pytest.MonkeyPatch) -> None:
    order: list[str] = []
    monkeypatch.setattr(sys, "excepthook", lambda *_: order.append("reported"))
    with closing(ExceptionWatch(order.append)):
        sys.excepthook(ValueError, ValueError("x"), None)
    assert order[1] == "reported"
    assert "ValueError" in order[0]


def test_exception_is_reported_even_if_stop_fails(monkeypatch: pytest.MonkeyPatch) -> None:
    reported: list[object] = []
    monkeypatch.setattr(sys, "excepthook", lambda *args: reported.append(args))

    def fail(_: str) -> None:
        raise RuntimeError

    with closing(ExceptionWatch(fail)), pytest.raises(RuntimeError):
        sys.excepthook(ValueError, ValueError("x"), None)
    assert reported


# --- Sleep ------------------------------------------------------------------------------


def test_wake_after_sleep_is_reported_once(qtbot: QtBot) -> None:
    slept = 100.0
    detector = SuspendDetector(lambda: slept)
    reports: list[str] = []
    detector.woke.connect(reports.append)
    detector.poll()
    slept = 100.3
    detector.poll()
    assert reports == []
    slept = 130.0
    detector.poll()
    detector.poll()
    assert len(reports) == 1
    assert "asleep" in reports[0]


def test_time_asleep_is_not_negative() -> None:
    assert slept_so_far() >= -0.01
