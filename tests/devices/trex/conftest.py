"""Fixtures for tests of discovery and sessions."""

import pytest

from trex_gui.devices.trex.simulator.motors import SerialControl


@pytest.fixture
def motor_commands(monkeypatch: pytest.MonkeyPatch) -> list[str]:
    """Record the motor commands that any simulated board executes, including stops."""
    commands: list[str] = []

    def drive(_control: SerialControl, *arguments: object, **options: object) -> None:
        commands.append(f"motor {arguments} {options}")

    def drive_aux(_control: SerialControl, *arguments: object, **options: object) -> None:
        commands.append(f"auxiliary {arguments} {options}")

    monkeypatch.setattr(SerialControl, "drive", drive)
    monkeypatch.setattr(SerialControl, "drive_aux", drive_aux)
    return commands
