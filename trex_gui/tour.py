"""A look at every page without a person: pictures of them all, light and dark."""

import sys
from collections.abc import Callable, Iterator
from functools import partial
from pathlib import Path

from PySide6.QtCore import QCoreApplication, QObject, QTimer

from trex_gui.model.device import Link
from trex_gui.views.theme import Scheme, theme
from trex_gui.window import Program

_SIZE = (1440, 800)  # room for a page as it is, and for the panel of the simulated board
_SETTLE_MS = 2500
_PATIENCE_MS = 15_000
_SCHEMES: tuple[Scheme, ...] = ("light", "dark")


class Tour(QObject):
    """Waits for the simulated board, drives its motors a little and writes one PNG a page.

    `folder` is made when it is missing. The program ends with exit code 0 when all pictures
    are written, with 1 when the board did not come up.
    """

    def __init__(self, program: Program, folder: Path) -> None:
        super().__init__()
        self._program = program
        self._folder = folder
        self._steps = self._make_steps()
        self._deadline = QTimer(self)
        self._deadline.setSingleShot(True)
        self._deadline.setInterval(_PATIENCE_MS)
        self._deadline.timeout.connect(lambda: QCoreApplication.exit(1))

    def start(self) -> None:
        """Begin, as soon as the board is there."""
        self._folder.mkdir(parents=True, exist_ok=True)
        self._program.window.resize(*_SIZE)
        self._deadline.start()
        self._program.device.state_changed.connect(self._on_state_changed)

    def _on_state_changed(self) -> None:
        if self._program.device.link is Link.UP and self._deadline.isActive():
            self._deadline.stop()
            motors = self._program.device.motors
            motors.arm()
            motors.set_speed(1, 90)
            motors.set_speed(2, -60)
            motors.set_auxiliary(40)
            QTimer.singleShot(_SETTLE_MS, self._step)

    def _step(self) -> None:
        step = next(self._steps, None)
        if step is None:
            self._program.device.motors.stop()
            QTimer.singleShot(100, self._program.end)
            return
        step()
        QTimer.singleShot(300, self._step)

    def _make_steps(self) -> Iterator[Callable[[], object]]:
        tabs = self._program.window.pages
        for scheme in _SCHEMES:
            yield partial(theme().set_scheme, scheme)
            for index in range(tabs.count()):
                yield partial(tabs.setCurrentIndex, index)
                page = tabs.widget(index)
                name = page.objectName().removesuffix("PageArea") if page else str(index)
                yield partial(self._write, f"{name}-{scheme}.png")

    def _write(self, name: str) -> None:
        path = self._folder / name
        if self._program.window.grab().save(str(path)):
            sys.stdout.write(f"{path}\n")
