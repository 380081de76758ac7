"""Options of trex-sim that are for an Aracna alone, or not for it."""

import pytest
from click.testing import CliRunner

from trex_gui.cli.simulator import main

MEANINGLESS = [
    ["--model", "trexjr"],
    ["--model", "trex"],  # the default, but somebody meant something by it
    ["--firmware", "1.0"],
    ["--mode", "rc"],
    ["--mix"],
    ["--echo"],
    ["--eeprom", "somewhere"],
    ["--device", "7"],
    ["--demo"],
]


@pytest.mark.parametrize("option", MEANINGLESS, ids=" ".join)
def test_trex_options_are_rejected_with_explanation(option: list[str]) -> None:
    result = CliRunner().invoke(main, ["--aracna", *option])
    assert result.exit_code == 2
    assert f"{option[0]} does not apply to the device aracna" in result.output


def test_motors_option_requires_aracna() -> None:
    result = CliRunner().invoke(main, ["--motors", "2"])
    assert result.exit_code == 2
    assert "--motors does not apply to the device trex" in result.output


@pytest.mark.parametrize("motors", ["0", "9", "many"])
def test_invalid_motor_count_is_rejected(motors: str) -> None:
    assert CliRunner().invoke(main, ["--aracna", "--motors", motors]).exit_code == 2


def test_help_lists_aracna_option() -> None:
    assert "--aracna" in CliRunner().invoke(main, ["--help"]).output
