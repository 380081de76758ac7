"""A blocked write does not delay the exit, and a killed program leaves no partial file."""

import os
import random
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest

from tests.support.kill_saves import KINDS, Saver, attack
from tests.support.matrix import sampled

pytestmark = pytest.mark.realtime

ROOT = Path(__file__).parents[2]

_SCRIPT = """
import os
import sys
import threading
from functools import partial
from pathlib import Path
import numpy as np
from PySide6.QtCore import QTimer
from trex_gui import app, composition
from tests.support.program import trex
from trex_gui.devices.trex.model.telemetry import Series, board_traces
from trex_gui.ui.plotting.history import SampleHistory
from trex_gui.ui.plotting.traces import Traces

build, panels, path = composition.build, [], Path(sys.argv[2])
os.fsync = lambda handle: threading.Event().wait()  # a disk that does not respond

def table(program):
    from trex_gui.ui.plotting.panel import TracePanel
    history, times = SampleHistory(len(Series)), np.arange(1000) / 80
    history.extend(times, [times] * len(Series))
    panels.append(panel := TracePanel())
    panel.set_source(Traces(board_traces(), history))
    panel.export.save_table(path, -np.inf, np.inf)

def transcript(program):
    from trex_gui.ui.files import write_in_background
    device = trex(program).device
    traffic = device.connection.traffic
    write = partial(traffic.write, rows=traffic.everything.rows)
    write_in_background(program.window, path, write, device.notifier, str)

def build_and_write(*_):
    program = build()
    def run():
        globals()[sys.argv[1]](program)
        QTimer.singleShot(300, program.window.close)
    QTimer.singleShot(300, run)
    return program

composition.build = build_and_write
code = app.main([])
sys.stdout.write("returned")
sys.exit(code)
"""


@pytest.mark.parametrize("content", sampled(["table", "transcript"], every=2))
def test_program_exits_while_a_file_write_blocks(content: str, tmp_path: Path) -> None:
    result = subprocess.run(
        [sys.executable, "-c", _SCRIPT, content, str(tmp_path / "a.txt")],
        cwd=ROOT,
        env={**os.environ, "XDG_CONFIG_HOME": str(tmp_path), "TREX_STUDIO_DATA": str(tmp_path)},
        capture_output=True,
        text=True,
        timeout=45,
        check=False,
    )
    assert result.returncode == 0, result.stderr
    assert result.stdout == "", "a returning interpreter would destroy a running thread"
    assert "Destroyed while" not in result.stderr


KILLS = 8


@pytest.fixture(scope="module")
def saver() -> Iterator[Saver]:
    with Saver() as saver:
        yield saver


@pytest.mark.skipif(sys.platform == "win32", reason="the program that saves forks")
@pytest.mark.parametrize("kind", KINDS)
def test_killed_save_leaves_the_old_or_the_new_file(
    saver: Saver, kind: str, tmp_path: Path
) -> None:
    assert attack(saver, kind, tmp_path, KILLS, random.Random(kind)) == []
