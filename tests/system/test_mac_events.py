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
    """Simulated macOS that records the answered power messages."""

    def __init__(self) -> None:
        self.lock: Callable[[], object] = lambda: None
        self.tell_power: Callable[[int, int], object] = lambda _message, _argument: None
        self.allowed: list[int] = []

    def listen(
        self, on_locked: Callable[[], object], on_power: Callable[[int, int], object]
    ) -> None:
        self.lock, self.tell_power = on_locked, on_power

    def allow_power_change(self, argument: int) -> None:
        self.allowed.append(argument)


def test_lock_and_sleep_are_reasons_to_stop_and_waking_up_is_none() -> None:
    mac, reasons = FakeMac(), list[str]()
    events = MacEvents(mac, lambda: False, timeout=1.0)
    events.leaving.connect(reasons.append)
    mac.tell_power(HAS_POWERED_ON, 3)
    assert reasons == []
    mac.lock()
    mac.tell_power(WILL_SLEEP, 5)
    assert reasons == ["The screen was locked", "The computer is going to sleep"]


def test_sleep_waits_for_the_stop_but_not_for_ever(qtbot: QtBot) -> None:
    mac, may_move = FakeMac(), True
    _events = MacEvents(mac, lambda: may_move, timeout=1.0)
    mac.tell_power(CAN_SLEEP, 4)
    assert mac.allowed == [4], "an idle computer may sleep: it is told again when it does"
    mac.tell_power(WILL_SLEEP, 5)
    begun = now()
    assert mac.allowed == [4]
    qtbot.waitUntil(lambda: mac.allowed == [4, 5])
    assert now() - begun == pytest.approx(1.0, abs=0.1)
    may_move = False
    mac.tell_power(WILL_SLEEP, 6)
    begun = now()
    qtbot.waitUntil(lambda: mac.allowed == [4, 5, 6])
    assert now() - begun < 0.1


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


def test_libraries_are_called_with_as_many_arguments_as_declared() -> None:
    calls: dict[str, list[tuple[Any, ...]]] = {}
    loaded: list[str] = []

    def load(path: str) -> FakeLibrary:
        loaded.append(path)
        return FakeLibrary(calls)

    native = NativeMac(load, lambda _library, name: name)
    seen: list[object] = []
    native.listen(lambda: seen.append("locked"), lambda *message: seen.append(message))
    assert [path.rpartition("/")[2] for path in loaded] == ["CoreFoundation", "IOKit"]
    assert [call[1] for call in calls["CFStringCreateWithCString"]] == [
        b"com.apple.screenIsLocked",
        b"com.apple.screensaver.didstart",
    ]
    for _center, observer, notified, *_rest in calls["CFNotificationCenterAddObserver"]:
        notified(0, observer, 0, 0, 0)  # as macOS calls it from C
        assert seen.pop() == "locked"
    (call,) = calls["IORegisterForSystemPower"]
    call[2](0, 0, WILL_SLEEP, 5)
    assert seen == [(WILL_SLEEP, 5)]
    assert calls["CFRunLoopAddSource"] == [(7, 7, "kCFRunLoopCommonModes")]
    native.allow_power_change(5)
    assert calls["IOAllowPowerChange"] == [(7, 5)]
