"""The poses that the robot's authors used, by their names.

Ref: CreativeMachinesLab/aracna `RobotPi/PiConstants.py`: an inner and an outer position, the same
for all four legs. Several lie outside the joints' limits and are cropped when they are played.
"""

from trex_gui.devices.aracna.poses.pose import Pose
from trex_gui.devices.aracna.protocol.units import MOTORS


def all_legs(name: str, inner: int, outer: int) -> Pose:
    """Return the pose in which the legs are alike: even motors are inner joints."""
    return Pose(name, (inner, outer) * (MOTORS // 2))


FLAT = all_legs("flat", 770, 40)
HALF_STAND = all_legs("half-stand", 700, 100)
STAND = all_legs("stand", 512, 680)
UP_1 = all_legs("up-1", 0, 600)
UP_2 = all_legs("up-2", 600, 600)
SELF_TEST_A = all_legs("self-test a", 770, 200)
SELF_TEST_B = all_legs("self-test b", 670, 300)

KNOWN_POSES = (FLAT, HALF_STAND, STAND, UP_1, UP_2, SELF_TEST_A, SELF_TEST_B)
