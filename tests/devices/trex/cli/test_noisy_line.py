"""Commands on a noisy line without CRC: one byte in a hundred is corrupted."""

from pathlib import Path
from typing import Any

import pytest

from tests.support.matrix import sampled
from tests.support.simulator import StartSimulator
from tests.support.virtual_command import StartCommand
from trex_gui.devices.trex.settings.history import SettingsHistory
from trex_gui.devices.trex.settings.reader import read_settings

_NOISE = 0.01  # probability that a byte is corrupted, in either direction
_STORED = {"required_channels": 1, "motor1_current_limit": 20, "motor2_acceleration": 5}
"""Parameters of the board that differ from the defaults."""


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
    start: StartCommand, start_simulator: StartSimulator, tmp_path: Path, seed: int
) -> None:
    simulator = start_simulator("--seed", str(seed))
    start("calibration", "set", "2", "2400", "3700", "5100", "60", url=simulator.url).ends(0)
    for key, value in _STORED.items():
        start("set", key, str(value), url=simulator.url).ends(0)
    earlier = {found.path for found in SettingsHistory().snapshots()}
    before = simulator.show()
    simulator.do(f"line noise {_NOISE}")

    values = {"serial_timeout": 15, "motor1_acceleration": 3, "motor2_acceleration": 3}
    calibration = {"minimum": 2450, "neutral": 3720, "maximum": 5040, "deadband": 70}
    fields = ", ".join(f"{name}: {value}" for name, value in calibration.items())
    lines = [f"{key}: {value}" for key, value in values.items()]
    path = tmp_path / "new.txt"
    path.write_text("\n".join(["product: TReX", *lines, f"rc_channel_1: {{{fields}}}", ""]))
    is_successful = start("set-settings", str(path), url=simulator.url).wait() == 0
    after = simulator.show()
    if is_successful:
        assert after["parameters"] == {**before["parameters"], **values}
        calibrations = {**before["calibrations"], "rc_channel_1": calibration}
        assert after["calibrations"] == calibrations
    for snapshot in SettingsHistory().snapshots():
        if snapshot.path not in earlier:
            assert_stored(snapshot.path, before)
