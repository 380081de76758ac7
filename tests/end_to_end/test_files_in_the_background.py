"""Files are opened outside the window's thread, and only ordinary ones."""

import os
import shutil
from collections.abc import Callable
from pathlib import Path

import pytest

from tests.devices.trex.recording.samples import an_hour, write
from tests.support.program import trex
from tests.support.window import WindowDriver

pipes = pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="needs named pipes")


@pytest.fixture
def recording(tmp_path: Path) -> Path:
    path = tmp_path / "a.trexrec"
    write(path, list(an_hour(5)))
    return path


@pipes
def test_pipe_dropped_or_named_at_the_start_is_rejected(
    window: WindowDriver, recording: Path
) -> None:
    def reject(path: Path, why: str = "an ordinary file") -> None:
        window.wait_for_text("bannerText", path.name)
        window.wait_for_text("bannerText", why)
        window.click("bannerDismiss")

    for suffix in (".trexrec", ".csv", ".txt", ".yaml", ".ppr"):
        path = recording.with_name(f"pipe{suffix}")
        os.mkfifo(path)
        window.drop(path)
        reject(path, "CSV" if suffix == ".csv" else "an ordinary file")
        if suffix in {".txt", ".ppr"}:
            window.program.open_named(path, connecting=False)
            reject(path)
    os.mkfifo(recording.with_name("a.trexrec-wal"))
    window.drop(recording)
    reject(recording)


def test_recording_is_opened_while_the_window_goes_on(
    window: WindowDriver, recording: Path
) -> None:
    """In virtual time a thread has not begun before the test lets time pass."""
    other = recording.with_name("b.trexrec")
    shutil.copy(recording, other)
    recordings = trex(window.program).workspace.recordings
    for path in (recording, recording, other):  # a second time: ignored
        recordings.open_file(path)
    assert recordings.windows == []
    window.open_page("motorsPage")
    window.wait_for_files()
    assert [each.player.path for each in recordings.windows] == [recording, other]
    recordings.close_all()


@pytest.mark.parametrize("meanwhile", ["vanishes", "window closes"])
def test_recording_may_change_its_mind_while_it_is_opened(
    window: WindowDriver, recording: Path, meanwhile: str
) -> None:
    recordings = trex(window.program).workspace.recordings
    recordings.open_file(recording)
    end: dict[str, Callable[[], object]] = {
        "vanishes": recording.unlink,
        "window closes": window.window.close,
    }
    end[meanwhile]()
    window.wait_for_files()
    assert recordings.windows == []
    if meanwhile == "vanishes":
        window.wait_for_text("bannerText", "No such file")


def test_settings_file_is_opened_while_the_window_goes_on(
    window: WindowDriver, tmp_path: Path
) -> None:
    path, files = tmp_path / "a.txt", trex(window.program).workspace.files
    path.write_text("product: TReX\nserial_timeout: 5\n", encoding="utf-8")
    files.open_file(path)
    files.open_file(path)
    assert files.editors == []
    window.wait_for_files()
    assert [editor.document.path for editor in files.editors] == [path]
    files.close_all()
    files.open_file(path)
    window.window.close()
    window.wait_for_files()
    assert files.editors == []
