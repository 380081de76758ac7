"""Recordings of a session with a simulated board in virtual time.

An hour at full rate has 690,000 records and takes 250 s of processor time.
"""

from functools import partial
from pathlib import Path

import pytest

from tests.devices.trex.recording.samples import HEADER, open_recording, read_all
from tests.support.virtual import SessionHarness
from trex_gui.core.recording.kinds import Marker
from trex_gui.core.recording.store import CHUNK, RecordingWriter
from trex_gui.devices.trex.driving.requests import SetMotor, Stop
from trex_gui.devices.trex.protocol.driving import Drive
from trex_gui.devices.trex.recording import FORMAT, Header, Record, SetpointRecord
from trex_gui.devices.trex.session.messages import Batch, Report
from trex_gui.devices.trex.simulator.firmware import Board


def record_session(seconds: int, path: Path) -> list[Record]:
    """Record a session that drives and stops once a minute. Return its records."""
    recorded: list[Record] = []
    writer = RecordingWriter[Header, Record](path, FORMAT, HEADER)

    def record(*records: Record) -> None:
        recorded.extend(records)
        writer.write(records)

    class BatchRecorder(list[Report]):
        """List that records the samples of each report and then discards the report."""

        def append(self, report: Report) -> None:
            if isinstance(report, Batch):
                record(*report.samples)

    harness = SessionHarness(Board())
    harness.reports = BatchRecorder()
    for minute in range(-(-seconds // 60)):
        begin = 60.0 * minute + 5
        drive = Drive.at(127 if minute % 2 else -90)

        setpoint, stop = SetpointRecord(begin, 1, drive), Marker(begin + 5, "stop", "Stop")
        harness.script.at(begin, partial(record, setpoint)).at(begin, SetMotor(1, drive))
        harness.script.at(begin + 5, partial(record, stop)).at(begin + 5, Stop(minute))
    harness.script.at(seconds, lambda: None)
    harness.run()
    writer.finish()
    writer.close()
    return recorded


def assert_read_as_written(path: Path, records: list[Record]) -> None:
    recording = open_recording(path)
    assert read_all(recording) == records
    assert recording.problems == []
    for first in reversed(range(1, len(records) + 1, CHUNK)):
        assert recording.read(first, first + CHUNK - 1) == records[first - 1 : first - 1 + CHUNK]
    recording.close()


def test_recorded_seconds_of_session_are_read_unchanged(tmp_path: Path) -> None:
    records = record_session(12, tmp_path / "a.trexrec")
    assert len(records) > 2 * CHUNK
    assert any(isinstance(record, SetpointRecord) for record in records)
    assert_read_as_written(tmp_path / "a.trexrec", records)


@pytest.mark.slow
@pytest.mark.timeout(1800)
def test_recorded_hour_of_session_is_read_unchanged(tmp_path: Path) -> None:
    records = record_session(3600, tmp_path / "a.trexrec")
    assert len(records) > 600_000
    assert (tmp_path / "a.trexrec").stat().st_size < 18_000_000
    assert_read_as_written(tmp_path / "a.trexrec", records)
