"""Recordings of a robot to write and read: any that can be, and a session that could have been."""

from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from datetime import UTC, datetime
from functools import partial
from pathlib import Path
from random import Random
from typing import Any

import pytest
from hypothesis import strategies as st
from PySide6.QtCore import QThread

from trex_gui.devices.aracna.model.playback import RobotPlayback
from trex_gui.devices.aracna.recording import CsvWriter, FellSilent, Header, Row
from trex_gui.devices.aracna.recording.csv_reader import RobotCsvFile
from trex_gui.devices.aracna.session.messages import (
    Ending,
    Moved,
    Moving,
    Passed,
    PlayEnded,
    Restarted,
    SpeedsHeld,
    StepBegun,
    Stuck,
)
from trex_gui.devices.trex.recording.recording import Marker
from trex_gui.ui.playback.recording_loader import LoadedRecording
from trex_gui.ui.runtime import runtime
from trex_gui.ui.workers.file_worker import ProgressCallback

MOTORS = 8
HEADER = Header(datetime(2026, 1, 2, 3, 4, 5, tzinfo=UTC), 1234.5, version=1, motors=MOTORS)
T0 = HEADER.clock

RESOLUTION = 1e-6
"""Seconds to which times are written."""

_times = st.floats(0, 1e6).map(lambda seconds: T0 + seconds)
_seconds = st.floats(0, 1e5)
_places = st.integers(0, 1023)
_heard = st.integers(-1, 1023)


def _all(each: st.SearchStrategy[int]) -> st.SearchStrategy[tuple[int, ...]]:
    return st.tuples(*[each] * MOTORS)


rows: st.SearchStrategy[Row] = st.one_of(
    st.builds(Moving, _times, _all(_places), st.tuples(*[st.none() | _places] * MOTORS), _seconds),
    st.builds(Passed, _times, st.lists(_heard, max_size=MOTORS).map(tuple)),
    st.builds(Moved, _times, _all(_places), _all(_heard), _seconds),
    st.builds(SpeedsHeld, _times, _all(_places), _all(_heard)),
    st.builds(
        StepBegun,
        _times,
        st.sampled_from(["in", "steps", "out"]),
        st.integers(0, 1000),
        st.integers(0, 10_000),
        st.floats(-1, 1000),
    ),
    st.builds(PlayEnded, _times, st.sampled_from(Ending)),
    st.builds(Stuck, _times, st.none() | st.integers(0, MOTORS - 1)),
    st.builds(Restarted, _times, st.booleans()),
    st.builds(FellSilent, _times),
    st.builds(Marker, _times, st.sampled_from(["stop", "fault", "link"]), st.text(max_size=40)),
)


def session(moves: int = 20, *, seconds: float = 2.0, pause: float = 1.0) -> Iterator[Row]:
    """What is recorded of a robot that is sent to one place after the other.

    After half of them the board restarts, and is silent for as long as a motion takes.
    """
    random, time = Random(1), T0 + pause
    starts: tuple[int | None, ...] = (None,) * MOTORS
    yield SpeedsHeld(T0 + 0.5, (100,) * MOTORS, (*(100,) * (MOTORS - 1), -1))
    yield Marker(T0 + 0.5, "fault", "Motor 7 does not answer (−1)")
    for number in range(moves):
        goals = tuple(random.randint(50, 550) for _ in range(MOTORS))
        present = tuple(goal + random.randint(-3, 3) for goal in goals)
        yield StepBegun(time, "steps", number % 4, number // 4, 0.25)
        yield Moving(time, goals, starts, seconds)
        for count in range(1, MOTORS):
            yield Passed(time + seconds * (0.5 + count / 20), present[:count])
        time += seconds
        yield Moved(time, goals, present, seconds)
        starts = present
        time += pause
        if number == moves // 2:
            yield Marker(time, "fault", "The board has restarted.")
            yield Restarted(time, voided=True)
            yield PlayEnded(time, Ending.RESTARTED)
            starts = (None,) * MOTORS
            time += seconds
    yield Marker(time, "stop", "Stopped: nothing more is sent.")


def write(path: Path, what: list[Row], header: Header = HEADER) -> int:
    """Write a recording; return its size."""
    with path.open("wb") as file:
        writer = CsvWriter(file, header)
        for at in range(0, len(what), 7):
            writer.write(what[at : at + 7])
        writer.finish()
        return writer.size


def hang(monkeypatch: pytest.MonkeyPatch) -> None:
    """Let the loading of any recording hang until it is cancelled.

    A large file would not do: the loading might end while the window is busy.
    """
    loader = RobotPlayback.loader

    def hanging(playback: RobotPlayback) -> Callable[[ProgressCallback], LoadedRecording[Any]]:
        gather = loader(playback)

        def tell_and_hang(tell: ProgressCallback, share: float) -> None:
            tell(share)
            while share > 0.1:
                runtime().sleep(0.01)
                tell(share)  # raises once it is cancelled

        return lambda tell: gather(partial(tell_and_hang, tell))

    monkeypatch.setattr(RobotPlayback, "loader", hanging)


def loader_thread(playback: RobotPlayback) -> QThread:
    """Return the thread that reads a recording."""
    (thread,) = playback.findChildren(QThread)
    assert isinstance(thread, QThread)
    return thread


def read(file: RobotCsvFile) -> list[Row]:
    """Everything in a recording, in order."""
    return [record for index in range(len(file.blocks)) for record in file.read(index)]


def _apart(record: Row) -> tuple[Row, list[float]]:
    """Return a record without its times and seconds, and those."""
    match record:
        case Moving(time=time, expected=seconds):
            return replace(record, time=0.0, expected=0.0), [time, seconds]
        case Moved(time=time, seconds=seconds):
            return replace(record, time=0.0, seconds=0.0), [time, seconds]
        case StepBegun(time=time, late=late):  # that is written to 1 ms
            return replace(record, time=0.0, late=0.0), [time, late / 1000]
    return replace(record, time=0.0), [record.time]


def assert_equal(found: Sequence[Row], what: Sequence[Row]) -> None:
    """Fail where anything that was read back is not what was written, to 1 µs."""
    assert len(found) == len(what)
    for one, other in zip(found, what, strict=True):
        (ours, times), (theirs, written) = _apart(one), _apart(other)
        assert ours == theirs
        assert times == pytest.approx(written, rel=0, abs=RESOLUTION)
