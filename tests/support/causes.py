"""Events at which the program stops all motors automatically."""

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
        reports: texts of the reported stops, in order.
    """

    def __init__(
        self,
        window: WindowDriver,
        supervisor: SafetySupervisor,
        exceptions: Sequence[tuple[Any, ...]],
    ) -> None:
        self._window = window
        self._supervisor = supervisor
        self._exceptions = exceptions
        self.reports: list[str] = []
        window.program.device_manager.stop_reported.connect(self.reports.append)

    @property
    def exceptions(self) -> list[type[BaseException]]:
        """Types of the uncaught exceptions."""
        return [kind for kind, *_ in self._exceptions]

    @property
    def banner(self) -> str:
        """Text of the banner. Empty without a banner."""
        return self._window.text("bannerText") if self._window.has("bannerText") else ""

    def raise_in_slot(self) -> None:
        """Raise an exception in a slot as soon as the event loop runs."""

        def fail() -> None:
            raise ValueError("on purpose")

        QTimer.singleShot(0, fail)

    def lock_the_screen(self) -> None:
        """Deliver the signal that the desktop sends on the message bus."""
        events = self._supervisor.findChild(SessionEvents)
        assert events is not None
        assert QMetaObject.invokeMethod(events, "_on_locked")


@contextmanager
def watched(program: Program, qtbot: QtBot, app: QApplication) -> Iterator[Causes]:
    """Supervise a program like its start does. Record exceptions in slots."""
    with qtbot.captureExceptions() as exceptions:
        supervisor = SafetySupervisor(program, app)
        causes = Causes(WindowDriver(program, qtbot), supervisor, exceptions)
        try:
            yield causes
        finally:
            supervisor.close()
            supervisor.deleteLater()
