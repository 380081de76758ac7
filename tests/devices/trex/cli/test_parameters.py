"""restore-defaults."""

from tests.support.simulator import SimulatedDevice
from tests.support.virtual_command import RunCommand


def test_defaults_are_restored_at_next_power_up(
    trexcmd: RunCommand, quick_simulator: SimulatedDevice
) -> None:
    trexcmd("set", "serial_timeout", "15")
    trexcmd("calibration", "set", "1", "2400", "3700", "5100", "60")
    result = trexcmd("restore-defaults", "--yes")
    assert "Switch it off and on" in result.stderr
    assert "19200 baud" in result.stderr
    quick_simulator.do("power cycle")
    assert quick_simulator.show()["parameters"]["serial_timeout"] == 0
    assert "2400 3700 5100 60" in trexcmd("calibration", "get").stdout


def test_restore_defaults_requires_confirmation(
    trexcmd: RunCommand, quick_simulator: SimulatedDevice
) -> None:
    trexcmd("set", "serial_timeout", "15")
    for answer in ("n\n", ""):
        trexcmd("restore-defaults", stdin=answer, exits=1)
    quick_simulator.do("power cycle")
    assert quick_simulator.show()["parameters"]["serial_timeout"] == 15
    trexcmd("restore-defaults", stdin="y\n")


def test_restore_defaults_requires_serial_mode(
    trexcmd: RunCommand, quick_simulator: SimulatedDevice
) -> None:
    quick_simulator.do("jumper mode rc", "power cycle")
    assert "not in serial mode" in trexcmd("restore-defaults", "--yes", exits=1).stderr
