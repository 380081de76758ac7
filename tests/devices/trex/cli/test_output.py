"""Exported code, reports, and output that cannot be written."""

import json
import zipfile
from pathlib import Path

import pytest
from click import ClickException

from tests.support.simulator import SimulatedDevice
from tests.support.virtual_command import RunCommand
from trex_gui.core.code import Language
from trex_gui.core.command_io import _Output


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


def test_report_without_a_board_contains_the_reason(
    trexcmd: RunCommand, quick_simulator: SimulatedDevice
) -> None:
    quick_simulator.do("power off")
    result = trexcmd("report", "-")
    assert "==> status.txt <==\nThe board could not be read: No TReX responds" in result.stdout
    assert "get signature → no reply" in result.stdout
    assert "status.txt" not in trexcmd("report", "-", TREX_PORT="").stdout


def test_reply_that_cannot_be_printed_stops_the_motors(
    trexcmd: RunCommand, quick_simulator: SimulatedDevice, monkeypatch: pytest.MonkeyPatch
) -> None:
    call = _Output._call

    def fail_on_data(self: _Output, function: object, *text: str) -> None:
        if self._is_data and text:
            raise ClickException("Standard output cannot be written: it is full.")
        call(self, function, *text)

    monkeypatch.setattr(_Output, "_call", fail_on_data)
    result = trexcmd("raw", "--motors", "C2 20", "81", exits=1)
    assert "Error: Standard output cannot be written: it is full." in result.stderr
    assert "Internal error" not in result.stderr
    assert quick_simulator.show()["motors"][0]["target_direction"] == "brake"


def test_too_long_name_of_data_folder_is_reported(trexcmd: RunCommand, tmp_path: Path) -> None:
    folder = tmp_path / ("a" * 300)
    result = trexcmd("set", "serial_timeout", "7", TREX_STUDIO_DATA=str(folder), exits=1)
    assert "File name too long" in result.stderr
    assert isinstance(result.exception, SystemExit)


@pytest.mark.parametrize(
    "words", [("diff", "a", "loop"), ("check-settings", "a", "loop"), ("report", "loop")]
)
def test_loop_of_symbolic_links_is_reported(
    trexcmd: RunCommand, tmp_path: Path, words: tuple[str, ...], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    Path("loop").symlink_to("loop")
    Path("a").write_text("product: TReX\n")
    result = trexcmd(*words, exits=2 if words[0] == "diff" else 1)
    assert "loop: it cannot be" in result.stderr
    assert "Too many levels of symbolic links" in result.stderr
