"""Internal errors in file threads, and undecodable names in files."""

import logging
import os
from functools import partial
from pathlib import Path

import pytest
from pytestqt.qtbot import QtBot

from tests.devices.trex.recording.samples import HEADER
from trex_gui.core.recording.kinds import Marker
from trex_gui.core.recording.store import RecordingWriter
from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.devices.trex.recording import FORMAT
from trex_gui.ui.devices.connection import ConnectionState
from trex_gui.ui.files import write_in_background
from trex_gui.ui.workers.file_worker import FileWorker
from trex_gui.ui.workers.record_thread import RecordThread


def fail(*_: object) -> int:
    raise ZeroDivisionError("on purpose")


def test_internal_error_in_a_worker_is_reported_and_logged(
    qtbot: QtBot, caplog: pytest.LogCaptureFixture
) -> None:
    worker = FileWorker(fail)
    worker.start()
    assert worker.wait(15_000)
    assert "Internal error" in str(worker.outcome.error)
    assert "ZeroDivisionError: on purpose" in caplog.text


@pytest.mark.skipif(os.name == "nt", reason="file names are Unicode on Windows")
def test_undecodable_port_name_is_saved_in_the_transcript(qtbot: QtBot, tmp_path: Path) -> None:
    device = Device()
    device.connect_to(ConnectionSettings(os.fsdecode(b"/dev/pts/\xe9")))
    qtbot.waitUntil(lambda: device.link is ConnectionState.DISCONNECTED)
    traffic, path = device.connection.traffic, tmp_path / "line.txt"
    write = partial(traffic.write, rows=traffic.everything.rows)
    with qtbot.waitSignal(device.notifier.info):
        write_in_background(device, path, write, device.notifier, str)
    assert "There is no port /dev/pts/\\udce9" in path.read_text(encoding="utf-8")
    qtbot.waitUntil(device.shut_down)


class MarkerRecorder(RecordThread[Marker]):
    """Recorder that is always available."""

    @property
    def is_available(self) -> bool:
        return True


@pytest.mark.parametrize("method", ["_create", "finish"])
def test_internal_error_ends_the_recording_with_a_failure(
    qtbot: QtBot,
    tmp_path: Path,
    caplog: pytest.LogCaptureFixture,
    monkeypatch: pytest.MonkeyPatch,
    method: str,
) -> None:
    monkeypatch.setattr(RecordingWriter, method, lambda writer, *_: fail(writer))
    recorder = MarkerRecorder()
    failures: list[str] = []
    ended: list[Path] = []
    recorder.failed.connect(failures.append)
    recorder.ended.connect(ended.append)
    with caplog.at_level(logging.ERROR):
        recorder.start_recording(tmp_path / "a.trexrec", FORMAT, HEADER)
        recorder.stop()
        qtbot.waitUntil(lambda: recorder.can_record)
    assert failures == [
        "Internal error while recording (ZeroDivisionError). The recording has ended."
    ]
    assert ended == []
    assert "on purpose" in caplog.text
