"""Interrupted set-settings and restore-defaults."""

import re
import signal
from collections.abc import Callable
from dataclasses import dataclass, replace
from pathlib import Path

import pytest

from tests.devices.trex.cli.conftest import becomes
from tests.support.simulator import SimulatedDevice, StartSimulator
from tests.support.virtual_command import RunCommand, StartCommand, VirtualCommand
from trex_gui.devices.trex.protocol.calibration import Calibration, CalibrationKey
from trex_gui.devices.trex.protocol.flags import CHANNELS, InputSource
from trex_gui.devices.trex.protocol.parameters import parameters_of
from trex_gui.devices.trex.settings.document import Settings
from trex_gui.devices.trex.settings.history import SettingsHistory
from trex_gui.devices.trex.settings.reader import read_settings
from trex_gui.devices.trex.settings.writer import write_settings

SPECS = parameters_of("trex", "1.2")
NAMES = {spec.name: spec.key for spec in SPECS.readable}

MIDDLE = "motor1_pwm_maximum"
"""A parameter before and behind which others are stored."""


@dataclass
class SettingsWrite:
    """Run of set-settings that has just stored a certain parameter."""

    process: VirtualCommand
    board: SimulatedDevice
    file: Path
    before: Settings
    wanted: Settings

    def end(self) -> str:
        """Wait for the end and return the messages."""
        _, said = self.process.communicate()
        assert "Traceback" not in said
        return said

    def assert_reported(self, said: str) -> None:
        """Check that the messages name the stored and the other settings."""
        stored = self.board.show()["parameters"]
        given = {key for key in self.wanted.parameters if self.differs(key)}
        named_stored = named(said, "Stored: ")
        untried = named(said, "Not tried: ") | named(said, "Not tried after that: ")
        assert "Stored: " in said  # the calibrations at least, which go first
        assert untried
        assert all(stored[key] == self.wanted.parameters[key] for key in named_stored)
        assert all(stored[key] == self.before.parameters[key] for key in untried)
        assert len(given - named_stored - untried) <= 1
        assert re.search(r"\d+ of \d+ changes stored and verified", said)
        assert "not all settings were stored" in said.lower()

    def differs(self, key: str) -> bool:
        return self.wanted.parameters[key] != self.before.parameters[key]

    def assert_snapshot_complete(self) -> None:
        """Check that the snapshot has all earlier settings."""
        (snapshot,) = SettingsHistory().snapshots()
        assert SettingsHistory().load(snapshot) == self.before


def named(said: str, beginning: str) -> set[str]:
    """Return the keys of the parameters that a sentence lists."""
    lines = [line for line in said.splitlines() if line.startswith(beginning)]
    names = lines[0].removeprefix(beginning).removesuffix(".").split(", ") if lines else []
    return {NAMES[name] for name in names if name in NAMES}


def other(before: Settings) -> Settings:
    """Return settings that differ from the board, except those that reach it."""
    values = {
        spec.key: max(spec.valid) if spec.default != max(spec.valid) else min(spec.valid)
        for spec in SPECS.readable
        if spec.key not in {"uart_settings", "crc7_polynomial", "device_number"}
    }
    places = {CalibrationKey.of(InputSource.RC, channel) for channel in CHANNELS[:2]}
    return replace(
        before,
        parameters={**before.parameters, **values},
        calibrations={
            **before.calibrations,
            **dict.fromkeys(places, Calibration(2400, 3700, 5100, 60)),
        },
    )


Disturb = Callable[[Callable[[SettingsWrite], object]], tuple[SettingsWrite, str]]


@pytest.fixture
def disturb(
    start: StartCommand, trexcmd: RunCommand, start_simulator: StartSimulator, tmp_path: Path
) -> Disturb:
    """Disturb a slow write of other settings.

    Returns the written settings and the messages.
    """

    def disturbed(how: Callable[[SettingsWrite], object]) -> tuple[SettingsWrite, str]:
        board = start_simulator()
        file = tmp_path / "wanted.txt"
        text = trexcmd("get-settings", "-", "--port", board.url).stdout
        before = read_settings(text)[0]
        wanted = other(before)
        file.write_text(write_settings(wanted), encoding="utf-8")
        process = start("set-settings", str(file), url=board.url)
        value = wanted.parameters[MIDDLE]
        assert becomes(lambda: board.show()["parameters"][MIDDLE], value)
        writing = SettingsWrite(process, board, file, before, wanted)
        how(writing)
        said = writing.end()
        assert writing.process.returncode == 1
        return writing, said

    return disturbed


def test_ctrl_c_ends_writing_between_two_settings(disturb: Disturb, trexcmd: RunCommand) -> None:
    writing, said = disturb(lambda writing: writing.process.send_signal(signal.SIGINT))
    assert "Interrupted: not all settings were stored; the others are unchanged." in said
    writing.assert_reported(said)
    writing.assert_snapshot_complete()
    trexcmd("set-settings", str(writing.file), "--port", writing.board.url)
    assert writing.board.show()["parameters"] == writing.wanted.parameters


def test_unplugging_while_writing_reports_every_setting(
    disturb: Disturb, trexcmd: RunCommand
) -> None:
    writing, said = disturb(lambda writing: writing.board.do("line unplug"))
    assert "gone" in said
    writing.assert_reported(said)
    writing.assert_snapshot_complete()
    url = writing.board.do("line plug").split()[-1]
    trexcmd("set-settings", str(writing.file), "--port", url)
    assert writing.board.show()["parameters"] == writing.wanted.parameters


# --- How the board is reached after its next start --------------------------------------


def given(trexcmd: RunCommand, path: Path, **values: int) -> str:
    """Write a file with these values to the board, and return the messages."""
    lines = "".join(f"{key}: {wire}\n" for key, wire in values.items())
    path.write_text(f"product: TReX\n{lines}", encoding="utf-8")
    result = trexcmd("set-settings", str(path))
    return result.stderr


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
    said = given(trexcmd, tmp_path / "line.txt", **values)
    sentence = "After the board is switched off and on, connect with"
    assert f"{sentence} --port {quick_simulator.url} {options}\n" in said


def test_printed_options_reach_the_board(
    trexcmd: RunCommand, quick_simulator: SimulatedDevice, tmp_path: Path
) -> None:
    said = given(trexcmd, tmp_path / "line.txt", uart_settings=0x3A, crc7_polynomial=0x15)
    (reports,) = re.findall("off and on, connect with (.*)", said)
    quick_simulator.do("power cycle")
    trexcmd("get", "crc7_polynomial", *reports.split())
    restored = trexcmd("restore-defaults", "--yes", *reports.split())
    (reports,) = re.findall("off and on, connect with (.*)", restored.stderr)
    quick_simulator.do("power cycle")
    trexcmd("get", "crc7_polynomial", *reports.split())


def test_baud_rate_halved_by_old_firmware_is_printed_halved(
    trexcmd: RunCommand, start_simulator: StartSimulator, tmp_path: Path
) -> None:
    old = start_simulator("--firmware", "1.0", "--unpaced")
    file = tmp_path / "line.txt"
    file.write_text("product: TReX\nuart_settings: 6\n", encoding="utf-8")  # 28800 baud
    said = trexcmd("set-settings", str(file), "--port", old.url).stderr
    assert f"connect with --port {old.url} --baud 14400\n" in said


def test_new_device_number_is_printed_for_expanded_protocol(
    trexcmd: RunCommand, quick_simulator: SimulatedDevice, tmp_path: Path
) -> None:
    file = tmp_path / "number.txt"
    file.write_text("product: TReX\ndevice_number: 9\nuart_settings: 8\n", encoding="utf-8")
    result = trexcmd("set-settings", str(file), "--protocol", "expanded")
    url = quick_simulator.url
    now = f"From now on, connect with --port {url} --baud 19200 --protocol expanded --device 9."
    later = f"connect with --port {url} --baud 57600 --protocol expanded --device 9\n"
    assert now in result.stderr
    assert later in result.stderr


@pytest.mark.parametrize("values", [{"serial_timeout": 5}, {"device_number": 9}])
def test_unchanged_line_settings_print_no_options(
    trexcmd: RunCommand, tmp_path: Path, values: dict[str, int]
) -> None:
    said = given(trexcmd, tmp_path / "same.txt", **values)
    assert "each the board" not in said
    assert "is reached" not in said


def test_restore_defaults_without_line_change_prints_no_options(trexcmd: RunCommand) -> None:
    assert "connect with" not in trexcmd("restore-defaults", "--yes").stderr
