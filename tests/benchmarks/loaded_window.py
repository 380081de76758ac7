"""Cost of the window in a separate process, with a connected board.

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
from trex_gui.app import load_hidden_parts
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
_LAYOUT_S = 2.0  # time to lay out and paint a page before its cost is measured
_STEP_S = 1.0  # time for which each page or pair of dialogs is shown
_TICK_MS = 5
_DIALOGS = (
    ("bench", "history"),
    ("apply", "defaults"),
    ("setup", "learn"),
    ("preferences", "report"),
    ("find", "check_board"),
)
_SENT, _RECEIVED = TrafficDirection.SENT, TrafficDirection.RECEIVED
_RECORDED_S = 4.0  # telemetry that is repeated to fill an hour


def _run_loop(seconds: float) -> None:
    loop = QEventLoop()
    QTimer.singleShot(round(1000 * seconds), loop.quit)
    loop.exec()


def _connected(url: str, collector: GuiThreadCollector) -> Program:
    """Return a started program with a connected board and all modules loaded."""
    program = composition.build()
    program.window.show()
    _run_loop(0.2)
    load_hidden_parts(program, collector)
    device = trex(program).device
    device.connect_to(ConnectionSettings(url, LineSettings(BAUD)))
    while device.link is not ConnectionState.CONNECTED:
        _run_loop(0.05)
    return program


def _cpu(program: Program, seconds: float) -> dict[str, float]:
    """Return the load of all threads, in percent of a core, by page and state of the window."""
    window, tabs = program.window, program.window.pages
    states: dict[str, Callable[[], None]] = {
        tabs.tabText(index): partial(tabs.setCurrentIndex, index) for index in range(tabs.count())
    }
    states["minimised"] = window.showMinimized
    states["hidden"] = window.hide
    load = {}
    for name, set_state in states.items():
        set_state()
        _run_loop(_LAYOUT_S)
        start, used = time.monotonic(), time.process_time()
        _run_loop(seconds)
        load[name] = 100 * (time.process_time() - used) / (time.monotonic() - start)
    return load


def _gaps(program: Program, seconds: float) -> dict[str, float]:
    """Return the longest gap of the event loop in ms while the pages are shown in turn.

    `longest` is measured in real time, `worked` in processor time of this thread.
    """
    tabs = program.window.pages

    def show_next() -> None:
        tabs.setCurrentIndex((tabs.currentIndex() + 1) % tabs.count())

    return _longest_gaps([show_next] * round(seconds / _STEP_S))


def _dialogs(program: Program, seconds: float) -> dict[str, float]:
    """Return the longest gaps in ms while dialogs open, two at a time."""
    del seconds
    window = program.window
    trex(program).device.parameters.edit("serial_timeout", 9)

    def open_two(first: str, second: str) -> None:
        actions = window.findChildren(QAction)
        triggers = {action.objectName(): action.trigger for action in actions}
        triggers[f"{first}Action"]()
        QTimer.singleShot(_TICK_MS, triggers[f"{second}Action"])

    return _longest_gaps([partial(open_two, *names) for names in _DIALOGS])


def _longest_gaps(steps: Sequence[Callable[[], object]]) -> dict[str, float]:
    last = time.monotonic(), time.thread_time()
    longest, worked = 0.0, 0.0

    def record_gap() -> None:
        nonlocal last, longest, worked
        now = time.monotonic(), time.thread_time()
        longest = max(longest, now[0] - last[0] - _TICK_MS / 1000)
        worked = max(worked, now[1] - last[1])
        last = now

    timer = QTimer()
    timer.setTimerType(Qt.TimerType.PreciseTimer)
    timer.timeout.connect(record_gap)
    timer.start(_TICK_MS)
    for step in steps:
        step()
        _run_loop(_STEP_S)
    return {"longest": 1000 * longest, "worked": 1000 * worked}


def _memory(program: Program, seconds: float) -> dict[str, float]:
    """Return the resident memory in MiB at the start and after some seconds, and its later growth.

    The telemetry consists of repeated samples from a few seconds of a real connection.
    """
    device = trex(program).device
    batches: list[Batch] = []
    traffic = device.connection.traffic
    start = _resident()
    traffic.clear()
    device.sampled.connect(batches.append)
    _run_loop(_RECORDED_S)
    device.sampled.disconnect(batches.append)
    device.disconnect_line()
    _run_loop(1.0)
    events = [
        TrafficEvent(row.time, direction, data)
        for row in traffic.everything.rows
        for direction, data in ((_SENT, row.sent), (_RECEIVED, row.received))
        if data
    ]

    def replay(first: int, last: int) -> float:
        for repetition in range(first, last):
            offset = repetition * _RECORDED_S
            for batch in batches:
                samples = tuple(replace(each, time=each.time + offset) for each in batch.samples)
                device.connection.sampled.emit(replace(batch, samples=samples))
            for event in events:
                device.connection.log.record(replace(event, time=event.time + offset))
            traffic.pull()
            QCoreApplication.processEvents()
        return _resident()

    count = round(seconds / _RECORDED_S)
    quarter = count // 4
    end = replay(1, count)
    full = replay(count, count + quarter)  # the plot is full and drops its first samples
    growth = replay(count + quarter, count + 2 * quarter) - full
    return {"start": start, "end": end, "growth": growth}


def _resident() -> float:
    pages = int(Path("/proc/self/statm").read_text(encoding="ascii").split()[1])
    return pages * os.sysconf("SC_PAGE_SIZE") / 2**20


def main(kind: str, url: str, seconds: float) -> None:
    app = QApplication([])
    QCoreApplication.setOrganizationName("TReX Studio benchmark")
    QSettings().clear()
    theme().install(app)
    program = _connected(url, GuiThreadCollector(app))
    supervisor = SafetySupervisor(program, app)
    measure = {"load": _cpu, "gaps": _gaps, "dialogs": _dialogs, "memory": _memory}[kind]
    sys.stdout.write(json.dumps(measure(program, seconds)) + "\n")
    sys.stdout.flush()
    program.window.hide()
    program.shut_down()
    supervisor.close()
    os._exit(0)  # Qt may crash on objects that remain at the end of the interpreter


if __name__ == "__main__":
    main(sys.argv[1], sys.argv[2], float(sys.argv[3]))
