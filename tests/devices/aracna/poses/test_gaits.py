"""The built-in poses and gaits are those that the robot's authors describe."""

import math

import pytest

from trex_gui.devices.aracna.poses.gaits import BUILT_IN_POSES, GAITS, Gait, GaitStage
from trex_gui.devices.aracna.poses.project import Pose
from trex_gui.devices.aracna.protocol.joints import crop, factory_limits


def gait(name: str) -> Gait:
    return next(one for one in GAITS if one.name == name)


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


def test_every_built_in_motion_fits_the_usual_limits() -> None:
    poses = [*BUILT_IN_POSES, *(stage.pose for one in GAITS for stage in one.stages)]
    for pose in poses:
        assert crop(pose.positions, factory_limits()) == pose.positions, pose.name


@pytest.mark.parametrize("number", [0, 2, 4, 6])
def test_star_gait_lifts_diagonal_legs_and_swings_outer_joints(number: int) -> None:
    star = gait(f"star {number}")
    assert [stage.seconds for stage in star.stages] == [0.5, 0.2, 0.5, 0.2]
    off = [[position - 300 for position in stage.pose.positions] for stage in star.stages]
    swung, opposite = number + 1, (number + 5) % 8
    ours, others = {number, (number + 4) % 8}, {(number + 2) % 8, (number + 6) % 8}
    for changes, lifted, swing in zip(
        off, [others, ours, ours, others], [300, 300, -300, 0], strict=True
    ):
        expected = [0] * 8
        for motor in lifted:
            expected[motor] = -200
        expected[swung], expected[opposite] = min(-swing, 250), min(swing, 250)
        assert changes == expected


def test_cyclic_gait_starts_in_last_pose() -> None:
    low, high = Pose("low", (0, 100)), Pose("high", (100, 300))
    assert Gait("to and fro", (GaitStage(high, 2.0), GaitStage(low, 1.0))).start == low


def test_sine_gait_follows_sine_function() -> None:
    stages = gait("sine").stages
    assert sum(stage.seconds for stage in stages) == pytest.approx(2 * math.pi)
    for number, stage in enumerate(stages, 1):
        time = 2 * math.pi * number / 16
        position = min(512 + 100 * math.sin(time), 600)  # cropped as on the robot
        assert stage.pose.positions[0] == pytest.approx(position, abs=0.51)


def test_every_gait_has_unique_name_text_and_eight_motors() -> None:
    assert len({one.name for one in GAITS}) == len(GAITS)
    for one in GAITS:
        assert one.about.endswith(".")
        assert all(len(stage.pose.positions) == 8 for stage in one.stages)
