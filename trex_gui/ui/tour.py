"""Automatic screenshots of pages and dialogs, in light and dark schemes."""

import sys
from collections.abc import Callable, Iterator, Sequence
from functools import partial
from pathlib import Path

from PySide6.QtCore import QObject, QSize, Signal
from PySide6.QtGui import QAction
from PySide6.QtWidgets import QAbstractButton, QWidget

from trex_gui.ui.devices.connection import ConnectionState
from trex_gui.ui.program import Program
from trex_gui.ui.runtime import new_timer, now
from trex_gui.ui.theme.theme import Scheme, theme
from trex_gui.ui.widgets.leds import Leds

_SIZE = QSize(1440, 800)  # fits a page beside the panel of the simulated device
_SETTLE_MS = 2500
_STEP_MS = 200
_STOP_MS = 100  # time to send the stop
_TIMEOUT_MS = 30_000  # computers may be slow, and a stop is confirmed only on a quiet line

TourStep = Callable[[], object]  # step of the tour; repeated while it returns `False`


class Tour(QObject):
    """Tour of all simulated devices that writes PNG files. The plugins define its steps."""

    finished = Signal(bool)  # True if all pictures were written, False if a step failed

    def __init__(
        self,
        program: Program,
        folder: Path,
        schemes: Sequence[Scheme] = ("light", "dark"),
        *,
        size: QSize = _SIZE,
    ) -> None:
        super().__init__(program.window)
        self._schemes = schemes
        self._size = size
        self._program = program
        self._folder = folder
        self._steps = self._create_steps()
        self._pending: tuple[TourStep, float] | None = None  # step, and time of its first attempt
        self._timer = new_timer(self, _STEP_MS, self._step, single_shot=True)

    def start(self) -> None:
        self._folder.mkdir(parents=True, exist_ok=True)
        self._program.window.resize(self._size)
        self._step()

    def _step(self) -> None:
        try:
            step, started = self._pending or (next(self._steps, None), now())
            is_done = step is None or step() is not False
        except Exception:
            self._finish(is_complete=False)
            raise
        if step is None or (not is_done and now() > started + _TIMEOUT_MS / 1000):
            self._finish(is_complete=is_done)
            return
        self._pending = None if is_done else (step, started)
        self._timer.start()

    def _finish(self, *, is_complete: bool) -> None:
        self._program.device_manager.press_stop()
        report = partial(self.finished.emit, is_complete)
        new_timer(self, _STOP_MS, report, single_shot=True).start()

    def _create_steps(self) -> Iterator[TourStep]:
        manager = self._program.device_manager
        for plugin in self._program.plugins:
            controller = manager.controller(plugin.key)
            yield manager.press_stop
            yield partial(self._program.connect_to_demo, plugin.key)
            yield lambda: manager.current.link is ConnectionState.CONNECTED
            yield from plugin.tour.load()(self, controller)

    @staticmethod
    def wait(seconds: float = _SETTLE_MS / 1000) -> Iterator[TourStep]:
        yield from [lambda: None] * round(seconds * 1000 / _STEP_MS)

    def capture_pages(self, state: str = "") -> Iterator[TourStep]:
        """Capture all pages. `state` becomes part of the file names."""
        window = self._program.window
        for scheme in self._schemes:
            yield partial(theme().set_scheme, scheme)
            device = self._program.device_manager.current
            workspace = self._program.workspace(device.plugin.key)
            for index in range(workspace.page_count):
                yield partial(workspace.show_page_at, index)
                page = workspace.page_at(index)
                name = page.objectName().removesuffix("PageArea") if page else str(index)
                yield partial(self.write, window, f"{name}{state}", scheme)

    def capture_dialog(self, dialog: str, name: str) -> Iterator[TourStep]:
        widget = self._program.window.findChild(QWidget, dialog)
        for scheme in self._schemes:
            yield partial(theme().set_scheme, scheme)
            if widget is not None:
                yield partial(self.write, widget, name, scheme)

    def trigger_action(self, name: str) -> bool:
        action = self._program.window.findChild(QAction, name)
        if action is None or not action.isEnabled():
            return False
        action.trigger()
        return True

    def press(self, name: str) -> bool:
        button = self._program.window.findChild(QAbstractButton, name)
        if button is None or not (button.isVisible() and button.isEnabled()):
            return False
        button.click()
        return True

    def is_visible(self, name: str) -> bool:
        widget = self._program.window.findChild(QWidget, name)
        return widget is not None and widget.isVisible()

    def write(self, widget: QWidget, name: str, scheme: Scheme) -> bool:
        """Write a picture. Return False if the file cannot be written."""
        for leds in widget.findChildren(Leds):
            leds.show_moment(0.0)  # the moment at which blinking LEDs are lit
        path = self._folder / f"{name}-{scheme}.png"
        is_saved = widget.grab().save(str(path))
        if is_saved:
            sys.stdout.write(f"{path}\n")
        return is_saved
