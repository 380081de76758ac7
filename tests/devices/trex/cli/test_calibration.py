"""The commands `calibration get` and `calibration set`."""

import json

import pytest

from tests.support.simulator import SimulatedDevice
from tests.support.virtual_command import RunCommand


def test_calibrations_are_shown_in_counts_and_physical_units(trexcmd: RunCommand) -> None:
    lines = trexcmd("calibration", "get").stdout.splitlines()
    assert lines[0] == "1\t2500 3750 5000 75\t1000 µs / 1500 µs / 2000 µs / 30 µs  (default)"
    assert len(lines) == 5


def test_calibration_get_prints_json(trexcmd: RunCommand) -> None:
    report = json.loads(trexcmd("calibration", "get", "--json").stdout)
    assert report["source"] == "RC"
    first = report["channels"][0]
    assert (first["minimum"], first["deadband"]) == (2500, 75)
    assert (first["pulse_us"]["minimum"], first["pulse_us"]["deadband"]) == (1000.0, 30.0)
    assert not first["differs_from_default"]


@pytest.mark.parametrize(
    "words", [("2400", "3700", "5100", "60"), ("960us", "1480 µs", "2.04ms", "24us")]
)
def test_calibration_is_stored_and_read_back(trexcmd: RunCommand, words: tuple[str, ...]) -> None:
    assert trexcmd("calibration", "set", "2", *words).stdout.startswith("2\t2400 3700 5100 60\t")
    second = json.loads(trexcmd("calibration", "get", "--json").stdout)["channels"][1]
    assert second["differs_from_default"]


def test_analog_channel_is_calibrated_in_volts(
    trexcmd: RunCommand, quick_simulator: SimulatedDevice
) -> None:
    trexcmd("set", "channel_input_source", "1")
    quick_simulator.do("power cycle")
    result = trexcmd("calibration", "set", "1", "0.5V", "2.5V", "4500mV", "100mV")
    assert result.stdout.startswith("1\t102 512 921 20\t")


def test_voltage_is_rejected_for_an_rc_calibration(trexcmd: RunCommand) -> None:
    result = trexcmd("calibration", "set", "1", "1V", "2V", "3V", "1V", exits=1)
    assert "currently measures RC inputs" in result.stderr
