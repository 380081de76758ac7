"""Recording a session with the simulated robot while it runs."""

import csv
import math
from collections.abc import Iterator
from pathlib import Path

import pytest
from pytestqt.qtbot import QtBot

from tests.devices.aracna.recordings import open_recording
from tests.support.simulator import StartSimulator
from trex_gui.core.recording.export import export_span
from trex_gui.core.timing import Timeouts
from trex_gui.core.transport.settings import PortSettings
from trex_gui.devices.aracna.model.recordings import AracnaRecorder
from trex_gui.devices.aracna.model.robot import Robot
from trex_gui.ui.devices.connection import ConnectionState


def rows(path: Path) -> list[dict[str, str]]:
    """Export a recording, and return its rows."""
    recording = open_recording(path)
    target = path.with_suffix(".csv")
    export_span(recording, target, (-math.inf, math.inf), recording.header.values())
    recording.close()
    with target.open(encoding="utf-8", newline="") as file:
        return list(csv.DictReader(file))


@pytest.fixture
def robot(qtbot: QtBot, start_simulator: StartSimulator) -> Iterator[Robot]:
    simulator = start_simulator("--aracna", "--unpaced")
    robot = Robot()
    robot.open(PortSettings(simulator.url, timeouts=Timeouts(extra=2.0)))
    qtbot.waitUntil(lambda: robot.link is ConnectionState.CONNECTED, timeout=15_000)
    yield robot
    robot.close()
    qtbot.waitUntil(lambda: robot.link is ConnectionState.DISCONNECTED, timeout=15_000)
    assert robot.shut_down()


@pytest.fixture
def recorder(robot: Robot) -> Iterator[AracnaRecorder]:
    recorder = AracnaRecorder(robot)
    yield recorder
    assert recorder.shut_down()


def test_move_is_recorded_with_goals_positions_and_speeds(
    robot: Robot, recorder: AracnaRecorder, tmp_path: Path, qtbot: QtBot
) -> None:
    path = tmp_path / "session.trexrec"
    assert recorder.start(path)
    assert recorder.recording
    assert not recorder.can_record
    assert robot.move((500,) * 8)
    qtbot.waitUntil(lambda: robot.state.moved is not None, timeout=15_000)
    with qtbot.waitSignal(recorder.ended, timeout=15_000) as ended:
        recorder.stop()
    assert ended.args == [path]
    assert recorder.size == path.stat().st_size
    found = rows(path)
    kinds = [row["sample"] for row in found]
    assert kinds[0] == "header"
    assert kinds.index("speeds") < kinds.index("goals") < kinds.index("present")
    last = [row for row in found if row["sample"] == "present"][-1]
    assert last["motor_3_goal_units"] == "500"
    assert abs(int(last["motor_3_present_units"]) - 500) < 10
    times = [float(row["time_s"]) for row in found]
    assert times == sorted(times)


def test_recording_starts_with_known_state(
    robot: Robot, recorder: AracnaRecorder, tmp_path: Path, qtbot: QtBot
) -> None:
    robot.move((500,) * 8)
    qtbot.waitUntil(lambda: robot.state.moved is not None, timeout=15_000)
    recorder.start(tmp_path / "later.trexrec")
    with qtbot.waitSignal(recorder.ended, timeout=15_000):
        recorder.stop()
    assert [row["sample"] for row in rows(tmp_path / "later.trexrec")[:3]] == [
        *("header", "present", "speeds")
    ]


def test_disconnect_ends_recording_with_message(
    robot: Robot, recorder: AracnaRecorder, tmp_path: Path, qtbot: QtBot
) -> None:
    recorder.start(tmp_path / "cut.trexrec")
    with qtbot.waitSignals([recorder.ended_early, recorder.ended], timeout=15_000):
        robot.close()
    assert not recorder.recording
    assert rows(tmp_path / "cut.trexrec")[0]["sample"] == "header"


def test_unwritable_file_is_reported(
    recorder: AracnaRecorder, tmp_path: Path, qtbot: QtBot
) -> None:
    with qtbot.waitSignal(recorder.failed, timeout=15_000) as failed:
        recorder.start(tmp_path / "gone" / "a.trexrec")
    assert "cannot be written" in failed.args[0]
    qtbot.waitUntil(lambda: recorder.can_record, timeout=15_000)


def test_recording_needs_connected_robot(tmp_path: Path, qtbot: QtBot) -> None:
    del qtbot
    recorder = AracnaRecorder(Robot())
    assert not recorder.start(tmp_path / "a.trexrec")
    assert list(tmp_path.iterdir()) == []
