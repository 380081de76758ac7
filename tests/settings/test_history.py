"""Snapshots: nothing is lost, nothing is removed that the bound does not say."""

import errno
import os
import subprocess
import sys
from datetime import UTC, datetime, timedelta
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from trex_gui.protocol.calibration import Calibration
from trex_gui.protocol.device_table import device_table
from trex_gui.protocol.flags import InputSource
from trex_gui.protocol.parameters import parameters_of
from trex_gui.settings.document import Settings
from trex_gui.settings.errors import SettingsError
from trex_gui.settings.history import BOUND_FILE, KEPT, Bound, History, default_folder

NOON = datetime(2026, 11, 21, 12, 0, 0, tzinfo=UTC)


def settings_of_a_board(**values: int) -> Settings:
    model = device_table().model("trexjr")
    parameters = {spec.key: spec.default for spec in parameters_of("trexjr", "1.2").readable}
    calibrations = {(InputSource.RC, 1): Calibration(2600, 3700, 5100, 60)}
    return Settings(model, "1.2", {**parameters, **values}, calibrations)


@pytest.fixture
def history(tmp_path: Path) -> History:
    return History(tmp_path / "snapshots")


def take(history: History, minutes: int = 0, **values: int) -> Path:
    settings = settings_of_a_board(**values)
    now = NOON + timedelta(minutes=minutes)
    return history.take(settings, adapter="FT232R (ttyUSB0)", reason="Apply", now=now).path


def test_a_new_history_is_empty_and_makes_no_folder(history: History) -> None:
    assert history.snapshots() == ()
    assert not history.folder.exists()


def test_what_was_taken_reads_back_the_same(history: History) -> None:
    settings = settings_of_a_board(serial_timeout=5)
    snapshot = history.take(settings, adapter="/dev/ttyUSB0", reason="Apply of 2 settings")
    assert history.load(snapshot) == settings
    assert history.snapshots() == (snapshot,)


def test_the_list_says_when_why_and_of_which_board(history: History) -> None:
    take(history, device_number=9)
    (snapshot,) = history.snapshots()
    assert snapshot.taken == NOON
    assert (snapshot.product, snapshot.firmware) == ("TReX Jr", "1.2")
    assert snapshot.device_number == 9
    assert (snapshot.adapter, snapshot.reason) == ("FT232R (ttyUSB0)", "Apply")


def test_the_newest_comes_first_also_within_a_second(history: History) -> None:
    paths = [take(history, minutes, serial_timeout=minutes) for minutes in (2, 0, 1, 1, 1)]
    listed = [snapshot.path for snapshot in history.snapshots()]
    assert listed == [paths[0], paths[4], paths[3], paths[2], paths[1]]
    assert len(set(paths)) == 5


# --- How many are kept ------------------------------------------------------------------


def test_only_the_bound_removes_and_the_oldest_goes_first(history: History) -> None:
    history.keep(3)
    paths = [take(history, minutes) for minutes in range(5)]
    assert {snapshot.path for snapshot in history.snapshots()} == set(paths[2:])


def test_the_one_just_taken_stays_though_the_clock_went_back(history: History) -> None:
    history.keep(2)
    for minutes in (10, 11):
        os.utime(take(history, minutes), (1, 1))  # saved before, by whatever clock
    newest = take(history, -60)
    assert newest in {snapshot.path for snapshot in history.snapshots()}
    assert len(history.snapshots()) == 2


def test_what_another_program_saved_at_the_same_time_is_left_to_it(history: History) -> None:
    history.keep(1)
    other = take(history, 1)
    os.utime(other, (2**32, 2**32))  # after anything saved now
    own = take(history, 2)
    assert {snapshot.path for snapshot in history.snapshots()} == {own, other}


@pytest.mark.skipif(sys.platform == "win32", reason="links need a permission there")
def test_snapshot_whose_file_is_gone_does_not_keep_another_from_being_taken(
    history: History,
) -> None:
    history.keep(1)
    gone = take(history)
    gone.unlink()
    gone.symlink_to(history.folder / "elsewhere")
    own = take(history, 1)
    assert [snapshot.path for snapshot in history.snapshots()] == [own]


def test_without_a_bound_nothing_goes(history: History) -> None:
    history.keep(None)
    for minutes in range(12):
        take(history, minutes)
    assert len(history.snapshots()) == 12
    assert history.bound() == Bound(None)


def test_a_history_of_nothing_is_refused(history: History) -> None:
    with pytest.raises(ValueError, match="at least one"):
        history.keep(0)
    assert history.bound() == Bound(KEPT)


def test_what_one_program_sets_another_keeps_to(history: History) -> None:
    history.keep(2)
    other = History(history.folder)
    assert other.bound() == Bound(2)
    for minutes in range(4):
        take(other, minutes)
    assert len(history.snapshots()) == 2


def test_a_lower_bound_removes_the_oldest_at_once_and_says_which(history: History) -> None:
    paths = [take(history, minutes) for minutes in range(5)]
    beyond = history.beyond(2)
    assert [snapshot.path for snapshot in beyond] == paths[2::-1]
    assert history.keep(2) == beyond
    assert [snapshot.path for snapshot in history.snapshots()] == paths[:2:-1]
    assert history.keep(500) == ()


@pytest.mark.parametrize("text", ["kept: 7\n", "# mine\n\n kept:7 # a week\n", "\ufeffkept: 7\r\n"])
def test_a_bound_may_be_written_by_hand(history: History, text: str) -> None:
    history.folder.mkdir()
    (history.folder / BOUND_FILE).write_bytes(text.encode())
    assert history.bound() == Bound(7)


@pytest.mark.parametrize(
    "text",
    [
        *("", "kept: 0", "kept: -1", "kept: many", "kept: 2 3", "kept: 1\nkept: 2", "2", "\x00"),
        *("kept: 99999999", "kept: 2" + " " * 5000, "kept: 1.5", "KEPT"),
    ],
)
def test_a_damaged_bound_removes_nothing_and_says_so(history: History, text: str) -> None:
    history.keep(2)
    (history.folder / BOUND_FILE).write_text(text, encoding="utf-8")
    for minutes in range(4):
        take(history, minutes)
    assert len(history.snapshots()) == 4
    assert history.bound().kept is None
    assert "is damaged" in history.bound().problem
    history.keep(3)
    assert history.bound() == Bound(3)
    assert len(history.snapshots()) == 3


def test_a_bound_that_cannot_be_read_removes_nothing_and_says_so(history: History) -> None:
    (history.folder / BOUND_FILE).mkdir(parents=True)
    take(history)
    assert "cannot be read" in history.bound().problem
    with pytest.raises(SettingsError):
        history.keep(1)


@pytest.mark.skipif(sys.platform == "win32", reason="links need a permission there")
def test_a_bound_that_was_linked_to_and_is_gone_removes_nothing(history: History) -> None:
    history.folder.mkdir()
    (history.folder / BOUND_FILE).symlink_to(history.folder / "elsewhere")
    assert "is missing" in history.bound().problem


def test_a_bound_that_cannot_be_saved_removes_nothing(
    history: History, monkeypatch: pytest.MonkeyPatch
) -> None:
    for minutes in range(3):
        take(history, minutes)
    monkeypatch.setattr("pathlib.Path.replace", no_space)
    with pytest.raises(SettingsError, match="No space left"):
        history.keep(1)
    assert len(history.snapshots()) == 3
    assert history.bound() == Bound(KEPT)


# --- Several at once, and the end in the middle -----------------------------------------


def no_space(*arguments: object) -> None:
    raise OSError(errno.ENOSPC, "No space left on device")


_MANY = """
import sys
from datetime import UTC, datetime
from pathlib import Path
from tests.settings.test_history import settings_of_a_board
from trex_gui.settings.history import History
history = History(Path(sys.argv[1]))
sys.stdin.readline()
for number in range(20):
    settings = settings_of_a_board(serial_timeout=int(sys.argv[2]) + number)
    history.take(settings, adapter="", reason="", now=datetime(2026, 11, 21, tzinfo=UTC))
"""


def test_two_programs_in_the_same_second_lose_nothing(history: History) -> None:
    programs = [
        subprocess.Popen(
            [sys.executable, "-c", _MANY, str(history.folder), str(first)],
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
    taken = [history.load(found).parameters["serial_timeout"] for found in history.snapshots()]
    assert sorted(taken) == [*range(1, 21), *range(51, 71)]
    assert len(list(history.folder.iterdir())) == 40


@pytest.mark.parametrize("failing", ["os.fsync", "pathlib.Path.hardlink_to pathlib.Path.replace"])
def test_the_end_in_the_middle_of_a_save_leaves_no_half_snapshot(
    history: History, monkeypatch: pytest.MonkeyPatch, failing: str
) -> None:
    take(history)
    before = sorted(history.folder.iterdir())
    with monkeypatch.context() as patched:
        for name in failing.split():
            patched.setattr(name, no_space)
        with pytest.raises(SettingsError, match="No space left"):
            take(history, 1)
    assert sorted(history.folder.iterdir()) == before


@pytest.mark.skipif(sys.platform == "win32", reason="needs no hard links there")
def test_a_disk_without_hard_links_keeps_snapshots_too(
    history: History, monkeypatch: pytest.MonkeyPatch
) -> None:
    def impossible(*arguments: object) -> None:
        raise PermissionError(errno.EPERM, "Operation not permitted")

    monkeypatch.setattr("pathlib.Path.hardlink_to", impossible)
    first, second = take(history), take(history)
    assert first != second
    assert sorted(history.folder.iterdir()) == sorted([first, second])
    assert all(history.load(found) == settings_of_a_board() for found in history.snapshots())


def test_a_draft_that_a_power_failure_left_is_no_snapshot(history: History) -> None:
    path = take(history)
    path.rename(path.with_name(f".{path.name}.1a2b3c4d.tmp"))
    assert history.snapshots() == ()


# --- What is there ----------------------------------------------------------------------


def test_other_files_are_left_alone(history: History) -> None:
    history.keep(1)
    take(history)
    names = ["notes.txt", "20261121T115900Z.txt", "20261121T115900Z-trex-1.2.txt.bak", "x"]
    for name in names:
        (history.folder / name).write_text("mine", encoding="utf-8")
    take(history, 1)
    assert {path.name for path in history.folder.iterdir()} > set(names)
    assert len(history.snapshots()) == 1


def test_a_damaged_snapshot_is_listed_and_says_what_is_wrong(history: History) -> None:
    path = take(history)
    path.write_bytes(b"\xff\x00 nothing of use")
    (snapshot,) = history.snapshots()
    assert snapshot.taken == NOON
    assert snapshot.product == ""
    assert snapshot.problem == "It does not say of which board it is."
    with pytest.raises(SettingsError):
        history.load(snapshot)


@pytest.mark.parametrize(
    ("text", "problem"),
    [
        ("", "It is empty."),
        ("product: Jrk 12v12\n", "It does not say of which board it is."),
        ("product: TReX Jr  # mine\r\n\r\nfirmware: '1.2'\r\n", ""),
    ],
)
def test_the_list_tells_what_the_head_tells(history: History, text: str, problem: str) -> None:
    take(history).write_bytes(text.encode())
    (snapshot,) = history.snapshots()
    assert snapshot.problem == problem
    if not problem:
        assert (snapshot.product, snapshot.firmware) == ("TReX Jr", "1.2")


def test_a_snapshot_that_is_gone_says_so(history: History) -> None:
    take(history)
    (snapshot,) = history.snapshots()
    history.remove(snapshot)
    history.remove(snapshot)
    assert history.snapshots() == ()
    with pytest.raises(SettingsError, match="no such file"):
        history.load(snapshot)


@pytest.mark.skipif(os.name == "nt" or os.geteuid() == 0, reason="root may write everywhere")
def test_a_folder_that_cannot_be_made_is_a_sentence(tmp_path: Path) -> None:
    tmp_path.chmod(0o500)
    with pytest.raises(SettingsError, match="cannot be made"):
        take(History(tmp_path / "snapshots"))


def test_a_folder_that_is_a_file_is_a_sentence(tmp_path: Path) -> None:
    (tmp_path / "snapshots").write_text("", encoding="utf-8")
    with pytest.raises(SettingsError, match="cannot be made"):
        take(History(tmp_path / "snapshots"))


@given(adapter=st.text(max_size=80), reason=st.text(max_size=80))
def test_no_adapter_and_no_reason_can_break_a_snapshot(
    tmp_path_factory: pytest.TempPathFactory, adapter: str, reason: str
) -> None:
    history = History(tmp_path_factory.mktemp("history"))
    settings = settings_of_a_board()
    snapshot = history.take(settings, adapter=adapter, reason=reason)
    assert history.load(snapshot) == settings
    assert [listed.path for listed in history.snapshots()] == [snapshot.path]


def test_the_folder_is_one_of_this_persons_data(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.delenv("TREX_STUDIO_DATA", raising=False)
    assert default_folder().is_absolute()
    assert "TReX Studio" in str(default_folder())


def test_the_environment_may_name_another_place(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    monkeypatch.setenv("TREX_STUDIO_DATA", str(tmp_path))
    assert History().folder == tmp_path / "snapshots"
