"""Window, port, and messages to the user during a fault."""

import os
from collections.abc import Callable
from pathlib import Path
from typing import Any

from PySide6.QtWidgets import QLabel, QWidget

from tests.support.program import trex
from tests.support.simulator import PortFault, SimulatedDevice, StartSimulator
from tests.support.window import WindowDriver
from trex_gui.devices.trex.protocol.calibration import Calibration, CalibrationKey
from trex_gui.devices.trex.settings.document import Settings, settings_of
from trex_gui.ui.devices.connection import ConnectionState
from trex_gui.ui.notifier import Notifier
from trex_gui.ui.runtime import new_timer, now

FIRST, OTHER, JUNIOR = 7, 8, 9
"""Numbers of the boards on the line: the user's board, another board, another model."""

CHECK_INTERVAL_MS = 20
"""Milliseconds between two checks of the window."""

MIN_GAP = 0.1  # seconds by which a late check counts as a gap

SERIAL_TIMEOUT = 15
"""Tenths of a second. Shorter than the duration of a fault."""

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
"""Labels that show messages."""


def _stored(state: dict[str, Any]) -> Stored:
    calibrations = state["calibrations"].items()
    return {**state["parameters"], **{key: Calibration(**value) for key, value in calibrations}}


class BoardOnLine(SimulatedDevice):
    """One of several boards on a line."""

    def __init__(self, line: SimulatedDevice, number: int) -> None:
        self.url = line.url
        self._line = line
        self._number = number

    def control(self, line: str) -> str:
        return self._line.control(line if line.startswith("line") else f"@{self._number} {line}")

    def set_port_fault(self, fault: PortFault) -> None:
        self._line.set_port_fault(fault)

    def end(self) -> None:
        self._line.end()


class FaultHarness:
    """Window, boards and actions of the user in a case.

    Attributes:
        board: the board of the user.
        line: the simulator at the port, with all boards on the line.
        folder: files of the user.
        data: files of the program, such as snapshots.
        messages: messages shown since the fault began.
        gaps: times in which the event loop did not respond since the fault began.
        edits: settings that the user has changed, by key, both applied and pending.
        before: settings that the program read before the fault.
        stored_before: values that the board stored before the fault.
        other_boards_before: result of `other_boards` before the fault.
        targets: targets of the motors while the user drives.
        files: files that are being written.
        foreign: files that another program has written.
        needs_shutdown: true if the serial timeout of the boards stops motors only together with
            UART-Error Shutdown, which is then off. Otherwise it is on.
        uart_settings: value that the board stored before a fault changed it.
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
        self._other_numbers = (OTHER, JUNIOR) if other_boards else ()
        self.window = window
        window.program.complete()
        self.folder = folder / "files"
        self.folder.mkdir()
        self.data = Path(os.environ["TREX_STUDIO_DATA"])
        self.messages: list[str] = []
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
            for number in self._other_numbers:
                BoardOnLine(self.line, number).do(f"eeprom serial_timeout {SERIAL_TIMEOUT}")
                self.switch(number, "off")
        else:
            self.line = self.board = start(*options)
        self.board.do(f"eeprom serial_timeout {SERIAL_TIMEOUT}", "power cycle")
        self.other_boards_before = self.other_boards()
        self.url = self.line.url
        for dialog in ("learnDialog", "reviewDialog"):
            window.dialog(dialog)
        self._labels = [window.find(QLabel, name) for name in LABELS]
        self._due = now() + CHECK_INTERVAL_MS / 1000
        self.listen_to(window.device.notifier)
        self._timer = new_timer(window.window, CHECK_INTERVAL_MS, self._check_window)
        self._timer.start()

    # --- Boards -------------------------------------------------------------------------

    def switch(self, number: int, state: str) -> None:
        """Switch one of several boards on or off."""
        self.line.do(f"@{number} power {state}")

    def stored(self) -> Stored:
        """Return the stored values of the user's board, with all calibrations."""
        return _stored(self.board.show())

    def other_boards(self) -> list[tuple[Stored, int]]:
        """Return the stored values and number of writes of each other board."""
        states = [BoardOnLine(self.line, number).show() for number in self._other_numbers]
        return [(_stored(state), state["counters"]["eeprom_writes"]) for state in states]

    def motor_targets(self) -> list[Target]:
        """Return the targets of the motors of the user's board."""
        motors = self.board.show()["motors"]
        return [(motor["target_direction"], motor["target_speed"]) for motor in motors]

    def motors_run(self) -> bool:
        """Return whether the board has power and drives a motor or accelerates it."""
        state = self.board.show()
        return bool(state["power"]) and (
            state["aux"]["target_speed"] != 0
            or any(motor["target_direction"] != "brake" for motor in state["motors"])
        )

    # --- Actions of the user ------------------------------------------------------------

    @property
    def link(self) -> ConnectionState:
        return self.window.device.link

    def connect(self) -> None:
        self.window.connect(self.url)
        assert self.window.device.state is not None
        self.before = settings_of(self.window.device.state)
        self.stored_before = self.stored()

    def edit_calibration(self, key: CalibrationKey, calibration: Calibration) -> None:
        self.window.device.calibrations.edit(key.channel, calibration)
        self.edits[key] = calibration

    def edit(self, **values: int) -> None:
        """Change parameters to wire values."""
        model = self.window.device.parameters
        for key, value in values.items():
            assert model.setData(model.index_of(key), value)
            self.edits[key] = value

    def at_step(self, number: int, action: Callable[[], object]) -> Callable[[], bool]:
        """Run an action at a step of the session. Return a function that returns whether it ran."""
        done: list[int] = []

        def on_progressed(step: int, _total: int, _text: str) -> None:
            if step >= number and not done:
                done.append(step)
                action()

        self.window.device.connection.progressed.connect(on_progressed)
        return lambda: bool(done)

    @property
    def recordings(self) -> Any:
        return trex(self.window.program).workspace.recordings

    # --- Messages -----------------------------------------------------------------------

    def clear_messages(self) -> None:
        self.messages.clear()
        self.gaps.clear()
        self._due = now() + CHECK_INTERVAL_MS / 1000

    def listen_to(self, notifier: Notifier) -> None:
        """Record every banner message, because the next message may replace it."""
        notifier.logged.connect(lambda text, _is_problem: self._record(text))

    def record_labels(self, widget: QWidget) -> None:
        """Record the texts of all labels of a widget."""
        for label in widget.findChildren(QLabel):
            self._record(label.text())

    def _check_window(self) -> None:
        time = now()
        if time - self._due > MIN_GAP:
            self.gaps.append((self._due, time))
        self._due = time + CHECK_INTERVAL_MS / 1000
        for label in self._labels:
            if label.isVisible():
                self._record(label.text())

    def _record(self, text: str) -> None:
        if text and text not in self.messages:
            self.messages.append(text)
