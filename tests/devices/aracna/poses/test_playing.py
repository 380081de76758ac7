"""Steps of sequences and gaits: limits, blends and late motors."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from tests.support.matrix import examples
from trex_gui.core.errors import BadRequest
from trex_gui.devices.aracna.poses.gaits import (
    BUILT_IN_POSES,
    FLAT,
    GAITS,
    STAND,
    STAND_UP,
    all_legs,
)
from trex_gui.devices.aracna.poses.playing import (
    blend_in,
    blend_out,
    estimated_seconds,
    motor_count_warning,
    slow_motors,
    steps_of,
)
from trex_gui.devices.aracna.poses.project import Pose, Sequence, SequenceStep
from trex_gui.devices.aracna.protocol.joints import (
    MAX_EFFECTIVE_SPEED,
    UNITS_PER_SECOND,
    factory_limits,
)
from trex_gui.devices.aracna.session.messages import Step

LIMITS = factory_limits()
SEQUENCE = Sequence("up", (SequenceStep("flat", 3000), SequenceStep("stand", 500)))
FLAT_GOALS, STAND_GOALS = (600, 40) * 4, (512, 550) * 4


def test_sequence_becomes_steps_within_limits() -> None:
    assert steps_of(SEQUENCE, BUILT_IN_POSES, LIMITS) == (
        Step(FLAT_GOALS, 3.0, "flat"),
        Step(STAND_GOALS, 0.5, "stand"),
    )
    scaled_for_two_motors = steps_of(SEQUENCE, BUILT_IN_POSES, factory_limits(2), 2.0)
    assert scaled_for_two_motors == (Step((600, 40), 6.0, "flat"), Step((512, 550), 1.0, "stand"))


def test_sequence_with_undefined_poses_is_rejected() -> None:
    gait = Sequence("gait", (SequenceStep("p1"), SequenceStep("flat"), SequenceStep("p2")))
    with pytest.raises(BadRequest, match="p1, p2"):
        steps_of(gait, BUILT_IN_POSES, LIMITS)
    assert steps_of(gait, [Pose("p1", FLAT_GOALS), Pose("p2", FLAT_GOALS), FLAT], LIMITS)


def test_sequence_without_steps_is_rejected() -> None:
    with pytest.raises(BadRequest, match="no steps"):
        steps_of(Sequence("nothing"), BUILT_IN_POSES, LIMITS)


def test_cyclic_gait_blends_in_to_last_pose_unless_robot_is_there() -> None:
    star = next(gait for gait in GAITS if gait.name == "star 6")
    [step] = blend_in(star, (), LIMITS, (None,) * 8)
    assert step.seconds == 3.0
    first, *_, last = steps_of(star, (), LIMITS)
    assert step.goals == last.goals != first.goals
    assert blend_in(star, (), LIMITS, step.goals) == ()


def test_sequence_blends_in_to_first_pose_but_stand_up_does_not() -> None:
    assert blend_in(SEQUENCE, BUILT_IN_POSES, LIMITS) == (Step(FLAT_GOALS, 3.0, "flat"),)
    assert blend_in(STAND_UP, (), LIMITS) == ()


def test_blend_out_ends_in_built_in_or_own_stand_pose() -> None:
    assert blend_out(LIMITS) == (Step(STAND_GOALS, 3.0, "stand"),)
    [own] = blend_out(LIMITS, [all_legs(STAND.name, 300, 300)])
    assert own.goals == (300,) * 8


def test_late_motors_are_reported_with_needed_time() -> None:
    steps = (Step((0, 500), 1.0), Step((100, 0), 0.1))
    needed = pytest.approx(500 / (UNITS_PER_SECOND * MAX_EFFECTIVE_SPEED))
    assert slow_motors(steps, (0, 500)) == {1: {1: needed}}


def test_loop_includes_travel_from_last_to_first_step() -> None:
    steps = (Step((1000,), 0.1), Step((0,), 1.0))
    assert slow_motors(steps, (1000,)) == {}
    assert list(slow_motors(steps, (1000,), repeated=True)) == [0]


def test_first_step_of_loop_needs_time_for_longest_travel() -> None:
    steps = (Step((500,), 0.1), Step((800,), 1.0))
    once = slow_motors(steps, (0,))
    assert slow_motors(steps, (0,), repeated=True) == once
    assert slow_motors(steps, (700,), repeated=True)[0][0] > slow_motors(steps, (700,))[0][0]


def test_motor_at_unknown_position_is_not_late() -> None:
    assert list(slow_motors((Step((1000, 1000), 0.1),), (None, 0))[0]) == [1]


def test_estimate_uses_step_times_or_slowest_motors() -> None:
    steps = (Step((1000, 10), 2.0), Step((0, 0), 0.1))
    assert estimated_seconds(steps, (0, 0)) == pytest.approx(2.0 + 1000 / (2.28 * 870))


@examples(40)
@given(
    st.lists(
        st.tuples(st.tuples(*[st.integers(0, 1023)] * 2), st.floats(0.01, 10)),
        min_size=1,
        max_size=5,
    )
)
def test_estimate_exceeds_step_times_only_with_slow_motors(
    stages: list[tuple[tuple[int, ...], float]],
) -> None:
    steps = tuple(Step(goals, max(seconds, 0.1)) for goals, seconds in stages)
    total = sum(step.seconds for step in steps)
    estimate = estimated_seconds(steps, (512, 512))
    assert estimate >= total - 1e-9
    assert (estimate > total + 1e-9) == any(
        max(needed.values()) > steps[step].seconds + 1e-9
        for step, needed in slow_motors(steps, (512, 512)).items()
    )


@pytest.mark.parametrize(
    ("positions", "message"),
    [
        (8, ""),
        (18, "are for 18 motors, but the robot has 8: the last positions are ignored"),
        (2, "are for 2 motors, but the robot has 8: the remaining motors go to 512"),
    ],
)
def test_poses_for_other_motor_count_are_reported(positions: int, message: str) -> None:
    text = motor_count_warning([STAND, Pose("other", (512,) * positions)], 8)
    assert message in text
    assert bool(message) is bool(text)
