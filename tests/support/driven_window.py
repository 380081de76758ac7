"""The whole program in a separate process, which drives motors until it fails on request.

Run as `python -m tests.support.driven_window URL [TIMEOUTS [BAUD]]`. With `default` as TIMEOUTS the
program has its own timeouts, otherwise longer ones.

Each line on stdin is the name of a method of `Driver`. After `drive`, the program arms and drives
all motors, and does so again after each stop. It prints `driving` once the motors are driven. Any
other command ends the rearming. `stop_rearming` only prints `rearming_stopped`. The other commands
cause a fault or an action of the user. The program prints `hanging` before it hangs, and
`recording` after some samples are recorded.
"""

import os
import signal
import sys
import threading
import time
from contextlib import suppress
from functools import partial
from pathlib import Path
from typing import Any

from PySide6.QtCore import QCoreApplication, QEvent, QObject, QSocketNotifier, QTimer
from PySide6.QtGui import QPaintEvent
from PySide6.QtWidgets import QWidget

from tests.support.patient import PATIENT
from tests.support.program import trex
from trex_gui import app, composition
from trex_gui.core.recording.store import RecordingWriter
from trex_gui.core.timing import Timeouts
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.devices.trex.protocol.line_settings import LineSettings
from trex_gui.devices.trex.session import board_reader, open_line
from trex_gui.supervisor import SuspendDetector
from trex_gui.ui.devices.connection import ConnectionState
from trex_gui.ui.program import Program

SPEEDS = {1: 30, 2: -30}
AUXILIARY = 35
HANG_S = 30.0
RECORDED_SAMPLES = 100


def raise_error(kind: type[BaseException]) -> None:
    raise kind("on purpose")


class FailingFilter(QObject):
    """Event filter that fails once."""

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        watched.removeEventFilter(self)
        raise LookupError("on purpose")


class FailingWidget(QWidget):
    """Widget that fails to paint itself once."""

    def paintEvent(self, event: QPaintEvent) -> None:
        self.hide()
        raise ArithmeticError("on purpose")


class Driver(QObject):
    """Performs actions of a user, and causes faults."""

    def __init__(self, program: Program) -> None:
        super().__init__(program.window)
        self._program = program
        self._motors = trex(program).device.motors
        self._has_driven = False
        self._rearm_timer = QTimer(self)
        self._rearm_timer.timeout.connect(self._drive_if_possible)
        self._rearm_timer.setInterval(20)
        self._commands = QSocketNotifier(0, QSocketNotifier.Type.Read, self)
        self._commands.activated.connect(self._on_command)
        self._failure = QTimer(self)
        self._failure.setSingleShot(True)
        self._failure.timeout.connect(partial(raise_error, ZeroDivisionError))

    def _drive_if_possible(self) -> None:
        if (
            trex(self._program).device.link is not ConnectionState.CONNECTED
            or not self._motors.is_available
        ):
            return
        if self._motors.armed:
            return
        self._motors.accelerate = False
        self._motors.arm()
        for motor, speed in SPEEDS.items():
            self._motors.set_speed(motor, speed)
        self._motors.set_auxiliary(AUXILIARY)
        if not self._has_driven:
            self._has_driven = True
            self._print("driving")

    def _print(self, word: str) -> None:
        sys.stdout.write(f"{word}\n")
        sys.stdout.flush()

    def _on_command(self) -> None:
        self._rearm_timer.stop()
        for command in os.read(0, 4096).decode().split():
            getattr(self, command)()

    def drive(self) -> None:
        self._has_driven = False
        self._rearm_timer.start()

    def stop_rearming(self) -> None:
        self._print("rearming_stopped")

    def error_in_a_slot(self) -> None:
        self._failure.start(0)

    def error_in_a_thread(self) -> None:
        threading.Thread(target=raise_error, args=(IndexError,)).start()

    def exit_in_a_thread(self) -> None:
        threading.Thread(target=raise_error, args=(SystemExit,)).start()

    def interrupt_in_a_slot(self) -> None:
        QTimer.singleShot(0, partial(raise_error, KeyboardInterrupt))

    def error_in_an_event_filter(self) -> None:
        self._program.window.installEventFilter(FailingFilter(self._program.window))
        self._program.window.update()

    def error_while_painting(self) -> None:
        FailingWidget(self._program.window).show()

    def exit_in_a_slot(self) -> None:
        QTimer.singleShot(0, partial(sys.exit, 3))

    def exit_in_a_signal_handler(self) -> None:
        signal.signal(signal.SIGWINCH, lambda *_: sys.exit(3))
        os.kill(os.getpid(), signal.SIGWINCH)

    def error_in_a_destructor(self) -> None:
        class Dying:
            def __del__(self) -> None:
                raise_error(RecursionError)

        Dying()

    def end_of_the_line_thread(self) -> None:
        def collect(*_: object) -> None:
            raise SystemExit("on purpose")  # not caught by exception handlers

        setattr(open_line.OpenLine, "collect", collect)  # noqa: B010

    def close_the_descriptor(self) -> None:
        """Close the port like a fault elsewhere in the process."""
        for link in Path("/proc/self/fd").iterdir():
            with suppress(OSError):
                if str(link.readlink()).startswith("/dev/pts/"):
                    os.close(int(link.name))

    def hang_the_line(self) -> None:
        def poll(*_: object) -> None:
            self._print("hanging")
            time.sleep(HANG_S)

        setattr(board_reader, "poll", poll)  # noqa: B010

    def hang(self) -> None:
        self._print("hanging")
        time.sleep(HANG_S)

    def hang_computing(self) -> None:
        self._print("hanging")
        end = time.monotonic() + HANG_S
        while time.monotonic() < end:
            pass

    def close(self) -> None:
        self._program.window.close()

    def sleep_unnoticed(self) -> None:
        program = QCoreApplication.instance()
        assert program is not None
        watch = program.findChild(SuspendDetector)
        assert watch is not None
        watch._slept = lambda: 1e6

    def record_on_a_slow_disk(self) -> None:
        self._record(0.05)

    def record_on_a_hanging_disk(self) -> None:
        self._record(2 * HANG_S)

    def _record(self, seconds: float) -> None:
        """Record onto a disk that is slow at the end of the recording."""
        parts, finish, timer = trex(self._program), RecordingWriter.finish, QTimer(self)
        recorder, last_sample = parts.workspace.recordings.recorder, 0

        def finish_late(writer: RecordingWriter[Any, Any]) -> None:
            time.sleep(seconds)
            finish(writer)

        def check() -> None:
            nonlocal last_sample
            if recorder.can_record:
                recorder.start(Path(os.environ["TREX_STUDIO_DATA"]) / "a.trexrec")
                last_sample = parts.device.telemetry.samples + RECORDED_SAMPLES
            elif recorder.recording and parts.device.telemetry.samples > last_sample:
                timer.stop()
                self._print("recording")

        setattr(RecordingWriter, "finish", finish_late)  # noqa: B010
        timer.timeout.connect(check)
        timer.start(20)

    def lose_the_gamepad(self) -> None:
        self._motors.acquire("gamepad")
        self._motors.set_speed(1, 90, "gamepad")
        self._motors.abort("gamepad", "The gamepad is gone.")


def main(url: str, timeout_set: str = "", baud: str = "19200") -> int:
    """Run the program until it ends."""
    build = composition.build

    def build_and_drive(timeouts: Timeouts | None = None) -> Program:
        del timeouts
        program = build(Timeouts() if timeout_set == "default" else PATIENT)
        trex(program).controller.set_settings(ConnectionSettings("", LineSettings(int(baud))))
        Driver(program)
        return program

    composition.build = build_and_drive
    return app.main(["--port", url])


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
