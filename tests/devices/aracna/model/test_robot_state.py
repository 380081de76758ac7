"""State of a robot during and after motions."""

import pytest

from trex_gui.devices.aracna.model.robot_state import RobotState
from trex_gui.devices.aracna.session.messages import (
    Connected,
    Moved,
    Moving,
    NotResponding,
    Restarted,
    Stuck,
)

GOALS = (300, 400)
STARTED = Moving(10.0, GOALS, (None, None), 4.0)
THERE = Moved(13.0, GOALS, GOALS, 3.0)
CONNECTED = Connected(1, 2)


def state_after(*reports: object) -> RobotState:
    state = RobotState(2)
    for report in reports:
        state.update(report)
    return state


def test_new_robot_may_be_moving_for_unknown_time() -> None:
    state = state_after(CONNECTED)
    assert state.may_be_moving
    assert state.moving_until is None
    assert not state.uncertain, "nothing was sent"


def test_observed_motion_has_end_time_until_reply() -> None:
    assert not state_after(CONNECTED, STARTED).may_be_moving
    assert state_after(CONNECTED, STARTED).moving_until == 14.0
    state = state_after(CONNECTED, STARTED, THERE)
    assert not state.may_be_moving
    assert state.moving_until is None


@pytest.mark.parametrize(
    "end",
    [
        (Restarted(11.0, voided=True),),
        (Restarted(11.0, voided=True), CONNECTED),
        (NotResponding(13.0), CONNECTED),
        (CONNECTED,),
        (Moved(11.0, GOALS, (-1, -1), 1.0),),
        (Stuck(11.0, 1), Restarted(12.0, voided=True), NotResponding(13.0)),
    ],
    ids=["restart", "reconnection", "silence", "reply to query", "lost reply", "stuck"],
)
def test_interrupted_motion_keeps_its_expected_end(end: tuple[object, ...]) -> None:
    state = state_after(CONNECTED, STARTED, *end)
    assert state.moving is None
    assert state.stuck is None
    assert state.moving_until == 14.0
    assert state.may_be_moving
    assert state.uncertain


def test_next_motion_replaces_interrupted_motion() -> None:
    interrupted = (CONNECTED, STARTED, Restarted(11.0, voided=True), CONNECTED)
    following = Moving(12.0, GOALS, (None, None), 7.0)
    assert state_after(*interrupted, following).moving_until == 19.0
    state = state_after(*interrupted, following, THERE)
    assert state.moving_until is None
    assert not state.may_be_moving
