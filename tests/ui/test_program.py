"""The program as a whole: what is left of it once it is closed."""

import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import pytest
import shiboken6
from PySide6.QtCore import QObject
from pytestqt.qtbot import QtBot

from tests.support.program import trex
from tests.support.simulator import SimulatedDevice
from trex_gui.composition import build
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.ui.devices.connection import ConnectionState

_EMBEDDING = """
from PySide6.QtWidgets import QApplication
from tests.support.program import trex
from trex_gui.composition import build
app = QApplication([])
program = build()
program.window.show()
program.connect_to_demo("trex")
while trex(program).device.telemetry.raw is None:
    app.processEvents()
assert program.close()
"""


def _objects() -> set[QObject]:
    return {one for one in shiboken6.getAllValidWrappers() if isinstance(one, QObject)}


def test_close_leaves_no_qt_object(
    qtbot: QtBot, quick_simulator: SimulatedDevice, tmp_path: Path
) -> None:
    before = _objects()
    program = build()
    program.window.show()
    settings = tmp_path / "rover.txt"
    settings.write_text("product: TReX\n", encoding="utf-8")
    program.open_named(settings, connecting=False)
    device = trex(program).device
    device.connect_to(ConnectionSettings(quick_simulator.url))
    qtbot.waitUntil(lambda: device.link is ConnectionState.CONNECTED)
    assert program.close()
    assert _objects() - before == set()


@pytest.mark.realtime
@pytest.mark.timeout(180)
def test_embedding_processes_end_without_crash() -> None:
    """Without `close` one of six crashes."""

    def embed(_: int) -> subprocess.CompletedProcess[str]:
        command = [sys.executable, "-c", _EMBEDDING]
        return subprocess.run(command, capture_output=True, text=True, timeout=80, check=False)

    with ThreadPoolExecutor(2) as pool:
        results = list(pool.map(embed, range(4)))
    assert [result.returncode for result in results] == [0] * 4, results
    assert not any("Traceback" in result.stderr for result in results), results
