"""Fixtures for tests of discovery and sessions."""

import pytest

from trex_gui.devices.trex.simulator.motors import SerialControl


@pytest.fixture
def motor_commands(monkeypatch: pytest.MonkeyPatch) -> list[str]:
    """Every command to a motor of any simulated board, including stops."""
    given: list[str] = []

    def drive(_control: SerialControl, *words: object, **more: object) -> None:
        given.append(f"motor {words} {more}")

    def drive_aux(_control: SerialControl, *words: object, **more: object) -> None:
        given.append(f"auxiliary {words} {more}")

    monkeypatch.setattr(SerialControl, "drive", drive)
    monkeypatch.setattr(SerialControl, "drive_aux", drive_aux)
    return given
