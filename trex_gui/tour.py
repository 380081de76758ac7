"""A look at every page and at the wizard without a person: pictures of them, light and dark."""

import sys
from collections.abc import Callable, Iterator, Sequence
from functools import partial
from pathlib import Path

from PySide6.QtCore import QObject, QTimer, Signal
from PySide6.QtGui import QAction
from PySide6.QtWidgets import QAbstractButton, QWidget

from trex_gui.devices.aracna.session.messages import Play, Step
from trex_gui.devices.trex.protocol.flags import CHANNELS
from trex_gui.program import Program
from trex_gui.ui.devices.connection_state import ConnectionState
from trex_gui.ui.runtime import now, runtime
from trex_gui.ui.theme.theme import Scheme, theme

_SIZE = (1440, 800)  # room for a page as it is, and for the panel of the simulated board
_SETTLE_MS = 2500
_STEP_MS = 200
_STOP_MS = 100  # for the stop to be sent
_PATIENCE_MS = 30_000  # a machine may be busy, and a stop is proved on a quiet line only
_ROBOT_STEP = 2.5  # seconds; long enough that every picture shows it on its way
_DEAD_SERVO = 3
_HELD_STEPS = 6  # a stick that is held longer than a second is at an end

Do = Callable[[], object]
"""A step of the tour; one that answers `False` could not be done yet and is tried again."""


class Tour(QObject):
    """Waits for the simulated board, drives its motors a little and writes one PNG a page.

    Then it learns the channels, moving the board's sticks itself, with a picture of each step;
    what was learned is not taken. At last it looks at the pages of the simulated robot: at rest,
    in motion, and waiting for a servo that has died.

    `folder` is made when it is missing.

    Signals:
        finished: whether all pictures are written; else the board did not come up, or the wizard
            did not go on.
    """

    finished = Signal(bool)

    def __init__(
        self, program: Program, folder: Path, schemes: Sequence[Scheme] = ("light", "dark")
    ) -> None:
        super().__init__()
        self._schemes = schemes
        self._program = program
        self._folder = folder
        self._steps = self._make_steps()
        self._waiting: tuple[Do, float] | None = None
        self._timer = self._single_shot(self._step)
        self._has_all = False
        self._end = self._single_shot(lambda: self.finished.emit(self._has_all))
        self._deadline = self._single_shot(lambda: self.finished.emit(False))

    def _single_shot(self, act: Callable[[], object]) -> QTimer:
        timer = runtime().timer(self)
        timer.setSingleShot(True)
        timer.timeout.connect(act)
        return timer

    def start(self) -> None:
        """Begin, as soon as the board is there."""
        self._folder.mkdir(parents=True, exist_ok=True)
        self._program.window.resize(*_SIZE)
        self._deadline.start(_PATIENCE_MS)
        self._program.device.state_changed.connect(self._on_state_changed)

    def _on_state_changed(self) -> None:
        if self._program.device.link is ConnectionState.CONNECTED and self._deadline.isActive():
            self._deadline.stop()
            motors = self._program.device.motors
            motors.arm()
            motors.set_speed(1, 90)
            motors.set_speed(2, -60)
            motors.set_auxiliary(40)
            self._timer.start(_SETTLE_MS)

    def _step(self) -> None:
        step, begun = self._waiting or (next(self._steps, None), now())
        self._waiting = None
        is_done = step is None or step() is not False
        if step is None or (not is_done and now() > begun + _PATIENCE_MS / 1000):
            self._has_all = is_done
            self._program.device.motors.stop()
            self._end.start(_STOP_MS)
            return
        if not is_done:
            self._waiting = step, begun
        self._timer.start(_STEP_MS)

    def _make_steps(self) -> Iterator[Do]:
        yield from self._look_at_pages()
        yield from self._learn()
        yield from self._look_at_robot()

    def _look_at_pages(self, state: str = "", *, first_only: bool = False) -> Iterator[Do]:
        """Look at the pages, or at the first one; `state` goes into the names of the pictures."""
        window = self._program.window
        tabs = window.pages
        for scheme in self._schemes:
            yield partial(theme().set_scheme, scheme)
            for index in range(1 if first_only else tabs.count()):
                yield partial(tabs.setCurrentIndex, index)
                page = tabs.widget(index)
                name = page.objectName().removesuffix("PageArea") if page else str(index)
                yield partial(self._write, window, f"{name}{state}-{scheme}.png")

    def _learn(self) -> Iterator[Do]:
        sticks = self._program.connector.demo_board
        yield partial(sticks.set_automatic, False)
        yield sticks.centre_sticks
        yield partial(self._choose, "learnAction")
        yield self._is_at_rest
        yield from self._look_at_wizard("learn-rest")
        yield partial(self._press, "learnNextButton")
        yield partial(self._is_seen, "learnTravelPage")
        for microseconds in (1850, 1150):
            yield from self._hold(microseconds)
        yield sticks.centre_sticks
        yield from self._look_at_wizard("learn-travel")
        yield partial(self._press, "learnNextButton")
        yield partial(self._is_seen, "learnReviewPage")
        yield from self._look_at_wizard("learn-review")
        yield partial(self._press, "learnCancelButton")
        yield partial(self._choose, "test_sticksAction")
        yield partial(self._is_seen, "learnTestPage")
        yield from self._hold(1850)
        yield from self._look_at_wizard("learn-test")
        yield partial(self._press, "learnCancelButton")

    def _look_at_robot(self) -> Iterator[Do]:
        """Look at the simulated Aracna at rest, in motion, and waiting for a dead servo.

        Its panel stands beside them, and shows what the robot does not tell.
        """
        robot, demo = self._program.robot, self._program.robot_way.demo_robot
        pairs = robot.motors // 2
        steps = tuple(
            Step(goals * pairs, _ROBOT_STEP, name)
            for name, goals in (("down", (300, 400)), ("up", (550, 150)))
        )
        yield self._program.device.motors.stop
        yield partial(self._program.connect_to_demo, "aracna")
        yield lambda: robot.link is ConnectionState.CONNECTED
        yield partial(robot.move, steps[0].goals)
        yield lambda: robot.known.moved is not None
        yield from self._look_at_pages()
        yield partial(robot.play, Play(0, steps, rounds=0))
        yield lambda: robot.known.moving is not None
        yield from self._look_at_pages("-moving")
        yield partial(demo.set_dead, _DEAD_SERVO, True)
        yield lambda: robot.known.stuck is not None
        yield from self._look_at_pages("-stuck", first_only=True)

    def _hold(self, microseconds: float) -> Iterator[Do]:
        """Hold all sticks for a while where they give pulses of this length."""
        sticks = self._program.connector.demo_board

        def push() -> None:
            for channel in CHANNELS:
                sticks.hold_stick(channel, microseconds)

        yield push
        yield from [lambda: None] * _HELD_STEPS

    def _look_at_wizard(self, name: str) -> Iterator[Do]:
        dialog = self._program.window.findChild(QWidget, "learnDialog")
        for scheme in self._schemes:
            yield partial(theme().set_scheme, scheme)
            if dialog is not None:
                yield partial(self._write, dialog, f"{name}-{scheme}.png")

    def _choose(self, name: str) -> bool:
        action = self._program.window.findChild(QAction, name)
        if action is None or not action.isEnabled():
            return False
        action.trigger()
        return True

    def _press(self, name: str) -> bool:
        button = self._program.window.findChild(QAbstractButton, name)
        if button is None or not (button.isVisible() and button.isEnabled()):
            return False
        button.click()
        return True

    def _is_at_rest(self) -> bool:
        """Whether the motors are stopped; on a busy machine that may take more than one try."""
        return self._is_seen("learnRestPage") or (self._press("learnAgainButton") and False)

    def _is_seen(self, name: str) -> bool:
        found = self._program.window.findChild(QWidget, name)
        return found is not None and found.isVisible()

    def _write(self, widget: QWidget, name: str) -> None:
        path = self._folder / name
        if widget.grab().save(str(path)):
            sys.stdout.write(f"{path}\n")
