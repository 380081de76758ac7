"""Cost of the program's window in a separate process, with a connected board.

`python -m tests.benchmarks.loaded_window load|gaps|dialogs|memory URL SECONDS` prints one JSON
object.
"""

import json
import os
import sys
import time
from collections.abc import Callable, Sequence
from dataclasses import replace
from functools import partial
from pathlib import Path

from PySide6.QtCore import QCoreApplication, QEventLoop, QSettings, Qt, QTimer
from PySide6.QtGui import QAction
from PySide6.QtWidgets import QApplication

from tests.support.program import trex
from trex_gui import composition
from trex_gui.app import complete
from trex_gui.core.transport.traffic import TrafficDirection, TrafficEvent
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.devices.trex.protocol.line_settings import LineSettings
from trex_gui.devices.trex.session.messages import Batch
from trex_gui.supervisor import SafetySupervisor
from trex_gui.ui.devices.connection import ConnectionState
from trex_gui.ui.program import Program
from trex_gui.ui.theme.theme import theme
from trex_gui.ui.workers.threads import GuiThreadCollector

BAUD = 115_200
_SETTLE = 2.0  # seconds for a page to be laid out and painted before its cost is measured
_TURN = 1.0  # seconds for which each page is shown in turn
_TICK_MS = 5
_DIALOGS = (
    ("bench", "history"),
    ("apply", "defaults"),
    ("setup", "learn"),
    ("preferences", "report"),
    ("find", "check_board"),
)
_SENT, _RECEIVED = TrafficDirection.SENT, TrafficDirection.RECEIVED
_RECORDED = 4.0  # seconds of telemetry that are replayed to fill an hour


def _run_loop(seconds: float) -> None:
    loop = QEventLoop()
    QTimer.singleShot(round(1000 * seconds), loop.quit)
    loop.exec()


def _connected(url: str, collector: GuiThreadCollector) -> Program:
    """Return a started program with a connected board and all modules loaded."""
    program = composition.build()
    program.window.show()
    _run_loop(0.2)
    complete(program, collector)
    device = trex(program).device
    device.connect_to(ConnectionSettings(url, LineSettings(BAUD)))
    while device.link is not ConnectionState.CONNECTED:
        _run_loop(0.05)
    return program


def _cpu(program: Program, seconds: float) -> dict[str, float]:
    """Return percent of a core for each page and without a window, in all threads."""
    window, tabs = program.window, program.window.pages
    states: dict[str, Callable[[], None]] = {
        tabs.tabText(index): partial(tabs.setCurrentIndex, index) for index in range(tabs.count())
    }
    states["minimised"] = window.showMinimized
    states["hidden"] = window.hide
    found = {}
    for name, enter in states.items():
        enter()
        _run_loop(_SETTLE)
        began, used = time.monotonic(), time.process_time()
        _run_loop(seconds)
        found[name] = 100 * (time.process_time() - used) / (time.monotonic() - began)
    return found


def _gaps(program: Program, seconds: float) -> dict[str, float]:
    """Return the longest gaps in the event loop, in ms, with all pages in turn.

    `worked` is the longest gap in processor time of this thread, without other processes.
    """
    tabs = program.window.pages

    def show_next() -> None:
        tabs.setCurrentIndex((tabs.currentIndex() + 1) % tabs.count())

    return _longest([show_next] * round(seconds / _TURN))


def _dialogs(program: Program, seconds: float) -> dict[str, float]:
    """Return the longest gap while dialogs open, two at a time."""
    del seconds
    window = program.window
    trex(program).device.parameters.edit("serial_timeout", 9)

    def open_two(first: str, second: str) -> None:
        actions = window.findChildren(QAction)
        one, other = (
            next(each for each in actions if each.objectName() == f"{key}Action")
            for key in (first, second)
        )
        one.trigger()
        QTimer.singleShot(_TICK_MS, other.trigger)

    return _longest([partial(open_two, *each) for each in _DIALOGS])


def _longest(steps: Sequence[Callable[[], object]]) -> dict[str, float]:
    turns = [(time.monotonic(), time.thread_time())]
    longest, worked = 0.0, 0.0

    def record_gap() -> None:
        nonlocal longest, worked
        now = time.monotonic(), time.thread_time()
        longest = max(longest, now[0] - turns[0][0] - _TICK_MS / 1000)
        worked = max(worked, now[1] - turns[0][1])
        turns[0] = now

    timer = QTimer()
    timer.setTimerType(Qt.TimerType.PreciseTimer)
    timer.timeout.connect(record_gap)
    timer.start(_TICK_MS)
    for step in steps:
        step()
        _run_loop(_TURN)
    return {"longest": 1000 * longest, "worked": 1000 * worked}


def _memory(program: Program, seconds: float) -> dict[str, float]:
    """Return the resident MiB at the start and after some seconds, and the growth afterwards.

    The telemetry of an hour is a few seconds of a real connection, replayed.
    """
    device = trex(program).device
    batches: list[Batch] = []
    traffic = device.connection.traffic
    begin = _resident()
    traffic.clear()
    device.sampled.connect(batches.append)
    _run_loop(_RECORDED)
    device.sampled.disconnect(batches.append)
    device.disconnect_line()
    _run_loop(1.0)
    heard = [
        TrafficEvent(row.time, direction, data)
        for row in traffic.everything.rows
        for direction, data in ((_SENT, row.sent), (_RECEIVED, row.received))
        if data
    ]

    def replay(first: int, last: int) -> float:
        for turn in range(first, last):
            later = turn * _RECORDED
            for batch in batches:
                samples = tuple(replace(one, time=one.time + later) for one in batch.samples)
                device.connection.sampled.emit(replace(batch, samples=samples))
            for event in heard:
                device.connection.log.record(replace(event, time=event.time + later))
            traffic.pull()
            QCoreApplication.processEvents()
        return _resident()

    turns = round(seconds / _RECORDED)
    quarter = turns // 4
    found = {"start": begin, "end": replay(1, turns)}
    full = replay(turns, turns + quarter)  # the plot is, and drops its first samples
    return {**found, "growth": replay(turns + quarter, turns + 2 * quarter) - full}


def _resident() -> float:
    pages = int(Path("/proc/self/statm").read_text(encoding="ascii").split()[1])
    return pages * os.sysconf("SC_PAGE_SIZE") / 2**20


def main(what: str, url: str, seconds: float) -> None:
    app = QApplication([])
    QCoreApplication.setOrganizationName("TReX Studio benchmark")
    QSettings().clear()
    theme().install(app)
    program = _connected(url, GuiThreadCollector(app))
    supervisor = SafetySupervisor(program, app)
    found = {"load": _cpu, "gaps": _gaps, "dialogs": _dialogs, "memory": _memory}[what](
        program, seconds
    )
    sys.stdout.write(json.dumps(found) + "\n")
    sys.stdout.flush()
    program.window.hide()
    program.shut_down()
    supervisor.close()
    os._exit(0)  # Qt may crash on what is left at the interpreter's end


if __name__ == "__main__":
    main(sys.argv[1], sys.argv[2], float(sys.argv[3]))
