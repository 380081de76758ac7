"""Reasons of stops by each operating system, sleep and internal errors."""

import sys
from contextlib import closing

import pytest
from PySide6.QtDBus import QDBusConnection

from tests.system.test_mac_events import HAS_POWERED_ON, FakeMac
from trex_gui.supervisor import ExceptionWatch, SuspendDetector
from trex_gui.system.login_session import SessionEvents
from trex_gui.system.mac_events import WILL_SLEEP, MacEvents
from trex_gui.system.windows_events import (
    PBT_APMSUSPEND,
    WM_POWERBROADCAST,
    WM_QUERYENDSESSION,
    WM_WTSSESSION_CHANGE,
    WTS_SESSION_LOCK,
    stop_reason,
)

pytestmark = pytest.mark.usefixtures("qapp")


def desktop_reasons(*, is_starting: bool) -> list[str]:
    """Return the reasons after each signal of a Linux desktop, at the start or end of an event."""
    bus = QDBusConnection("no bus")
    events = SessionEvents(bus, bus)
    reports: list[str] = []
    events.leaving.connect(reports.append)
    events._on_sleep(is_starting=is_starting)
    events._on_shut_down(is_starting=is_starting)
    events._on_saver(active=is_starting)
    return reports


def windows_reasons() -> list[str]:
    """Return the reasons after each message of Windows about the session."""
    messages = [
        (WM_POWERBROADCAST, PBT_APMSUSPEND),
        (WM_WTSSESSION_CHANGE, WTS_SESSION_LOCK),
        (WM_QUERYENDSESSION, 0),
    ]
    return [stop_reason(*message) or "" for message in messages]


def mac_reasons() -> list[str]:
    """Return the reasons after each notification of macOS."""
    mac, reports = FakeMac(), list[str]()
    events = MacEvents(mac, lambda: False, timeout=1.0)
    events.leaving.connect(reports.append)
    mac.notify_power(HAS_POWERED_ON, 3)  # not a reason
    mac.lock()
    mac.notify_power(WILL_SLEEP, 5)
    return reports


def wake_reasons() -> list[str]:
    slept = 0.0
    detector = SuspendDetector(lambda: slept)
    reports: list[str] = []
    detector.woke.connect(reports.append)
    slept = 60.0
    detector.poll()
    return reports


def exception_reasons(monkeypatch: pytest.MonkeyPatch) -> list[str]:
    reports: list[str] = []
    monkeypatch.setattr(sys, "excepthook", lambda *_: None)
    with closing(ExceptionWatch(reports.append)):
        sys.excepthook(ValueError, ValueError("x"), None)
    return reports


def test_stop_reasons_are_clauses_without_stop_or_motor(monkeypatch: pytest.MonkeyPatch) -> None:
    reasons = [
        *desktop_reasons(is_starting=True),
        *windows_reasons(),
        *mac_reasons(),
        *wake_reasons(),
        *exception_reasons(monkeypatch),
    ]
    assert len(reasons) == 10
    for reason in reasons:
        assert reason
        assert not reason.endswith("."), reason
        assert "stop" not in reason, reason
        assert "motor" not in reason, reason
    assert reasons[-1] == "Internal error (ValueError)"
    assert reasons[2] == "The screen was locked"
    sleep, lock = "The computer is going to sleep", "The screen was locked"
    assert reasons[3:6] == [sleep, lock, "The session is ending"]  # Windows
    assert reasons[6:8] == [lock, sleep]  # macOS


def test_waking_up_and_unlocking_give_no_stop_reason() -> None:
    assert desktop_reasons(is_starting=False) == []
    assert stop_reason(WM_POWERBROADCAST, 0x12) is None  # wake-up
    assert stop_reason(WM_WTSSESSION_CHANGE, 8) is None  # unlock
    assert stop_reason(0x0200, 0) is None  # mouse move
