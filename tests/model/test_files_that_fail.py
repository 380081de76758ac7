"""A fault of the program in a thread that reads or writes a file is told as a failure."""

import logging
import os
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import BinaryIO

import pytest
from pytestqt.qtbot import QtBot

from trex_gui.link.settings import LinkSettings
from trex_gui.model.device import Device, Link
from trex_gui.model.file_saver import FileSaver
from trex_gui.model.record_thread import RecordThread
from trex_gui.model.transcript_saver import TranscriptSaver
from trex_gui.recording.recording import Marker
from trex_gui.worker.file_worker import Done, FileWorker, Tell
from trex_gui.worker.record_worker import Writer


def fail(_: object) -> int:
    raise ZeroDivisionError("on purpose")


def test_work_that_fails_by_a_fault_says_so(qtbot: QtBot, caplog: pytest.LogCaptureFixture) -> None:
    worker = FileWorker(fail)
    with qtbot.waitSignal(worker.done) as done:
        worker.start()
    assert worker.wait(15_000)
    assert isinstance(done.args, list)
    (outcome,) = done.args
    assert isinstance(outcome, Done)
    assert "fault of the program" in str(outcome.error)
    assert "ZeroDivisionError: on purpose" in caplog.text


def test_a_file_that_a_fault_ends_is_told_and_the_next_can_be_written(
    qtbot: QtBot, tmp_path: Path
) -> None:
    saver = FileSaver()
    with qtbot.waitSignal(saver.failed) as failed:
        saver.begin(tmp_path / "line.txt", fail)
    assert isinstance(failed.args, list)
    assert failed.args[0].startswith("line.txt was not written. A fault of the program")
    assert not saver.is_saving
    with qtbot.waitSignal(saver.saved) as saved:
        saver.begin(tmp_path / "line.txt", lambda _tell: 3)
    assert saved.args == [3, tmp_path / "line.txt"]


def test_a_thread_that_ends_without_a_word_is_told_as_a_failure(
    qtbot: QtBot, tmp_path: Path
) -> None:
    saver = FileSaver()

    def work(tell: Tell) -> int:
        while True:
            tell(0.0)

    saver.begin(tmp_path / "line.txt", work)
    worker = saver.findChild(FileWorker)
    assert worker is not None
    with qtbot.waitSignal(saver.failed) as failed:
        worker.cancel()
    assert failed.args == ["line.txt was not written."]
    assert not saver.is_saving


@pytest.mark.skipif(os.name == "nt", reason="names there are text")
def test_a_port_whose_name_is_no_text_is_in_the_transcript(qtbot: QtBot, tmp_path: Path) -> None:
    device = Device()
    device.connect_to(LinkSettings(os.fsdecode(b"/dev/pts/\xe9")))
    qtbot.waitUntil(lambda: device.link is Link.NONE)
    saver, path = TranscriptSaver(device.transcript), tmp_path / "line.txt"
    with qtbot.waitSignal(saver.saved):
        saver.save(path, device.transcript.everything.rows)
    assert "There is no port /dev/pts/\\udce9" in path.read_text(encoding="utf-8")
    qtbot.waitUntil(device.shut_down)


class Anything(RecordThread[Marker]):
    """A recorder of anything."""

    @property
    def is_there(self) -> bool:
        return True


class Odd:
    """Writes nothing, and fails at its end."""

    size = 0

    def write(self, records: Sequence[Marker]) -> None:
        pass

    def flush(self) -> None:
        pass

    def finish(self) -> None:
        raise ZeroDivisionError("on purpose")


@pytest.mark.parametrize("make", [fail, lambda _file: Odd()], ids=["beginning", "end"])
def test_a_recording_that_a_fault_ends_is_not_told_as_recorded(
    qtbot: QtBot,
    tmp_path: Path,
    caplog: pytest.LogCaptureFixture,
    make: Callable[[BinaryIO], Writer[Marker]],
) -> None:
    recorder = Anything()
    told: list[str] = []
    ended: list[Path] = []
    recorder.failed.connect(told.append)
    recorder.ended.connect(ended.append)
    with caplog.at_level(logging.ERROR):
        recorder.begin(tmp_path / "a.trexrec", 0.0, make)
        recorder.stop()
        qtbot.waitUntil(lambda: recorder.can_record)
    path = tmp_path / "a.trexrec"
    assert told == [f"{path} cannot be written: a fault of the program (ZeroDivisionError)."]
    assert ended == []
    assert "on purpose" in caplog.text
