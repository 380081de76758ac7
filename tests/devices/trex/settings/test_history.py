"""Snapshots of settings, and the limit of their number."""

import errno
import os
import subprocess
import sys
from dataclasses import replace
from datetime import UTC, datetime, timedelta
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from tests.devices.trex.settings.samples import factory
from tests.support.matrix import examples
from trex_gui.core.errors import BadRequest
from trex_gui.core.files import SettingsError
from trex_gui.devices.trex.settings.document import Settings
from trex_gui.devices.trex.settings.history import DEFAULT_LIMIT, LIMIT_FILE, Limit, SettingsHistory

NOON = datetime(2026, 11, 21, 12, 0, 0, tzinfo=UTC)


def board_settings(**values: int) -> Settings:
    settings = factory("trexjr")
    return replace(settings, parameters={**settings.parameters, **values})


@pytest.fixture
def history(tmp_path: Path) -> SettingsHistory:
    return SettingsHistory(tmp_path / "snapshots")


def save_snapshot(history: SettingsHistory, minutes: int = 0, **values: int) -> Path:
    settings = board_settings(**values)
    now = NOON + timedelta(minutes=minutes)
    return history.save(settings, adapter="FT232R (ttyUSB0)", reason="Apply", now=now).path


def test_new_history_is_empty_and_creates_no_folder(history: SettingsHistory) -> None:
    assert history.snapshots() == ()
    assert not history.folder.exists()


def test_snapshot_lists_time_board_adapter_and_reason(history: SettingsHistory) -> None:
    adapter, settings = "FT232R (ttyUSB0)", board_settings(device_number=9)
    saved = history.save(settings, adapter=adapter, reason="Apply", now=NOON)
    (snapshot,) = history.snapshots()
    assert snapshot == saved
    assert snapshot.taken == NOON
    assert (snapshot.product, snapshot.firmware) == ("TReX Jr", "1.2")
    assert snapshot.device_number == 9
    assert (snapshot.adapter, snapshot.reason) == (adapter, "Apply")


def test_newest_snapshot_is_first_even_within_one_second(history: SettingsHistory) -> None:
    paths = [save_snapshot(history, minutes, serial_timeout=minutes) for minutes in (2, 0, 1, 1, 1)]
    listed = [snapshot.path for snapshot in history.snapshots()]
    assert listed == [paths[0], paths[4], paths[3], paths[2], paths[1]]
    assert len(set(paths)) == 5


# --- Limit ------------------------------------------------------------------------------


def test_new_snapshot_is_retained_if_clock_goes_back(history: SettingsHistory) -> None:
    history.set_limit(2)
    for minutes in (10, 11):
        os.utime(save_snapshot(history, minutes), (1, 1))  # saved long ago by the time of the file
    newest = save_snapshot(history, -60)
    assert newest in {snapshot.path for snapshot in history.snapshots()}
    assert len(history.snapshots()) == 2


def test_snapshot_saved_at_the_same_time_is_retained(history: SettingsHistory) -> None:
    history.set_limit(1)
    other = save_snapshot(history, 1)
    os.utime(other, (2**32, 2**32))  # later than any snapshot of this program
    own = save_snapshot(history, 2)
    assert {snapshot.path for snapshot in history.snapshots()} == {own, other}


@pytest.mark.skipif(sys.platform == "win32", reason="links need a permission there")
def test_dangling_snapshot_link_does_not_block_new_snapshot(history: SettingsHistory) -> None:
    history.set_limit(1)
    link = save_snapshot(history)
    link.unlink()
    link.symlink_to(history.folder / "missing")
    own = save_snapshot(history, 1)
    assert [snapshot.path for snapshot in history.snapshots()] == [own]


def test_named_snapshot_is_retained_beyond_the_limit(history: SettingsHistory) -> None:
    history.set_limit(1)
    path = save_snapshot(history, 0)
    (first,) = history.snapshots()
    history.label(first, name="before the\tcontest")
    save_snapshot(history, 1)
    newest = save_snapshot(history, 2)
    assert [snapshot.path for snapshot in history.snapshots()] == [newest, path]
    assert history.set_limit(1) == ()
    history.label(first, name="")
    assert [snapshot.path for snapshot in history.set_limit(1)] == [path]


def test_name_and_note_change_no_settings(history: SettingsHistory) -> None:
    path = save_snapshot(history)
    before = path.read_bytes()
    (snapshot,) = history.snapshots()
    history.label(snapshot, name=" new   tyres ", note="run 3\nas fast as run 2")
    (labelled,) = history.snapshots()
    assert (labelled.name, labelled.note) == ("new tyres", "run 3 as fast as run 2")
    assert history.load(labelled) == board_settings()
    assert labelled.reason == "Apply"
    for invalid in ({"name": "x" * 61}, {"note": "x" * 301}, {"name": " 2 "}):
        with pytest.raises(BadRequest):
            history.label(labelled, **invalid)
    save_snapshot(history, 1)
    with pytest.raises(BadRequest, match="Another snapshot"):
        history.label(history.snapshots()[0], name="new  tyres")
    history.label(labelled, name="", note="")
    assert path.read_bytes() == before


def test_history_without_limit_removes_nothing(history: SettingsHistory) -> None:
    history.set_limit(None)
    for minutes in range(12):
        save_snapshot(history, minutes)
    assert len(history.snapshots()) == 12
    assert history.limit() == Limit(None)


def test_limit_of_zero_is_rejected(history: SettingsHistory) -> None:
    with pytest.raises(ValueError, match="1 to 9999999"):
        history.set_limit(0)
    assert history.limit() == Limit(DEFAULT_LIMIT)


def test_limit_of_all_programs_removes_oldest_snapshots(history: SettingsHistory) -> None:
    history.set_limit(2)
    other = SettingsHistory(history.folder)
    assert other.limit() == Limit(2)
    paths = [save_snapshot(other, minutes) for minutes in range(4)]
    assert {snapshot.path for snapshot in history.snapshots()} == set(paths[2:])


def test_lower_limit_removes_and_returns_oldest_snapshots(history: SettingsHistory) -> None:
    paths = [save_snapshot(history, minutes) for minutes in range(5)]
    excess = history.excess(2)
    assert [snapshot.path for snapshot in excess] == paths[2::-1]
    assert history.set_limit(2) == excess
    assert [snapshot.path for snapshot in history.snapshots()] == paths[:2:-1]
    assert history.set_limit(500) == ()


@pytest.mark.parametrize("text", ["kept: 7\n", "# mine\n\n kept:7 # a week\n", "\ufeffkept: 7\r\n"])
def test_limit_file_may_be_written_by_hand(history: SettingsHistory, text: str) -> None:
    history.folder.mkdir()
    (history.folder / LIMIT_FILE).write_bytes(text.encode())
    assert history.limit() == Limit(7)


@pytest.mark.parametrize(
    "text",
    [
        *("", "kept: 0", "kept: -1", "kept: many", "kept: 2 3", "kept: 1\nkept: 2", "2", "\x00"),
        *("kept: 99999999", "kept: 2" + " " * 5000, "kept: 1.5", "KEPT"),
    ],
)
def test_damaged_limit_removes_nothing_and_is_reported(history: SettingsHistory, text: str) -> None:
    history.set_limit(2)
    (history.folder / LIMIT_FILE).write_text(text, encoding="utf-8")
    for minutes in range(4):
        save_snapshot(history, minutes)
    assert len(history.snapshots()) == 4
    assert history.limit().count is None
    assert "is damaged" in history.limit().problem
    history.set_limit(3)
    assert history.limit() == Limit(3)
    assert len(history.snapshots()) == 3


def test_unreadable_limit_is_reported_and_cannot_be_set(history: SettingsHistory) -> None:
    (history.folder / LIMIT_FILE).mkdir(parents=True)
    save_snapshot(history)
    save_snapshot(history, 1)
    assert "cannot be read" in history.limit().problem
    with pytest.raises(SettingsError):
        history.set_limit(1)
    assert len(history.snapshots()) == 2


@pytest.mark.skipif(sys.platform == "win32", reason="links need a permission there")
def test_dangling_limit_link_is_reported(history: SettingsHistory) -> None:
    history.folder.mkdir()
    (history.folder / LIMIT_FILE).symlink_to(history.folder / "missing")
    assert "is missing" in history.limit().problem


def test_limit_that_cannot_be_saved_removes_nothing(
    history: SettingsHistory, monkeypatch: pytest.MonkeyPatch
) -> None:
    for minutes in range(3):
        save_snapshot(history, minutes)
    monkeypatch.setattr("pathlib.Path.replace", no_space)
    with pytest.raises(SettingsError, match="No space left"):
        history.set_limit(1)
    assert len(history.snapshots()) == 3
    assert history.limit() == Limit(DEFAULT_LIMIT)


# --- Concurrent and failed saves --------------------------------------------------------


def no_space(*arguments: object) -> None:
    raise OSError(errno.ENOSPC, "No space left on device")


_SAVE_MANY = """
import sys
from dataclasses import replace
from datetime import UTC, datetime
from pathlib import Path
from trex_gui.devices.trex.protocol.device_table import device_table
from trex_gui.devices.trex.settings.document import Settings
from trex_gui.devices.trex.settings.history import SettingsHistory
history = SettingsHistory(Path(sys.argv[1]))
model = device_table().model("trexjr")
sys.stdin.readline()
for number in range(20):
    settings = Settings(model, "1.2", {"serial_timeout": int(sys.argv[2]) + number})
    history.save(settings, adapter="", reason="", now=datetime(2026, 11, 21, tzinfo=UTC))
"""


def test_programs_saving_in_same_second_lose_no_snapshot(history: SettingsHistory) -> None:
    programs = [
        subprocess.Popen(
            [sys.executable, "-c", _SAVE_MANY, str(history.folder), str(first)],
            stdin=subprocess.PIPE,
            text=True,
        )
        for first in (1, 51)
    ]
    for program in programs:
        assert program.stdin is not None
        program.stdin.write("now\n")
        program.stdin.close()
    assert [program.wait(50) for program in programs] == [0, 0]
    values = [
        history.load(snapshot).parameters["serial_timeout"] for snapshot in history.snapshots()
    ]
    assert sorted(values) == [*range(1, 21), *range(51, 71)]
    assert len(list(history.folder.iterdir())) == 40


@pytest.mark.parametrize(
    "failing", ["os.fsync", "pathlib.Path.hardlink_to pathlib.Path.replace pathlib.Path.rename"]
)
def test_failed_save_leaves_no_partial_snapshot(
    history: SettingsHistory, monkeypatch: pytest.MonkeyPatch, failing: str
) -> None:
    save_snapshot(history)
    before = sorted(history.folder.iterdir())
    with monkeypatch.context() as patched:
        for name in failing.split():
            patched.setattr(name, no_space)
        with pytest.raises(SettingsError, match="No space left"):
            save_snapshot(history, 1)
    assert sorted(history.folder.iterdir()) == before


@pytest.mark.skipif(sys.platform == "win32", reason="needs no hard links there")
def test_snapshots_are_saved_without_hard_links(
    history: SettingsHistory, monkeypatch: pytest.MonkeyPatch
) -> None:
    def fail(*arguments: object) -> None:
        raise PermissionError(errno.EPERM, "Operation not permitted")

    monkeypatch.setattr("pathlib.Path.hardlink_to", fail)
    first, second = save_snapshot(history), save_snapshot(history)
    assert first != second
    assert sorted(history.folder.iterdir()) == sorted([first, second])
    assert all(history.load(saved) == board_settings() for saved in history.snapshots())


def test_leftover_temporary_file_is_not_listed(history: SettingsHistory) -> None:
    path = save_snapshot(history)
    path.rename(path.with_name(f".{path.name}.1a2b3c4d.trexdraft"))
    assert history.snapshots() == ()


# --- Files in the folder ----------------------------------------------------------------


def test_limit_removes_no_unrelated_files(history: SettingsHistory) -> None:
    history.set_limit(1)
    save_snapshot(history)
    names = ["notes.txt", "20261121T115900Z.txt", "20261121T115900Z-trex-1.2.txt.bak", "x"]
    for name in names:
        (history.folder / name).write_text("mine", encoding="utf-8")
    save_snapshot(history, 1)
    assert {path.name for path in history.folder.iterdir()} > set(names)
    assert len(history.snapshots()) == 1


@pytest.mark.parametrize(
    ("data", "product", "problem"),
    [
        (b"", "", "It is empty."),
        (b"product: Jrk 12v12\n", "Jrk 12v12", "It does not name its board."),
        (b"\xff\x00 no settings", "", "It does not name its board."),
    ],
)
def test_damaged_snapshot_is_listed_with_its_problem(
    history: SettingsHistory, data: bytes, product: str, problem: str
) -> None:
    save_snapshot(history).write_bytes(data)
    (snapshot,) = history.snapshots()
    assert (snapshot.taken, snapshot.product, snapshot.problem) == (NOON, product, problem)
    with pytest.raises(SettingsError):
        history.load(snapshot)


@pytest.mark.skipif(sys.platform == "win32", reason="Windows has no pipes with a path")
def test_pipe_among_the_snapshots_is_not_opened(history: SettingsHistory) -> None:
    history.folder.mkdir(parents=True, exist_ok=True)
    os.mkfifo(history.folder / "20260101T120000Z-trex-1.3.txt")
    os.mkfifo(history.folder / "history.txt")
    (snapshot,) = history.snapshots()
    assert snapshot.problem == "The file cannot be read: it is not an ordinary file."
    assert "cannot be read" in history.limit().problem


def test_product_and_firmware_are_read_in_any_notation(history: SettingsHistory) -> None:
    save_snapshot(history).write_bytes(b"product: TReX Jr  # mine\r\n\r\nfirmware: '1.2'\r\n")
    (snapshot,) = history.snapshots()
    assert (snapshot.product, snapshot.firmware, snapshot.problem) == ("TReX Jr", "1.2", "")


def test_load_of_removed_snapshot_reports_missing_file(history: SettingsHistory) -> None:
    save_snapshot(history)
    (snapshot,) = history.snapshots()
    history.remove(snapshot)
    history.remove(snapshot)
    assert history.snapshots() == ()
    with pytest.raises(SettingsError, match="no such file"):
        history.load(snapshot)


def test_snapshot_that_cannot_be_removed_is_reported(history: SettingsHistory) -> None:
    path = save_snapshot(history)
    path.unlink()
    path.mkdir()
    (snapshot,) = history.snapshots()
    with pytest.raises(SettingsError, match="cannot be removed"):
        history.remove(snapshot)


def test_folder_that_cannot_be_created_is_reported(tmp_path: Path) -> None:
    (tmp_path / "snapshots").write_text("", encoding="utf-8")
    with pytest.raises(SettingsError, match="snapshots: it cannot be written"):
        save_snapshot(SettingsHistory(tmp_path / "snapshots"))


@examples(15)
@given(adapter=st.text(max_size=80), reason=st.text(max_size=80))
def test_snapshot_accepts_any_adapter_and_reason(
    tmp_path_factory: pytest.TempPathFactory, adapter: str, reason: str
) -> None:
    history = SettingsHistory(tmp_path_factory.mktemp("history"))
    settings = board_settings()
    snapshot = history.save(settings, adapter=adapter, reason=reason)
    assert history.load(snapshot) == settings
    assert [saved.path for saved in history.snapshots()] == [snapshot.path]


def test_default_folder_is_absolute_and_names_program(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.delenv("TREX_STUDIO_DATA", raising=False)
    assert SettingsHistory().folder.is_absolute()
    assert "TReX Studio" in str(SettingsHistory().folder)


def test_environment_variable_sets_data_folder(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    monkeypatch.setenv("TREX_STUDIO_DATA", str(tmp_path))
    assert SettingsHistory().folder == tmp_path / "snapshots"
