"""Only regular files are opened, and not in the thread of the window."""

import os
import shutil
from pathlib import Path

import pytest

from tests.devices.trex.recording.samples import drive_records, write
from tests.support.program import trex
from tests.support.window import WindowDriver

pipes = pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="needs named pipes")


@pytest.fixture
def recording(tmp_path: Path) -> Path:
    path = tmp_path / "a.trexrec"
    write(path, list(drive_records(5)))
    return path


@pipes
def test_pipe_that_is_dropped_or_opened_at_start_is_rejected(
    window: WindowDriver, recording: Path
) -> None:
    def expect_rejection(path: Path) -> None:
        window.wait_for_text("bannerText", path.name)
        window.wait_for_text("bannerText", "an ordinary file")
        window.click("bannerDismiss")

    for suffix in (".trexrec", ".txt", ".yaml", ".ppr"):
        path = recording.with_name(f"pipe{suffix}")
        os.mkfifo(path)
        window.drop(path)
        expect_rejection(path)
        if suffix in {".txt", ".ppr"}:
            window.program.open_file(path, connecting=False)
            expect_rejection(path)
    os.mkfifo(recording.with_name("a.trexrec-wal"))
    window.drop(recording)
    expect_rejection(recording)


def test_files_are_opened_while_the_window_responds(
    window: WindowDriver, recording: Path, tmp_path: Path
) -> None:
    """In virtual time, a thread starts only when the test advances the time."""
    other, text = recording.with_name("b.trexrec"), tmp_path / "a.txt"
    shutil.copy(recording, other)
    text.write_text("product: TReX\nserial_timeout: 5\n", encoding="utf-8")
    workspace = trex(window.program).workspace
    recordings, files = workspace.recordings, workspace.files
    for path in (recording, recording, other):  # the second attempt is ignored
        recordings.open_file(path)
    files.open_file(text)
    files.open_file(text)
    assert [*recordings.windows, *files.editors] == []
    window.open_page("motorsPage")
    window.wait_for_files()
    assert [each.player.path for each in recordings.windows] == [recording, other]
    assert [editor.document.path for editor in files.editors] == [text]
    recordings.close_all()
    files.close_all()

    recordings.open_file(recording)
    recording.unlink()
    window.wait_for_text("bannerText", "No such file")
    assert recordings.windows == []

    write(recording, list(drive_records(5)))
    recordings.open_file(recording)
    files.open_file(text)
    window.window.close()
    window.wait_for_files()
    assert [*recordings.windows, *files.editors] == []
