"""Snapshots: nothing is lost, nothing is removed that the bound does not say."""

import os
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
from trex_gui.settings.history import History, default_folder

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


def test_only_the_bound_removes_and_the_oldest_goes_first(history: History) -> None:
    history.kept = 3
    paths = [take(history, minutes) for minutes in range(5)]
    assert {snapshot.path for snapshot in history.snapshots()} == set(paths[2:])


def test_the_one_just_taken_stays_though_the_clock_went_back(history: History) -> None:
    history.kept = 2
    take(history, 10)
    take(history, 11)
    newest = take(history, -60)
    assert newest in {snapshot.path for snapshot in history.snapshots()}
    assert len(history.snapshots()) == 2


def test_without_a_bound_nothing_goes(tmp_path: Path) -> None:
    history = History(tmp_path, kept=None)
    for minutes in range(12):
        take(history, minutes)
    assert len(history.snapshots()) == 12


def test_a_history_of_nothing_is_refused(tmp_path: Path) -> None:
    with pytest.raises(ValueError, match="at least one"):
        History(tmp_path, kept=0)


def test_other_files_are_left_alone(history: History) -> None:
    history.kept = 1
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
    with pytest.raises(SettingsError):
        history.load(snapshot)


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
