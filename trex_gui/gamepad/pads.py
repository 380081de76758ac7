"""What a gamepad is and shows, whatever library reads it."""

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Protocol


class GamepadUnavailable(Exception):  # noqa: N818 - reads as what is wrong, as PortUnavailable
    """No gamepad can be read on this computer; the text says what to do about it."""


@dataclass(frozen=True, slots=True)
class Pad:
    """One gamepad, from being plugged in to being gone.

    Attributes:
        ident: a number of this connection; one that is plugged in again gets another.
        guid: SDL's identifier of its kind; two of a kind share it.
        axes: how many there are.
        buttons: how many there are.
        parts: where SDL knows the kind, its axes (`a0`) and buttons (`b4`) by SDL's names of
            what is printed on such pads: `{"lefty": "a1", "leftshoulder": "b4"}`.
    """

    ident: int
    guid: str
    name: str
    axes: int
    buttons: int
    parts: Mapping[str, str] = field(default_factory=dict, compare=False)

    def axis_of(self, part: str) -> int | None:
        """The number of the axis that SDL calls so; `None` where it knows none."""
        return self._number_of(part, "a", self.axes)

    def button_of(self, part: str) -> int | None:
        """The number of the button that SDL calls so; `None` where it knows none."""
        return self._number_of(part, "b", self.buttons)

    def part_name(self, kind: str, number: int) -> str:
        """SDL's name of an axis (`a`) or a button (`b`); empty where it knows none."""
        wanted = f"{kind}{number}"
        return next((part for part, where in self.parts.items() if where == wanted), "")

    def _number_of(self, part: str, kind: str, count: int) -> int | None:
        digits = self.parts.get(part, "").removeprefix(kind)
        return int(digits) if digits.isdecimal() and int(digits) < count else None


@dataclass(frozen=True, slots=True)
class PadState:
    """What a gamepad shows at a moment: axes from -1 to 1 (down and right are positive)."""

    axes: tuple[float, ...]
    buttons: tuple[bool, ...]

    def axis(self, number: int) -> float:
        """Return the position of an axis; 0 for one that does not exist."""
        return self.axes[number] if 0 <= number < len(self.axes) else 0.0

    def pressed(self, number: int | None) -> bool:
        """Whether a button is down; one that is not there never is."""
        return number is not None and 0 <= number < len(self.buttons) and self.buttons[number]


class PadSource(Protocol):
    """Reads gamepads. Every call comes from one thread and returns at once."""

    def open(self) -> None:
        """Begin; gamepads that are there already are found by the next `pads`.

        Raises:
            GamepadUnavailable: gamepads cannot be read here.
        """

    def pads(self) -> tuple[Pad, ...]:
        """Look at what has happened since, and return the gamepads that are there now."""

    def read(self, pad: Pad) -> PadState | None:
        """What a gamepad showed at the last `pads`; `None` when it has gone or cannot be read."""

    def close(self) -> None:
        """Let all of them go. Closing twice is closing once."""
