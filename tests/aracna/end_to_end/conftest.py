"""A window asks no more of the robot's answers than a robot can do; a busy computer needs more."""

import pytest

from trex_gui.aracna.link import client, servos

_PATIENCE = 3.0
"""Seconds that other tests and the host of this computer may hold the simulated robot up."""


@pytest.fixture(autouse=True)
def _patient(monkeypatch: pytest.MonkeyPatch) -> None:
    """Call no answer to speeds or to a motion late that only comes from a busy computer."""
    monkeypatch.setattr(client, "ANSWER", _PATIENCE)
    monkeypatch.setattr(servos, "ALLOWANCE", _PATIENCE)
