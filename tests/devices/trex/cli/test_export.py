"""export: settings as program code."""

from pathlib import Path

import pytest

from tests.support.simulator import SimulatedDevice
from tests.support.virtual_command import RunCommand
from trex_gui.core.code import Language


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
