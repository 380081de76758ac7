"""The sketch of the robot: symmetrical where numbers are alike, and within its picture."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from tests.support.matrix import examples
from trex_gui.devices.aracna.protocol.joints import Leg
from trex_gui.devices.aracna.views.robot.drawing import drawn_legs


@examples(40)
@given(pair=st.tuples(st.integers(0, 1023), st.integers(0, 1023)))
def test_legs_with_equal_positions_are_mirrored_within_picture(pair: tuple[int, int]) -> None:
    drawn = {leg.leg: leg for leg in drawn_legs(pair * 4)}
    for right, left in ((Leg.RIGHT_FRONT, Leg.LEFT_FRONT), (Leg.RIGHT_BACK, Leg.LEFT_BACK)):
        assert drawn[right].foot[0] == pytest.approx(-drawn[left].foot[0], abs=1e-9)
        assert drawn[right].foot[1] == pytest.approx(drawn[left].foot[1], abs=1e-9)
    front, back = drawn[Leg.RIGHT_FRONT].foot, drawn[Leg.RIGHT_BACK].foot
    assert front[1] == pytest.approx(-back[1], abs=1e-9)
    assert all(max(map(abs, leg.foot)) <= 1.05 for leg in drawn.values())


def test_motors_0_and_1_are_left_front_leg() -> None:
    first = drawn_legs((512,) * 8)[0]
    assert first.leg is Leg.LEFT_FRONT
    assert first.foot[0] < 0
    assert first.foot[1] < 0


def test_two_motor_robot_has_one_leg() -> None:
    assert len(drawn_legs((512, 512))) == 1
