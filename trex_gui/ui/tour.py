"""Screenshots of every page and dialog, light and dark, without a user."""

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

_SIZE = QSize(1440, 800)  # space for a page and for the panel of the simulated device
_SETTLE_MS = 2500
_STEP_MS = 200
_STOP_MS = 100  # time to send the stop
_TIMEOUT_MS = 30_000  # a computer may be busy, and a stop is confirmed on a quiet line only

Do = Callable[[], object]
"""Step of the tour. A step that returns `False` could not be done yet and is tried again."""


class Tour(QObject):
    """Connects to each simulated device, runs the steps of its plugin, writes PNG files."""

    # True if all pictures are written. False: a device did not connect, or a step failed.
    finished = Signal(bool)

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
        self._waiting: tuple[Do, float] | None = None
        self._timer = new_timer(self, _STEP_MS, self._step, single_shot=True)

    def start(self) -> None:
        self._folder.mkdir(parents=True, exist_ok=True)
        self._program.window.resize(self._size)
        self._step()

    def _step(self) -> None:
        try:
            step, begun = self._waiting or (next(self._steps, None), now())
            is_done = step is None or step() is not False
        except Exception:
            self._finish(has_all=False)
            raise
        if step is None or (not is_done and now() > begun + _TIMEOUT_MS / 1000):
            self._finish(has_all=is_done)
            return
        self._waiting = None if is_done else (step, begun)
        self._timer.start()

    def _finish(self, *, has_all: bool) -> None:
        self._program.device_manager.press_stop()
        report = partial(self.finished.emit, has_all)
        new_timer(self, _STOP_MS, report, single_shot=True).start()

    def _create_steps(self) -> Iterator[Do]:
        manager = self._program.device_manager
        for plugin in self._program.plugins:
            controller = manager.controller(plugin.key)
            yield manager.press_stop
            yield partial(self._program.connect_to_demo, plugin.key)
            yield lambda: manager.current.link is ConnectionState.CONNECTED
            yield from plugin.tour.load()(self, controller)

    @staticmethod
    def wait(seconds: float = _SETTLE_MS / 1000) -> Iterator[Do]:
        yield from [lambda: None] * round(seconds * 1000 / _STEP_MS)

    def look_at_pages(self, state: str = "") -> Iterator[Do]:
        """Take pictures of all pages. `state` becomes part of the file names."""
        window = self._program.window
        for scheme in self._schemes:
            yield partial(theme().set_scheme, scheme)
            device = self._program.device_manager.current
            workspace = self._program.workspace(device.plugin.key)
            for index in range(workspace.count):
                yield partial(workspace.show_number, index)
                page = workspace.page_at(index)
                name = page.objectName().removesuffix("PageArea") if page else str(index)
                yield partial(self.write, window, f"{name}{state}", scheme)

    def look_at(self, dialog: str, name: str) -> Iterator[Do]:
        widget = self._program.window.findChild(QWidget, dialog)
        for scheme in self._schemes:
            yield partial(theme().set_scheme, scheme)
            if widget is not None:
                yield partial(self.write, widget, name, scheme)

    def trigger_action(self, action: str) -> bool:
        found = self._program.window.findChild(QAction, action)
        if found is None or not found.isEnabled():
            return False
        found.trigger()
        return True

    def press(self, button: str) -> bool:
        found = self._program.window.findChild(QAbstractButton, button)
        if found is None or not (found.isVisible() and found.isEnabled()):
            return False
        found.click()
        return True

    def is_visible(self, widget: str) -> bool:
        found = self._program.window.findChild(QWidget, widget)
        return found is not None and found.isVisible()

    def write(self, widget: QWidget, name: str, scheme: Scheme) -> None:
        for leds in widget.findChildren(Leds):
            leds.show_moment(0.0)  # a moment when blinking LEDs are lit
        path = self._folder / f"{name}-{scheme}.png"
        if widget.grab().save(str(path)):
            sys.stdout.write(f"{path}\n")
