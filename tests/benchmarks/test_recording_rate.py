"""Size and processor time of an hour of recording at full rate (690,000 records)."""

import contextlib
import math
import sqlite3
import time
from collections.abc import Callable
from pathlib import Path

from tests.benchmarks.conftest import ReportFigure
from tests.devices.trex.recording.samples import HEADER, drive_records, open_recording, write
from trex_gui.core.recording.export import export_span
from trex_gui.devices.trex.model.playback import Playback


def seconds(work: Callable[[], object]) -> float:
    """Return the processor time of some work."""
    start = time.process_time()
    work()
    return time.process_time() - start


def test_hour_is_written_loaded_and_exported(tmp_path: Path, figure: ReportFigure) -> None:
    path, records = tmp_path / "hour.trexrec", list(drive_records())
    writing = seconds(lambda: write(path, records))
    recording = open_recording(path)
    tables = [kind.name for kind in recording.kinds]

    def read_tables() -> None:
        with contextlib.closing(sqlite3.connect(path)) as database:
            for table in tables:
                database.execute(f"SELECT * FROM {table}").fetchall()

    def export(suffix: str) -> float:
        span, target = (-math.inf, math.inf), path.with_suffix(suffix)
        return seconds(lambda: export_span(recording, target, span, HEADER.values()))

    loader = Playback(open_recording(path)).loader()
    figure("recorded hour, size", path.stat().st_size / 1e6, "MB", at_most=18)
    figure("recorded hour, written", writing / len(records) * 1e6, "us/record")
    figure("recorded hour, tables read", seconds(read_tables), "s")
    figure("recorded hour, loaded for playback", seconds(lambda: loader(lambda _share: None)), "s")
    figure("recorded hour, exported as CSV", export(".csv"), "s")
    figure("recorded hour, exported as MCAP", export(".mcap"), "s")
    recording.close()
