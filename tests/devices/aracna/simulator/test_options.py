"""Options of trex-sim for an Aracna."""

import pytest
from click.testing import CliRunner

from trex_gui.cli.simulator import main

REJECTED = [
    # TReX is the default model, but the option is given.
    ("--aracna --model trex", "--model does not apply to the device aracna"),
    ("--aracna --mix", "--mix does not apply to the device aracna"),
    ("--aracna --eeprom somewhere", "--eeprom does not apply to the device aracna"),
    ("--motors 2", "--motors does not apply to the device trex"),
    *((f"--aracna --motors {motors}", "--motors") for motors in ("0", "9", "many")),
]


@pytest.mark.parametrize(("words", "text"), REJECTED)
def test_option_of_other_device_and_invalid_motor_count_are_rejected(words: str, text: str) -> None:
    result = CliRunner().invoke(main, words.split())
    assert result.exit_code == 2
    assert text in result.output


def test_help_lists_aracna_option() -> None:
    assert "--aracna" in CliRunner().invoke(main, ["--help"]).output
