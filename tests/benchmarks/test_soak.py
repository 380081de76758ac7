"""Reference count of None over thousands of frames of a window.

With Python 3.11, PySide6 6.12 loses references and ends the process after some hundred frames.
"""

import resource
import sys
import time

from pytestqt.qtbot import QtBot

from tests.benchmarks.conftest import ReportFigure
from tests.support.program import trex
from trex_gui.ui.devices.connection import ConnectionState
from trex_gui.ui.program import Program

_FRAMES = 20_000


def test_20000_frames_lose_no_references_to_none(
    program: Program, qtbot: QtBot, figure: ReportFigure
) -> None:
    trex(program).controller.connect_to(program.ports.demo_of("trex"))
    qtbot.waitUntil(lambda: trex(program).device.link is ConnectionState.CONNECTED, timeout=20_000)
    motors = trex(program).device.motors
    motors.arm()
    motors.set_speed(1, 100)
    tabs = program.window.pages
    before, start, memory = sys.getrefcount(None), time.perf_counter(), _memory()
    for frame in range(_FRAMES):
        if frame % 50 == 0:
            tabs.setCurrentIndex(frame // 50 % tabs.count())
            qtbot.wait(1)
        page = tabs.currentWidget()
        trex(program).device.telemetry.updated.emit()
        page.repaint()
    drift = sys.getrefcount(None) - before
    seconds = time.perf_counter() - start
    motors.stop()
    figure(f"{_FRAMES} frames", seconds, "s")
    figure(f"references to None after {_FRAMES} frames", drift, "", at_least=-1000)
    figure(f"memory gained in {_FRAMES} frames", _memory() - memory, "MiB")


def _memory() -> float:
    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024
