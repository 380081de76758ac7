"""The command `stream`."""

import csv
import io
import itertools
import json
import signal
import sys
from pathlib import Path

import pytest

from tests.devices.trex.cli.conftest import StartProcess, becomes
from tests.support.simulator import SimulatedDevice
from tests.support.virtual_command import RunCommand, StartCommand, VirtualCommand


def rows_of(text: str) -> list[dict[str, str]]:
    return list(csv.DictReader(io.StringIO(text)))


def start_stream(start: StartCommand, file: Path, simulator: SimulatedDevice) -> VirtualCommand:
    """Start a stream, and wait for some rows in the file."""
    command = start("stream", "--csv", str(file), url=simulator.url)
    assert becomes(lambda: file.exists() and file.stat().st_size > 2000, True)
    return command


def test_rows_have_units_in_header_and_complete_values(
    trexcmd: RunCommand, quick_simulator: SimulatedDevice
) -> None:
    def current() -> float:
        return float(json.loads(trexcmd("status", "--json").stdout)["motor_1_current_A"])

    def raw() -> list[int | None]:
        return [channel["raw"] for channel in quick_simulator.show()["channels"][1:3]]

    quick_simulator.do("channel 2 1250us", "channel 3 invalid", "current 1 3.0")
    assert becomes(raw, [3125, None])
    assert becomes(current, 3.0)
    result = trexcmd("stream", "--seconds", "0.5")
    rows = rows_of(result.stdout)
    assert len(rows) > 10
    for row in rows:
        assert (row["channel_2_raw"], row["channel_2_us"]) == ("3125", "1250.0")
        assert int(row["channel_2_remapped"]) < -50
        assert (row["channel_3_raw"], row["channel_3_us"]) == ("", ""), "without signal"
        assert row["motor_1_current_A"] == "3.0"
        assert row["serial_controls"] == "1"
    times = [float(row["time_s"]) for row in rows]
    assert times == sorted(times)
    assert times[-1] < 0.6
    assert f"{len(rows)} rows." in result.stderr


def test_analog_board_is_streamed_in_volts(
    trexcmd: RunCommand, quick_simulator: SimulatedDevice
) -> None:
    quick_simulator.do("jumper mode analog", "power cycle", "channel 1 2.5V")
    row = rows_of(trexcmd("stream", "--seconds", "0.6").stdout)[-1]
    assert float(row["channel_1_V"]) == pytest.approx(2.5, abs=0.01)


def test_interrupted_stream_has_complete_rows(
    start: StartCommand, quick_simulator: SimulatedDevice, tmp_path: Path
) -> None:
    file = tmp_path / "log.csv"
    command = start_stream(start, file, quick_simulator)
    command.send_signal(signal.SIGINT)
    errors = command.ends(0).stderr
    text = file.read_text(encoding="utf-8")
    assert text.endswith("\n")
    assert f"{len(rows_of(text))} rows." in errors
    assert all(None not in row.values() for row in rows_of(text))


@pytest.mark.realtime
@pytest.mark.skipif(sys.platform == "win32", reason="needs pseudo-terminals")
def test_closed_output_ends_stream_without_traceback(start_process: StartProcess) -> None:
    process = start_process("stream")
    assert process.stdout is not None
    assert process.stderr is not None
    assert process.stdout.readline().startswith("time_s,")
    process.stdout.close()
    errors = process.stderr.read()
    process.stderr.close()
    assert process.wait(20) == 1
    assert "Traceback" not in errors
    assert "Exception" not in errors


@pytest.mark.parametrize(
    ("lines", "reason"),
    [
        (["line unplug"], "is gone"),
        (["power off"], "stopped responding"),
        (["jumper mode analog", "power cycle"], "mode has changed"),
    ],
)
def test_stream_that_ends_early_saves_its_rows_and_the_reason(
    start: StartCommand,
    quick_simulator: SimulatedDevice,
    tmp_path: Path,
    lines: list[str],
    reason: str,
) -> None:
    file = tmp_path / "log.csv"
    command = start_stream(start, file, quick_simulator)
    quick_simulator.do(*lines)
    errors = command.ends(1).stderr
    assert reason in errors
    assert len(rows_of(file.read_text(encoding="utf-8"))) > 5


def test_old_csv_file_is_replaced_only_after_a_reply(
    trexcmd: RunCommand, tmp_path: Path, quick_simulator: SimulatedDevice
) -> None:
    file = tmp_path / "data.csv"
    file.write_text("old " * 1000)
    quick_simulator.do("power off")
    trexcmd("stream", "--csv", str(file), "--limit", "1", exits=1)
    assert file.read_text() == "old " * 1000
    quick_simulator.do("power on")
    trexcmd("stream", "--csv", str(file), "--limit", "1")
    assert len(rows_of(file.read_text())) == 1
    missing = trexcmd("stream", "--csv", str(tmp_path / "missing" / "log.csv"), exits=1)
    assert "cannot be written" in missing.stderr


def test_stream_has_selected_interval_count_and_separator(
    trexcmd: RunCommand, quick_simulator: SimulatedDevice
) -> None:
    trexcmd("raw", "41")
    words = ("--interval", "0.25", "--limit", "4", "--separator", "tab")
    result = trexcmd("stream", *words)
    rows = list(csv.DictReader(io.StringIO(result.stdout), delimiter="\t"))
    times = [float(row["time_s"]) for row in rows]
    assert len(rows) == 4
    assert "4 rows." in result.stderr
    assert all(later - earlier > 0.249 for earlier, later in itertools.pairwise(times))
    assert times[-1] < 1.2
    assert [row["uart_format"] for row in rows].count("1") == 1, "skipped samples lose no error"
    assert [row["status_uart_error"] for row in rows].count("1") == 1
    first, _ = map(json.loads, trexcmd("stream", "--json", "--limit", "2").stdout.splitlines())
    assert first["channel_1_us"] == 1500.0
