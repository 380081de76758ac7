"""Time from a fault of the program to the stop by the guardian, with telemetry at full rate.

The simulated board works at the pace of the wire. Each look at its motors adds up to 10 ms.
"""

import signal
import sys
import time
from collections.abc import Callable
from pathlib import Path

import pytest

from tests.benchmarks.conftest import ReportFigure, fast_board
from tests.devices.trex.conftest import running_script
from tests.devices.trex.test_library import DRIVE_TWO
from tests.end_to_end.test_every_stop_cause import DrivingProcess
from tests.support.pages.motors import is_stopped
from tests.support.simulator import SimulatorProcess

pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="pseudo-terminals and signals")

_ROUNDS = 5
_DEATH_LIMIT_S = 0.3
_HANG_LIMIT_S = 0.8

FAULTS: dict[str, tuple[Callable[[DrivingProcess], object], float]] = {
    "killed": (lambda window: window.process.kill(), _DEATH_LIMIT_S),
    "crashed": (lambda window: window.process.send_signal(signal.SIGSEGV), _DEATH_LIMIT_S),
    "suspended": (
        lambda window: window.process.send_signal(signal.SIGSTOP),
        _HANG_LIMIT_S,
    ),
    "window hangs": (lambda window: window.hang("hang"), _HANG_LIMIT_S),
    "line hangs": (lambda window: window.hang("hang_the_line"), _HANG_LIMIT_S),
}

LINES = {
    "19200 baud": (19200, ()),
    "115200 baud": (115200, ()),
    "TCP": (19200, ("--tcp", "127.0.0.1:0")),
    "RFC 2217": (19200, ("--rfc2217", "127.0.0.1:0")),
}


@pytest.mark.timeout(600)
@pytest.mark.parametrize("fault", FAULTS)
@pytest.mark.parametrize("line", LINES)
def test_motors_stop_soon_after_a_fault(
    fault: str, line: str, tmp_path: Path, figure: ReportFigure
) -> None:
    inject, limit = FAULTS[fault]
    baud, options = LINES[line]
    board = fast_board(tmp_path, baud)
    worst = 0.0
    for _ in range(_ROUNDS):
        simulator = SimulatorProcess(*board, *options)
        window = DrivingProcess(simulator, tmp_path, "default", str(baud))
        try:
            window.drive()
            start = time.perf_counter()
            inject(window)
            while not is_stopped(simulator):
                assert time.perf_counter() - start < 10
            worst = max(worst, time.perf_counter() - start)
        finally:
            window.end()
            simulator.end()
    figure(f"{fault}, {line}: until the stop, worst of {_ROUNDS}", worst, "s", at_most=limit)


@pytest.mark.timeout(600)
def test_two_boards_stop_soon_after_their_program_is_killed(figure: ReportFigure) -> None:
    worst = 0.0
    for _ in range(4 * _ROUNDS):
        simulator = SimulatorProcess("--device", "7", "--device", "9")
        try:
            with running_script(DRIVE_TWO, simulator.url) as program:
                start = time.perf_counter()
                program.kill()
            while not all(is_stopped(simulator, board) for board in ("@7", "@9")):
                assert time.perf_counter() - start < 10
            worst = max(worst, time.perf_counter() - start)
        finally:
            simulator.end()
    name = f"killed, two boards at 19200 baud: until both stop, worst of {4 * _ROUNDS}"
    figure(name, worst, "s", at_most=_DEATH_LIMIT_S)
