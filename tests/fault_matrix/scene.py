"""A window, its port, and the messages to the user during a fault."""

import os
from collections.abc import Callable
from pathlib import Path
from typing import Any

from PySide6.QtWidgets import QLabel, QWidget

from tests.support.program import trex
from tests.support.simulator import PortFault, SimulatedDevice, StartSimulator
from tests.support.window import WindowDriver
from trex_gui.core.session import Progress
from trex_gui.devices.trex.protocol.calibration import Calibration, CalibrationKey
from trex_gui.devices.trex.settings.document import Settings, settings_of
from trex_gui.ui.devices.connection import ConnectionState
from trex_gui.ui.notifier import Notifier
from trex_gui.ui.runtime import new_timer, now

FIRST, OTHER, JUNIOR = 7, 8, 9
"""Numbers of the boards on the line: the user's board, another board, another model."""

LOOK_MS = 20
"""Milliseconds between two checks of the window."""

SHORTEST_GAP = 0.1  # seconds

SERIAL_TIMEOUT = 15
"""Tenths of a second; shorter than a fault lasts."""

Gap = tuple[float, float]

Stored = dict[str, int | Calibration]

Target = tuple[str, int]
"""Direction and speed."""

LABELS = (
    "bannerText",
    "questionText",
    "statusLabel",
    "motorsReason1",
    "boardLost",
    "motorStateLabel",
    "learnNote",
    "reviewHead",
)
"""Places of messages."""


def _stored(shown: dict[str, Any]) -> Stored:
    calibrations = shown["calibrations"].items()
    return {**shown["parameters"], **{key: Calibration(**value) for key, value in calibrations}}


class BoardOnLine(SimulatedDevice):
    """One of several boards on a line."""

    def __init__(self, line: SimulatedDevice, number: int) -> None:
        self.url = line.url
        self._line = line
        self._number = number

    def obey(self, line: str) -> str:
        return self._line.obey(line if line.startswith("line") else f"@{self._number} {line}")

    def set_port_fault(self, fault: PortFault) -> None:
        self._line.set_port_fault(fault)

    def end(self) -> None:
        self._line.end()


class Scene:
    """Scene of the cases.

    Attributes:
        board: the board of the user.
        line: what is at the port: the board, or all boards on its line.
        folder: where the user keeps files.
        data: where the program keeps snapshots.
        said: what the window has shown since the fault began.
        gaps: from when to when the event loop did not answer, since the fault began.
        edits: the settings that the user changed and has applied or not, by key.
        before: what the program has read from the board before.
        stored_before: what the board stored before.
        others_before: the same of the other boards on its line, and how often they had written.
        targets: what the motors are to do, if the user drives.
        files: what is being written.
        foreign: what another program has written.
        needs_shutdown: whether the serial timeout of the boards stops motors only with UART-Error
            Shutdown, which is off then. Else that is on.
        uart_settings: what the board stored before a fault changed it.
    """

    def __init__(
        self,
        window: WindowDriver,
        start: StartSimulator,
        folder: Path,
        *,
        other_boards: bool = False,
        needs_shutdown: bool,
    ) -> None:
        self._others = (OTHER, JUNIOR) if other_boards else ()
        self.window = window
        window.program.complete()
        self.folder = folder / "files"
        self.folder.mkdir()
        self.data = Path(os.environ["TREX_STUDIO_DATA"])
        self.said: list[str] = []
        self.gaps: list[Gap] = []
        self.edits: dict[str, int | Calibration] = {}
        self.before: Settings | None = None
        self.stored_before: Stored = {}
        self.targets: list[Target] = []
        self.files: list[Path] = []
        self.foreign: list[Path] = []
        self.uart_settings = 0
        self.needs_shutdown = needs_shutdown
        options = ["--timeout-needs-shutdown", "on" if needs_shutdown else "off"]
        options += ["--error-shutdown", "off" if needs_shutdown else "on"]
        if other_boards:
            for device in (f"{FIRST}", f"{OTHER}", f"{JUNIOR}:trexjr"):
                options += ["--device", device]
            self.line = start(*options)
            self.board: SimulatedDevice = BoardOnLine(self.line, FIRST)
            for number in self._others:
                BoardOnLine(self.line, number).do(f"eeprom serial_timeout {SERIAL_TIMEOUT}")
                self.switch(number, "off")
        else:
            self.line = self.board = start(*options)
        self.board.do(f"eeprom serial_timeout {SERIAL_TIMEOUT}", "power cycle")
        self.others_before = self.others()
        self.url = self.line.url
        for dialog in ("learnDialog", "reviewDialog"):
            window.dialog(dialog)
        self._labels = [window.root.findChild(QLabel, name) for name in LABELS]
        self._due = now() + LOOK_MS / 1000
        self.listen_to(window.device.notifier)
        self._timer = new_timer(window.window, LOOK_MS, self._look)
        self._timer.start()

    # --- Boards -------------------------------------------------------------------------

    def switch(self, number: int, state: str) -> None:
        """Switch one of several boards on or off."""
        self.line.do(f"@{number} power {state}")

    def shown(self) -> dict[str, Any]:
        return self.board.show()

    def stored(self) -> Stored:
        """Return the stored values of the user's board, with all calibrations."""
        return _stored(self.shown())

    def others(self) -> list[tuple[Stored, int]]:
        """Return the stored values and number of writes of each other board."""
        shown = [BoardOnLine(self.line, number).show() for number in self._others]
        return [(_stored(one), one["counters"]["eeprom_writes"]) for one in shown]

    def driven(self) -> list[Target]:
        """Return the targets of the motors of the user's board."""
        motors = self.shown()["motors"]
        return [(motor["target_direction"], motor["target_speed"]) for motor in motors]

    def motors_turn(self) -> bool:
        """True if the board has power and drives a motor, or will drive it."""
        shown = self.shown()
        return bool(shown["power"]) and (
            shown["aux"]["target_speed"] != 0
            or any(motor["target_direction"] != "brake" for motor in shown["motors"])
        )

    # --- The user -----------------------------------------------------------------------

    @property
    def link(self) -> ConnectionState:
        return self.window.device.link

    def connect(self) -> None:
        self.window.connect(self.url)
        assert self.window.device.state is not None
        self.before = settings_of(self.window.device.state)
        self.stored_before = self.stored()

    def edit_calibration(self, key: CalibrationKey, wanted: Calibration) -> None:
        self.window.device.calibrations.edit(key.channel, wanted)
        self.edits[key] = wanted

    def edit(self, **values: int) -> None:
        """Change parameters to wire values."""
        model = self.window.device.parameters
        for key, value in values.items():
            assert model.setData(model.index_of(key), value)
            self.edits[key] = value

    def at_step(self, number: int, act: Callable[[], object]) -> Callable[[], bool]:
        """Run an action at the `number`th step of the line. Return whether it ran."""
        done: list[Progress] = []
        progressed = self.window.device.connection.progressed

        def on_progressed(step: int, total: int, what: str) -> None:
            if step >= number and not done:
                done.append(Progress(step, total, what))
                act()

        progressed.connect(on_progressed)
        return lambda: bool(done)

    def let_pass(self, seconds: float) -> None:
        end = now() + seconds
        self.window.wait(lambda: now() >= end)

    @property
    def recordings(self) -> Any:
        return trex(self.window.program).workspace.recordings

    # --- What the user sees -------------------------------------------------------------

    def start_watching(self) -> None:
        self.said.clear()
        self.gaps.clear()
        self._due = now() + LOOK_MS / 1000

    def listen_to(self, notifier: Notifier) -> None:
        """Record every banner message, because the next message may replace it."""
        notifier.error.connect(self._hear)
        notifier.info.connect(self._hear)

    def hear_all(self, widget: QWidget) -> None:
        """Record the texts of all labels of a widget."""
        for label in widget.findChildren(QLabel):
            self._hear(label.text())

    def _look(self) -> None:
        moment = now()
        if moment - self._due > SHORTEST_GAP:
            self.gaps.append((self._due, moment))
        self._due = moment + LOOK_MS / 1000
        for label in self._labels:
            if label is not None and label.isVisible():
                self._hear(label.text())

    def _hear(self, text: str) -> None:
        if text and text not in self.said:
            self.said.append(text)
