"""A computer that lets any process stand still for seconds, and a program that bears it.

The program is quick to notice a window that hangs and a board that is silent: within a second,
which `tests/link` shows in virtual time. Where the processor is taken away from a test, or from its
simulator, for as long, it notices what nobody means to show.
"""

from types import ModuleType

import pytest

from trex_gui.link import guard, motors, presence, reading
from trex_gui.model import bench
from trex_gui.system import sleep_delay

LONG_PATIENCE: tuple[tuple[ModuleType, str, float], ...] = (
    (guard, "PATIENCE", 60.0),  # of armed motors with a window that says nothing, seconds
    (presence, "_FAILURES_TO_SILENCE", 24),  # questions: some three seconds
    (reading, "ATTEMPTS", 24),
    (motors, "ATTEMPTS", 40),
    (motors, "PROOF_PATIENCE", 15.0),  # s
    (bench, "_LONGEST_SILENCE", 30.0),  # s
    (sleep_delay, "_PATIENCE_MS", 15_000),
)
"""Module, name and value of what the program waits for, longer than it does by itself."""


def be_patient() -> None:
    """Wait for so long in this process, until it ends."""
    for module, name, value in LONG_PATIENCE:
        setattr(module, name, value)


@pytest.fixture
def usual_patience() -> None:
    """Wait no longer for window and board than the program does by itself."""


@pytest.fixture(autouse=True)
def long_patience(request: pytest.FixtureRequest, monkeypatch: pytest.MonkeyPatch) -> None:
    """Wait as long as `LONG_PATIENCE` says, in every test of a folder whose conftest has this."""
    if "usual_patience" not in request.fixturenames:
        for module, name, value in LONG_PATIENCE:
            monkeypatch.setattr(module, name, value)
