"""Commands on a noisy line without CRC: one byte in a hundred is corrupted."""

from pathlib import Path
from typing import Any

import pytest

from tests.support.matrix import sampled
from tests.support.simulator import SimulatedDevice, StartSimulator
from tests.support.virtual_command import VirtualCommand
from tests.support.virtual_time import VirtualRuntime
from trex_gui.devices.trex.settings.history import SettingsHistory
from trex_gui.devices.trex.settings.reader import read_settings

_NOISE = 0.01  # probability that a byte is corrupted, in either direction
_STORED = {"required_channels": 1, "motor1_current_limit": 20, "motor2_acceleration": 5}
"""Parameters of the board that differ from the defaults."""


class NoisyBoard:
    """Simulated board on a noisy line."""

    def __init__(self, runtime: VirtualRuntime, simulator: SimulatedDevice) -> None:
        self._runtime = runtime
        self.simulator = simulator
        self.command("calibration", "set", "2", "2400", "3700", "5100", "60").ends(0)
        for key, value in _STORED.items():
            self.command("set", key, str(value)).ends(0)
        self.earlier = {found.path for found in SettingsHistory().snapshots()}
        self.before = simulator.show()
        simulator.do(f"line noise {_NOISE}")

    def command(self, *words: str) -> VirtualCommand:
        return VirtualCommand(self._runtime, words, {"TREX_PORT": self.simulator.url})

    @property
    def snapshots(self) -> list[Path]:
        """Return the snapshots since the line became noisy."""
        return [
            found.path for found in SettingsHistory().snapshots() if found.path not in self.earlier
        ]


@pytest.fixture
def board(seed: int, virtual_time: VirtualRuntime, start_simulator: StartSimulator) -> NoisyBoard:
    return NoisyBoard(virtual_time, start_simulator("--seed", str(seed)))


def assert_stored(path: Path, state: dict[str, Any]) -> None:
    """Check that the board stores every value of a settings file."""
    settings, *_ = read_settings(path.read_bytes(), str(path))
    stored = state["parameters"]
    assert dict(settings.parameters) == {key: stored[key] for key in settings.parameters}
    for key, calibration in settings.calibrations.items():
        source, channel = key.source.value.lower(), key.channel
        fields = state["calibrations"][f"{source}_channel_{channel}"]
        assert [getattr(calibration, name) for name in fields] == list(fields.values()), key


@pytest.mark.parametrize("seed", sampled(range(100), every=25))
def test_settings_and_snapshots_are_correct_despite_noise(
    board: NoisyBoard, tmp_path: Path
) -> None:
    values = {"serial_timeout": 15, "motor1_acceleration": 3, "motor2_acceleration": 3}
    calibration = {"minimum": 2450, "neutral": 3720, "maximum": 5040, "deadband": 70}
    fields = ", ".join(f"{name}: {value}" for name, value in calibration.items())
    lines = [f"{key}: {value}" for key, value in values.items()]
    path = tmp_path / "new.txt"
    path.write_text("\n".join(["product: TReX", *lines, f"rc_channel_1: {{{fields}}}", ""]))
    command = board.command("set-settings", str(path))
    command.wait()
    after = board.simulator.show()
    if command.returncode == 0:
        assert after["parameters"] == {**board.before["parameters"], **values}
        calibrations = {**board.before["calibrations"], "rc_channel_1": calibration}
        assert after["calibrations"] == calibrations
    for snapshot in board.snapshots:
        assert_stored(snapshot, board.before)
