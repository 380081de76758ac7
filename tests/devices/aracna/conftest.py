import pytest

from tests.support.aracna import AracnaStage
from tests.support.simulator import SimulatedDevice, StartSimulator


@pytest.fixture
def stage() -> AracnaStage:
    return AracnaStage()


@pytest.fixture
def robot(start_simulator: StartSimulator) -> SimulatedDevice:
    return start_simulator("--aracna", "--unpaced")
