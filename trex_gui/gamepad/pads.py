"""Gamepads and their states, whatever library reads them."""

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Protocol


class GamepadUnavailable(Exception):  # noqa: N818 - reads as what is wrong, as PortUnavailable
    """Gamepads cannot be read on this computer; the text says what to do about it."""


@dataclass(frozen=True, slots=True)
class Pad:
    """One gamepad, from being plugged in to being gone.

    Attributes:
        ident: a number of this connection; one that is plugged in again gets another.
        guid: SDL's identifier of its kind; two of a kind share it.
        axes, buttons: how many there are.
        parts: its axes (`a0`) and buttons (`b4`) by SDL's names, if SDL knows the kind:
            `{"lefty": "a1", "leftshoulder": "b4"}`.
    """

    ident: int
    guid: str
    name: str
    axes: int
    buttons: int
    parts: Mapping[str, str] = field(default_factory=dict, compare=False)

    def axis_of(self, part: str) -> int | None:
        return self._number_of(part, "a", self.axes)

    def button_of(self, part: str) -> int | None:
        return self._number_of(part, "b", self.buttons)

    def part_name(self, kind: str, number: int) -> str:
        """SDL's name of an axis (`a`) or a button (`b`); empty if it has none."""
        wanted = f"{kind}{number}"
        return next((part for part, where in self.parts.items() if where == wanted), "")

    def _number_of(self, part: str, kind: str, count: int) -> int | None:
        digits = self.parts.get(part, "").removeprefix(kind)
        return int(digits) if digits.isdecimal() and int(digits) < count else None


@dataclass(frozen=True, slots=True)
class PadState:
    """The state of a gamepad: axes from -1 to 1 (down and right are positive)."""

    axes: tuple[float, ...]
    buttons: tuple[bool, ...]

    def axis(self, number: int) -> float:
        """Return the position of an axis; 0 if there is none."""
        return self.axes[number] if 0 <= number < len(self.axes) else 0.0

    def pressed(self, number: int | None) -> bool:
        """Whether a button is down; a button that does not exist never is."""
        return number is not None and 0 <= number < len(self.buttons) and self.buttons[number]


class PadSource(Protocol):
    """Reads gamepads. Every call comes from one thread and returns at once."""

    def open(self) -> None:
        """Begin; the next `pads` finds gamepads that are already connected.

        Raises:
            GamepadUnavailable: gamepads cannot be read here.
        """

    def pads(self) -> tuple[Pad, ...]:
        """Return the gamepads that are connected now."""

    def read(self, pad: Pad) -> PadState | None:
        """Return the state at the last `pads`; `None` if it is gone or cannot be read."""

    def close(self) -> None:
        """Close all of them; may be called twice."""
