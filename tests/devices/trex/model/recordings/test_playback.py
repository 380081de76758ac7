"""Looking at a recording without a device."""

from bisect import bisect_right
from collections import deque
from collections.abc import Iterator
from copy import deepcopy
from itertools import pairwise
from pathlib import Path
from random import Random

import pytest
from PySide6.QtCore import QCoreApplication, QObject, QThread, QTimer, Slot
from pytestqt.qtbot import QtBot

from tests.devices.trex.recording.samples import HEADER, an_hour, read, write, write_an_hour_of_csv
from trex_gui.core.recording.errors import RecordingError
from trex_gui.devices.trex.client.telemetry import Currents, Raw, Remapped
from trex_gui.devices.trex.model.recordings.playback import Playback, limits_in
from trex_gui.devices.trex.protocol.commands import Drive
from trex_gui.devices.trex.protocol.flags import Mode
from trex_gui.devices.trex.recording.files import open_recording
from trex_gui.devices.trex.recording.recording import Marker, Record, SetpointRecord, SettingsSeen
from trex_gui.devices.trex.recording.replay import Latest
from trex_gui.ui.devices.event_log import EventKind
from trex_gui.ui.runtime import now
from trex_gui.ui.workers.file_worker import FileWorker

T0 = HEADER.clock

TRIES = 4
"""How often is tried what a computer that stands still for a moment spoils."""


@pytest.fixture
def minute(tmp_path: Path, qtbot: QtBot) -> Iterator[Playback]:
    write(tmp_path / "minute.trexrec", list(an_hour(60)))
    playback = loaded(tmp_path / "minute.trexrec", qtbot)
    yield playback
    playback.close()


def loaded(path: Path, qtbot: QtBot) -> Playback:
    playback = Playback.open(path)
    with qtbot.waitSignal(playback.loaded, timeout=20_000):
        pass
    return playback


def playback_of(path: Path, qtbot: QtBot, *what: Record) -> Playback:
    write(path, list(what))
    return loaded(path, qtbot)


def test_progress_of_reading_is_reported(tmp_path: Path, qtbot: QtBot) -> None:
    write(tmp_path / "a.trexrec", list(an_hour(120)))
    playback = Playback.open(tmp_path / "a.trexrec")
    assert not playback.is_loaded
    shares: list[float] = []
    playback.progressed.connect(lambda: shares.append(playback.progress))
    with qtbot.waitSignal(playback.loaded, timeout=20_000):
        pass
    assert shares == sorted(shares)
    assert shares[-1] == 1.0
    assert playback.end - playback.start == pytest.approx(120, abs=0.1)
    playback.close()


def test_seeking_gives_the_same_state_as_sequential_reading(minute: Playback) -> None:
    random = Random(3)
    places = [random.uniform(0, 60) for _ in range(60)]
    straight = Latest(HEADER.mode, HEADER.settings)
    records = deque(an_hour(60))
    expected: dict[float, Latest] = {}
    for place in sorted(places):
        minute.set_position(T0 + place)
        while records and records[0].time <= minute.position:
            straight.take(records.popleft())
        expected[place] = deepcopy(straight)
    for place in [*sorted(places, reverse=True), *places]:
        minute.set_position(T0 + place)
        assert minute.latest() == expected[place]


def test_traces_hold_every_pair_of_currents(minute: Playback) -> None:
    currents = [record for record in an_hour(60) if isinstance(record, Currents)]
    times, columns = minute.traces.samples(minute.start, minute.end)
    assert times.tolist() == [record.time for record in currents]
    unit = HEADER.model.current_unit
    assert columns[0].tolist() == [record.counts[0] * unit for record in currents]
    assert minute.traces.value_at("motor2_current", minute.end) == currents[-1].counts[1] * unit


def test_traces_hold_channels_and_setpoints(tmp_path: Path, qtbot: QtBot) -> None:
    playback = playback_of(
        tmp_path / "a.trexrec",
        qtbot,
        Currents(T0, (0, 0)),
        Remapped(T0 + 0.01, (1, 2, 3, 4, -5)),
        SetpointRecord(T0 + 0.02, 2, Drive.at(-70)),
        Raw(T0 + 0.03, (3750, None, 1, 2, 3)),
        Currents(T0 + 0.1, (10, 0)),
        Marker(T0 + 0.2, "stop", "Stop"),
        Currents(T0 + 0.3, (0, 0)),
    )
    traces = playback.traces
    assert traces.value_at("motor2_setpoint", T0 + 0.15) == -70
    assert traces.value_at("channel5", T0 + 0.15) == -5
    assert traces.value_at("motor2_setpoint", T0 + 0.3) == 0
    playback.set_position(T0 + 0.15)
    assert playback.latest().wishes == {2: Drive.at(-70)}
    assert playback.latest().raw == (3750, None, 1, 2, 3)
    playback.set_position(T0 + 0.25)
    assert playback.latest().wishes == {}
    playback.close()


def test_settings_follow_the_position_and_events_are_sorted(tmp_path: Path, qtbot: QtBot) -> None:
    later = "product: TReX\nmotor1_current_limit: 20\n"
    playback = playback_of(
        tmp_path / "a.trexrec",
        qtbot,
        Marker(T0 + 1, "apply", "Apply: Motor 1 Current Limit"),
        SettingsSeen(T0 + 1.1, later),
        Marker(T0 + 2, "word of a later program", "something"),
        Marker(T0 + 0.5, "fault", "Motor 1 fault"),
        Currents(T0 + 3, (0, 0)),
    )
    assert [(event.time - T0, event.kind) for event in playback.events] == [
        (0.5, EventKind.FAULT),
        (1, EventKind.APPLY),
        (2, EventKind.NOTE),
    ]
    assert playback.latest().settings == HEADER.settings
    playback.set_position(T0 + 2)
    assert playback.latest().settings == later
    assert playback.latest().mode is Mode.SERIAL_RC
    assert playback.traces.events_between(T0, T0 + 0.7) == playback.events[:1]
    playback.close()


def test_current_limits_come_from_the_settings() -> None:
    limits = limits_in("product: TReX\nmotor1_current_limit: 20\nmotor2_current_limit: 0\n")
    assert limits == {"motor1_current": pytest.approx(6.0)}
    assert limits_in("nonsense") == {}


def is_playing(playback: Playback) -> bool:
    return playback.playing


def test_playback_runs_at_its_speed_within_the_recording(minute: Playback) -> None:
    minute.play()
    assert is_playing(minute)
    minute.advance(1.0)
    assert minute.position - T0 == pytest.approx(1.0)
    minute.set_speed(16)
    minute.advance(2.0)
    assert minute.position - T0 == pytest.approx(33.0)
    minute.set_speed(0.5)
    minute.advance(2.0)
    assert minute.position - T0 == pytest.approx(34.0)
    minute.advance(100)
    assert minute.position == minute.end
    assert not is_playing(minute)
    minute.play()
    assert minute.position == minute.start
    minute.pause()
    assert not is_playing(minute)

    minute.set_position(0)
    assert minute.position == minute.start
    minute.set_position(1e9)
    assert minute.position == minute.end


def test_span_is_exported_as_csv_or_fails_with_a_reason(
    minute: Playback, tmp_path: Path, qtbot: QtBot
) -> None:
    begin, end = T0 + 20, T0 + 35.5
    with qtbot.waitSignal(minute.exported, timeout=20_000):
        minute.export(tmp_path / "span.csv", begin, end)
    file = open_recording(tmp_path / "span.csv")
    found = read(file)
    wanted = [record for record in an_hour(60) if begin <= record.time <= end]
    assert len(found) == len(wanted)
    assert [type(record) for record in found] == [type(record) for record in wanted]
    times = [record.time for record in wanted]
    assert bisect_right(times, begin) == 0
    assert found[0].time == pytest.approx(wanted[0].time, abs=2e-6)
    file.close()

    with qtbot.waitSignal(minute.failed) as failed:
        minute.export(tmp_path / "none" / "span.csv", T0, T0 + 1)
    assert "cannot be written: No such file" in failed.args[0]
    assert minute.exporting is None


def test_empty_recording_opens(tmp_path: Path, qtbot: QtBot) -> None:
    playback = playback_of(tmp_path / "a.trexrec", qtbot)
    assert playback.is_loaded
    assert playback.position == playback.end == T0
    assert playback.latest() == Latest(HEADER.mode, HEADER.settings)
    playback.close()


def test_file_of_another_kind_is_rejected(tmp_path: Path) -> None:
    (tmp_path / "a.trexrec").write_bytes(b"something else")
    with pytest.raises(RecordingError):
        Playback.open(tmp_path / "a.trexrec")


# --- The thread that reads ----------------------------------------------------------------


@pytest.fixture(scope="module")
def hour(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Path]:
    path = tmp_path_factory.mktemp("hour") / "hour.csv"
    write_an_hour_of_csv(path)
    yield path
    path.unlink()


class Ticks(QObject):
    """A timer of the window's thread, and how it fared while somebody else was busy."""

    def __init__(self) -> None:
        super().__init__()
        self.times: list[float] = []
        self._timer = QTimer(self)
        self._timer.setInterval(50)
        self._timer.timeout.connect(self._on_timeout)
        self._timer.start()

    @Slot()
    def _on_timeout(self) -> None:
        self.times.append(now())

    def within(self, begin: float, end: float) -> int:
        """How many there were in this time."""
        return sum(begin <= at <= end for at in self.times)

    def longest_pause(self, begin: float, end: float) -> float:
        """Seconds that passed at most without one."""
        known = [begin, *(at for at in self.times if begin <= at <= end), end]
        return max(later - earlier for earlier, later in pairwise(known))


@pytest.mark.slow
@pytest.mark.realtime
@pytest.mark.timeout(300)  # a busy computer takes its time, and is not judged by it
def test_window_responds_while_an_hour_of_csv_is_read(hour: Path, qtbot: QtBot) -> None:
    assert any(responds_while_reading(hour, qtbot) for _ in range(TRIES))


def responds_while_reading(hour: Path, qtbot: QtBot) -> bool:
    """Open a recording, and return whether the window could do something else meanwhile."""
    ticks = Ticks()
    begin = now()
    playback = Playback.open(hour)
    opened = now()
    qtbot.waitUntil(lambda: playback.progress > 0.2, timeout=120_000)
    looked_through = now()
    with qtbot.waitSignal(playback.loaded, timeout=240_000):
        pass
    end = now()
    assert playback.drawn[0] == playback.drawn[1] > 280_000
    assert playback.end - playback.start == pytest.approx(3600, abs=0.1)
    playback.close()
    # Of the whole time the first call takes next to nothing, and nothing later holds up the rest.
    return (
        opened - begin < (end - begin) / 20
        and ticks.within(begin, looked_through) >= 5
        and ticks.within(begin, end) >= 40
        and ticks.longest_pause(begin, end) < (end - begin) / 5
    )


@pytest.fixture
def started_workers(monkeypatch: pytest.MonkeyPatch) -> list[FileWorker]:
    """The threads that the test has started."""
    workers: list[FileWorker] = []
    start = FileWorker.start

    def record_and_start(worker: FileWorker, priority: QThread.Priority) -> None:
        workers.append(worker)
        start(worker, priority)

    monkeypatch.setattr(FileWorker, "start", record_and_start)
    return workers


@pytest.mark.realtime
def test_close_while_reading_ends_the_thread(
    hour: Path, qtbot: QtBot, started_workers: list[FileWorker]
) -> None:
    playback = Playback.open(hour)
    (thread,) = started_workers
    qtbot.waitUntil(lambda: playback.progress > 0)
    told: list[str] = []
    playback.loaded.connect(lambda: told.append("loaded"))
    playback.failed.connect(told.append)
    assert thread.isRunning()
    qtbot.waitUntil(playback.close)
    assert thread.isFinished()
    QCoreApplication.sendPostedEvents()
    assert told == []
    assert not playback.is_loaded


def test_read_error_is_reported(tmp_path: Path, qtbot: QtBot) -> None:
    path = tmp_path / "a.trexrec"
    write(path, list(an_hour(5)))
    playback = Playback(open_recording(path, head_only=True), path)
    playback._file.close()
    with qtbot.waitSignal(playback.failed, timeout=20_000) as failed:
        playback.start_reading()
    assert "a.trexrec, byte 0: It cannot be read" in failed.args[0]
    playback.close()


def test_last_samples_of_a_long_recording_are_drawn(tmp_path: Path, qtbot: QtBot) -> None:
    path = tmp_path / "a.trexrec"
    write(path, list(an_hour(120)))
    playback = Playback(open_recording(path, head_only=True), path, most_rows=5000)
    with qtbot.waitSignal(playback.loaded, timeout=20_000):
        playback.start_reading()
    currents = [record for record in an_hour(120) if isinstance(record, Currents)]
    assert playback.drawn == (5000, len(currents))
    times, _ = playback.traces.samples(playback.start, playback.end)
    assert times.tolist() == [record.time for record in currents[-5000:]]
    playback.close()


@pytest.mark.realtime
@pytest.mark.parametrize("how", ["close", "cancel_export"])
def test_cancelled_export_keeps_the_existing_file(tmp_path: Path, qtbot: QtBot, how: str) -> None:
    write(tmp_path / "minute.trexrec", list(an_hour(240)))
    path = tmp_path / "span.csv"
    source = tmp_path / "minute.trexrec"
    assert any(is_cancelled(path, loaded(source, qtbot), qtbot, how) for _ in range(TRIES))
    assert path.read_text() == "what was there"


def is_cancelled(path: Path, playback: Playback, qtbot: QtBot, how: str) -> bool:
    """Cut an export off; return whether it was not done before the window heard of it."""
    path.write_text("what was there")
    done: list[Path] = []
    playback.exported.connect(done.append)
    with qtbot.waitSignal(playback.progressed):
        playback.export(path, T0, T0 + 240)
    had_begun = bool(list(path.parent.glob(".span.csv.*.part")))
    getattr(playback, how)()
    qtbot.waitUntil(lambda: not list(path.parent.glob(".span.csv.*")))
    qtbot.waitUntil(lambda: not playback.busy)
    assert playback.exporting is None
    playback.close()
    return had_begun and done == []
