"""Recording a session while it runs."""

import shutil
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest
from pytestqt.qtbot import QtBot

from tests.devices.trex.recording.samples import open_recording, read_file
from tests.support.simulator import SimulatedDevice
from trex_gui.core.recording.backlog import Backlog
from trex_gui.core.recording.kinds import Marker
from trex_gui.devices.trex.client.telemetry import Control, Currents, ModeSample, Raw, Remapped
from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.model.recorder import Recorder
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.devices.trex.protocol.driving import Drive
from trex_gui.devices.trex.recording import Record, SetpointRecord, SettingsSnapshot
from trex_gui.devices.trex.session.messages import Batch
from trex_gui.ui.devices.connection import ConnectionState
from trex_gui.ui.event_log import EventKind
from trex_gui.ui.runtime import now


class RecorderSetup:
    """A device on a simulated board, its recorder, and everything the line reported."""

    def __init__(self, simulator: SimulatedDevice, qtbot: QtBot) -> None:
        self.simulator = simulator
        self.qtbot = qtbot
        self.device = Device()
        self.recorder = Recorder(self.device)
        self.samples: list[object] = []
        self.device.sampled.connect(self._on_sampled)
        self.connect()

    def _on_sampled(self, batch: Batch) -> None:
        if self.recorder.recording:
            self.samples += batch.samples

    def connect(self) -> None:
        self.device.connect_to(ConnectionSettings(self.simulator.url))
        self.wait(lambda: self.device.link is ConnectionState.CONNECTED)

    def wait(self, condition: Callable[[], bool]) -> None:
        self.qtbot.waitUntil(condition, timeout=20_000)

    def end_recording(self) -> None:
        with self.qtbot.waitSignal(self.recorder.ended, timeout=20_000):
            self.recorder.stop()

    def end(self) -> None:
        self.recorder.shut_down()
        self.device.shut_down()


@pytest.fixture
def session(quick_simulator: SimulatedDevice, qtbot: QtBot) -> Iterator[RecorderSetup]:
    session = RecorderSetup(quick_simulator, qtbot)
    yield session
    session.end()


def test_recording_has_every_sample_while_no_window_is_seen(
    session: RecorderSetup, tmp_path: Path
) -> None:
    session.device.set_seen(False)
    session.recorder.start(tmp_path / "unseen.trexrec")
    begun = now()
    session.wait(lambda: now() > begun + 3)
    session.end_recording()
    assert sum(isinstance(one, Currents) for one in session.samples) > 3 * 70

    session.samples.clear()
    begun, before = now(), session.device.telemetry.samples
    session.wait(lambda: now() > begun + 3)
    assert session.device.telemetry.samples - before < 3 * 60


def everything(path: Path) -> list[Record]:
    _, records, problems = read_file(path)
    assert problems == []
    return records


def test_every_reported_sample_is_recorded(session: RecorderSetup, tmp_path: Path) -> None:
    path = tmp_path / "session.trexrec"
    assert session.recorder.start(path)
    session.wait(lambda: len(session.samples) > 400)
    session.end_recording()
    samples = [
        record
        for record in everything(path)
        if isinstance(record, Currents | Raw | Remapped | Control | ModeSample)
    ]
    assert samples == session.samples
    assert session.recorder.size == path.stat().st_size
    assert {Currents, Raw, Remapped, Control} <= {type(sample) for sample in samples}


def test_header_names_board_mode_and_settings(session: RecorderSetup, tmp_path: Path) -> None:
    session.recorder.start(tmp_path / "a.trexrec")
    session.end_recording()
    file = open_recording(tmp_path / "a.trexrec")
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
    device.motors.arm()
    device.motors.set_speed(1, 40)
    session.wait(lambda: len(session.samples) > 50)
    device.motors.press_stop()
    session.wait(lambda: not device.may_move)
    device.parameters.edit("serial_timeout", 9)
    with session.qtbot.waitSignal(device.applied, timeout=20_000):
        device.apply()
    session.end_recording()
    records = everything(path)
    setpoints = [record for record in records if isinstance(record, SetpointRecord)]
    assert [(one.motor, one.drive) for one in setpoints] == [(1, Drive.at(40))]
    kinds = [record.kind for record in records if isinstance(record, Marker)]
    assert {EventKind.STOP.value, EventKind.APPLY.value} <= set(kinds)
    (seen,) = [record for record in records if isinstance(record, SettingsSnapshot)]
    assert "serial_timeout: 9 " in seen.text
    times = [record.time for record in records]
    assert max(times) - min(times) < 60
    assert min(times) <= setpoints[0].time < seen.time <= max(times)


def test_disconnecting_ends_the_recording_intact(session: RecorderSetup, tmp_path: Path) -> None:
    session.recorder.start(tmp_path / "a.trexrec")
    session.wait(lambda: len(session.samples) > 50)
    with session.qtbot.waitSignals([session.recorder.ended_early, session.recorder.ended]):
        session.device.disconnect_line()
    assert not session.recorder.recording
    assert everything(tmp_path / "a.trexrec")


def test_recording_continues_while_the_board_is_unresponsive(
    session: RecorderSetup, tmp_path: Path
) -> None:
    session.recorder.start(tmp_path / "a.trexrec")
    session.wait(lambda: len(session.samples) > 50)
    session.simulator.do("power off")
    session.wait(lambda: session.device.link is ConnectionState.NOT_RESPONDING)
    assert session.recorder.recording
    session.simulator.do("power on")
    session.wait(lambda: session.device.link is ConnectionState.CONNECTED)
    before = len(session.samples)
    session.wait(lambda: len(session.samples) > before + 50)
    assert session.recorder.recording
    session.end_recording()
    assert len(everything(tmp_path / "a.trexrec")) >= before + 50


def test_recording_ends_when_the_input_source_changes(
    session: RecorderSetup, tmp_path: Path
) -> None:
    session.recorder.start(tmp_path / "a.trexrec")
    session.simulator.do("jumper mode analog")
    with session.qtbot.waitSignal(session.recorder.ended, timeout=20_000):
        session.simulator.do("power cycle")
    assert everything(tmp_path / "a.trexrec")


def test_full_disk_fails_the_recording_but_not_the_connection(
    session: RecorderSetup, tmp_path: Path, full_disk: None
) -> None:
    with session.qtbot.waitSignal(session.recorder.failed, timeout=20_000) as failed:
        session.recorder.start(tmp_path / "a.trexrec")
    assert "cannot be written: No space left" in failed.args[0]
    session.wait(lambda: session.recorder.can_record)
    samples = session.device.telemetry.samples
    session.wait(lambda: session.device.telemetry.samples > samples)


def test_recording_is_committed_every_second(session: RecorderSetup, tmp_path: Path) -> None:
    path = tmp_path / "a.trexrec"
    session.recorder.start(path)
    session.wait(lambda: len(session.samples) > 50)
    begin = now()
    session.wait(lambda: now() > begin + 1)
    copies = [tmp_path / f"copy{suffix}" for suffix in (".trexrec", ".trexrec-wal")]
    for suffix, copied in zip(("", "-wal"), copies, strict=True):
        shutil.copy(f"{path}{suffix}", copied)  # what a power failure would leave
    recording = open_recording(copies[0])
    last = recording.read(recording.count - 20, recording.count)[-1]
    recording.close()
    assert last.time > begin
    session.end_recording()


def test_missing_folder_is_reported(session: RecorderSetup, tmp_path: Path) -> None:
    with session.qtbot.waitSignal(session.recorder.failed, timeout=20_000) as failed:
        session.recorder.start(tmp_path / "none" / "a.trexrec")
    assert "No such file" in failed.args[0]
    session.wait(lambda: session.recorder.can_record)


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
    backlog.put(first)  # has no room
    assert backlog.lost == 8
    assert backlog.get(0) == first
    backlog.put([Control(20.0, by_serial=True)])
    text = "Samples missing here, because the disk was too slow: 8."
    assert backlog.get(0) == [Marker(20.0, "note", text), Control(20.0, by_serial=True)]
    backlog.close(21.0)
    assert backlog.get(0) is None
