"""Bot and timeouts for a busy computer."""

from collections.abc import Callable
from typing import Any

from pytestqt.qtbot import QtBot
from pytestqt.wait_signal import MultiSignalBlocker, SignalBlocker

from trex_gui.core.timing import Timeouts

PATIENT = Timeouts(
    extra=0.3,
    heartbeat=60.0,
    guardian=60.0,
    stop_confirmation=15.0,
    current_gap=30.0,
    sleep_delay=15.0,
)
"""Timeouts in real time, because a test or its simulator may hang for seconds."""

LONG_TIMEOUT_MS = 20_000
"""Default timeout. Other tests may take the processor for a second or two."""


Callback = Callable[[], bool | None]


def as_condition(callback: Callback) -> Callback:
    """Make a lambda return a bool, because pytest-qt takes `None` for true."""
    is_lambda = getattr(callback, "__name__", "") == "<lambda>"
    return (lambda: bool(callback())) if is_lambda else callback


class PatientQtBot(QtBot):
    """Bot with longer default timeouts."""

    def waitUntil(  # noqa: N802 - the name is Qt's
        self, callback: Callback, *, timeout: int = LONG_TIMEOUT_MS
    ) -> None:
        super().waitUntil(as_condition(callback), timeout=timeout)

    def waitSignal(  # noqa: N802
        self, signal: Any, *, timeout: int = LONG_TIMEOUT_MS, **options: Any
    ) -> SignalBlocker:
        return super().waitSignal(signal, timeout=timeout, **options)

    def waitSignals(  # noqa: N802
        self, signals: list[Any], *, timeout: int = LONG_TIMEOUT_MS, **options: Any
    ) -> MultiSignalBlocker:
        return super().waitSignals(signals, timeout=timeout, **options)
