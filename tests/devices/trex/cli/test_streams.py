"""Output that cannot be written, and files of users that cannot be opened."""

from pathlib import Path

import pytest
from click import ClickException

from tests.support.simulator import SimulatedDevice
from tests.support.virtual_command import RunCommand
from trex_gui.core.command_io import _Output


def test_reply_that_cannot_be_printed_stops_the_motors(
    trexcmd: RunCommand, quick_simulator: SimulatedDevice, monkeypatch: pytest.MonkeyPatch
) -> None:

    real = _Output._use

    def full(self: _Output, function: object, *text: str) -> None:
        if self._is_data and text:
            raise ClickException("Standard output cannot be written: it is full.")
        real(self, function, *text)

    monkeypatch.setattr(_Output, "_use", full)
    result = trexcmd("raw", "--motors", "C2 20", "81", exits=1)
    assert "Error: Standard output cannot be written: it is full." in result.stderr
    assert "Internal error" not in result.stderr
    assert quick_simulator.show()["motors"][0]["target_direction"] == "brake"


def test_folder_whose_name_is_too_long_is_named(trexcmd: RunCommand, tmp_path: Path) -> None:
    folder = tmp_path / ("a" * 300)
    result = trexcmd("set", "serial_timeout", "7", TREX_STUDIO_DATA=str(folder), exits=1)
    assert "File name too long" in result.stderr
    assert isinstance(result.exception, SystemExit)


@pytest.mark.parametrize(
    "words", [("diff", "a", "loop"), ("check-settings", "a", "loop"), ("report", "loop")]
)
def test_loop_of_links_is_named(
    trexcmd: RunCommand, tmp_path: Path, words: tuple[str, ...], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    Path("loop").symlink_to("loop")
    Path("a").write_text("product: TReX\n")
    result = trexcmd(*words, exits=2 if words[0] == "diff" else 1)
    assert "loop: it cannot be" in result.stderr
    assert "Too many levels of symbolic links" in result.stderr
