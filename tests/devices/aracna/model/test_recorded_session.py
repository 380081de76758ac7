"""Recording of a session with the simulated robot."""

from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import pytest
from pytestqt.qtbot import QtBot

from tests.devices.aracna.model.test_robot import RobotHarness
from tests.devices.aracna.recordings import open_recording, read_all
from tests.support.playing import loading
from tests.support.simulator import SimulatedDevice
from tests.support.virtual_devices import VirtualSimulator
from trex_gui.core.events import EventKind
from trex_gui.core.recording.kinds import Marker
from trex_gui.devices.aracna.model.recordings import AracnaRecorder, RobotPlayback
from trex_gui.devices.aracna.model.robot import Robot
from trex_gui.devices.aracna.recording import Record
from trex_gui.devices.aracna.session.messages import (
    Moved,
    Moving,
    NotResponding,
    Play,
    PlayEnded,
    Progress,
    Restarted,
    SpeedsHeld,
    Step,
    StepStarted,
    Stuck,
)
from trex_gui.ui.devices.connection import ConnectionState

TIMEOUT_MS = 15_000
RECORDED = (
    *(Moving, Progress, Moved, SpeedsHeld, StepStarted, PlayEnded, Stuck, Restarted),
    *(NotResponding, Marker),
)


class Session(RobotHarness):
    """Connected robot with its recorder and its reports during the recording."""

    def __init__(self, qtbot: QtBot, path: Path, simulator: SimulatedDevice) -> None:
        super().__init__(simulator, qtbot)
        self.path = path
        self.recorder = AracnaRecorder(self.robot)
        self.reported: list[Record] = []
        self.robot.reported.connect(self._on_reported)
        self.connect()

    def _on_reported(self, report: object) -> None:
        if self.recorder.recording and isinstance(report, RECORDED):
            if isinstance(report, NotResponding):
                report = replace(report, error=None)  # not recorded
            self.reported.append(report)

    def wait_for(self, link: ConnectionState) -> None:
        self.wait(lambda: self.robot.link is link)

    def stop(self) -> list[Record]:
        with self.qtbot.waitSignal(self.recorder.ended, timeout=TIMEOUT_MS):
            self.recorder.stop()
        found, problems = read_all(self.path)
        assert problems == []
        return found

    def end(self) -> None:
        assert self.recorder.shut_down()
        super().end()


@pytest.fixture
def session(qtbot: QtBot, tmp_path: Path, robot: SimulatedDevice) -> Iterator[Session]:
    session = Session(qtbot, tmp_path / "session.trexrec", robot)
    yield session
    session.end()


def without_markers(rows: list[Record]) -> list[Record]:
    return [row for row in rows if not isinstance(row, Marker)]


def test_every_report_is_read_back_equal(session: Session) -> None:
    session.recorder.start(session.path)
    session.move((500,) * 8)
    session.move(tuple(range(100, 500, 50)))
    steps = tuple(Step((goal,) * 8, 0.1) for goal in (300, 320, 340))
    with session.qtbot.waitSignal(
        session.robot.reported,
        timeout=TIMEOUT_MS,
        check_params_cb=lambda report: isinstance(report, PlayEnded),
    ):
        session.robot.play(Play(0, steps, rounds=2))
    found = session.stop()
    types = {type(row) for row in session.reported}
    assert types >= {Moving, Progress, Moved, SpeedsHeld, StepStarted, PlayEnded}
    assert without_markers(found) == session.reported
    texts = [row.text for row in found if isinstance(row, Marker)]
    assert f"Move to {', '.join(['500'] * 8)}." in texts
    assert "Played to the end." in texts
    assert texts[-1] == "The recording ends here."


def test_recording_contains_faults_and_rejected_move(session: Session) -> None:
    session.recorder.start(session.path)
    session.move((500,) * 8)
    session.lose_motor_3((400,) * 8)
    session.wait(lambda: session.robot.state.stuck is not None)
    assert not session.robot.move((300,) * 8)
    session.simulator.do("servo 3 alive")
    session.wait(lambda: session.robot.state.moving is None)
    session.links.clear()
    session.simulator.do("reset")
    session.wait(
        lambda: ConnectionState.NOT_RESPONDING in [link for link, _ in session.links]
    )  # for a second
    session.wait_for(ConnectionState.CONNECTED)
    session.simulator.do("line mute on")
    session.wait_for(ConnectionState.NOT_RESPONDING)
    session.simulator.do("line mute off")
    session.wait_for(ConnectionState.CONNECTED)
    found = session.stop()
    kinds = {type(row) for row in found}
    assert {Stuck, Restarted, NotResponding} <= kinds
    assert without_markers(found) == session.reported
    markers = [row for row in found if isinstance(row, Marker)]
    assert any(
        "is waiting for motor" in each.text for each in markers if each.kind == EventKind.NOTE
    )
    assert any(
        "is waiting for motor 3" in each.text for each in markers if each.kind == EventKind.FAULT
    )
    assert any("restarted" in each.text for each in markers)
    assert any(each.kind == EventKind.LINK for each in markers)


def test_late_recording_starts_with_known_state(session: Session) -> None:
    session.move((500,) * 8)
    session.robot.set_speeds((40,) * 8)
    assert session.robot.move((100,) * 8)  # 4.4 s, during which the recording starts
    session.wait(lambda: session.robot.state.moving is not None)
    moving, speeds = session.robot.state.moving, session.robot.state.speeds
    assert moving is not None
    assert speeds is not None
    session.recorder.start(session.path)
    session.wait(lambda: session.robot.state.moved is not None)
    state = session.robot.state
    first, second, third, *rest = without_markers(session.stop())
    assert isinstance(first, Progress)
    assert isinstance(second, SpeedsHeld)
    assert second.held == speeds.held
    assert isinstance(third, Moving)
    assert replace(third, time=0, expected=0) == replace(moving, time=0, expected=0)
    assert third.expected <= moving.expected
    assert isinstance(rest[-1], Moved)
    assert rest[-1].present == state.present


def test_curves_continue_to_end_of_recording(session: Session, qtbot: QtBot) -> None:
    session.recorder.start(session.path)
    session.move((500,) * 8)
    session.move(tuple(range(100, 500, 50)))
    ending = session.stop()[-1]
    assert ending.time > session.reported[-1].time
    playback = loading(RobotPlayback(open_recording(session.path)))
    with qtbot.waitSignal(playback.loaded, timeout=TIMEOUT_MS):
        pass
    last = playback.traces.samples(playback.start, playback.end)[0][-1]
    assert playback.end == last == ending.time
    playback.close()


def test_disconnect_ends_recording(session: Session) -> None:
    session.recorder.start(session.path)
    ending = [session.recorder.ended_early, session.recorder.ended]
    with session.qtbot.waitSignals(ending, timeout=TIMEOUT_MS):
        session.robot.close()
    assert not session.recorder.recording
    assert read_all(session.path)[1] == []


def test_recording_ends_when_robot_with_other_motor_count_responds(session: Session) -> None:
    simulator = session.simulator
    assert isinstance(simulator, VirtualSimulator)
    other = VirtualSimulator(simulator.runtime, "other", "--aracna", "--unpaced", "--motors", "2")
    session.move((500,) * 8)
    session.recorder.start(session.path)
    with session.qtbot.waitSignal(session.recorder.ended_early, timeout=TIMEOUT_MS) as ended:
        simulator.move_cable_to(other)
    assert "the number of motors has changed" in ended.args[0]
    first, *_ = read_all(session.path)[0]
    assert isinstance(first, Moved)
    assert first.present == (500,) * 8


def test_recording_needs_connected_robot(tmp_path: Path, qtbot: QtBot) -> None:
    assert not AracnaRecorder(Robot()).start(tmp_path / "a.trexrec")
    assert list(tmp_path.iterdir()) == []
