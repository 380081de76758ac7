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


def known(*reports: object) -> RobotState:
    found = RobotState(2)
    for report in reports:
        found.update(report)
    return found


def test_new_robot_may_be_moving_for_unknown_time() -> None:
    found = known(CONNECTED)
    assert found.may_be_moving
    assert found.moving_until is None
    assert not found.uncertain, "nothing was sent"


def test_observed_motion_has_end_time_until_reply() -> None:
    assert not known(CONNECTED, STARTED).may_be_moving
    assert known(CONNECTED, STARTED).moving_until == 14.0
    found = known(CONNECTED, STARTED, THERE)
    assert not found.may_be_moving
    assert found.moving_until is None


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
    found = known(CONNECTED, STARTED, *end)
    assert found.moving is None
    assert found.stuck is None
    assert found.moving_until == 14.0
    assert found.may_be_moving
    assert found.uncertain


def test_next_motion_replaces_interrupted_motion() -> None:
    interrupted = (CONNECTED, STARTED, Restarted(11.0, voided=True), CONNECTED)
    following = Moving(12.0, GOALS, (None, None), 7.0)
    assert known(*interrupted, following).moving_until == 19.0
    found = known(*interrupted, following, THERE)
    assert found.moving_until is None
    assert not found.may_be_moving
