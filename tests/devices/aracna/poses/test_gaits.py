"""Built-in poses and gaits, as the robot's authors describe them."""

import math

import pytest

from trex_gui.devices.aracna.poses.gaits import BUILT_IN_POSES, GAITS, Gait
from trex_gui.devices.aracna.protocol.joints import clamp, factory_limits


def gait(name: str) -> Gait:
    return next(gait for gait in GAITS if gait.name == name)


@pytest.mark.parametrize(
    ("name", "inner", "outer"),
    [
        ("flat", 770, 40),
        ("half-stand", 700, 100),
        ("stand", 512, 680),
        ("up-1", 0, 600),
        ("up-2", 600, 600),
        ("self-test a", 770, 200),
        ("self-test b", 670, 300),
    ],
)
def test_built_in_poses_repeat_joint_pair_within_limits(name: str, inner: int, outer: int) -> None:
    pose = next(pose for pose in BUILT_IN_POSES if pose.name == name)
    assert pose.positions == (min(max(inner, 50), 600), min(outer, 550)) * 4


def test_every_built_in_pose_is_within_factory_limits() -> None:
    for pose in (*BUILT_IN_POSES, *(pose for gait in GAITS for pose in gait.poses)):
        assert clamp(pose.positions, factory_limits()) == pose.positions, pose.name


@pytest.mark.parametrize("number", [0, 2, 4, 6])
def test_star_gait_lifts_diagonal_legs_and_swings_outer_joints(number: int) -> None:
    star = gait(f"star {number}")
    assert [step.milliseconds for step in star.steps] == [500, 200, 500, 200]
    offsets = [[position - 300 for position in pose.positions] for pose in star.poses]
    swung, opposite = number + 1, (number + 5) % 8
    swinging, standing = {number, (number + 4) % 8}, {(number + 2) % 8, (number + 6) % 8}
    for changes, lifted, swing in zip(
        offsets, [standing, swinging, swinging, standing], [300, 300, -300, 0], strict=True
    ):
        expected = [0] * 8
        for motor in lifted:
            expected[motor] = -200
        expected[swung], expected[opposite] = min(-swing, 250), min(swing, 250)
        assert changes == expected


def test_sine_gait_follows_sine_function() -> None:
    sine = gait("sine")
    assert sum(step.milliseconds for step in sine.steps) / 1000 == pytest.approx(
        2 * math.pi, abs=16 * 0.0005
    )  # whole milliseconds
    for number, pose in enumerate(sine.poses, 1):
        time = 2 * math.pi * number / 16
        position = min(512 + 100 * math.sin(time), 600)  # clamped as on the robot
        assert pose.positions[0] == pytest.approx(position, abs=0.51)


def test_every_gait_has_unique_name_text_and_eight_motors() -> None:
    assert len({gait.name for gait in GAITS}) == len(GAITS)
    for gait in GAITS:
        assert gait.about.endswith(".")
        assert all(len(pose.positions) == 8 for pose in gait.poses)
