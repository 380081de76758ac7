"""Fuzzing of files that users open."""

import contextlib
import math
import os
import re
import sqlite3
import tempfile
from collections.abc import Callable, Sequence
from functools import cache
from itertools import chain, cycle, islice
from pathlib import Path
from typing import Any
from unittest.mock import patch

from tests.devices.aracna import recordings
from tests.devices.trex.bench.test_files import SAVED
from tests.devices.trex.recording import samples
from tests.fuzz.fuzzing import Target, mutations
from tests.support.bad_files import BAD_FILES
from trex_gui.core.code import Language
from trex_gui.core.errors import BadRequest
from trex_gui.core.files import Finding, SettingsError, Severity, load
from trex_gui.core.guardian.log import log_file, logged_stops
from trex_gui.core.recording.export import export_span
from trex_gui.core.recording.kinds import RecordingError
from trex_gui.core.recording.store import Recording
from trex_gui.core.resource_files import resource
from trex_gui.core.transport import transcript
from trex_gui.devices.aracna.model.recordings import RobotPlayback
from trex_gui.devices.aracna.poses.ppr import read_file, read_ppr, write_ppr
from trex_gui.devices.aracna.recording import FORMAT as ROBOT_FORMAT
from trex_gui.devices.trex.bench.files import BenchFileError, from_csv, load_run, to_csv
from trex_gui.devices.trex.cli.replay import RecordedTraffic
from trex_gui.devices.trex.model.playback import Playback
from trex_gui.devices.trex.model.settings.document import SettingsDocument
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.devices.trex.protocol.device_table import device_table
from trex_gui.devices.trex.protocol.flags import InputSource
from trex_gui.devices.trex.recording import FORMAT as BOARD_FORMAT
from trex_gui.devices.trex.session.traffic_decoder import TrexDecoder
from trex_gui.devices.trex.settings.board_records import BoardRecord, BoardRecords, utc_now
from trex_gui.devices.trex.settings.code_export import export_code
from trex_gui.devices.trex.settings.comparison import compare
from trex_gui.devices.trex.settings.conversion import convert
from trex_gui.devices.trex.settings.document import factory_settings
from trex_gui.devices.trex.settings.edit_files import BoardIdentity
from trex_gui.devices.trex.settings.edit_in_place import amend
from trex_gui.devices.trex.settings.history import LIMIT_FILE, SettingsHistory
from trex_gui.devices.trex.settings.reader import MAX_FINDINGS, read_settings, repair_values
from trex_gui.devices.trex.settings.rules import accept_proposals, lint
from trex_gui.devices.trex.settings.writer import write_settings
from trex_gui.devices.trex.simulator.memory import Eeprom, EepromError
from trex_gui.gamepad.pads import Pad, PadState
from trex_gui.gamepad.profile import GamepadProfile, Pilot, read_profile
from trex_gui.ui.playback.player import RecordingPlayer

# --- Settings ---------------------------------------------------------------------------


def settings_samples() -> Sequence[bytes]:
    models = device_table().models
    factory = [write_settings(factory_settings(model, None)).encode() for model in models]
    shipped = [path.read_bytes() for path in sorted(resource("samples").glob("*.txt"))]
    return [*factory, *shipped, *(bad.data for bad in BAD_FILES if len(bad.data) < 4000)]


def _check_findings(
    findings: Sequence[Finding],
    data: bytes,
    *,
    rejected: bool = False,
    max_count: int = MAX_FINDINGS + 30,  # the limit of the reader does not apply to warnings
) -> None:
    lines = re.split("\r\n|[\n\r\x85\u2028\u2029]", data.decode("utf-8", "replace"))
    assert len(findings) <= max_count
    assert not rejected or any(finding.severity is Severity.ERROR for finding in findings)
    for finding in findings:
        assert finding.message
        assert finding.line is None or 1 <= finding.line <= len(lines)
        str(finding).encode("utf-8")  # for a terminal


def check_settings(data: bytes, folder: Path) -> None:
    path = folder / "any.txt"
    path.write_bytes(data)
    try:
        document = SettingsDocument.of_file(path, load(path))
    except SettingsError as error:
        _check_findings(error.findings, data)
    else:
        document.check()
        if not document.readable:
            assert document.findings
            document.set_text(document.text + "x")
            document.check()
    with contextlib.suppress(SettingsError):
        read_settings(data.decode("utf-8", "surrogateescape"))
    with contextlib.suppress(SettingsError, BadRequest):
        text, repairs = repair_values(data, "any.txt")
        assert repairs or text.encode() == data
        assert repair_values(text.encode(), "any.txt")[1] == ()
        settings, accepted = accept_proposals(read_settings(text)[0])
        assert accepted or amend(text, settings) == text
        for model in device_table().models:
            converted = convert(settings, model, model.firmware[0]).settings
            assert read_settings(amend(text, converted))[0] == converted
    try:
        read, findings = read_settings(data)
    except SettingsError as error:
        _check_findings(error.findings, data, rejected=True)
        return
    _check_findings(findings, data)
    assert read_settings(write_settings(read))[0] == read
    factory = factory_settings(read.product, read.firmware)
    text = data.decode("utf-8")
    assert amend(text, read) == text
    with contextlib.suppress(SettingsError, BadRequest):
        assert read_settings(amend(text, factory))[0].parameters == factory.parameters
    compare(read, factory)
    lint(read)
    for language in Language:
        export_code(read, ConnectionSettings("virtual"), language)


YAML = tuple(
    word.encode()
    for word in (
        *("\n", ": ", "#", "{", "}", "[", "]", "- ", "? ", ", ", "'", '"', "&a ", "*a", "|\n"),
        *("<<: *a", ">-\n", "!!python/object:os.system ", "!!int ", "!<x> ", "---\n", "...\n"),
        *("%YAML 9.9\n", "%TAG ! x\n", "\r", "\r\n", "\t", "\x85", "\u2028", "\ufeff", "\0"),
        *("\x7f", "\ud7ff", '"\\U00110000"', '"\\xZZ"', '"\\uD800"', "~", "null", "0x", "+5"),
        *("[" * 300, "{a: " * 300, "product: TReX Jr\n", "firmware: 1.0\n", "motor_mode: 1\n"),
        *("firmware: 1.9.999\n", "rc_channel_1: ", "analog_channel_5:\n  minimum: 1\n"),
        "{minimum: 1, neutral: 2, maximum: 3, deadband: 4}\n",
        "\n# Note on motor_mode: one\n",
    )
)


def _record_samples() -> Sequence[bytes]:
    stored = factory_settings(device_table().model("trex"), "1.2")
    record = BoardRecord(stored).after_writing(stored, InputSource.RC, (), utc_now())
    with tempfile.TemporaryDirectory() as folder:
        records, board = BoardRecords(Path(folder)), BoardIdentity.of(stored)
        records.save(board, record.with_notes({"motor_mode": "two motors"}))
        return [records.path(board).read_bytes()]


def check_record(data: bytes, folder: Path) -> None:
    """Check the file that stores data about a board."""
    stored = factory_settings(device_table().model("trex"), "1.2")
    records, board = BoardRecords(folder), BoardIdentity.of(stored)
    records.path(board).write_bytes(data)
    try:
        record = records.load(board)
    except SettingsError as error:
        _check_findings(error.findings, data, rejected=True)
        return
    assert record is not None
    records.save(board, record)
    assert records.load(board) == record
    record.differences(stored)
    record.after_reading(stored, InputSource.ANALOG, utc_now()).with_hidden(stored, InputSource.RC)


# --- Snapshots --------------------------------------------------------------------------


def check_snapshot(data: bytes, folder: Path) -> None:
    """Check the input as two snapshots and as the file with the limit of snapshots."""
    (folder / "20260102T030405Z-trex-1.2.txt").write_bytes(data)
    (folder / "99999999T999999Z-9-trex-1.2.txt").write_bytes(data)
    (folder / LIMIT_FILE).write_bytes(data)
    history = SettingsHistory(folder)
    snapshots = history.snapshots()
    assert len(snapshots) == 2
    for snapshot in snapshots:
        with contextlib.suppress(SettingsError):
            history.load(snapshot)
    limit = history.limit()
    assert limit.count is None or limit.count >= 1
    settings = factory_settings(device_table().model("trex"), None)
    saved = history.save(settings, adapter=data.decode("latin-1"), reason="any")
    assert history.load(saved) == settings
    assert saved.path in {snapshot.path for snapshot in history.snapshots()}


def _snapshot_samples() -> Sequence[bytes]:
    with tempfile.TemporaryDirectory() as name:
        history = SettingsHistory(Path(name))
        history.set_limit(7)
        settings = factory_settings(device_table().model("trex"), None)
        saved = history.save(settings, adapter="/dev/ttyUSB0", reason="Apply of 3 settings")
        return [saved.path.read_bytes(), (Path(name) / LIMIT_FILE).read_bytes()]


# --- Other text files -------------------------------------------------------------------


def check_poses(data: bytes, folder: Path) -> None:
    path = folder / "any.ppr"
    path.write_bytes(data)
    try:
        file = read_file(path)
    except SettingsError as error:
        _check_findings(error.findings, data, rejected=True)
        return
    _check_findings(file.findings, data, max_count=len(data) + 1)
    assert read_ppr(write_ppr(file.project))[0] == file.project


def check_bench(data: bytes, folder: Path) -> None:
    path = folder / "any.csv"
    path.write_bytes(data)
    with contextlib.suppress(BenchFileError, SettingsError):
        from_csv(to_csv(load_run(path)))


PAD = Pad(ident=1, guid="0", name="Stick", axes=4, buttons=6)


def check_profile(data: bytes, folder: Path) -> None:
    profile = read_profile(data.decode("utf-8", "replace"))
    if profile is None:
        return
    assert read_profile(profile.to_text()) == profile
    profile.fits(PAD)
    pilot = Pilot(profile)
    for axes in ((0.0,) * 4, (1.0,) * 4):
        for pressed in (False, True):
            request = pilot.update(PadState(axes, (pressed,) * 6))
            assert -1 <= request.forward <= 1
            assert -1 <= request.turn <= 1


def check_eeprom(data: bytes, folder: Path) -> None:
    path = folder / "eeprom.json"
    path.write_bytes(data)
    with contextlib.suppress(EepromError):
        eeprom = Eeprom.open(path)
        eeprom.factory_reset()
        assert eeprom.unsaved is None


def _eeprom_samples() -> Sequence[bytes]:
    with tempfile.TemporaryDirectory() as name:
        path = Path(name) / "eeprom.json"
        Eeprom.open(path)
        return [path.read_bytes()]


JSON: Sequence[bytes] = (
    *(b"null", b"true", b"[]", b"{}", b"NaN", b"-Infinity", b'"', b"[" * 5000, b'{"a":' * 5000),
    *(b"\\ud800", b"\\u0000", b",", b":", b"1e999", b"0.15", b'"style": "tank"', b"\xff"),
)


# --- Recordings -------------------------------------------------------------------------


@cache
def recording_samples() -> Sequence[bytes]:
    with tempfile.TemporaryDirectory() as name:
        board, robot = Path(name) / "board.trexrec", Path(name) / "robot.trexrec"
        samples.write(board, list(islice(samples.drive_records(), 400)))
        recordings.write(robot, list(recordings.session(4)))
        return [board.read_bytes(), robot.read_bytes()]


def check_recording(data: bytes, folder: Path) -> None:
    path = folder / "any.trexrec"
    path.write_bytes(data)
    _play(path)


CHANGES = ("UPDATE", "DELETE", "INSERT", "ALTER", "DROP", "CREATE")


def check_statements(data: bytes, folder: Path) -> None:
    """Run SQL on a valid recording, as other programs might."""
    path = folder / "any.trexrec"
    first, _, rest = data.partition(b"\n")
    path.write_bytes(recording_samples()[b"robot" in first])
    for statement in rest.decode("utf-8", "replace").split("\n"):
        if statement.lstrip().upper().startswith(CHANGES):
            # A changed schema takes effect when the file is opened the next time.
            with contextlib.closing(sqlite3.connect(path, isolation_level=None)) as database:
                database.execute("PRAGMA writable_schema = ON")
                database.execute("PRAGMA synchronous = OFF")
                with contextlib.suppress(sqlite3.Error, sqlite3.Warning):
                    database.execute(statement)
    _play(path)


def _check_name(error: RecordingError, path: Path) -> None:
    assert str(error).startswith(f"{path}: ")


def _play(path: Path) -> None:
    formats: Sequence[tuple[Any, Callable[..., RecordingPlayer[Any, Any, Any]]]] = (
        (BOARD_FORMAT, Playback),
        (ROBOT_FORMAT, RobotPlayback),
    )
    for recording_format, create_player in formats:
        try:
            recording: Recording[Any, Any] = Recording(path, recording_format)
        except RecordingError as error:
            _check_name(error, path)
            continue
        try:
            player = create_player(recording)
            steps = 0

            def count(share: float) -> None:
                nonlocal steps
                assert 0 <= share <= 1
                steps += 1

            loaded = player.loader()(count)
            player._set_recording(loaded)
            assert steps <= recording.count / 1000 + 2
            assert len(recording.problems) <= 22
            for time in (-math.inf, recording.header.clock, loaded.end, math.inf, math.nan):
                player.state_at(time)
            assert player.traces is not None
            for suffix in (".csv", ".mcap"):
                header = player.export_header(recording.header.clock)
                export_span(recording, path.with_suffix(suffix), (-math.inf, math.inf), header)
        finally:
            recording.close()


TABLES = {
    "board": (
        *("raw", "remapped", "currents", "control", "mode", "status", "setpoint"),
        *("aux_setpoint", "marker", "settings"),
    ),
    "robot": (
        *("goals", "progress", "present", "speeds", "step", "play_end", "stuck", "restart"),
        *("not_responding", "marker"),
    ),
}
COLUMNS = {
    "board": (
        *("mode.mode", "marker.text", "settings.text", "setpoint.direction", "setpoint.speed"),
        *("setpoint.brake", "setpoint.setpoint_motor", "currents.motor_1_current_counts"),
        *("raw.channel_1_raw", "remapped.channel_2_remapped", "control.serial_controls"),
    ),
    "robot": (
        *("goals.motor_0_goal_units", "goals.expected_s", "progress.answered", "step.part"),
        *("present.motor_3_present_units", "present.duration_s", "play_end.reason", "step.step"),
        *("stuck.stuck_motor", "restart.pending_lost", "speeds.motor_0_speed_units", "step.round"),
    ),
}
KEYS = (
    "started_utc",
    "clock_s",
    "model",
    "firmware",
    "mode",
    "settings",
    "device_number",
    "motors",
)
VALUES = (
    *("NULL", "1", "-1", "9223372036854775807", "1e308", "9e999", "-9e999", "''", "'forward'"),
    *("X'FF00'", "randomblob(70)", "'\ud7ff'", "CAST(X'FFFE' AS TEXT)", "zeroblob(2000000)"),
    *("'2026-01-02'", "0.5", "'R'", "'steps'", "1e18", "'9999-12-31T23:59:59-23:59'"),
)
SCHEMA = (
    "UPDATE sqlite_master SET sql = replace(sql, 'NOT NULL', '')",
    "UPDATE sqlite_master SET sql = replace(sql, 'INTEGER PRIMARY KEY', 'INTEGER')",
    "UPDATE sqlite_master SET sql = replace(sql, 'VIRTUAL', 'STORED')",
    "UPDATE sqlite_master SET sql = replace(sql, 'round(', 'printf(')",
    "UPDATE sqlite_master SET rootpage = 2",
    "DROP TABLE marker",
    "ALTER TABLE marker RENAME TO other",
    "CREATE VIEW marker AS SELECT 1 AS record, 1.0 AS clock_s",
    "CREATE TABLE extra (a)",
    "UPDATE marker SET record = 9223372036854775807",
    "INSERT INTO header VALUES ('x', 1)",
    "DELETE FROM header WHERE key = 'ended_utc_s'",
)


def _statement_samples() -> Sequence[bytes]:
    def script(kind: str, statements: Sequence[str]) -> bytes:
        return "\n".join([f"-- {kind}", *statements]).encode()

    def changes(kind: str) -> Sequence[str]:
        values = cycle(VALUES)
        columns = (column.split(".") for column in COLUMNS[kind])
        return [
            *(f"UPDATE {table} SET clock_s = {next(values)}" for table in TABLES[kind]),
            *(f"UPDATE {table} SET {column} = {next(values)}" for table, column in columns),
            *(f"UPDATE header SET value = {next(values)} WHERE key = '{key}'" for key in KEYS),
        ]

    return [script(kind, lines) for kind in TABLES for lines in (changes(kind), SCHEMA)]


SQL = tuple(
    f" {word} ".encode() for word in (*VALUES, *chain(*TABLES.values()), "WHERE record % 2")
)


# --- Guardian log -----------------------------------------------------------------------


def check_guardian_log(data: bytes, folder: Path) -> None:
    with patch.dict(os.environ, TREX_STUDIO_DATA=str(folder)):
        log_file().write_bytes(data)
        assert logged_stops(0)[0] == len(data)


GUARDIAN = (b"confirmed", b"repeated", b"lost", b": ", b" ", b"\n", b"\xff", b"\0", b"x" * 70_000)
POSES = (b"Pose=", b"Seq=", b"Nuke=", b":", b"|", b", ", b"\r", b"\n", b"\xff", b"\x85", b"\0")
BENCH = (
    b"# ",
    b": ",
    b",",
    b'"',
    b"\n",
    b"\0",
    b"\r",
    b"nan",
    b"\xef\xbb\xbf",
    b"\x1c",
    b"x" * 140_000,
)


def pose_samples() -> Sequence[bytes]:
    return [resource("aracna/sample.ppr").read_bytes(), b"Aracna:8:1024\nPose=a:1\nSeq=s: a|5\n"]


def guardian_samples() -> Sequence[bytes]:
    lines = b"2026-11-23 12:03:05 confirmed: Text.\n2026-11-24 07:00:00 unconfirmed: Text.\n"
    return [lines, lines[:-1]]


# --- Transcripts ------------------------------------------------------------------------

TRANSCRIPT = (b"\t", b"\n", b"\r", b"\x85", b"\0", b"#", b"81", b"AF 7F 7F 55 2A", b"9999-12-31")


def _transcript_samples() -> Sequence[bytes]:
    rows = "2026-11-23 12:00:00.000+00:00\t\t81\t54 52 65 58 31 2E 32\t8.0\tget signature\n"
    rows += "2026-11-23 12:00:00.100+00:00\t\tAF 07 0F 55 2A\t00\t8.0\tset\n"
    rows += "2026-11-23 12:00:00.200+00:00\t!\t9F 7E\t25\t8.0\tget\n"
    return [(transcript.header() + rows).encode(), (transcript.header() + rows[:60]).encode()]


def check_transcript(data: bytes, folder: Path) -> None:
    text = data.decode("utf-8", "replace")
    try:
        rows = list(transcript.read_transcript(text, "it", TrexDecoder()))
    except SettingsError as error:
        _check_findings(error.findings, data, rejected=True)
        return
    for row, received in RecordedTraffic.of(rows[:10]).replayed():
        assert received != row.received


FILE_TARGETS = (
    Target("transcripts", mutations(_transcript_samples, TRANSCRIPT), check_transcript),
    Target("guardian_log", mutations(guardian_samples, GUARDIAN), check_guardian_log),
    Target("settings", mutations(settings_samples, YAML), check_settings, examples=12),
    Target("board_records", mutations(_record_samples, YAML), check_record, examples=10),
    Target("snapshots", mutations(_snapshot_samples, YAML), check_snapshot, examples=10),
    Target("poses", mutations(pose_samples, POSES), check_poses),
    Target("bench", mutations(lambda: [to_csv(SAVED).encode()], BENCH), check_bench),
    Target(
        "gamepad", mutations(lambda: [GamepadProfile().to_text().encode()], JSON), check_profile
    ),
    Target("eeprom", mutations(_eeprom_samples, JSON), check_eeprom),
    Target("recordings", mutations(recording_samples), check_recording, examples=15),
    Target("statements", mutations(_statement_samples, SQL), check_statements, examples=6),
)
