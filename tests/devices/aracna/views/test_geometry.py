"""Sketch of the robot: symmetry and bounds."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from tests.support.matrix import examples
from trex_gui.devices.aracna.views.robot.drawing import drawn_legs


@examples(40)
@given(pair=st.tuples(st.integers(0, 1023), st.integers(0, 1023)))
def test_legs_with_equal_positions_are_mirrored_within_picture(pair: tuple[int, int]) -> None:
    left_front, right_front, right_back, left_back = (leg.foot for leg in drawn_legs(pair * 4))
    for right, left in ((right_front, left_front), (right_back, left_back)):
        assert right[0] == pytest.approx(-left[0], abs=1e-9)
        assert right[1] == pytest.approx(left[1], abs=1e-9)
    assert right_front[1] == pytest.approx(-right_back[1], abs=1e-9)
    assert max(map(abs, (*right_front, *left_back))) <= 1


def test_motors_0_and_1_are_front_left_leg() -> None:
    first = drawn_legs((512,) * 8)[0]
    assert first.foot[0] < 0
    assert first.foot[1] < 0


def test_two_motor_robot_has_one_leg() -> None:
    assert len(drawn_legs((512, 512))) == 1
