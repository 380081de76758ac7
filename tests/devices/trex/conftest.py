"""What tests of discovery and of a session have in common."""

import pytest

from trex_gui.devices.trex.simulator.motors import SerialControl


@pytest.fixture
def orders(monkeypatch: pytest.MonkeyPatch) -> list[str]:
    """Every order that a motor of any simulated board is given, a stop included."""
    given: list[str] = []

    def drive(_control: SerialControl, *words: object, **more: object) -> None:
        given.append(f"motor {words} {more}")

    def drive_aux(_control: SerialControl, *words: object, **more: object) -> None:
        given.append(f"auxiliary {words} {more}")

    monkeypatch.setattr(SerialControl, "drive", drive)
    monkeypatch.setattr(SerialControl, "drive_aux", drive_aux)
    return given
