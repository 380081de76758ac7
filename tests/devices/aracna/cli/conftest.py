"""trexcmd against a simulated robot whose bytes take no time, in virtual time."""

import pytest

from tests.support.simulator import SimulatedDevice
from tests.support.virtual_command import RunCommand, StartCommand, VirtualCommand
from tests.support.virtual_time import VirtualRuntime


@pytest.fixture
def start(virtual_time: VirtualRuntime, robot: SimulatedDevice) -> StartCommand:
    """Start `trexcmd` on the robot's port."""
    return lambda *words: VirtualCommand(virtual_time, words, {"TREX_PORT": robot.url})


@pytest.fixture
def trexcmd(start: StartCommand) -> RunCommand:
    """Run `trexcmd` to its end; it ends well where a test does not say otherwise."""
    return lambda *words, exits=0: start(*words).ends(exits)
