"""export: settings as program code; and the snapshots that changes take."""

from pathlib import Path

import pytest

from tests.support.simulator import SimulatedDevice
from tests.support.virtual_command import RunCommand
from trex_gui.core.code import Language
from trex_gui.devices.trex.settings.history import SettingsHistory


@pytest.mark.parametrize("language", list(Language))
def test_board_is_exported_in_each_language(
    trexcmd: RunCommand, quick_simulator: SimulatedDevice, tmp_path: Path, language: Language
) -> None:
    trexcmd("set", "serial_timeout", "5")
    path = tmp_path / f"board{language.suffix}"
    trexcmd("export", "--as", language.value, str(path))
    text = path.read_text(encoding="utf-8")
    assert "Serial Timeout" in text
    assert "0.5 s" in text
    assert trexcmd("export", "--as", language.value, "-").stdout == text
    motor = quick_simulator.show()["motors"][0]
    assert motor["target_speed"] == 0 or motor["target_direction"] == "brake"


def test_export_to_unwritable_path_fails(trexcmd: RunCommand, tmp_path: Path) -> None:
    result = trexcmd("export", "--as", "c", str(tmp_path / "missing" / "board.c"), exits=1)
    assert "missing" in result.stderr


def test_set_settings_takes_snapshot_before_writing(trexcmd: RunCommand, tmp_path: Path) -> None:
    path = tmp_path / "wish.txt"
    path.write_text("product: TReX\nserial_timeout: 7\n", encoding="utf-8")
    trexcmd("set-settings", "--dry-run", str(path))
    assert not SettingsHistory().snapshots()
    result = trexcmd("set-settings", str(path))
    (snapshot,) = SettingsHistory().snapshots()
    assert str(snapshot.path) in result.stderr
    assert SettingsHistory().load(snapshot).parameters["serial_timeout"] == 0
    trexcmd("set-settings", str(snapshot.path))
    assert trexcmd("get", "serial_timeout").stdout.startswith("0\t")


def test_set_settings_without_changes_takes_no_snapshot(
    trexcmd: RunCommand, tmp_path: Path
) -> None:
    path = tmp_path / "wish.txt"
    path.write_text("product: TReX\nserial_timeout: 0\n", encoding="utf-8")
    trexcmd("set-settings", str(path))
    assert not SettingsHistory().snapshots()


def test_restore_defaults_takes_snapshot(trexcmd: RunCommand) -> None:
    trexcmd("set", "serial_timeout", "5")
    trexcmd("restore-defaults", "--yes")
    snapshot, _before_set = SettingsHistory().snapshots()
    assert snapshot.reason == "trexcmd restore-defaults"
    assert SettingsHistory().load(snapshot).parameters["serial_timeout"] == 5


def test_set_settings_writes_nothing_if_snapshot_fails(trexcmd: RunCommand, tmp_path: Path) -> None:
    path = tmp_path / "wish.txt"
    path.write_text("product: TReX\nserial_timeout: 7\n", encoding="utf-8")
    place = tmp_path / "file"
    place.write_text("", encoding="utf-8")
    result = trexcmd("set-settings", str(path), TREX_STUDIO_DATA=str(place), exits=1)
    assert "snapshots cannot be made" in result.stderr
    assert trexcmd("get", "serial_timeout").stdout.startswith("0\t")
