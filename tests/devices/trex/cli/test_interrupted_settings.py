"""Interrupted `set-settings`, and the options that reach the board after new line settings."""

import re
import signal
from dataclasses import replace
from pathlib import Path

import pytest

from tests.devices.trex.cli.conftest import becomes
from tests.support.simulator import SimulatedDevice, StartSimulator
from tests.support.virtual_command import RunCommand, StartCommand
from trex_gui.devices.trex.protocol.calibration import Calibration, CalibrationKey
from trex_gui.devices.trex.protocol.parameters import parameters_of
from trex_gui.devices.trex.settings.document import Settings
from trex_gui.devices.trex.settings.history import SettingsHistory
from trex_gui.devices.trex.settings.reader import read_settings
from trex_gui.devices.trex.settings.writer import write_settings

SPECS = parameters_of("trex", "1.2")
NAMES = {spec.name: spec.key for spec in SPECS.readable}

MIDDLE_KEY = "motor1_pwm_maximum"
"""Key of a parameter that is neither the first nor the last to be stored."""


def listed_keys(messages: str, prefix: str) -> set[str]:
    """Return the keys of the parameters in the first message with this prefix."""
    lines = [line for line in messages.splitlines() if line.startswith(prefix)]
    names = lines[0].removeprefix(prefix).removesuffix(".").split(", ") if lines else []
    return {NAMES[name] for name in names if name in NAMES}


def changed_settings(before: Settings) -> Settings:
    """Return settings with different values, but the same line settings and device number."""
    values = {
        spec.key: max(spec.valid) if spec.default != max(spec.valid) else min(spec.valid)
        for spec in SPECS.readable
        if spec.key not in {"uart_settings", "crc7_polynomial", "device_number"}
    }
    keys = {CalibrationKey.RC_CHANNEL_1, CalibrationKey.RC_CHANNEL_2}
    calibrations = dict.fromkeys(keys, Calibration(2400, 3700, 5100, 60))
    return replace(
        before,
        parameters={**before.parameters, **values},
        calibrations={**before.calibrations, **calibrations},
    )


@pytest.mark.parametrize("unplugged", [False, True])
def test_interrupted_write_reports_every_setting_and_can_be_repeated(
    start: StartCommand,
    trexcmd: RunCommand,
    start_simulator: StartSimulator,
    tmp_path: Path,
    *,
    unplugged: bool,
) -> None:
    board, file = start_simulator(), tmp_path / "target.txt"
    settings, *_ = read_settings(trexcmd("get-settings", "-", "--port", board.url).stdout)
    changed = changed_settings(settings)
    file.write_text(write_settings(changed), encoding="utf-8")
    before, target = settings.parameters, changed.parameters
    process = start("set-settings", str(file), url=board.url)
    assert becomes(lambda: board.show()["parameters"][MIDDLE_KEY], target[MIDDLE_KEY])
    if unplugged:
        board.do("line unplug")
    else:
        process.send_signal(signal.SIGINT)
    messages = process.ends(1).stderr
    interrupted = "Interrupted: not all settings were stored; the rest is unchanged."
    assert ("gone" if unplugged else interrupted) in messages

    stored = board.show()["parameters"]
    reported = listed_keys(messages, "Stored: ")
    untried = listed_keys(messages, "Not tried: ") | listed_keys(messages, "Not tried after that: ")
    assert "Stored: " in messages  # at least the calibrations, which are written first
    assert untried
    assert all(stored[key] == target[key] for key in reported)
    assert all(stored[key] == before[key] for key in untried)
    changes = {key for key in target if target[key] != before[key]}
    assert len(changes - reported - untried) <= 1
    assert re.search(r"\d+ of \d+ changes stored and verified", messages)
    assert "not all settings were stored" in messages.lower()
    assert "Traceback" not in messages
    (snapshot,) = SettingsHistory().snapshots()
    assert SettingsHistory().load(snapshot) == settings

    url = board.do("line plug").split()[-1] if unplugged else board.url
    trexcmd("set-settings", str(file), "--port", url)
    assert board.show()["parameters"] == target


# --- Options that reach the board after its next start ----------------------------------


def write_values(trexcmd: RunCommand, path: Path, *options: str, **values: int) -> str:
    """Write a file with these values to the board, and return the messages."""
    lines = "".join(f"{key}: {wire}\n" for key, wire in values.items())
    path.write_text(f"product: TReX\n{lines}", encoding="utf-8")
    return trexcmd("set-settings", str(path), *options).stderr


@pytest.mark.parametrize(
    ("values", "options"),
    [
        ({"uart_settings": 0x7A}, "--baud 115200 --parity odd --stop-bits 2"),
        ({"uart_settings": 0x2A, "crc7_polynomial": 0x15}, "--baud 115200 --crc --polynomial 95"),
    ],
)
def test_changed_line_settings_print_new_options(
    trexcmd: RunCommand,
    quick_simulator: SimulatedDevice,
    tmp_path: Path,
    values: dict[str, int],
    options: str,
) -> None:
    messages = write_values(trexcmd, tmp_path / "line.txt", **values)
    sentence = "After the board is switched off and on, connect with"
    assert f"{sentence} --port {quick_simulator.url} {options}\n" in messages


def test_printed_options_reach_the_board(
    trexcmd: RunCommand, quick_simulator: SimulatedDevice, tmp_path: Path
) -> None:
    path = tmp_path / "line.txt"
    messages = write_values(trexcmd, path, uart_settings=0x3A, crc7_polynomial=0x15)
    (options,) = re.findall("off and on, connect with (.*)", messages)
    quick_simulator.do("power cycle")
    trexcmd("get", "crc7_polynomial", *options.split())
    restored = trexcmd("restore-defaults", "--yes", *options.split())
    (options,) = re.findall("off and on, connect with (.*)", restored.stderr)
    quick_simulator.do("power cycle")
    trexcmd("get", "crc7_polynomial", *options.split())


def test_baud_rate_halved_by_old_firmware_is_printed_halved(
    trexcmd: RunCommand, start_simulator: StartSimulator, tmp_path: Path
) -> None:
    url = start_simulator("--firmware", "1.0", "--unpaced").url
    path = tmp_path / "line.txt"
    messages = write_values(trexcmd, path, "--port", url, uart_settings=6)  # 28800 baud
    assert f"connect with --port {url} --baud 14400\n" in messages


def test_new_device_number_is_printed_for_expanded_protocol(
    trexcmd: RunCommand, quick_simulator: SimulatedDevice, tmp_path: Path
) -> None:
    values = {"device_number": 9, "uart_settings": 8}
    path, options = tmp_path / "number.txt", ("--protocol", "expanded")
    messages = write_values(trexcmd, path, *options, **values)
    url = quick_simulator.url
    now = f"From now on, connect with --port {url} --baud 19200 --protocol expanded --device 9."
    later = f"connect with --port {url} --baud 57600 --protocol expanded --device 9\n"
    assert now in messages
    assert later in messages


@pytest.mark.parametrize("values", [{"serial_timeout": 5}, {"device_number": 9}])
def test_unchanged_line_settings_print_no_options(
    trexcmd: RunCommand, tmp_path: Path, values: dict[str, int]
) -> None:
    messages = write_values(trexcmd, tmp_path / "new.txt", **values)
    assert "connect with" not in messages
    assert "connect with" not in trexcmd("restore-defaults", "--yes").stderr
