"""One pose: a name, and where every motor is."""

from dataclasses import dataclass

from trex_gui.devices.aracna.protocol.units import HIGHEST

CENTRE = 512
"""Where a motor is taken to be of which a file does not say it."""


@dataclass(frozen=True, slots=True)
class Pose:
    """Positions by name.

    Attributes:
        name: as a file spells it; no colon, for that ends it there.
        positions: one a motor, motor 0 first, each 0-1023.
    """

    name: str
    positions: tuple[int, ...]

    def __post_init__(self) -> None:
        """Refuse what no file can hold.

        Raises:
            ValueError: the name has a colon or a line end, or a position is outside 0-1023.
        """
        if any(sign in self.name for sign in ":\r\n"):
            raise ValueError(f"a pose's name has no colon and no line end, unlike {self.name!r}")
        for motor, position in enumerate(self.positions):
            if not 0 <= position <= HIGHEST:
                raise ValueError(
                    f"positions are 0 to {HIGHEST}, not {position} (motor {motor} of {self.name})"
                )

    def first(self, motors: int) -> tuple[int, ...]:
        """Return the positions of so many motors; those that are missing are in the centre."""
        missing = max(motors - len(self.positions), 0)
        return self.positions[:motors] + (CENTRE,) * missing
