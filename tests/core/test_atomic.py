"""Atomic writes of files."""

import os
import sys
from pathlib import Path

import pytest

from trex_gui.core.files import NotOrdinaryFileError, atomic_file, open_ordinary


@pytest.mark.parametrize("name", ["a.csv", "設" * 80])  # the second name has 240 bytes
def test_file_is_replaced_when_completely_written(tmp_path: Path, name: str) -> None:
    path = tmp_path / name
    path.write_bytes(b"old")
    with atomic_file(path) as file:
        file.write(b"new")
        file.flush()
        assert path.read_bytes() == b"old"
    assert path.read_bytes() == b"new"
    assert list(tmp_path.iterdir()) == [path]


def test_interrupted_write_keeps_old_file(tmp_path: Path) -> None:
    path = tmp_path / "a.csv"
    path.write_bytes(b"old")

    def write_half() -> None:
        with atomic_file(path) as file:
            file.write(b"half")
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        write_half()
    assert path.read_bytes() == b"old"
    assert list(tmp_path.iterdir()) == [path]


@pytest.mark.skipif(sys.platform == "win32", reason="links need special rights on Windows")
def test_symlink_is_kept_and_points_to_new_file(tmp_path: Path) -> None:
    path, link = tmp_path / "a.csv", tmp_path / "link.csv"
    path.write_bytes(b"old")
    link.symlink_to(path)
    with atomic_file(link) as file:
        file.write(b"new")
    assert link.is_symlink()
    assert path.read_bytes() == b"new"


def write_to(path: Path) -> None:
    with atomic_file(path) as file:
        file.write(b"new")


def test_pipe_device_or_folder_is_not_overwritten(tmp_path: Path) -> None:
    others = [Path(os.devnull), tmp_path]
    if hasattr(os, "mkfifo"):
        others.append(tmp_path / "pipe")
        os.mkfifo(others[-1])
    for other in others:
        with pytest.raises(NotOrdinaryFileError):
            write_to(other)
        assert not other.is_file()


def test_old_draft_of_killed_program_is_removed(tmp_path: Path) -> None:
    abandoned, recent = (tmp_path / f".a.csv.0000000{n}.trexdraft" for n in (1, 2))
    log, foreign = tmp_path / f"{abandoned.name}-wal", tmp_path / ".a.csv.tmp"
    for path in (abandoned, log, recent, foreign):
        path.write_bytes(b"half")
    for path in (abandoned, log, foreign):
        os.utime(path, (0, 0))
    write_to(tmp_path / "b.csv")
    assert sorted(tmp_path.iterdir()) == sorted([recent, foreign, tmp_path / "b.csv"])


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="needs named pipes")
def test_file_replaced_by_pipe_does_not_block(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    path = tmp_path / "a.csv"
    os.mkfifo(path)
    monkeypatch.setattr("trex_gui.core.files.check_ordinary", lambda path: None)
    with pytest.raises(NotOrdinaryFileError, match="not an ordinary file"):
        open_ordinary(path)
