"""Lock and sleep on macOS, with replaced system libraries."""

from collections.abc import Callable
from typing import Any

import pytest
from pytestqt.qtbot import QtBot

from trex_gui.system.mac_events import CAN_SLEEP, WILL_SLEEP, MacEvents, NativeMac
from trex_gui.ui.runtime import now

HAS_POWERED_ON = 0xE0000300
pytestmark = pytest.mark.usefixtures("qapp")


class FakeMac(NativeMac):
    """Simulated macOS that records which power changes were allowed."""

    def __init__(self) -> None:
        self.lock: Callable[[], object] = lambda: None
        self.notify_power: Callable[[int, int], object] = lambda _message, _argument: None
        self.allowed: list[int] = []

    def listen(
        self, on_locked: Callable[[], object], on_power: Callable[[int, int], object]
    ) -> None:
        self.lock, self.notify_power = on_locked, on_power

    def allow_power_change(self, argument: int) -> None:
        self.allowed.append(argument)


def test_sleep_waits_for_the_stop_until_a_timeout(qtbot: QtBot) -> None:
    mac, may_move = FakeMac(), True
    _events = MacEvents(mac, lambda: may_move, timeout=1.0)
    mac.notify_power(CAN_SLEEP, 4)
    assert mac.allowed == [4], "an idle computer may sleep: another message follows before it does"
    mac.notify_power(WILL_SLEEP, 5)
    start = now()
    assert mac.allowed == [4]
    qtbot.waitUntil(lambda: mac.allowed == [4, 5])
    assert now() - start == pytest.approx(1.0, abs=0.1)
    may_move = False
    mac.notify_power(WILL_SLEEP, 6)
    start = now()
    qtbot.waitUntil(lambda: mac.allowed == [4, 5, 6])
    assert now() - start < 0.1


class FakeLibrary:
    """Functions of a library by name. Calls are recorded and return 7."""

    def __init__(self, calls: dict[str, list[tuple[Any, ...]]]) -> None:
        self._calls = calls

    def __getattr__(self, name: str) -> Any:
        def function(*arguments: Any) -> int:
            assert len(arguments) == len(function.argtypes), name  # type: ignore[attr-defined]
            self._calls.setdefault(name, []).append(arguments)
            return 7

        setattr(self, name, function)
        return function


def test_libraries_are_called_with_the_declared_arguments() -> None:
    calls: dict[str, list[tuple[Any, ...]]] = {}
    loaded: list[str] = []

    def load(path: str) -> FakeLibrary:
        loaded.append(path)
        return FakeLibrary(calls)

    native = NativeMac(load, lambda _library, name: name)
    events: list[object] = []
    native.listen(lambda: events.append("locked"), lambda *message: events.append(message))
    assert [path.rpartition("/")[2] for path in loaded] == ["CoreFoundation", "IOKit"]
    assert [call[1] for call in calls["CFStringCreateWithCString"]] == [
        b"com.apple.screenIsLocked",
        b"com.apple.screensaver.didstart",
    ]
    for _center, observer, callback, *_rest in calls["CFNotificationCenterAddObserver"]:
        callback(0, observer, 0, 0, 0)  # as macOS calls it from C
        assert events.pop() == "locked"
    (call,) = calls["IORegisterForSystemPower"]
    call[2](0, 0, WILL_SLEEP, 5)
    assert events == [(WILL_SLEEP, 5)]
    assert calls["CFRunLoopAddSource"] == [(7, 7, "kCFRunLoopCommonModes")]
    native.allow_power_change(5)
    assert calls["IOAllowPowerChange"] == [(7, 5)]
