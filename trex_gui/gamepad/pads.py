"""Gamepads, read through SDL. `pygame-ce` is optional and imported on first use."""

import contextlib
import importlib
import os
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from types import ModuleType
from typing import TYPE_CHECKING

from trex_gui.core.optional_packages import install_command
from trex_gui.core.translation import tr

if TYPE_CHECKING:
    from pygame.joystick import JoystickType

_HINTS = {
    "PYGAME_HIDE_SUPPORT_PROMPT": "1",
    "SDL_VIDEODRIVER": "dummy",  # SDL's events need a video driver, but it must not use the display
    "SDL_AUDIODRIVER": "dummy",
    "SDL_JOYSTICK_ALLOW_BACKGROUND_EVENTS": "1",  # there is no SDL window that could have the focus
    "SDL_NO_SIGNAL_HANDLERS": "1",  # SDL would swallow SIGTERM
    "SDL_VIDEO_ALLOW_SCREENSAVER": "1",
}


class GamepadUnavailable(Exception):  # noqa: N818 - like PortUnavailable
    """Gamepads cannot be read on this computer. The text contains the remedy."""


@dataclass(frozen=True, slots=True)
class Pad:
    """Connected gamepad."""

    ident: int  # number of the connection; a reconnected gamepad gets another number
    guid: str  # SDL's identifier of the model
    name: str
    axes: int  # number of axes
    buttons: int  # number of buttons
    # SDL's names of axes and buttons, if SDL knows the model: `{"lefty": "a1", "b": "b1"}`.
    parts: Mapping[str, str] = field(default_factory=dict, compare=False)

    def part_name(self, kind: str, number: int) -> str:
        """Return SDL's name of an axis (`a`) or a button (`b`). Empty if unknown."""
        key = f"{kind}{number}"
        return next((part for part, value in self.parts.items() if value == key), "")

    def part_number(self, kind: str, part: str) -> int | None:
        """Return the number of the axis (`a`) or button (`b`) with this SDL name."""
        digits = self.parts.get(part, "").removeprefix(kind)
        count = self.axes if kind == "a" else self.buttons
        return int(digits) if digits.isdecimal() and int(digits) < count else None


@dataclass(frozen=True, slots=True)
class PadState:
    """State of a gamepad. Axes: -1 to 1, positive down and to the right."""

    axes: tuple[float, ...]
    buttons: tuple[bool, ...]

    def axis(self, number: int) -> float:
        """Return the position of an axis. 0 if the axis does not exist."""
        return self.axes[number] if 0 <= number < len(self.axes) else 0.0

    def is_pressed(self, number: int | None) -> bool:
        """Return whether a button is down. False if the button does not exist."""
        return number is not None and 0 <= number < len(self.buttons) and self.buttons[number]


class SdlPads:
    """Gamepads of this computer. Create only one instance, because SDL's state is global.

    Call all methods from one thread. They do not block.
    """

    def __init__(self) -> None:
        self._pygame: ModuleType | None = None
        self._open: dict[int, tuple[Pad, JoystickType]] = {}

    def open(self) -> None:
        """Initialize SDL.

        Raises:
            GamepadUnavailable: pygame is missing or SDL does not start.
        """
        if self._pygame is not None:
            return
        with _environment(_HINTS):
            pygame = _load()
            try:
                pygame.display.init()
                pygame.joystick.init()
            except pygame.error as error:
                raise GamepadUnavailable(
                    tr("Gamepads cannot be read on this computer: {0}.").format(error)
                ) from error
        self._pygame = pygame

    def pads(self) -> tuple[Pad, ...]:
        """Handle SDL's events. Return the connected gamepads."""
        pygame = self._pygame
        if pygame is None:
            return ()
        try:
            events = pygame.event.get()
        except pygame.error:  # SDL was shut down elsewhere in this process
            self._open.clear()
            return ()
        for event in events:
            if event.type == pygame.JOYDEVICEREMOVED:
                self._open.pop(event.instance_id, None)
            elif event.type == pygame.JOYDEVICEADDED:
                self._add(pygame, event.device_index)
        return tuple(pad for pad, _ in self._open.values())

    def read(self, pad: Pad) -> PadState | None:
        """Return the state as of the last call of `pads`. `None` for a disconnected gamepad."""
        entry = self._open.get(pad.ident)
        if entry is None or self._pygame is None:
            return None
        joystick = entry[1]
        try:
            return PadState(
                tuple(joystick.get_axis(number) for number in range(pad.axes)),
                tuple(bool(joystick.get_button(number)) for number in range(pad.buttons)),
            )
        except self._pygame.error:  # the gamepad is disconnected
            del self._open[pad.ident]
            return None

    def close(self) -> None:
        if self._pygame is not None:
            self._open.clear()
            self._pygame.joystick.quit()
            self._pygame.display.quit()
            self._pygame = None

    def _add(self, pygame: ModuleType, index: int) -> None:
        with contextlib.suppress(pygame.error):  # the gamepad is already disconnected or unreadable
            joystick = pygame.joystick.Joystick(index)
            pad = Pad(
                joystick.get_instance_id(),
                joystick.get_guid(),
                joystick.get_name(),
                joystick.get_numaxes(),
                joystick.get_numbuttons(),
                _parts(joystick),
            )
            self._open[pad.ident] = (pad, joystick)


def _load() -> ModuleType:
    try:
        pygame = importlib.import_module("pygame")
        for part in ("display", "event", "joystick"):
            importlib.import_module(f"pygame.{part}")
    except ImportError as error:
        raise GamepadUnavailable(
            tr(
                "Gamepads need one more package. Install the package with {0}, then switch "
                "Gamepad on again."
            ).format(install_command("pygame-ce"))
        ) from error
    return pygame


def _parts(joystick: "JoystickType") -> Mapping[str, str]:
    """Return SDL's names of axes and buttons. Empty for unknown models."""
    try:
        controllers = importlib.import_module("pygame._sdl2.controller")
    except ImportError:  # the module is experimental in pygame-ce 2.5
        return {}
    pygame = importlib.import_module("pygame")
    try:
        controllers.init()
        controller = controllers.Controller.from_joystick(joystick)
        mapping = controller.get_mapping()
    except (pygame.error, AttributeError):
        return {}
    return {part: key for part, key in mapping.items() if key[:1] in {"a", "b"}}


@contextlib.contextmanager
def _environment(hints: Mapping[str, str]) -> Iterator[None]:
    """Set environment variables for SDL temporarily. Later child processes do not inherit them."""
    before = {name: os.environ.get(name) for name in hints}
    os.environ.update(hints)
    try:
        yield
    finally:
        for name, value in before.items():
            if value is None:
                os.environ.pop(name, None)
            else:
                os.environ[name] = value
