"""Playback of a robot's recording."""

import math
from pathlib import Path
from random import Random

import pytest
from pytestqt.qtbot import QtBot

from tests.devices.aracna.recordings import MOTORS, T0, open_recording, session, write
from tests.support.playing import loading
from trex_gui.core.recording.store import CHUNK
from trex_gui.devices.aracna.model.recordings import RobotPlayback
from trex_gui.devices.aracna.model.robot_state import RobotState
from trex_gui.devices.aracna.protocol.joints import degrees
from trex_gui.devices.aracna.recording import Record
from trex_gui.devices.aracna.session.messages import (
    Moved,
    Moving,
    NotResponding,
    Progress,
    Restarted,
    Stuck,
)

TIMEOUT_MS = 20_000


def loaded(path: Path, qtbot: QtBot, *content: Record) -> RobotPlayback:
    write(path, list(content))
    playback = loading(RobotPlayback(open_recording(path)))
    assert not playback.is_loaded
    with qtbot.waitSignal(playback.loaded, timeout=TIMEOUT_MS):
        pass
    return playback


def state_at(content: list[Record], time: float) -> RobotState:
    """Return the state after all records up to a time."""
    state = RobotState(MOTORS)
    for record in content:
        if record.time <= time:
            state.update(record)
    return state


def test_seek_gives_same_state_as_reading_from_start(tmp_path: Path, qtbot: QtBot) -> None:
    content = list(session(110))
    assert len(content) > CHUNK
    long = loaded(tmp_path / "long.trexrec", qtbot, *content)
    long.set_position(T0 + 10)
    before = long.state()
    present = before.present
    random = Random(3)
    times = [random.uniform(0, long.end - T0) + 1e-4 for _ in range(40)]
    for time in [*sorted(times, reverse=True), *times]:
        long.set_position(T0 + time)
        assert long.state() == state_at(content, long.position)
    assert before.present == present, "an earlier state does not change"
    long.close()


def test_curve_is_flat_at_rest_and_linear_in_motion(tmp_path: Path, qtbot: QtBot) -> None:
    playback = loaded(
        tmp_path / "a.trexrec",
        qtbot,
        Moved(T0, (100,) * 8, (100,) * 8, 1.0),
        Moving(T0 + 10, (200,) * 8, (100,) * 8, 2.0),
        Progress(T0 + 11, (200,)),
        Progress(T0 + 11.5, (200, 200)),
        Moved(T0 + 12, (200,) * 8, (200,) * 8, 2.0),
    )
    times, columns = playback.traces.samples(playback.start, playback.end)
    assert [round(time - T0, 3) for time in times] == [0, 10, 12]
    positions = [[round(float(value) / degrees(1)) for value in column] for column in columns]
    assert positions == [[100, 100, 200]] * 8
    playback.close()


@pytest.mark.parametrize("lost", [Restarted(T0 + 3, voided=False), NotResponding(T0 + 3)])
def test_curve_has_gap_while_position_is_unknown(
    tmp_path: Path, qtbot: QtBot, lost: Record
) -> None:
    playback = loaded(
        tmp_path / "a.trexrec",
        qtbot,
        Moving(T0 + 1, (100,) * 8, (None,) * 8, 1.0),
        Moved(T0 + 2, (100,) * 8, (100,) * 8, 1.0),
        lost,
        Moving(T0 + 5, (200,) * 8, (None,) * 8, 1.0),
        Moved(T0 + 6, (200,) * 8, (200,) * 8, 1.0),
    )
    value_at = playback.traces.value_at
    assert math.isnan(value_at("motor_0", T0 + 1.5))
    assert value_at("motor_0", T0 + 2.5) == degrees(100)
    assert math.isnan(value_at("motor_0", T0 + 4))
    playback.set_position(T0 + 4)
    state = playback.state()
    assert state.present == (None,) * 8
    assert state.uncertain
    assert value_at("motor_7", T0 + 6) == degrees(200)
    playback.close()


def test_stuck_motor_is_known_until_robot_replies(tmp_path: Path, qtbot: QtBot) -> None:
    playback = loaded(
        tmp_path / "a.trexrec",
        qtbot,
        Moving(T0 + 1, (100,) * 8, (None,) * 8, 1.0),
        Progress(T0 + 2, (100, 100, 100)),
        Stuck(T0 + 5, 3),
        Moved(T0 + 9, (100,) * 8, (100,) * 3 + (-1,) * 5, 8.0),
    )
    playback.set_position(T0 + 6)
    state = playback.state()
    assert state.stuck is not None
    assert state.stuck.motor == state.awaited_motor == 3
    playback.set_position(T0 + 9)
    state = playback.state()
    assert state.stuck is None
    assert list(state.missed_goals) == [3, 4, 5, 6, 7]
    playback.close()
