"""Seconds from the start to a painted window, and to a window with a live board.

The reference is an empty window with one plot, the minimum for a program with these libraries. Both
windows start alternately, with compiled bytecode. Their processor times are compared because other
processes affect these least.
"""

import os
import subprocess
import sys
from pathlib import Path

from tests.benchmarks.conftest import ReportFigure

_BARE = """
import time
start, used = time.perf_counter(), time.process_time()
from PySide6.QtWidgets import QApplication, QMainWindow
from pyqtgraph import PlotWidget
app = QApplication([])
window = QMainWindow()
plot = PlotWidget()
plot.plot([0, 1, 2], [0, 1, 0])
window.setCentralWidget(plot)
window.resize(1100, 760)
window.show()
app.processEvents()
print(time.perf_counter() - start, time.process_time() - used)
"""

_PROBE = """
import time
start, used = time.perf_counter(), time.process_time()
from PySide6.QtWidgets import QApplication
from trex_gui.ui.theme.theme import theme
from trex_gui.ui.workers.threads import GuiThreadCollector
from trex_gui.composition import build
app = QApplication([])
QApplication.setOrganizationName("TReX Studio benchmark")
theme().install(app)
collector = GuiThreadCollector(app)
program = build()
program.window.show()
app.processEvents()
shown, used = time.perf_counter(), time.process_time() - used
program.complete()
program.connect_to_demo("trex")
device = program.device_manager.current.device
while device.telemetry.raw is None:
    app.processEvents()
live = time.perf_counter()
assert program.close()
print(shown - start, used, live - start)
"""

_RUNS = 8  # of each window, after one run that writes the bytecode


def _run(script: str, bytecode: Path) -> tuple[float, ...]:
    environment = {
        **os.environ,
        "QT_QPA_PLATFORM": "offscreen",
        "PYTHONDONTWRITEBYTECODE": "",
        "PYTHONPYCACHEPREFIX": str(bytecode),
    }
    command = [sys.executable, "-c", script]
    result = subprocess.run(command, env=environment, capture_output=True, text=True, check=True)
    return tuple(float(word) for word in result.stdout.split())


def test_start_to_window_and_to_live_board_is_measured(
    tmp_path: Path, figure: ReportFigure
) -> None:
    _run(_BARE, tmp_path)
    _run(_PROBE, tmp_path)
    runs = [(*_run(_BARE, tmp_path), *_run(_PROBE, tmp_path)) for _ in range(_RUNS)]
    bare, bare_used, window, used, live = (min(times) for times in zip(*runs, strict=True))
    figure("start to bare window with a plot", bare, "s")
    figure("start to window", window, "s")
    figure("processor time of window and bare window", used / bare_used, "ratio", at_most=1.2)
    figure("start to live simulated board", live, "s")
