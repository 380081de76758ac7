"""The program trexcmd: commands, imported modules, completion."""

import logging
import subprocess
import sys

import pytest
from click.testing import CliRunner

from trex_gui.cli import main
from trex_gui.cli.program import COMMANDS

_LOADED = """
import sys
from click.testing import CliRunner
from trex_gui.cli import main
for lines in {groups!r}:
    for words in lines:
        assert CliRunner().invoke(main, words).exit_code == 0
    print(*sys.modules)
"""


def loaded_by(*groups: list[list[str]]) -> list[set[str]]:
    """Return the modules that a fresh interpreter imports for each group of command lines."""
    code = _LOADED.format(groups=groups)
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    return [set(line.split()) for line in done.stdout.splitlines()]


def test_help_loads_only_needed_modules() -> None:
    of_program, of_all = loaded_by([["--help"]], [[command, "--help"] for command in COMMANDS])
    link_and_commands = {"serial", "trex_gui.core.transport", "trex_gui.devices.trex.protocol"}
    assert not of_program & link_and_commands
    assert not {name for name in of_program if name.startswith("trex_gui.cli.")} - {
        "trex_gui.cli.program"
    }
    assert not {name for name in of_all if name.startswith(("PySide6", "pyqtgraph", "numpy"))}


def test_command_table_matches_each_command() -> None:
    listed = CliRunner().invoke(main, ["--help"]).stdout
    context = main.make_context("trexcmd", ["--help"], resilient_parsing=True)
    for command, info in COMMANDS.items():
        loaded = main.get_command(context, command)
        assert loaded is not None
        assert loaded.name == command
        assert loaded.help
        assert f"  {command} " in listed
        assert info.help.replace("\n", " ") in " ".join(listed.split())


def test_misspelled_command_gets_a_suggestion() -> None:
    result = CliRunner().invoke(main, ["get-setings"])
    assert result.exit_code == 2
    assert "Did you mean" in result.stderr
    assert "'get-settings'" in result.stderr


@pytest.mark.parametrize(("words", "is_verbose"), [([], False), (["--verbose"], True)])
def test_verbose_option_prints_the_log(
    words: list[str], is_verbose: bool, capsys: pytest.CaptureFixture[str]
) -> None:
    log = logging.getLogger("trex_gui.tests")
    with main.make_context("trexcmd", [*words, "list"]):
        log.debug("opened")
    log.debug("closed")
    printed = capsys.readouterr().err
    assert ("DEBUG trex_gui.tests: opened\n" in printed) is is_verbose
    assert "closed" not in printed


@pytest.mark.parametrize(
    ("words", "offered"),
    [
        ("get-s", "get-settings"),
        ("get serial_", "serial_timeout"),
        ("set motor1_a", "motor1_acceleration"),
        ("status --par", "--parity"),
        ("calibration s", "set"),
        ("completion z", "zsh"),
    ],
)
def test_completion_offers_commands_options_and_parameters(words: str, offered: str) -> None:
    line = f"trexcmd {words}"
    environment = {
        "_TREXCMD_COMPLETE": "bash_complete",
        "COMP_WORDS": line,
        "COMP_CWORD": str(len(line.split()) - 1),
    }
    result = CliRunner().invoke(main, [], prog_name="trexcmd", env=environment)
    assert f"plain,{offered}" in result.stdout.splitlines()


def test_completion_script_is_printed_for_each_shell_that_is_known() -> None:
    for shell in ("bash", "zsh", "fish"):
        result = CliRunner().invoke(main, ["completion", shell])
        assert result.exit_code == 0
        assert f"_TREXCMD_COMPLETE={shell}_complete" in result.stdout
    assert CliRunner().invoke(main, ["completion", "tcsh"]).exit_code == 2
