"""Seconds from the command to a window, and to a window that shows a live board."""

import os
import subprocess
import sys

from tests.benchmarks.conftest import ReportFigure

_PROBE = """
import sys, time
begun = time.perf_counter()
from PySide6.QtWidgets import QApplication
from tests.support.program import trex
from trex_gui.ui.theme.theme import theme
from trex_gui.composition import build
app = QApplication([])
QApplication.setOrganizationName("TReX Studio benchmark")
theme().install(app)
program = build()
program.window.show()
app.processEvents()
shown = time.perf_counter()
trex(program).controller.connect_to(program.ports.demo_of("trex"))
while trex(program).device.telemetry.raw is None:
    app.processEvents()
live = time.perf_counter()
assert program.close()
print(shown - begun, live - begun)
"""


def test_time_to_window_and_live_board_is_measured(figure: ReportFigure) -> None:
    environment = {**os.environ, "QT_QPA_PLATFORM": "offscreen"}
    best = min(
        tuple(
            float(word)
            for word in subprocess.run(
                [sys.executable, "-c", _PROBE],
                env=environment,
                capture_output=True,
                text=True,
                check=True,
            ).stdout.split()
        )
        for _ in range(3)
    )
    figure("start to window", best[0], "s")
    figure("start to live simulated board", best[1], "s")
