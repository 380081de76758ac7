"""Every fault at every moment."""

import sys
from pathlib import Path

import pytest

from tests.fault_matrix.cases import CASES, name_of
from tests.fault_matrix.check import run_case, unknown_pauses
from tests.support.matrix import sampled
from tests.support.patient import PATIENT
from tests.support.simulator import StartSimulator
from tests.support.window import WindowDriver
from trex_gui.core.timing import Timeouts

EVERY = 13
"""The gate runs one case of this number, with each fault, and each moment once or twice."""


@pytest.mark.parametrize(
    ("fault", "moment"),
    [
        pytest.param(*case, id=name_of(*case), marks=[pytest.mark.slow] if number % EVERY else [])
        for number, case in enumerate(CASES)
    ],
)
def test_fault_is_handled_safely(
    fault: str, moment: str, window: WindowDriver, start_simulator: StartSimulator, tmp_path: Path
) -> None:
    run_case(fault, moment, window, start_simulator, tmp_path)


@pytest.fixture
def timeouts(request: pytest.FixtureRequest) -> Timeouts:
    """Long timeouts in real time, so that only the fault stops motors."""
    return PATIENT if request.node.get_closest_marker("realtime") else Timeouts()


@pytest.mark.realtime
@pytest.mark.timeout(120)
@pytest.mark.skipif(sys.platform == "win32", reason="needs pseudo-terminals")
@pytest.mark.parametrize(
    ("fault", "moment"), sampled([("unplug", "driving"), ("mute", "closing")], every=2)
)
def test_fault_of_a_real_port_is_handled_safely(
    fault: str, moment: str, window: WindowDriver, start_simulator: StartSimulator, tmp_path: Path
) -> None:
    run_case(fault, moment, window, start_simulator, tmp_path, pauses=unknown_pauses)
