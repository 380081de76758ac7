"""Commands, imported modules and completion of trexcmd."""

import logging
import subprocess
import sys

import pytest
from click.testing import CliRunner

from trex_gui.cli import main
from trex_gui.cli.program import COMMANDS

_SCRIPT = """
import sys
from click.testing import CliRunner
from trex_gui.cli import main
for lines in {groups!r}:
    for arguments in lines:
        assert CliRunner().invoke(main, arguments).exit_code == 0
    print(*sys.modules)
"""


def imported_by(*groups: list[list[str]]) -> list[set[str]]:
    """Return the modules that a fresh interpreter imports for each group of command lines."""
    code = _SCRIPT.format(groups=groups)
    output = subprocess.check_output([sys.executable, "-c", code], text=True)
    return [set(line.split()) for line in output.splitlines()]


def test_help_imports_only_needed_modules() -> None:
    program_modules, all_modules = imported_by(
        [["--help"]], [[command, "--help"] for command in COMMANDS]
    )
    device_modules = {"serial", "trex_gui.core.transport", "trex_gui.devices.trex.protocol"}
    assert not program_modules & device_modules
    commands = {name for name in program_modules if name.startswith("trex_gui.cli.")}
    assert commands <= {"trex_gui.cli.program"}
    assert not {name for name in all_modules if name.startswith(("PySide6", "pyqtgraph", "numpy"))}


def test_command_table_matches_each_command() -> None:
    text = CliRunner().invoke(main, ["--help"]).stdout
    context = main.make_context("trexcmd", ["--help"], resilient_parsing=True)
    for command, info in COMMANDS.items():
        loaded = main.get_command(context, command)
        assert loaded is not None
        assert loaded.name == command
        assert loaded.help
        assert f"  {command} " in text
        assert info.help.replace("\n", " ") in " ".join(text.split())


def test_misspelled_command_gets_a_suggestion() -> None:
    result = CliRunner().invoke(main, ["get-setings"])
    assert result.exit_code == 2
    assert "Did you mean" in result.stderr
    assert "'get-settings'" in result.stderr


@pytest.mark.parametrize(("options", "is_verbose"), [([], False), (["--verbose"], True)])
def test_verbose_option_prints_the_log(
    options: list[str], is_verbose: bool, capsys: pytest.CaptureFixture[str]
) -> None:
    log = logging.getLogger("trex_gui.tests")
    with main.make_context("trexcmd", [*options, "list"]):
        log.debug("opened")
    log.debug("closed")
    printed = capsys.readouterr().err
    assert ("DEBUG trex_gui.tests: opened\n" in printed) is is_verbose
    assert "closed" not in printed


@pytest.mark.parametrize(
    ("words", "completion"),
    [
        ("get-s", "get-settings"),
        ("get serial_", "serial_timeout"),
        ("set motor1_a", "motor1_acceleration"),
        ("status --par", "--parity"),
        ("calibration s", "set"),
        ("completion z", "zsh"),
    ],
)
def test_completion_offers_commands_options_and_parameters(words: str, completion: str) -> None:
    line = f"trexcmd {words}"
    environment = {
        "_TREXCMD_COMPLETE": "bash_complete",
        "COMP_WORDS": line,
        "COMP_CWORD": str(len(line.split()) - 1),
    }
    result = CliRunner().invoke(main, [], prog_name="trexcmd", env=environment)
    assert f"plain,{completion}" in result.stdout.splitlines()


def test_completion_script_is_printed_for_each_known_shell() -> None:
    for shell in ("bash", "zsh", "fish"):
        result = CliRunner().invoke(main, ["completion", shell])
        assert result.exit_code == 0
        assert f"_TREXCMD_COMPLETE={shell}_complete" in result.stdout
    assert CliRunner().invoke(main, ["completion", "tcsh"]).exit_code == 2
