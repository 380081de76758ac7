"""What makes the program stop everything by itself, brought about in a window of the test's own."""

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
    """A supervised window, and the events that stop its motors.

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
        """The kinds of the errors that nobody caught."""
        return [kind for kind, *_ in self._caught]

    @property
    def banner(self) -> str:
        """What the banner says; empty while none is shown."""
        return self._window.text("bannerText") if self._window.has("bannerText") else ""

    def make_a_mistake(self) -> None:
        """Let a slot raise an error that nobody catches, a moment later."""

        def fail() -> None:
            raise ValueError("on purpose")

        QTimer.singleShot(0, fail)

    def lock_the_screen(self) -> None:
        """Say what the desktop says, as it arrives from the bus."""
        events = self._watching.findChild(SessionEvents)
        assert events is not None
        assert QMetaObject.invokeMethod(events, "_on_locked")


@contextmanager
def watched(program: Program, qtbot: QtBot, app: QApplication) -> Iterator[Causes]:
    """Watch over a program as its start does; errors of slots are kept, and fail nothing."""
    with qtbot.captureExceptions() as mistakes:
        watching = SafetySupervisor(program, app)
        causes = Causes(WindowDriver(program, qtbot), watching, mistakes)
        try:
            yield causes
        finally:
            watching.close()
            watching.deleteLater()
