"""A session with a simulated board in virtual time, recorded and replayed equal.

An hour of it at full rate, 690,000 records through session, wire and board, takes some four
minutes of processor time (measured: 250 s): 60 ms a second of the session.
"""

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


def record_virtually(seconds: int, path: Path) -> list[Record]:
    """Record a session that drives and stops once a minute. Return its records."""
    what: list[Record] = []
    writer = RecordingWriter[Header, Record](path, FORMAT, HEADER)

    def put(*records: Record) -> None:
        what.extend(records)
        writer.write(records)

    class Recorded(SessionHarness):
        def record(self, report: Report) -> None:
            if isinstance(report, Batch):
                put(*report.samples)

    harness = Recorded(Board())
    harness.reports = _Sink(harness.record)  # type: ignore[assignment] # batches of an hour are not kept
    for minute in range(-(-seconds // 60)):
        begin = 60.0 * minute + 5
        drive = Drive.at(127 if minute % 2 else -90)

        def put_setpoint(at: float = begin, drive: Drive = drive) -> None:
            put(SetpointRecord(at, 1, drive))

        def stop(at: float = begin + 5) -> None:
            put(Marker(at, "stop", "Stop"))

        harness.script.at(begin, put_setpoint).at(begin, SetMotor(1, drive))
        harness.script.at(begin + 5, stop).at(begin + 5, Stop(minute))
    harness.script.at(seconds, lambda: None)
    harness.run()
    writer.finish()
    writer.close()
    return what


class _Sink:
    """Replaces the list of reports and passes each on."""

    def __init__(self, take: object) -> None:
        self._take = take

    def append(self, report: Report) -> None:
        assert callable(self._take)
        self._take(report)


def assert_replays_equal(what: list[Record], path: Path) -> None:
    recording = open_recording(path)
    assert read_all(recording) == what
    assert recording.problems == []
    for first in reversed(range(1, len(what) + 1, CHUNK)):
        assert recording.read(first, first + CHUNK - 1) == what[first - 1 : first - 1 + CHUNK]
    recording.close()


def test_recorded_seconds_of_session_replay_unchanged(tmp_path: Path) -> None:
    what = record_virtually(12, tmp_path / "a.trexrec")
    assert len(what) > 2 * CHUNK
    assert any(isinstance(record, SetpointRecord) for record in what)
    assert_replays_equal(what, tmp_path / "a.trexrec")


@pytest.mark.slow
@pytest.mark.timeout(1800)
def test_recorded_hour_of_session_replays_unchanged(tmp_path: Path) -> None:
    what = record_virtually(3600, tmp_path / "a.trexrec")
    assert len(what) > 600_000
    assert (tmp_path / "a.trexrec").stat().st_size < 18_000_000
    assert_replays_equal(what, tmp_path / "a.trexrec")
