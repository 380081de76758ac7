"""Recordings of a running session."""

import csv
import math
import re
import shutil
from collections.abc import Callable, Iterator
from datetime import UTC, datetime
from functools import partial
from pathlib import Path

import pytest
from pytestqt.qtbot import QtBot

from tests.devices.trex.model.device_setup import DeviceSetup
from tests.devices.trex.recording.samples import open_recording, read_file
from tests.support.simulator import SimulatedDevice, StartSimulator
from trex_gui.core.events import EventKind
from trex_gui.core.recording.automatic import automatic_path, create_automatic_folder, remove_oldest
from trex_gui.core.recording.backlog import Backlog
from trex_gui.core.recording.export import export_span
from trex_gui.core.recording.kinds import Marker
from trex_gui.devices.trex.client.telemetry import Control, Currents, Raw, Remapped, Sample
from trex_gui.devices.trex.model import recorder
from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.model.group import BoardGroup
from trex_gui.devices.trex.model.recorder import EventRecorder, Recorder
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.devices.trex.protocol.driving import Drive
from trex_gui.devices.trex.recording import (
    OtherBoardRecord,
    Record,
    SetpointRecord,
    SettingsSnapshot,
)
from trex_gui.devices.trex.session.messages import Batch
from trex_gui.ui.devices.connection import ConnectionState
from trex_gui.ui.runtime import now


class RecorderSetup(DeviceSetup):
    """Device with a simulated board, and its recorder. Collects the recorded samples."""

    def __init__(self, qtbot: QtBot, simulator: SimulatedDevice) -> None:
        super().__init__(qtbot, simulator)
        self.recorder = Recorder(self.device)
        self.samples: list[object] = []
        self.device.sampled.connect(self._on_sampled)
        self.connect()

    def _on_sampled(self, batch: Batch) -> None:
        if self.recorder.recording:
            self.samples += batch.samples

    def start_recording(self, path: Path, samples: int = 50) -> None:
        """Start a recording, and wait for more than this number of samples."""
        assert self.recorder.start(path)
        self.until(lambda: len(self.samples) > samples)

    def drive(self) -> None:
        self.device.motors.arm()
        self.device.motors.set_speed(1, 40)
        self.pass_time(1)

    def end_recording(self) -> None:
        with self.qtbot.waitSignal(self.recorder.ended):
            self.recorder.stop()


@pytest.fixture
def session(quick_simulator: SimulatedDevice, qtbot: QtBot) -> Iterator[RecorderSetup]:
    session = RecorderSetup(qtbot, quick_simulator)
    yield session
    session.recorder.shut_down()
    session.shut_down()


def test_recording_has_every_sample_while_no_window_is_visible(
    session: RecorderSetup, tmp_path: Path
) -> None:
    session.device.set_visible(False)
    session.recorder.start(tmp_path / "hidden.trexrec")
    session.pass_time(3)
    session.end_recording()
    assert sum(isinstance(sample, Currents) for sample in session.samples) > 3 * 70

    session.samples.clear()
    count = session.device.telemetry.samples
    session.pass_time(3)
    assert session.device.telemetry.samples - count < 3 * 60


def records_of(path: Path) -> list[Record]:
    _, records, problems = read_file(path)
    assert problems == []
    return records


def test_header_and_every_sample_are_recorded(session: RecorderSetup, tmp_path: Path) -> None:
    path = tmp_path / "session.trexrec"
    session.start_recording(path, samples=400)
    session.end_recording()
    samples = [record for record in records_of(path) if isinstance(record, Sample)]
    assert samples == session.samples
    assert session.recorder.size == path.stat().st_size
    assert {Currents, Raw, Remapped, Control} <= {type(sample) for sample in samples}

    file = open_recording(path)
    state = session.device.state
    assert state is not None
    assert file.header.board == str(state.signature)
    assert file.header.mode is state.mode
    assert "serial_timeout:" in file.header.settings
    assert "rc_channel_1:" in file.header.settings
    assert file.header.program.startswith("TReX Studio ")
    file.close()


def test_setpoints_events_and_settings_are_recorded_in_order(
    session: RecorderSetup, tmp_path: Path
) -> None:
    device, path = session.device, tmp_path / "a.trexrec"
    session.recorder.start(path)
    session.drive()
    device.motors.press_stop()
    session.until(lambda: not device.may_move)
    device.parameters.edit("serial_timeout", 9)
    with session.qtbot.waitSignal(device.applied):
        device.writer.apply()
    session.end_recording()
    records = records_of(path)
    setpoints = [record for record in records if isinstance(record, SetpointRecord)]
    assert [(record.motor, record.drive) for record in setpoints] == [(1, Drive.at(40))]
    kinds = [record.kind for record in records if isinstance(record, Marker)]
    assert {EventKind.STOP.value, EventKind.APPLY.value} <= set(kinds)
    (settings,) = [record for record in records if isinstance(record, SettingsSnapshot)]
    assert "serial_timeout: 9 " in settings.text
    times = [record.time for record in records]
    assert max(times) - min(times) < 60
    assert min(times) <= setpoints[0].time < settings.time <= max(times)


def test_closed_line_or_new_input_source_ends_the_recording(
    session: RecorderSetup, tmp_path: Path
) -> None:
    session.start_recording(tmp_path / "a.trexrec")
    with session.qtbot.waitSignals([session.recorder.ended_early, session.recorder.ended]):
        session.device.disconnect_line()
    assert not session.recorder.recording
    assert records_of(tmp_path / "a.trexrec")

    session.connect()
    session.recorder.start(tmp_path / "b.trexrec")
    session.simulator.do("jumper mode analog")
    with session.qtbot.waitSignal(session.recorder.ended):
        session.simulator.do("power cycle")
    assert records_of(tmp_path / "b.trexrec")


def test_recording_continues_while_the_board_is_unresponsive(
    session: RecorderSetup, tmp_path: Path
) -> None:
    session.start_recording(tmp_path / "a.trexrec")
    session.simulator.do("power off")
    session.until_link(ConnectionState.NOT_RESPONDING)
    assert session.recorder.recording
    session.simulator.do("power on")
    session.until_link(ConnectionState.CONNECTED)
    count = len(session.samples)
    session.until(lambda: len(session.samples) > count + 50)
    assert session.recorder.recording
    session.end_recording()
    assert len(records_of(tmp_path / "a.trexrec")) >= count + 50


def test_full_disk_ends_the_recording_but_not_the_connection(
    session: RecorderSetup, tmp_path: Path, full_disk: None
) -> None:
    with session.qtbot.waitSignal(session.recorder.failed) as failed:
        session.recorder.start(tmp_path / "a.trexrec")
    assert "cannot be written: No space left" in failed.args[0]
    session.until(lambda: session.recorder.can_record)
    samples = session.device.telemetry.samples
    session.until(lambda: session.device.telemetry.samples > samples)


def test_recording_is_committed_every_second(session: RecorderSetup, tmp_path: Path) -> None:
    path = tmp_path / "a.trexrec"
    session.start_recording(path)
    start = now()
    session.pass_time(1)
    copies = [tmp_path / f"copy{suffix}" for suffix in (".trexrec", ".trexrec-wal")]
    for suffix, copy in zip(("", "-wal"), copies, strict=True):
        shutil.copy(f"{path}{suffix}", copy)  # like the files after a power failure
    recording = open_recording(copies[0])
    last = recording.read(recording.count - 20, recording.count)[-1]
    recording.close()
    assert last.time > start
    session.end_recording()


def new_recording(
    session: RecorderSetup, automatic: EventRecorder, act: Callable[[], object]
) -> tuple[Path, list[Record]]:
    """Call `act`, and return the next automatic recording."""
    with session.qtbot.waitSignal(automatic.ended) as ended:
        act()
    return ended.args[0], records_of(ended.args[0])


@pytest.fixture
def automatic(session: RecorderSetup, monkeypatch: pytest.MonkeyPatch) -> Iterator[EventRecorder]:
    """Automatic recordings with 2 seconds before and after an event."""
    assert (recorder._BEFORE, recorder._AFTER) == (20.0, 10.0)
    monkeypatch.setattr(recorder, "_BEFORE", 2.0)
    monkeypatch.setattr(recorder, "_AFTER", 2.0)
    automatic = EventRecorder(session.device, session.recorder)
    session.device.link_changed.emit()
    session.device.state_changed.emit()  # the board is read already
    yield automatic
    automatic.shut_down()


def test_seconds_around_a_stop_are_recorded(
    session: RecorderSetup, automatic: EventRecorder
) -> None:
    motors = session.device.motors
    motors.press_stop()  # the motors are at rest, so nothing is recorded
    session.until(lambda: not motors.locked_for)
    session.drive()
    session.pass_time(3)
    stopped = now()
    motors.press_stop()
    session.pass_time(1)
    add_fault = partial(session.simulator.do, "fault 1 on")  # within the same seconds
    path, records = new_recording(session, automatic, add_fault)
    assert list(path.parent.glob("*.trexrec")) == [path]
    assert re.fullmatch(r"[-_.0-9]{24}stop.trexrec", path.name)
    assert 1.5 < stopped - records[0].time < 2.5
    assert 2.5 < records[-1].time - stopped < 3.5
    first = records[0]
    assert isinstance(first, SetpointRecord)  # the setpoint is older than 2 seconds
    assert first.drive == Drive.at(40)
    kinds = [record.kind for record in records if isinstance(record, Marker)]
    assert kinds == [EventKind.STOP.value, EventKind.FAULT.value]
    file = open_recording(path)
    assert file.header.clock == first.time
    assert "serial_timeout:" in file.header.settings
    file.close()
    motors.press_stop()  # no motor was driven since the last stop
    session.pass_time(1)
    assert not automatic.recording


def test_repeated_faults_do_not_extend_a_recording_without_limit(
    session: RecorderSetup, automatic: EventRecorder, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(recorder, "_MAX_LENGTH", 2.0)
    files: list[Path] = []
    automatic.ended.connect(files.append)
    session.pass_time(2)
    start = now()
    for _ in range(6):
        session.device.events.add(EventKind.FAULT, "Motor 1 fault", is_problem=True)
        session.pass_time(1)
    assert records_of(files[0])[-1].time < start + 5


def test_stop_is_not_recorded_during_a_recording_or_if_off(
    session: RecorderSetup, automatic: EventRecorder, tmp_path: Path
) -> None:
    session.recorder.start(tmp_path / "user.trexrec")
    session.drive()
    session.device.motors.press_stop()
    session.pass_time(1)
    assert not automatic.recording
    session.end_recording()

    automatic.set_on(False)
    session.until(lambda: not session.device.motors.locked_for)
    session.drive()
    session.device.motors.press_stop()
    session.pass_time(1)
    assert not automatic.recording
    assert not EventRecorder(session.device, session.recorder).is_on


def test_fault_is_recorded_if_the_line_closes_at_once(
    session: RecorderSetup, automatic: EventRecorder
) -> None:
    session.pass_time(2)
    session.simulator.do("fault 2 on")
    session.until(lambda: session.device.board.errors.recent(2, now()))
    path, records = new_recording(session, automatic, session.device.disconnect_line)
    assert path.stem.endswith("_fault")
    assert any(isinstance(record, Currents) for record in records)


def test_errors_from_before_the_connection_start_no_recording(
    session: RecorderSetup, automatic: EventRecorder
) -> None:
    session.disconnect()
    session.simulator.do("fault 2 on", "fault 2 off")
    session.connect()
    session.until(lambda: any(entry.is_earlier for entry in session.device.board.errors.entries))
    assert not session.device.board.errors.recent(2, now())
    session.pass_time(1)
    assert not automatic.recording


def test_oldest_recordings_are_removed_unless_renamed() -> None:
    folder = create_automatic_folder()
    names = [automatic_path(datetime(2026, 1, day, tzinfo=UTC), "stop").name for day in range(1, 5)]
    for name in (*names, "my crash.trexrec"):
        (folder / name).write_bytes(bytes(1000))
    (folder / f"{names[0]}-wal").touch()
    remove_oldest(max_files=4)
    assert {path.name for path in folder.iterdir()} == {*names[1:], "my crash.trexrec"}
    remove_oldest(max_bytes=2000)
    assert {path.name for path in folder.iterdir()} == {*names[2:], "my crash.trexrec"}
    remove_oldest(max_bytes=10)
    assert {path.name for path in folder.iterdir()} == {names[3], "my crash.trexrec"}


def test_recording_needs_a_connected_board(tmp_path: Path, qtbot: QtBot) -> None:
    device = Device()
    recorder = Recorder(device)
    assert not recorder.can_record
    assert not recorder.start(tmp_path / "a.trexrec")
    assert list(tmp_path.iterdir()) == []


def test_slow_disk_drops_samples_and_marks_the_gap() -> None:
    backlog: Backlog[Record] = Backlog(capacity=10)
    first: list[Record] = [Control(float(n), by_serial=True) for n in range(8)]
    backlog.put(first)
    backlog.put(first)  # no space left
    assert backlog.lost == 8
    assert backlog.get(0) == first
    backlog.put([Control(20.0, by_serial=True)])
    text = "Samples lost here because the disk was too slow: 8."
    assert backlog.get(0) == [Marker(20.0, "note", text), Control(20.0, by_serial=True)]
    backlog.close(21.0)
    assert backlog.get(0) is None


def test_recording_distinguishes_two_boards(
    start_simulator: StartSimulator, qtbot: QtBot, tmp_path: Path
) -> None:
    simulator = start_simulator("--unpaced", "--device", "7", "--device", "9:trexjr")
    device, path = Device(), tmp_path / "both.trexrec"
    group, recorder = BoardGroup(device), Recorder(device)
    settings = ConnectionSettings(simulator.url).with_group((7, 9))
    device.connect_to(settings)
    qtbot.waitUntil(lambda: device.motors.is_available)
    recorder.start(path)
    device.motors.arm()
    device.motors.set_speeds(40, -20)
    qtbot.waitUntil(lambda: group.devices[9].board.newest[Currents].counts[0] > 0)
    with qtbot.waitSignal(recorder.ended):
        recorder.stop()
    device.shut_down()
    recording = open_recording(path)
    records = recording.read(1, recording.count)
    second_board = [record for record in records if isinstance(record, OtherBoardRecord)]
    assert {record.board for record in second_board} == {9}
    assert any(isinstance(record.record, SetpointRecord) for record in second_board)
    assert any(isinstance(record, Currents) for record in records)
    export = tmp_path / "both.csv"
    export_span(recording, export, (0, math.inf), {})
    recording.close()
    with export.open(encoding="utf-8", newline="") as file:
        rows = [row for row in csv.DictReader(file) if row["sample"] == "currents"]
    for row in rows:
        amperes = {"7": 0.15, "9": 0.04}[row["board"]] * int(row["motor_1_current_counts"])
        assert float(row["motor_1_current_A"]) == pytest.approx(amperes)
    assert {row["board"] for row in rows} == {"7", "9"}
