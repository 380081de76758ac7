"""The whole program in a process of its own, recording onto a disk that takes its time.

Run as `python -m tests.support.recording_window URL FILE SECONDS`, or `never` for a disk that
hangs; prints `recording` once something was recorded.
"""

import sys
import time
from pathlib import Path
from typing import Any

from PySide6.QtCore import QObject, QTimer

from tests.support.patient import PATIENT
from tests.support.program import trex
from trex_gui import app, composition
from trex_gui.core.recording.store import RecordingWriter
from trex_gui.core.timing import Timeouts
from trex_gui.ui.devices.connection import ConnectionState
from trex_gui.ui.program import Program

ENOUGH = 100  # samples


class Recording(QObject):
    """Begins to record as soon as there is something."""

    def __init__(self, program: Program, path: Path) -> None:
        super().__init__(program.window)
        self._program = program
        self._path = path
        self._samples = 0
        self._timer = QTimer(self)
        self._timer.timeout.connect(self._look)
        self._timer.start(20)

    def _look(self) -> None:
        recorder = trex(self._program).workspace.recordings.recorder
        if trex(self._program).device.link is not ConnectionState.CONNECTED:
            return
        samples = trex(self._program).device.telemetry.samples
        if recorder.recording and samples > self._samples + ENOUGH:
            self._timer.stop()
            sys.stdout.write("recording\n")
            sys.stdout.flush()
        elif recorder.can_record and recorder.start(self._path):
            self._samples = samples


def main(url: str, path: str, disk: str) -> int:
    """Run the program until it is ended."""
    build, finish = composition.build, RecordingWriter.finish

    def slow_finish(writer: RecordingWriter[Any, Any]) -> None:
        time.sleep(60 if disk == "never" else float(disk))
        finish(writer)

    def build_and_record(timeouts: Timeouts | None = None) -> Program:
        del timeouts
        program = build(PATIENT)
        Recording(program, Path(path))
        return program

    setattr(RecordingWriter, "finish", slow_finish)  # noqa: B010 - typed as a method
    composition.build = build_and_record
    return app.main(["--port", url])


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
