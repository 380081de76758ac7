"""report: a zip of what a board and this program are."""

import json
import zipfile
from pathlib import Path

from tests.support.simulator import SimulatedDevice
from tests.support.virtual_command import RunCommand


def test_report_has_status_settings_and_traffic(
    trexcmd: RunCommand, quick_simulator: SimulatedDevice, tmp_path: Path
) -> None:
    file = tmp_path / "report.zip"
    result = trexcmd("report", str(file))
    assert result.stdout == f"{file}\n"
    with zipfile.ZipFile(file) as archive:
        texts = {name: archive.read(name).decode() for name in archive.namelist()}
    assert {"versions.txt", "ports.txt", "status.txt", "settings.txt"} <= texts.keys()
    assert json.loads(texts["status.txt"])["product"] == "TReX"
    assert "serial_timeout: 0" in texts["settings.txt"]
    assert "get signature → TReX 1.2" in texts["traffic.txt"]
    assert all(name in result.stderr for name in texts)
    trexcmd("report", str(tmp_path), exits=2)
    trexcmd("report", str(tmp_path / "no" / "x.zip"), exits=1)


def test_report_without_a_board_says_why(
    trexcmd: RunCommand, quick_simulator: SimulatedDevice
) -> None:
    quick_simulator.do("power off")
    result = trexcmd("report", "-")
    assert "==> status.txt <==\nThe board could not be read: No TReX responds" in result.stdout
    assert "get signature → no reply" in result.stdout
    assert "status.txt" not in trexcmd("report", "-", TREX_PORT="").stdout
