"""Looking at a recording without a device."""

from bisect import bisect_right
from collections.abc import Iterator
from pathlib import Path
from random import Random

import pytest
from pytestqt.qtbot import QtBot

from tests.recording.samples import HEADER, an_hour, read, write
from trex_gui.link.telemetry import Currents, Raw, Remapped
from trex_gui.model.events import EventKind
from trex_gui.model.playback import Playback, limits_in
from trex_gui.protocol.commands import Drive
from trex_gui.protocol.flags import Mode
from trex_gui.recording.errors import RecordingError
from trex_gui.recording.files import open_recording
from trex_gui.recording.recording import Marker, Record, SettingsSeen, Wish
from trex_gui.recording.replay import Latest

T0 = HEADER.clock


@pytest.fixture
def minute(tmp_path: Path, qtbot: QtBot) -> Iterator[Playback]:
    write(tmp_path / "minute.trexrec", list(an_hour(60)))
    playback = Playback.open(tmp_path / "minute.trexrec")
    playback.read_all()
    yield playback
    playback.close()


def playback_of(path: Path, *what: Record) -> Playback:
    write(path, list(what))
    playback = Playback.open(path)
    playback.read_all()
    return playback


def test_it_is_read_bit_by_bit_while_the_window_lives(tmp_path: Path, qtbot: QtBot) -> None:
    write(tmp_path / "a.trexrec", list(an_hour(120)))
    playback = Playback.open(tmp_path / "a.trexrec")
    shares: list[float] = []
    playback.progressed.connect(lambda: shares.append(playback.progress))
    with qtbot.waitSignal(playback.loaded, timeout=20_000):
        pass
    assert shares == sorted(shares)
    assert shares[-1] == 1.0
    assert playback.end - playback.start == pytest.approx(120, abs=0.1)
    playback.close()


def test_going_anywhere_tells_the_same_as_reading_from_the_start(minute: Playback) -> None:
    what = list(an_hour(60))
    random = Random(3)
    places = [random.uniform(0, 60) for _ in range(60)]
    for place in [*sorted(places, reverse=True), *places]:
        minute.set_position(T0 + place)
        straight = Latest(HEADER.mode, HEADER.settings)
        for record in what:
            if record.time <= minute.position:
                straight.take(record)
        assert minute.latest() == straight


def test_the_curves_hold_every_pair_of_currents(minute: Playback) -> None:
    currents = [record for record in an_hour(60) if isinstance(record, Currents)]
    times, columns = minute.traces.samples(minute.start, minute.end)
    assert times.tolist() == [record.time for record in currents]
    unit = HEADER.model.current_unit
    assert columns[0].tolist() == [record.counts[0] * unit for record in currents]
    assert minute.traces.value_at("motor2_current", minute.end) == currents[-1].counts[1] * unit


def test_channels_and_wishes_stand_beside_the_currents(tmp_path: Path, qtbot: QtBot) -> None:
    playback = playback_of(
        tmp_path / "a.trexrec",
        Currents(T0, (0, 0)),
        Remapped(T0 + 0.01, (1, 2, 3, 4, -5)),
        Wish(T0 + 0.02, 2, Drive.at(-70)),
        Raw(T0 + 0.03, (3750, None, 1, 2, 3)),
        Currents(T0 + 0.1, (10, 0)),
        Marker(T0 + 0.2, "stop", "Stop"),
        Currents(T0 + 0.3, (0, 0)),
    )
    traces = playback.traces
    assert traces.value_at("motor2_wish", T0 + 0.15) == -70
    assert traces.value_at("channel5", T0 + 0.15) == -5
    assert traces.value_at("motor2_wish", T0 + 0.3) == 0
    playback.set_position(T0 + 0.15)
    assert playback.latest().wishes == {2: Drive.at(-70)}
    assert playback.latest().raw == (3750, None, 1, 2, 3)
    playback.set_position(T0 + 0.25)
    assert playback.latest().wishes == {}
    playback.close()


def test_events_and_settings_are_those_of_the_time(tmp_path: Path, qtbot: QtBot) -> None:
    later = "product: TReX\nmotor1_current_limit: 20\n"
    playback = playback_of(
        tmp_path / "a.trexrec",
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


def test_limits_come_from_the_settings() -> None:
    limits = limits_in("product: TReX\nmotor1_current_limit: 20\nmotor2_current_limit: 0\n")
    assert limits == {"motor1_current": pytest.approx(6.0)}
    assert limits_in("nonsense") == {}


def is_playing(playback: Playback) -> bool:
    return playback.playing


def test_it_plays_as_fast_as_asked_and_stands_still_at_the_end(minute: Playback) -> None:
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


def test_positions_outside_are_taken_for_the_ends(minute: Playback) -> None:
    minute.set_position(0)
    assert minute.position == minute.start
    minute.set_position(1e9)
    assert minute.position == minute.end


def test_a_span_is_exported_as_csv_that_replays(
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


def test_an_export_that_cannot_be_written_says_why(
    minute: Playback, tmp_path: Path, qtbot: QtBot
) -> None:
    with qtbot.waitSignal(minute.failed) as failed:
        minute.export(tmp_path / "none" / "span.csv", T0, T0 + 1)
    assert "cannot be written: No such file" in failed.args[0]
    assert minute.exporting is None


def test_an_empty_recording_opens(tmp_path: Path, qtbot: QtBot) -> None:
    playback = playback_of(tmp_path / "a.trexrec")
    assert playback.is_loaded
    assert playback.position == playback.end == T0
    assert playback.latest() == Latest(HEADER.mode, HEADER.settings)
    playback.close()


def test_another_file_is_refused(tmp_path: Path) -> None:
    (tmp_path / "a.trexrec").write_bytes(b"something else")
    with pytest.raises(RecordingError):
        Playback.open(tmp_path / "a.trexrec")
