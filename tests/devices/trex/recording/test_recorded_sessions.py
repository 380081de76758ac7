"""A session with a simulated board in virtual time, recorded and replayed equal.

An hour of it at full rate, 690,000 records through session, wire and board, takes some four
minutes of processor time (measured: 250 s): 60 ms a second of the session.
"""

from pathlib import Path

import pytest

from tests.devices.trex.recording.samples import HEADER, read
from tests.devices.trex.recording.test_csv import assert_equal
from tests.support.virtual import Stage
from trex_gui.devices.trex.driving.requests import SetMotor, Stop
from trex_gui.devices.trex.protocol.commands import Drive
from trex_gui.devices.trex.recording.files import open_recording, writer_for
from trex_gui.devices.trex.recording.recording import Marker, Record, SetpointRecord
from trex_gui.devices.trex.session.messages import Batch, Report
from trex_gui.devices.trex.simulator.firmware import Board


def record_virtually(seconds: int, folder: Path) -> list[Record]:
    """Run a session that drives and stops once a minute; record it in both formats.

    Returns what the line reported and what was asked, in order.
    """
    what: list[Record] = []
    files = [(folder / name).open("wb") for name in ("a.trexrec", "a.csv")]
    writers = [writer_for(Path(file.name), file, HEADER) for file in files]

    def put(*records: Record) -> None:
        what.extend(records)
        for writer in writers:
            writer.write(records)

    class Recorded(Stage):
        def take(self, report: Report) -> None:
            if isinstance(report, Batch):
                put(*report.samples)

    stage = Recorded(Board())
    stage.reports = _Sink(stage.take)  # type: ignore[assignment] # batches of an hour are not kept
    for minute in range(-(-seconds // 60)):
        begin = 60.0 * minute + 5
        drive = Drive.at(127 if minute % 2 else -90)

        def wish(at: float = begin, drive: Drive = drive) -> None:
            put(SetpointRecord(at, 1, drive))

        def stop(at: float = begin + 5) -> None:
            put(Marker(at, "stop", "Stop"))

        stage.script.at(begin, wish).at(begin, SetMotor(1, drive))
        stage.script.at(begin + 5, stop).at(begin + 5, Stop(minute))
    stage.script.at(seconds, lambda: None)
    stage.run()
    for writer, file in zip(writers, files, strict=True):
        writer.finish()
        file.close()
    return what


class _Sink:
    """Stands for the list of reports and hands each on."""

    def __init__(self, take: object) -> None:
        self._take = take

    def append(self, report: Report) -> None:
        assert callable(self._take)
        self._take(report)


def replays_equal(what: list[Record], folder: Path) -> None:
    exact = open_recording(folder / "a.trexrec")
    assert read(exact) == what
    assert exact.problems == []
    backwards = [exact.read(index) for index in reversed(range(len(exact.blocks)))]
    assert [record for block in reversed(backwards) for record in block] == what
    exact.close()
    table = open_recording(folder / "a.csv")
    assert_equal(read(table), what)
    assert table.problems == []
    table.close()


def test_recorded_minute_of_session_replays_unchanged(tmp_path: Path) -> None:
    what = record_virtually(60, tmp_path)
    assert len(what) > 9_000
    assert any(isinstance(record, SetpointRecord) for record in what)
    replays_equal(what, tmp_path)


@pytest.mark.slow
@pytest.mark.timeout(1800)
def test_recorded_hour_of_session_replays_unchanged(tmp_path: Path) -> None:
    what = record_virtually(3600, tmp_path)
    assert len(what) > 600_000
    assert (tmp_path / "a.trexrec").stat().st_size < 8_000_000
    replays_equal(what, tmp_path)
