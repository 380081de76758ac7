"""The limits of the joints, as the session was told them last."""

from collections.abc import Sequence

from trex_gui.core.errors import BadRequest
from trex_gui.devices.aracna.protocol.joints import Limits


class GoalLimits:
    """Keeps goals within the newest limits; before there are any, as they are."""

    def __init__(self) -> None:
        self._limits: tuple[Limits, ...] = ()

    def set(self, limits: Sequence[tuple[int, int]]) -> None:
        """Take other limits, lowest and highest position of each motor.

        Raises:
            BadRequest: they are not in this order, or outside 0-1023; the old ones stay.
        """
        try:
            self._limits = tuple(Limits(low, high) for low, high in limits)
        except ValueError as error:
            raise BadRequest(str(error)) from error

    def crop(self, goals: Sequence[int]) -> tuple[int, ...]:
        """Return the nearest goals that are allowed; as many as were given."""
        known = len(self._limits)
        return tuple(
            self._limits[motor].crop(goal) if motor < known else goal
            for motor, goal in enumerate(goals)
        )
