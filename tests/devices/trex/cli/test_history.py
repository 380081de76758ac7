"""The command `history`."""

import json
import re
from pathlib import Path
from typing import Any

import pytest
from click.shell_completion import ShellComplete

from tests.support.simulator import SimulatedDevice
from tests.support.snapshots import create_snapshot
from tests.support.virtual_command import RunCommand
from trex_gui.cli import main
from trex_gui.devices.trex.settings.history import LIMIT_FILE, Limit, SettingsHistory, Snapshot


def save_snapshot(reason: str = "Apply of 1 setting", **values: Any) -> Snapshot:
    return create_snapshot(SettingsHistory(), reason=reason, **values)


def test_empty_history_explains_when_snapshots_are_taken(trexcmd: RunCommand) -> None:
    result = trexcmd("history")
    assert result.stdout == ""
    assert "Each Apply" in result.stderr
    assert json.loads(trexcmd("history", "--json").stdout) == []
    assert "no snapshots" in trexcmd("history", "path", "1", exits=2).stderr
    trexcmd("history", "show", "99", exits=2)


def test_escape_sequences_of_names_do_not_reach_the_terminal(trexcmd: RunCommand) -> None:
    path = save_snapshot("trexcmd set-settings '\x1b]0;title\x07\x1b[2J'").path
    path.write_text(path.read_text().replace("FT232R", "FT\x1b[31m232R"))
    for result in (trexcmd("history"), trexcmd("history", "show", "\x1b[2J", exits=1)):
        assert not {"\x1b", "\x07"} & set(result.stdout + result.stderr)


def test_history_lists_newest_snapshot_first(trexcmd: RunCommand) -> None:
    save_snapshot()
    snapshot = save_snapshot("trexcmd restore-defaults", device_number=9)
    lines = trexcmd("history", TREX_PORT="").stdout.splitlines()
    local = snapshot.taken.astimezone().strftime("%Y-%m-%d %H:%M:%S")
    assert lines[0].split() == ["Time", "Board", "No.", "Adapter", "Before"]
    cells = [local, "TReX 1.2", "9", "FT232R (ttyUSB0)", "trexcmd restore-defaults"]
    assert re.split(r"  +", lines[1].strip()) == ["1", *cells]
    assert lines[2].endswith("Apply of 1 setting")
    row, _ = json.loads(trexcmd("history", "--json").stdout)
    assert row["number"] == 1
    assert row["taken"] == snapshot.taken.isoformat()
    assert (row["device_number"], row["adapter"]) == (9, "FT232R (ttyUSB0)")
    assert row["problem"] is None
    assert row["path"] == str(snapshot.path)


def test_damaged_snapshot_is_listed_as_damaged(trexcmd: RunCommand) -> None:
    save_snapshot().path.write_text("", encoding="utf-8")
    assert "damaged" in trexcmd("history").stdout
    assert "It is empty." in trexcmd("history").stdout
    trexcmd("history", "show", "1", exits=1)


def test_snapshot_is_shown_by_number_and_by_path(trexcmd: RunCommand) -> None:
    path = save_snapshot(serial_timeout=5).path
    save_snapshot()
    shown = trexcmd("history", "show", "2")
    assert shown.stdout == path.read_text(encoding="utf-8")
    assert trexcmd("history", "show", str(path)).stdout == shown.stdout
    assert trexcmd("history", "path", "2").stdout == f"{path}\n"
    report = json.loads(trexcmd("history", "show", "2", "--json").stdout)
    assert report["parameters"]["serial_timeout"] == 5


@pytest.mark.parametrize(("number", "code"), [("0", 2), ("3", 2), ("99999999999", 1)])
def test_unknown_snapshot_number_fails_without_traceback(
    trexcmd: RunCommand, number: str, code: int
) -> None:
    save_snapshot()
    result = trexcmd("history", "show", number, exits=code)
    assert result.stdout == ""
    assert "Traceback" not in result.stderr


def test_history_diff_compares_first_snapshot_with_second(trexcmd: RunCommand) -> None:
    save_snapshot(serial_timeout=5)
    save_snapshot(serial_timeout=7)
    trexcmd("history", "diff", "2", "2")
    assert "5 → 7" in trexcmd("history", "diff", "2", "1", exits=1).stdout


def test_history_diff_compares_snapshot_with_board(
    trexcmd: RunCommand, quick_simulator: SimulatedDevice
) -> None:
    quick_simulator.do("eeprom serial_timeout 7")
    save_snapshot(serial_timeout=5)
    result = trexcmd("history", "diff", "1", "--json", exits=1)
    rows = {row["key"]: row for row in json.loads(result.stdout)["differing"]}
    assert (rows["serial_timeout"]["before"], rows["serial_timeout"]["after"]) == (7, 5)


# --- Limit of the history ---------------------------------------------------------------


def test_history_keep_sets_and_prints_the_limit(trexcmd: RunCommand) -> None:
    assert trexcmd("history", "keep").stdout == "500\n"
    trexcmd("history", "keep", "all")
    assert trexcmd("history", "keep").stdout == "all\n"
    trexcmd("history", "keep", "20")
    assert SettingsHistory().limit() == Limit(20)


def test_lower_history_limit_prompts_before_removing_snapshots(trexcmd: RunCommand) -> None:
    for _ in range(5):
        save_snapshot()
    result = trexcmd("history", "keep", "2", stdin="n\n", exits=1)
    assert "Remove the oldest 3 of 5 snapshots permanently?" in result.stderr
    assert len(SettingsHistory().snapshots()) == 5
    assert SettingsHistory().limit() == Limit()
    assert "3 snapshots removed" in trexcmd("history", "keep", "2", stdin="y\n").stderr
    assert len(SettingsHistory().snapshots()) == 2
    trexcmd("history", "keep", "1", "--yes")
    assert len(SettingsHistory().snapshots()) == 1


def test_damaged_history_limit_is_reported(
    trexcmd: RunCommand, quick_simulator: SimulatedDevice, tmp_path: Path
) -> None:
    save_snapshot()
    (SettingsHistory().folder / LIMIT_FILE).write_text("kept: some\n", encoding="utf-8")
    assert "none is removed" in trexcmd("history").stderr
    assert "none is removed" in trexcmd("history", "keep", exits=1).stderr
    file = tmp_path / "new.txt"
    file.write_text("product: TReX\nserial_timeout: 9\n", encoding="utf-8")
    result = trexcmd("set-settings", str(file))
    assert "Warning: " in result.stderr
    assert "none is removed" in result.stderr
    trexcmd("history", "keep", "10")
    assert SettingsHistory().limit() == Limit(10)


def test_completion_describes_snapshot_numbers() -> None:
    save_snapshot()
    complete = ShellComplete(main, {}, "trexcmd", "_TREXCMD_COMPLETE")
    (found,) = complete.get_completions(["history", "show"], "")
    assert found.value == "1"
    assert found.help is not None
    assert "Apply of 1 setting" in found.help


def test_snapshot_is_selected_by_its_name(trexcmd: RunCommand) -> None:
    path = save_snapshot(serial_timeout=5).path
    save_snapshot()
    trexcmd("history", "name", "2", "contest", "--note", "as it won")
    assert trexcmd("history", "path", "contest").stdout == f"{path}\n"
    assert "serial_timeout: 5" in trexcmd("history", "show", "contest").stdout
    lines = trexcmd("history", "--find", "WON ft232r").stdout.splitlines()
    assert lines[0].split()[-2:] == ["Name", "Note"]
    assert [line.split()[0] for line in lines[1:]] == ["2"]
    assert "No snapshot" in trexcmd("history", "--find", "nothing like it").stderr
    row = json.loads(trexcmd("history", "--json").stdout)[1]
    assert (row["name"], row["note"]) == ("contest", "as it won")
    trexcmd("history", "name", "contest", "", "--note", "")
    assert "neither the number" in trexcmd("history", "path", "contest", exits=2).stderr
