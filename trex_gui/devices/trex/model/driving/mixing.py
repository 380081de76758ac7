"""Forward and turn, as a pad or a stick gives them, made into the speeds of two motors. Pure."""

from trex_gui.devices.trex.protocol.calibration import FULL_SCALE


def mix(forward: float, turn: float, ceiling: int = FULL_SCALE) -> tuple[int, int]:
    """Return the speeds of motors 1 and 2 for a wish of -1 to 1 each way.

    Motor 1 is the left one: turning right (positive) adds to it. That is the board's own mixing
    of channels (forward plus turn, forward minus turn; inferred there, reference section 3), so a
    robot turns the same way by pad and by stick. Where a sum is beyond full speed both are made
    smaller in proportion: the robot keeps the curve that was asked for, instead of losing it as
    by clipping. `ceiling` (1 to 127) is the speed that a full wish means.
    """
    left, right = forward + turn, forward - turn
    scale = ceiling / max(1.0, abs(left), abs(right))
    return round(left * scale), round(right * scale)
