"""Playback of a recording without a device."""

from collections import deque
from collections.abc import Callable, Iterator
from copy import deepcopy
from itertools import pairwise
from pathlib import Path
from random import Random

import pytest
from PySide6.QtCore import QCoreApplication, QTimer
from pytestqt.qtbot import QtBot

from tests.devices.trex.recording.samples import (
    HEADER,
    drive_records,
    open_recording,
    write,
    write_long_recording,
)
from tests.support.playing import loading
from trex_gui.core.events import EventKind
from trex_gui.core.recording.kinds import Marker
from trex_gui.core.recording.store import CHUNK
from trex_gui.devices.trex.client.telemetry import Control, Currents, ModeSample, Raw, Remapped
from trex_gui.devices.trex.model.playback import Playback, limits_in
from trex_gui.devices.trex.protocol.driving import Drive
from trex_gui.devices.trex.protocol.flags import Mode
from trex_gui.devices.trex.recording import (
    BoardSnapshot,
    Record,
    SetpointRecord,
    SettingsSnapshot,
)
from trex_gui.ui.runtime import now
from trex_gui.ui.workers.file_worker import FileWorker

T0 = HEADER.clock

ATTEMPTS = 4  # an attempt may fail on a busy computer


@pytest.fixture(scope="module")
def minute_file(tmp_path_factory: pytest.TempPathFactory) -> Path:
    path = tmp_path_factory.mktemp("minute") / "minute.trexrec"
    write(path, list(drive_records(60)))
    return path


@pytest.fixture(scope="module")
def long_file(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Recording of four minutes, which takes some time to read and export."""
    path = tmp_path_factory.mktemp("long") / "long.trexrec"
    write_long_recording(path, 4)
    return path


@pytest.fixture
def minute(minute_file: Path, qtbot: QtBot) -> Iterator[Playback]:
    playback = loaded(minute_file, qtbot)
    yield playback
    playback.close()


def loaded(path: Path, qtbot: QtBot) -> Playback:
    playback = loading(Playback(open_recording(path)))
    qtbot.waitUntil(lambda: playback.is_loaded)
    return playback


PlaybackOf = Callable[..., Playback]


@pytest.fixture
def playback_of(tmp_path: Path, qtbot: QtBot) -> Iterator[PlaybackOf]:
    """Return a function that writes records to a file and opens it for playback."""
    playbacks: list[Playback] = []

    def playback_of(*records: Record) -> Playback:
        write(tmp_path / "a.trexrec", list(records))
        playbacks.append(loaded(tmp_path / "a.trexrec", qtbot))
        return playbacks[-1]

    yield playback_of
    for playback in playbacks:
        playback.close()


def test_progress_of_reading_is_reported(long_file: Path, qtbot: QtBot) -> None:
    playback = loading(Playback(open_recording(long_file)))
    assert not playback.is_loaded
    shares: list[float] = []
    playback.progressed.connect(lambda: shares.append(playback.progress))
    with qtbot.waitSignal(playback.loaded):
        pass
    assert shares == sorted(shares)
    assert shares[-1] == 1.0
    assert playback.end - playback.start == pytest.approx(240, abs=0.1)
    playback.close()


def test_seeking_gives_the_same_state_as_sequential_reading(minute: Playback) -> None:
    random = Random(3)
    seconds = [random.uniform(0, 60) for _ in range(30)]
    state = BoardSnapshot.at_start(HEADER)
    records = deque(drive_records(60))
    expected: dict[float, BoardSnapshot] = {}
    for second in sorted(seconds):
        minute.set_position(T0 + second)
        while records and records[0].time <= minute.position:
            state.update(records.popleft())
        expected[second] = deepcopy(state)
    for second in [*sorted(seconds, reverse=True), *seconds]:
        minute.set_position(T0 + second)
        assert minute.state() == expected[second]


def test_late_marker_does_not_disturb_seeking(playback_of: PlaybackOf) -> None:
    """A marker may be recorded after its time, even at the start of a chunk."""
    control: list[Record] = [Control(T0 + n, by_serial=n % 2 == 0) for n in range(2 * CHUNK)]
    control[CHUNK] = Marker(T0 + 5, "fault", "recorded late")
    playback = playback_of(*control)
    for second in (3, CHUNK - 3, CHUNK - 2, CHUNK + 3):
        assert playback.state_at(T0 + second)[Control].by_serial == (second % 2 == 0)


def test_traces_have_every_pair_of_currents(minute: Playback) -> None:
    currents = [record for record in drive_records(60) if isinstance(record, Currents)]
    times, columns = minute.traces.samples(minute.start, minute.end)
    assert times.tolist() == [record.time for record in currents]
    unit = HEADER.model.current_unit
    assert columns[0].tolist() == [record.counts[0] * unit for record in currents]
    assert minute.traces.value_at("motor2_current", minute.end) == currents[-1].counts[1] * unit


def test_traces_have_channels_and_setpoints(playback_of: PlaybackOf) -> None:
    playback = playback_of(
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
    assert playback.state().setpoints == {2: Drive.at(-70)}
    assert playback.state()[Raw].counts == (3750, None, 1, 2, 3)
    playback.set_position(T0 + 0.25)
    assert playback.state().setpoints == {}


def test_settings_follow_the_position_and_events_are_sorted(playback_of: PlaybackOf) -> None:
    later = "product: TReX\nmotor1_current_limit: 20\n"
    playback = playback_of(
        Marker(T0 + 1, "apply", "Apply: Motor 1 Current Limit"),
        SettingsSnapshot(T0 + 1.1, later),
        Marker(T0 + 2, "kind of a later version", "something"),
        Marker(T0 + 0.5, "fault", "Motor 1 fault"),
        Currents(T0 + 3, (0, 0)),
    )
    assert [(event.time - T0, event.kind) for event in playback.events] == [
        (0.5, EventKind.FAULT),
        (1, EventKind.APPLY),
        (2, EventKind.NOTE),
    ]
    assert playback.state().settings == HEADER.settings
    playback.set_position(T0 + 2)
    assert playback.state().settings == later
    assert playback.state()[ModeSample].mode is Mode.SERIAL_RC
    assert playback.traces.events_between(T0, T0 + 0.7) == playback.events[:1]
    for second, settings in ((0.5, HEADER.settings), (2, later)):  # start of the exported span
        assert playback.export_header(T0 + second)["settings"] == settings


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
    minute.speed = 16
    minute.advance(2.0)
    assert minute.position - T0 == pytest.approx(33.0)
    minute.speed = 0.5
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
    with qtbot.waitSignal(minute.exported):
        minute.export(tmp_path / "span.csv", T0 + 20, T0 + 35.5)
    assert (tmp_path / "span.csv").exists()
    with qtbot.waitSignal(minute.failed) as failed:
        minute.export(tmp_path / "missing" / "span.csv", T0, T0 + 1)
    assert "cannot be written: No such file" in failed.args[0]
    assert not minute.is_busy


def test_empty_recording_can_be_opened(playback_of: PlaybackOf) -> None:
    playback = playback_of()
    assert playback.position == playback.end == T0
    assert playback.state() == BoardSnapshot.at_start(HEADER)


# --- Reading thread ---------------------------------------------------------------------


@pytest.mark.slow
@pytest.mark.realtime
@pytest.mark.timeout(300)  # for a busy computer
def test_window_responds_while_an_hour_is_read(tmp_path: Path, qtbot: QtBot) -> None:
    path = tmp_path / "hour.trexrec"
    write_long_recording(path)
    assert any(responds_while_reading(path, qtbot) for _ in range(ATTEMPTS))
    path.unlink()


def responds_while_reading(hour: Path, qtbot: QtBot) -> bool:
    """Load a recording of an hour. Return true if the GUI thread was never blocked for long."""
    ticks: list[float] = []  # a pause between ticks shows that the GUI thread was blocked
    timer = QTimer()
    timer.timeout.connect(lambda: ticks.append(now()))
    start = now()
    timer.start(50)
    playback = loading(Playback(open_recording(hour)))
    opened = now()
    qtbot.waitUntil(lambda: playback.progress > 0.2, timeout=120_000)
    scanned = now()
    with qtbot.waitSignal(playback.loaded, timeout=240_000):
        pass
    end = now()
    timer.stop()
    assert playback.row_counts[0] == playback.row_counts[1] > 280_000
    assert playback.end - playback.start == pytest.approx(3600, abs=0.1)
    playback.close()
    # Opening returns at once, and no later step blocks.
    return (
        opened - start < (end - start) / 20
        and sum(tick < scanned for tick in ticks) >= 5
        and len(ticks) >= 40
        and max(later - earlier for earlier, later in pairwise((start, *ticks, end)))
        < (end - start) / 5
    )


@pytest.mark.realtime
def test_closing_while_reading_ends_the_thread(long_file: Path, qtbot: QtBot) -> None:
    playback = loading(Playback(open_recording(long_file)))
    (thread,) = playback.findChildren(FileWorker)
    qtbot.waitUntil(lambda: playback.progress > 0)
    signals: list[str] = []
    playback.loaded.connect(lambda: signals.append("loaded"))
    playback.failed.connect(signals.append)
    assert thread.isRunning()
    qtbot.waitUntil(playback.close)
    assert thread.isFinished()
    QCoreApplication.sendPostedEvents()
    assert signals == []
    assert not playback.is_loaded


def test_read_error_is_reported(tmp_path: Path, qtbot: QtBot) -> None:
    path = tmp_path / "a.trexrec"
    write(path, list(drive_records(5)))
    playback = Playback(open_recording(path))
    playback._recording.close()
    with qtbot.waitSignal(playback.failed) as failed:
        playback.start_loading()
    assert "a.trexrec: The file cannot be read" in failed.args[0]
    playback.close()


def test_only_the_last_samples_of_a_long_recording_are_drawn(
    playback_of: PlaybackOf, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("trex_gui.devices.trex.model.playback.MAX_ROWS", 1000)
    playback = playback_of(*drive_records(30))
    currents = [record for record in drive_records(30) if isinstance(record, Currents)]
    assert playback.row_counts == (1000, len(currents))
    times, _ = playback.traces.samples(playback.start, playback.end)
    assert times.tolist() == [record.time for record in currents[-1000:]]


@pytest.mark.realtime
@pytest.mark.parametrize("method", ["close", "cancel"])
def test_cancelled_export_keeps_the_existing_file(
    long_file: Path, tmp_path: Path, qtbot: QtBot, method: str
) -> None:
    path = tmp_path / "span.csv"
    assert any(is_cancelled(path, loaded(long_file, qtbot), qtbot, method) for _ in range(ATTEMPTS))
    assert path.read_text() == "earlier export"


def is_cancelled(path: Path, playback: Playback, qtbot: QtBot, method: str) -> bool:
    """Cancel an export. Return true if it was still running and was cancelled."""
    path.write_text("earlier export")
    done: list[Path] = []
    playback.exported.connect(done.append)
    with qtbot.waitSignal(playback.progressed):
        playback.export(path, T0, T0 + 240)
    had_started = bool(list(path.parent.glob(".span.csv.*")))
    getattr(playback, method)()
    qtbot.waitUntil(lambda: not list(path.parent.glob(".span.csv.*")))
    qtbot.waitUntil(lambda: not playback.is_busy)
    playback.close()
    return had_started and done == []
