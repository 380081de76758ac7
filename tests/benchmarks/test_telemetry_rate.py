"""Rate at which each value is read, compared to the possible rate.

The possible rate is that of the schedule in virtual time, in which only the wire takes time.
"""

from pathlib import Path

import pytest
from PySide6.QtCore import Qt
from pytestqt.qtbot import QtBot

from tests.benchmarks.conftest import ReportFigure, fast_board
from tests.support.program import trex
from tests.support.simulator import StartSimulator
from tests.support.virtual import SessionHarness
from trex_gui.devices.trex.client.telemetry import Control, Currents, Raw, Remapped
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.devices.trex.protocol.line_settings import LineSettings
from trex_gui.devices.trex.session.messages import Batch, Report
from trex_gui.devices.trex.simulator.firmware import Board
from trex_gui.devices.trex.simulator.memory import Eeprom
from trex_gui.ui.devices.connection import ConnectionState
from trex_gui.ui.program import Program

_SECONDS = 8.0
_KINDS = {"currents": Currents, "raw": Raw, "remapped": Remapped, "control": Control}


def _count(reports: list[Report]) -> dict[str, int]:
    samples = [s for report in reports if isinstance(report, Batch) for s in report.samples]
    return {name: sum(isinstance(s, kind) for s in samples) for name, kind in _KINDS.items()}


def _possible(settings: ConnectionSettings) -> dict[str, float]:
    """Return the rates that the schedule reaches if only the wire takes time."""
    eeprom = Eeprom()
    eeprom.write("uart_settings", settings.line.to_wire())
    harness = SessionHarness(Board(eeprom=eeprom))
    harness.script.at(_SECONDS, lambda: None)
    harness.run(settings)
    batches = [report for report in harness.reports if isinstance(report, Batch)]
    times = [sample.time for batch in batches for sample in batch.samples]
    span = times[-1] - times[0]
    return {name: count / span for name, count in _count(harness.reports).items()}


@pytest.mark.parametrize("painting", [False, True], ids=["idle", "all pages painting"])
@pytest.mark.parametrize("baud", [9600, 19200, 115200])
def test_samples_of_every_kind_are_read(
    baud: int,
    painting: bool,
    program: Program,
    qtbot: QtBot,
    start_simulator: StartSimulator,
    tmp_path: Path,
    figure: ReportFigure,
) -> None:
    line = LineSettings(baud)
    simulator = start_simulator("--demo", *fast_board(tmp_path, baud))
    settings = ConnectionSettings(simulator.url, line)
    program.complete()
    if painting:
        tabs = program.window.pages
        for page in [tabs.widget(index) for index in range(tabs.count())]:  # all at once
            assert page is not None
            page.setParent(program.window, Qt.WindowType.Window)
            page.resize(1000, 600)
            page.show()
    else:
        program.window.hide()
        trex(program).device.connection.watch("benchmark", True)

    reports: list[Report] = []
    trex(program).device.connect_to(settings)
    qtbot.waitUntil(lambda: trex(program).device.link is ConnectionState.CONNECTED, timeout=20_000)
    trex(program).device.connection.reported.connect(reports.append)
    qtbot.wait(round(_SECONDS * 1000))
    read = {name: count / _SECONDS for name, count in _count(reports).items()}

    possible = _possible(settings)
    state = "painting" if painting else "idle"
    for name, rate in read.items():
        figure(f"{name} read at {baud} baud, {state}", rate, "/s")
        ratio = rate / possible[name]
        figure(f"{name} read at {baud} baud, {state}, relative to ideal host", ratio, "ratio")
    assert all(rate > 0 for rate in read.values())
