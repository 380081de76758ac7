import pytest

from tests.support.aracna import AracnaHarness
from tests.support.simulator import SimulatedDevice, StartSimulator


@pytest.fixture
def harness() -> AracnaHarness:
    return AracnaHarness()


@pytest.fixture
def robot(start_simulator: StartSimulator) -> SimulatedDevice:
    return start_simulator("--aracna", "--unpaced")
