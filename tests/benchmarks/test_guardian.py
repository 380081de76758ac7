"""Time from a fault to the stop at the board, with telemetry at full rate.

The simulated board works at the pace of the wire. Polling its motors adds up to 10 ms.
"""

import signal
import sys
import time
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
_DEATH_S, _HANG_S = 0.3, 0.8


def _kill(window: DrivingProcess) -> None:
    window.process.kill()


def _crash(window: DrivingProcess) -> None:
    window.process.send_signal(signal.SIGSEGV)


def _suspend(window: DrivingProcess) -> None:
    window.process.send_signal(signal.SIGSTOP)


def _hang_window(window: DrivingProcess) -> None:
    window.hang("hang")


def _hang_line(window: DrivingProcess) -> None:
    window.hang("hang_the_line")


FAULTS = {
    "killed": (_kill, _DEATH_S),
    "crashed": (_crash, _DEATH_S),
    "suspended": (_suspend, _HANG_S),
    "window hangs": (_hang_window, _HANG_S),
    "line hangs": (_hang_line, _HANG_S),
}


LINES = {
    "19200 baud": (19200, ()),
    "115200 baud": (115200, ()),
    "TCP": (19200, ("--tcp", "127.0.0.1:0")),
    "RFC 2217": (19200, ("--rfc2217", "127.0.0.1:0")),
}


@pytest.mark.timeout(600)
@pytest.mark.parametrize("fault", FAULTS)
@pytest.mark.parametrize("place", LINES)
def test_motors_stop_soon_after_a_fault(
    fault: str, place: str, tmp_path: Path, figure: ReportFigure
) -> None:
    cause, limit = FAULTS[fault]
    baud, options = LINES[place]
    board = fast_board(tmp_path, baud)
    worst = 0.0
    for _ in range(_ROUNDS):
        simulator = SimulatorProcess(*board, *options)
        window = DrivingProcess(simulator, tmp_path, "usual", str(baud))
        try:
            window.drive()
            begun = time.perf_counter()
            cause(window)
            while not is_stopped(simulator):
                assert time.perf_counter() - begun < 10
            worst = max(worst, time.perf_counter() - begun)
        finally:
            window.end()
            simulator.end()
    figure(f"{fault}, {place}: until the stop, worst of {_ROUNDS}", worst, "s", at_most=limit)


@pytest.mark.timeout(600)
def test_two_boards_stop_soon_after_the_death_of_their_program(figure: ReportFigure) -> None:
    worst = 0.0
    for _ in range(4 * _ROUNDS):
        simulator = SimulatorProcess("--device", "7", "--device", "9")
        with running_script(DRIVE_TWO, simulator.url) as program:
            begun = time.perf_counter()
            program.kill()
        moving = ["@7", "@9"]
        while moving:
            moving = [one for one in moving if _turns(simulator, one)]
            assert time.perf_counter() - begun < 10
        worst = max(worst, time.perf_counter() - begun)
        simulator.end()
    name = f"killed, two boards at 19200 baud: until both stop, worst of {4 * _ROUNDS}"
    figure(name, worst, "s", at_most=_DEATH_S)


def _turns(simulator: SimulatorProcess, board: str) -> bool:
    return any(motor["target_direction"] != "brake" for motor in simulator.show(board)["motors"])
