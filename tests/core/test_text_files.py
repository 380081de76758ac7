"""Settings files on disk, and error messages."""

import os
import sys
from pathlib import Path

import pytest

from tests.devices.trex.settings.samples import factory
from trex_gui.core.files import LARGEST_FILE, SettingsError, load, save
from trex_gui.devices.trex.settings.reader import read_settings
from trex_gui.devices.trex.settings.writer import write_settings

posix = pytest.mark.skipif(sys.platform == "win32", reason="needs POSIX permissions and pipes")


def file_error(path: Path, text: str | None = None) -> str:
    """Return the error message for reading a file, or writing a text to it."""
    with pytest.raises(SettingsError) as caught:
        load(path) if text is None else save(path, text)
    assert caught.value.name == str(path)
    (found,) = caught.value.findings
    return str(found)


def test_saved_file_can_be_loaded_and_has_line_feeds(tmp_path: Path) -> None:
    path = tmp_path / "bench µ.txt"
    save(path, write_settings(factory()))
    assert read_settings(load(path)) == (factory(), ())
    assert b"\r" not in path.read_bytes()


@pytest.mark.parametrize("failing_call", ["os.fsync", "pathlib.Path.replace"])
def test_failed_save_keeps_old_file(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, failing_call: str
) -> None:
    def raise_disk_full(*arguments: object) -> None:
        raise OSError(28, "No space left on device")

    path = tmp_path / "bench.txt"
    save(path, "old\n")
    monkeypatch.setattr(failing_call, raise_disk_full)
    assert file_error(path, "new\n") == "it cannot be written: No space left on device"
    assert path.read_text() == "old\n"
    assert list(tmp_path.iterdir()) == [path]


def test_invalid_unicode_is_rejected_and_keeps_old_file(tmp_path: Path) -> None:
    path = tmp_path / "bench.txt"
    save(path, "old\n")
    assert file_error(path, "\ud800").startswith("it cannot be written: ")
    assert path.read_text() == "old\n"
    assert list(tmp_path.iterdir()) == [path]


@posix
def test_saved_file_keeps_permissions_and_new_file_gets_default(tmp_path: Path) -> None:
    path, other = tmp_path / "bench.txt", tmp_path / "other"
    save(path, "new\n")
    other.write_text("")
    assert path.stat().st_mode == other.stat().st_mode
    path.chmod(0o640)
    save(path, "newer\n")
    assert path.stat().st_mode & 0o777 == 0o640


def test_missing_file_or_folder_is_reported(tmp_path: Path) -> None:
    assert file_error(tmp_path / "none.txt") == "there is no such file"
    folder = tmp_path / "none"
    assert file_error(folder / "bench.txt", "new\n") == f"there is no folder {folder.resolve()}"


def test_folder_is_rejected(tmp_path: Path) -> None:
    assert file_error(tmp_path) == "it is a folder, not a file"
    assert file_error(tmp_path, "new\n") == "it is a folder, not a file"


def test_invalid_file_name_is_reported() -> None:
    assert file_error(Path("a\0b")).startswith("it cannot be read: ")
    assert file_error(Path("a\0b"), "new\n").startswith("it cannot be written: ")


@posix
def test_pipe_is_rejected_without_waiting(tmp_path: Path) -> None:
    pipe = tmp_path / "pipe"
    os.mkfifo(pipe)
    assert file_error(pipe) == "it is not an ordinary file"
    assert file_error(pipe, "new\n") == "it is not an ordinary file"


def test_permission_error_is_reported(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def forbidden(*arguments: object, **options: object) -> None:
        raise PermissionError(13, "Permission denied")

    path = tmp_path / "bench.txt"
    path.write_text("old\n")
    monkeypatch.setattr(Path, "open", forbidden)
    monkeypatch.setattr(os, "open", forbidden)
    assert file_error(path) == "it cannot be read: permission denied"
    assert file_error(path, "new\n") == "it cannot be written: permission denied"


def test_oversized_file_is_rejected_without_reading_all(tmp_path: Path) -> None:
    path = tmp_path / "huge.txt"
    with path.open("wb") as file:
        file.truncate(1 << 40 if sys.platform == "linux" else LARGEST_FILE + 1)
    assert file_error(path) == "is larger than 256 KiB; settings are never that large"
