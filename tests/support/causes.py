"""Events that make the program stop all motors by itself."""

from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from typing import Any

from PySide6.QtCore import QMetaObject, QTimer
from PySide6.QtWidgets import QApplication
from pytestqt.qtbot import QtBot

from tests.support.window import WindowDriver
from trex_gui.supervisor import SafetySupervisor
from trex_gui.system.login_session import SessionEvents
from trex_gui.ui.program import Program


class Causes:
    """Supervised window and the events that stop its motors.

    Attributes:
        reports: every text that reported a stop, in order.
    """

    def __init__(
        self, window: WindowDriver, watching: SafetySupervisor, caught: Sequence[tuple[Any, ...]]
    ) -> None:
        self._window = window
        self._watching = watching
        self._caught = caught
        self.reports: list[str] = []
        window.program.device_manager.stop_reported.connect(self.reports.append)

    @property
    def mistakes(self) -> list[type[BaseException]]:
        """Types of the uncaught exceptions."""
        return [kind for kind, *_ in self._caught]

    @property
    def banner(self) -> str:
        """Text of the banner, or empty."""
        return self._window.text("bannerText") if self._window.has("bannerText") else ""

    def raise_in_slot(self) -> None:
        """Raise an uncaught exception in a slot, a moment later."""

        def fail() -> None:
            raise ValueError("on purpose")

        QTimer.singleShot(0, fail)

    def lock_the_screen(self) -> None:
        """Deliver a signal of the desktop from the bus."""
        events = self._watching.findChild(SessionEvents)
        assert events is not None
        assert QMetaObject.invokeMethod(events, "_on_locked")


@contextmanager
def watched(program: Program, qtbot: QtBot, app: QApplication) -> Iterator[Causes]:
    """Supervise a program as at its start. Exceptions in slots are recorded."""
    with qtbot.captureExceptions() as mistakes:
        watching = SafetySupervisor(program, app)
        causes = Causes(WindowDriver(program, qtbot), watching, mistakes)
        try:
            yield causes
        finally:
            watching.close()
            watching.deleteLater()
