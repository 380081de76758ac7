"""Every command with output that is redirected, in any encoding, and closed."""

from functools import partial
from itertools import product
from pathlib import Path

import pytest
from click import ClickException
from click.testing import CliRunner

from tests.support import virtual_command
from tests.support.matrix import sampled
from tests.support.simulator import SimulatedDevice
from tests.support.virtual_command import RunCommand
from trex_gui.cli.program import COMMANDS
from trex_gui.core.command_io import _Output

WORDS = {
    "stream": ("--limit", "2"),
    "get": ("serial_timeout",),
    "set": ("serial_timeout", "7"),
    "get-settings": ("-",),
    "set-settings": ("µ.txt", "--dry-run"),
    "check-settings": ("µ.txt", "-"),
    "diff": ("µ.txt",),
    "audit": ("µ.txt",),
    "calibration": ("get",),
    "export": ("--as", "c", "-"),
    "restore-defaults": ("--yes",),
    "motor": ("1", "20", "--seconds", "0.2"),
    "raw": ("81",),
    "decode": ("AF 07 0F 55 2A",),
    "report": ("-",),
    "survey": ("survey.toml",),
    "replay": ("µ.log",),
    "aracna": ("query",),
    "completion": ("bash",),
}
ENCODINGS = ("cp1252", "cp437", "cp850", "cp932", "ascii")


@pytest.mark.parametrize(("command", "encoding"), sampled(product(COMMANDS, ENCODINGS), every=3))
def test_redirected_output_is_utf_8(
    trexcmd: RunCommand,
    quick_simulator: SimulatedDevice,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    command: str,
    encoding: str,
) -> None:
    monkeypatch.chdir(tmp_path)
    quick_simulator.do("eeprom motor1_acceleration 9")
    note = "# Note on serial_timeout: 5 → 7 µs …"
    Path("µ.txt").write_text(f"product: TReX\n{note}\nserial_timeout: 7\n", encoding="utf-8")
    if command == "replay":
        assert trexcmd("get", "serial_timeout", "--traffic", "µ.log").exit_code == 0
    words = (command, *WORDS.get(command, ()))
    plain = trexcmd(*words)
    monkeypatch.setattr(virtual_command, "CliRunner", partial(CliRunner, charset=encoding))
    redirected = trexcmd(*words)
    assert redirected.exit_code == plain.exit_code
    assert redirected.exception is None or isinstance(redirected.exception, SystemExit)
    shown = redirected.stdout_bytes.decode("utf-8")
    assert len(shown.splitlines()) >= len(plain.stdout.splitlines()) - 2
    assert redirected.stderr_bytes.decode("utf-8") or not plain.stderr


def test_reply_that_cannot_be_printed_stops_the_motors(
    trexcmd: RunCommand, quick_simulator: SimulatedDevice, monkeypatch: pytest.MonkeyPatch
) -> None:

    real = _Output._use

    def full(self: _Output, function: object, *text: str) -> None:
        if self._is_data and text:
            raise ClickException("Standard output cannot be written: it is full.")
        real(self, function, *text)

    monkeypatch.setattr(_Output, "_use", full)
    result = trexcmd("raw", "--motors", "C2 20", "81")
    assert result.exit_code == 1
    assert "Error: Standard output cannot be written: it is full." in result.stderr
    assert "Internal error" not in result.stderr
    assert quick_simulator.show()["motors"][0]["target_direction"] == "brake"


def test_folder_whose_name_is_too_long_is_named(trexcmd: RunCommand, tmp_path: Path) -> None:
    folder = tmp_path / ("a" * 300)
    result = trexcmd("set", "serial_timeout", "7", TREX_STUDIO_DATA=str(folder))
    assert result.exit_code == 1
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
    result = trexcmd(*words)
    assert "loop: it cannot be" in result.stderr
    assert "Too many levels of symbolic links" in result.stderr
    assert result.exit_code == (2 if words[0] == "diff" else 1)
