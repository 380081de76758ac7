"""Delay of the computer's sleep until a stop is confirmed."""

from collections.abc import Callable

from PySide6.QtCore import QObject, Slot

from trex_gui.ui.runtime import new_timer

_POLL_MS = 20


class StopWait(QObject):
    """Calls `callback` once a stop is confirmed, or after `timeout` seconds.

    `may_move` returns True if motors were driven and no stop has been confirmed since.
    """

    def __init__(
        self,
        may_move: Callable[[], bool],
        callback: Callable[[], object],
        parent: QObject | None = None,
        *,
        timeout: float,
    ) -> None:
        super().__init__(parent)
        self._may_move = may_move
        self._callback = callback
        self._timeout = timeout
        self._polls = 0
        self._timer = new_timer(self, _POLL_MS, self._on_poll)

    def start(self) -> None:
        self._polls = 0
        self._timer.start()

    def cancel(self) -> None:
        self._timer.stop()

    @Slot()
    def _on_poll(self) -> None:
        self._polls += 1
        if not self._may_move() or self._polls * _POLL_MS >= self._timeout * 1000:
            self._timer.stop()
            self._callback()
