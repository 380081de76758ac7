"""Speed of the simulator, unpaced and at the pace of the wire.

The unpaced simulator must not slow down tests. The paced simulator must match the wire within 2 %.
"""

import time
from pathlib import Path

import pytest
import serial

from tests.benchmarks.conftest import ReportFigure, fast_board
from tests.support.simulator import StartSimulator
from trex_gui.devices.trex.protocol.line_settings import LineSettings
from trex_gui.devices.trex.simulator.firmware import Board
from trex_gui.devices.trex.simulator.line import SimulatedBoards

_TRANSACTIONS = 30_000
_MIN_RATE = 20_000
_SECONDS = 10.0
_TOLERANCE = 0.02
_TELEMETRY = [("86 1F", 10), ("87 1F", 5), ("8F", 2), ("84", 1)]
_NULL = b"\xff"


def test_unpaced_simulator_reaches_required_rate(figure: ReportFigure) -> None:
    line = SimulatedBoards([Board()], paced=False)
    requests = [(bytes.fromhex(packet), size) for packet, size in _TELEMETRY]
    start = time.perf_counter()
    for _ in range(_TRANSACTIONS // len(requests)):
        for packet, size in requests:
            line.send(packet)
            assert len(line.read(size, 0)) == size
    rate = _TRANSACTIONS / (time.perf_counter() - start)
    figure("unpaced simulator, in process", rate, "/s", at_least=_MIN_RATE)


@pytest.mark.parametrize("baud", [1200, 19200, 115200])
def test_paced_bytes_take_line_time(
    baud: int, start_simulator: StartSimulator, tmp_path: Path, figure: ReportFigure
) -> None:
    """Null bytes without pauses return as an echo. Each byte is echoed after its stop bit."""
    settings = LineSettings(baud)
    simulator = start_simulator("--echo", *fast_board(tmp_path, baud))
    size = round(_SECONDS / settings.seconds(1))
    chunk = max(1, round(0.01 / settings.seconds(1)))  # as much as the buffer of a port holds
    with serial.Serial(simulator.url, baud, timeout=2) as port:
        start = time.perf_counter()
        sent = received = 0
        while received < size:
            while sent < size and sent - received < 4 * chunk:
                sent += port.write(_NULL * min(chunk, size - sent)) or 0
            received += len(port.read(port.in_waiting or 1))
        duration = time.perf_counter() - start
    ratio = duration / settings.seconds(size)
    figure(
        f"paced bytes at {baud} baud to wire time",
        ratio,
        "ratio",
        at_least=1 - _TOLERANCE,
        at_most=1 + _TOLERANCE,
    )
    assert simulator.show()["counters"]["uart_errors"] == 0


@pytest.mark.parametrize("baud", [1200, 19200, 115200])
def test_paced_transactions_take_at_least_line_time(
    baud: int, start_simulator: StartSimulator, tmp_path: Path, figure: ReportFigure
) -> None:
    """Each request follows the last reply. Two processes need time in addition to the wire."""
    settings = LineSettings(baud)
    simulator = start_simulator(*fast_board(tmp_path, baud))
    requests = [(bytes.fromhex(packet), size) for packet, size in _TELEMETRY]
    wire = count = 0.0
    with serial.Serial(simulator.url, baud, timeout=2) as port:
        start = time.perf_counter()
        while time.perf_counter() < start + _SECONDS:
            for packet, size in requests:
                port.write(packet)
                assert len(port.read(size)) == size
                wire += settings.seconds(len(packet) + size)
                count += 1
        duration = time.perf_counter() - start
    figure(f"paced transactions at {baud} baud", count / duration, "/s")
    figure(f"added to a transaction at {baud} baud", (duration - wire) / count * 1e6, "us")
    assert duration >= wire  # a reply cannot arrive before its last bit
