"""Virtual time: the whole program runs on a clock that only tests advance.

Threads of the program become greenlets in the test's thread. Timers and waits become events in one
queue. Nothing runs concurrently, nothing waits in real time, and all runs of a test are identical.
Qt's own work (painting, layouts, posted events) happens between two events.
"""

import heapq
import itertools
import math
import sys
from collections import deque
from collections.abc import Callable
from typing import Any, Protocol, TypeVar

import greenlet
from PySide6.QtCore import QCoreApplication, QEvent, QObject, QProcess, QThread, QTimer
from pytestqt.qtbot import QtBot
from pytestqt.wait_signal import MultiSignalBlocker, SignalBlocker
from shiboken6 import Shiboken

from tests.support.patient import Callback, as_condition
from trex_gui.core.transport.serial_port import Transport
from trex_gui.core.transport.settings import PortSettings
from trex_gui.ui.runtime import Runtime

START = 1000.0
"""Virtual seconds at the start of every test."""

FRAME = 1.0
"""Virtual seconds between two paint events, which take most of the processor time."""

CHECK = 0.01
"""Virtual seconds between two checks of a condition."""

WAIT_MS = 60_000
"""Default timeout in virtual milliseconds."""


BlockerT = TypeVar("BlockerT", SignalBlocker, MultiSignalBlocker)


class Event:
    """Scheduled action, unless cancelled. `of_gui`: it needs the GUI thread, which may be busy."""

    __slots__ = ("action", "of_gui")

    def __init__(self, action: Callable[[], object], *, of_gui: bool = False) -> None:
        self.action: Callable[[], object] | None = action
        self.of_gui = of_gui

    def cancel(self) -> None:
        self.action = None


class Port(Protocol):
    """Port that can be opened."""

    def open(self, settings: PortSettings) -> Transport: ...


class VirtualRuntime(Runtime):
    """Clock, and the queue of events that wait for it.

    Attributes:
        ports: URL → port.
        create_process: creates the replacement of a process that the program starts.
    """

    def __init__(self) -> None:
        self.ports: dict[str, Port] = {}
        self.create_process: Callable[[QObject], QProcess] | None = None
        self._now = self._until = self._painted = START
        self._events: list[tuple[float, int, Event]] = []
        self._order = itertools.count()
        self._main = greenlet.getcurrent()
        self._tasks: dict[object, greenlet.greenlet] = {}

    # --- The runtime of the program -----------------------------------------------------

    def now(self) -> float:
        return self._now

    def sleep(self, seconds: float) -> None:
        self.sleep_until(self._now + seconds)

    def condition(self) -> "VirtualCondition":
        return VirtualCondition(self)

    def timer(self, parent: QObject) -> QTimer:
        return VirtualTimer(self, parent)

    def start(self, thread: QThread, priority: QThread.Priority) -> None:
        del priority
        self._spawn(thread, lambda: self._live(thread))

    def wait(self, thread: QThread, milliseconds: int) -> bool:
        until = math.inf if milliseconds < 0 else self._now + milliseconds / 1000
        return self._run(until, lambda: thread not in self._tasks, with_gui=False)

    def start_thread(self, function: Callable[[], object]) -> Callable[[], None]:
        """Run a function as a Python thread. Return a function that waits for its end."""
        key = object()
        task = self._spawn(key, function)

        def join() -> None:
            while not task.dead:
                self.sleep(CHECK)

        return join

    def process(self, parent: QObject) -> QProcess:
        if self.create_process is None:
            return super().process(parent)
        return self.create_process(parent)

    def open_transport(self, settings: PortSettings) -> Transport:
        if settings.url in self.ports:
            return self.ports[settings.url].open(settings)
        super().open_transport(settings).close()  # raises the error of a missing port
        raise RuntimeError(f"{settings.url} is a real port: mark the test as realtime")

    # --- For simulated devices ----------------------------------------------------------

    def at(self, moment: float, action: Callable[[], object], *, of_gui: bool = False) -> Event:
        """Schedule an action."""
        event = Event(action, of_gui=of_gui)
        heapq.heappush(self._events, (moment, next(self._order), event))
        return event

    def sleep_until(self, moment: float) -> None:
        """Suspend the calling thread until a time."""
        if moment <= self._now:
            return
        if moment < self.next_event and moment <= self._until:
            self._now = moment  # no other event is due before
            return
        if greenlet.getcurrent() is self._main:
            self._run(moment, lambda: False, with_gui=False)
            return
        event = self.at(moment, greenlet.getcurrent().switch)
        try:
            self.switch_to_main()
        finally:
            event.cancel()  # an exception may have interrupted the wait

    def switch_to_main(self) -> None:
        """Run other tasks until one of them switches back."""
        if greenlet.getcurrent() is self._main:
            raise RuntimeError("the GUI thread would wait forever")
        self._main.switch()

    # --- For tests ----------------------------------------------------------------------

    @property
    def is_idle(self) -> bool:
        """True if no thread is running."""
        return not self._tasks

    def advance(self, seconds: float) -> None:
        """Let time pass."""
        self._run(self._now + seconds, lambda: False)
        deliver()

    def run_until(self, condition: Callable[[], object], seconds: float) -> bool:
        """Let time pass until a condition holds. Return False after the timeout."""
        end = self._now + seconds
        deliver()
        while not condition():
            if self._now >= end:
                return False
            self._run(min(end, self._now + CHECK), lambda: False)
        deliver()
        return True

    def _spawn(self, key: object, function: Callable[[], object]) -> greenlet.greenlet:
        def live() -> None:
            try:
                function()
            finally:
                del self._tasks[key]

        task = self._tasks[key] = greenlet.greenlet(live, parent=self._main)
        self.at(self._now, task.switch)
        return task

    def _live(self, thread: QThread) -> None:
        try:
            thread.run()
        except Exception:  # noqa: BLE001 - like PySide in a QThread
            kind, error, trace = sys.exc_info()
            assert kind is not None
            assert error is not None
            sys.excepthook(kind, error, trace)
        if Shiboken.isValid(thread):
            thread.finished.emit()

    @property
    def next_event(self) -> float:
        """Time of the next event, or infinity."""
        while self._events and self._events[0][2].action is None:
            heapq.heappop(self._events)
        return self._events[0][0] if self._events else math.inf

    def _run(self, until: float, done: Callable[[], bool], *, with_gui: bool = True) -> bool:
        if greenlet.getcurrent() is not self._main:
            raise RuntimeError("only the GUI thread lets time pass")
        previous, self._until = self._until, until
        postponed: list[tuple[float, int, Event]] = []
        try:
            while not done():
                moment = self.next_event
                if moment > until or moment == math.inf:
                    if until == math.inf:
                        raise RuntimeError("no event is left that could end the wait")
                    self._now = max(self._now, until)
                    break
                entry = heapq.heappop(self._events)
                event = entry[2]
                if event.of_gui and not with_gui:
                    postponed.append(entry)
                    continue
                self._now = max(self._now, moment)
                action, event.action = event.action, None
                assert action is not None
                action()
                if with_gui:
                    QCoreApplication.sendPostedEvents(None, QEvent.Type.MetaCall)
                    if self._now >= self._painted + FRAME:
                        self._painted = self._now
                        deliver()
        finally:
            self._until = previous
            for entry in postponed:
                heapq.heappush(self._events, entry)
        return done()


def deliver() -> None:
    """Run Qt's pending work."""
    QCoreApplication.processEvents()
    QCoreApplication.sendPostedEvents(None, QEvent.Type.DeferredDelete)


class VirtualCondition:
    """Replacement of `threading.Condition` whose lock is always free."""

    def __init__(self, runtime: VirtualRuntime) -> None:
        self._runtime = runtime
        self._waiting: deque[Callable[[], None]] = deque()

    def __enter__(self) -> bool:
        return True

    def __exit__(self, *_: object) -> None:
        pass

    def wait(self, timeout: float | None = None) -> bool:
        task = greenlet.getcurrent()
        notified = False
        is_over = False

        def wake(*, by_notify: bool) -> None:
            nonlocal notified, is_over
            if not is_over:
                is_over, notified = True, by_notify
                task.switch()

        def on_notify() -> None:
            self._runtime.at(self._runtime.now(), lambda: wake(by_notify=True))

        self._waiting.append(on_notify)
        end = None
        if timeout is not None:
            moment = self._runtime.now() + timeout
            end = self._runtime.at(moment, lambda: wake(by_notify=False))
        self._runtime.switch_to_main()
        if end is not None:
            end.cancel()
        if on_notify in self._waiting:
            self._waiting.remove(on_notify)
        return notified

    def notify(self) -> None:
        if self._waiting:
            self._waiting.popleft()()


class VirtualTimer(QTimer):
    """Timer on the virtual clock."""

    def __init__(self, runtime: VirtualRuntime, parent: QObject) -> None:
        super().__init__(parent)
        self._runtime = runtime
        self._event: Event | None = None
        self._due = 0.0

    def start(self, *milliseconds: object) -> None:
        if milliseconds and isinstance(milliseconds[0], int):  # a connected signal may pass a text
            self.setInterval(milliseconds[0])
        self.stop()
        self._schedule(self._runtime.now())

    def stop(self) -> None:
        if self._event is not None:
            self._event.cancel()
            self._event = None

    def setInterval(self, milliseconds: int) -> None:
        super().setInterval(milliseconds)
        if self._event is not None:
            self.start()

    def isActive(self) -> bool:
        return self._event is not None

    def remainingTime(self) -> int:
        if self._event is None:
            return -1
        return max(0, round((self._due - self._runtime.now()) * 1000))

    def _schedule(self, since: float) -> None:
        seconds = self.interval() / 1000
        if not self.isSingleShot():
            seconds = max(0.001, seconds)
        self._due = max(since + seconds, self._runtime.now())
        self._event = self._runtime.at(self._due, self._fire, of_gui=True)

    def _fire(self) -> None:
        self._event = None
        if Shiboken.isValid(self):
            if not self.isSingleShot():
                self._schedule(self._due)
            self.timeout.emit()


class VirtualQtBot(QtBot):
    """Bot that waits in virtual time."""

    def __init__(self, request: Any, runtime: VirtualRuntime) -> None:
        super().__init__(request)
        self.runtime = runtime

    def wait(self, ms: int) -> None:
        raise TypeError(f"wait for a condition instead of {ms} ms, or advance the runtime")

    def waitUntil(self, callback: Callback, *, timeout: int = WAIT_MS) -> None:
        condition = as_condition(callback)
        failure: AssertionError | None = None

        def holds() -> bool:
            nonlocal failure
            try:
                result = condition()
            except AssertionError as error:
                failure = error
                return False
            failure = None
            return result is None or bool(result)

        if not self.runtime.run_until(holds, timeout / 1000):
            raise self.TimeoutError(f"condition not met within {timeout} virtual ms") from failure

    def waitSignal(self, signal: Any, *, timeout: int = WAIT_MS, **options: Any) -> SignalBlocker:
        blocker = super().waitSignal(signal, timeout=timeout, **options)
        return self._in_virtual_time(blocker)

    def waitSignals(
        self, signals: list[Any], *, timeout: int = WAIT_MS, **options: Any
    ) -> MultiSignalBlocker:
        blocker = super().waitSignals(signals, timeout=timeout, **options)
        return self._in_virtual_time(blocker)

    def _in_virtual_time(self, blocker: BlockerT) -> BlockerT:
        """Make a blocker of pytest-qt wait in virtual time."""
        milliseconds, blocker.timeout = blocker.timeout, 0  # it must not wait in real time

        def wait() -> None:
            is_emitted = self.runtime.run_until(
                lambda: blocker.signal_triggered, (milliseconds or 0) / 1000
            )
            if not is_emitted and blocker.raising:
                raise self.TimeoutError(f"no signal within {milliseconds} virtual ms")

        blocker.wait = wait  # type: ignore[method-assign]  # only for this blocker
        return blocker
