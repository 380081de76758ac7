"""All cases of the fault matrix with a real port. See `faults.py`."""

import sys
from collections.abc import Iterator
from pathlib import Path

import pytest

from tests.fault_matrix.cases import CASES, name_of
from tests.fault_matrix.check import run_case
from tests.soak.load_monitor import LoadMonitor
from tests.support.simulator import StartSimulator
from tests.support.window import WindowDriver

pytestmark = [
    pytest.mark.realtime,
    pytest.mark.timeout(100),
    pytest.mark.skipif(sys.platform == "win32", reason="needs pseudo-terminals"),
]


@pytest.fixture
def monitor() -> Iterator[LoadMonitor]:
    monitor = LoadMonitor()
    yield monitor
    monitor.end()


@pytest.mark.parametrize(("fault", "moment"), CASES, ids=[name_of(*case) for case in CASES])
def test_real_fault_is_handled_safely(
    fault: str,
    moment: str,
    window: WindowDriver,
    start_simulator: StartSimulator,
    tmp_path: Path,
    monitor: LoadMonitor,
) -> None:
    run_case(fault, moment, window, start_simulator, tmp_path, pauses=monitor.pauses)
