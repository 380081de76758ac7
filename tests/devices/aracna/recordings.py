"""Recordings of a robot for tests."""

from collections.abc import Iterator
from datetime import UTC, datetime
from pathlib import Path
from random import Random

from hypothesis import strategies as st

from trex_gui.core.recording.kinds import Marker
from trex_gui.core.recording.store import CHUNK, Recording, RecordingWriter
from trex_gui.devices.aracna.recording import FORMAT, Record, RobotHeader
from trex_gui.devices.aracna.session.messages import (
    Ending,
    Moved,
    Moving,
    NotResponding,
    PlayEnded,
    Progress,
    Restarted,
    SpeedsHeld,
    StepStarted,
    Stuck,
)

MOTORS = 8
HEADER = RobotHeader(datetime(2026, 1, 2, 3, 4, 5, tzinfo=UTC), 1234.5, version=1, motors=MOTORS)
T0 = HEADER.clock

_times = st.floats(0, 1e6).map(lambda seconds: T0 + seconds)
_seconds = st.floats(0, 1e5)
_positions = st.integers(0, 1023)
_reported = st.integers(-1, 1023)
_texts = st.text(st.characters(exclude_categories=["Cs"]), max_size=40)


def _all(values: st.SearchStrategy[int]) -> st.SearchStrategy[tuple[int, ...]]:
    return st.tuples(*[values] * MOTORS)


records: st.SearchStrategy[Record] = st.one_of(
    st.builds(
        Moving, _times, _all(_positions), st.tuples(*[st.none() | _positions] * MOTORS), _seconds
    ),
    st.builds(Progress, _times, st.lists(_reported, max_size=MOTORS).map(tuple)),
    st.builds(Moved, _times, _all(_positions), _all(_reported), _seconds),
    st.builds(SpeedsHeld, _times, _all(_positions), _all(_reported)),
    st.builds(
        StepStarted,
        _times,
        st.sampled_from(["in", "steps", "out"]),
        st.integers(0, 1000),
        st.integers(0, 10_000),
        st.floats(-1, 1000),
    ),
    st.builds(PlayEnded, _times, st.sampled_from(Ending)),
    st.builds(Stuck, _times, st.none() | st.integers(0, MOTORS - 1)),
    st.builds(Restarted, _times, st.booleans()),
    st.builds(NotResponding, _times),
    st.builds(Marker, _times, st.sampled_from(["stop", "fault", "link"]), _texts),
)


def session(moves: int = 20, *, seconds: float = 2.0, pause: float = 1.0) -> Iterator[Record]:
    """Yield the records of a robot that moves from goal to goal.

    After half of the moves, the board restarts and does not respond for the time of a motion.
    """
    random, time = Random(1), T0 + pause
    starts: tuple[int | None, ...] = (None,) * MOTORS
    yield SpeedsHeld(T0 + 0.5, (100,) * MOTORS, (*(100,) * (MOTORS - 1), -1))
    yield Marker(T0 + 0.5, "fault", "Motor 7 does not answer (−1)")
    for number in range(moves):
        goals = tuple(random.randint(50, 550) for _ in range(MOTORS))
        present = tuple(goal + random.randint(-3, 3) for goal in goals)
        yield StepStarted(time, "steps", number % 4, number // 4, 0.25)
        yield Moving(time, goals, starts, seconds)
        for count in range(1, MOTORS):
            yield Progress(time + seconds * (0.5 + count / 20), present[:count])
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
    yield Marker(time, "stop", "Nothing more is sent.")


def write(path: Path, content: list[Record], header: RobotHeader = HEADER) -> int:
    """Write a recording. Return its size."""
    writer = RecordingWriter[RobotHeader, Record](path, FORMAT, header)
    for at in range(0, len(content), 7):
        writer.write(content[at : at + 7])
    writer.finish()
    size = writer.size
    writer.close()
    return size


def open_recording(path: Path) -> Recording[RobotHeader, Record]:
    return Recording(path, FORMAT)


def read_all(path: Path) -> tuple[list[Record], list[str]]:
    """Return the records and the problems of a file."""
    recording = open_recording(path)
    numbers = range(1, recording.count + 1, CHUNK)
    found = [record for first in numbers for record in recording.read(first, first + CHUNK - 1)]
    recording.close()
    return found, recording.problems
