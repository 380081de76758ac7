"""Virtual joystick of SDL, created through ctypes."""

import ctypes
import importlib.util
import sys
from ctypes import c_int, c_int16, c_uint8, c_void_p
from pathlib import Path

_GAMEPAD = 1  # SDL_JOYSTICK_TYPE_GAMECONTROLLER


def _library() -> ctypes.CDLL:
    """Return the SDL library that pygame has loaded from its wheel."""
    if sys.platform == "win32":
        spec = importlib.util.find_spec("pygame")
        assert spec is not None
        assert spec.origin is not None
        return ctypes.CDLL(str(Path(spec.origin).parent / "SDL2.dll"))
    maps = Path("/proc/self/maps").read_text(encoding="utf-8").splitlines()
    return ctypes.CDLL(next(line.split()[-1] for line in maps if "libSDL2-" in line))


class VirtualPad:
    """Virtual gamepad, connected when created. SDL must be open."""

    def __init__(self, axes: int = 6, buttons: int = 15) -> None:
        self._sdl = _library()
        self._sdl.SDL_JoystickOpen.restype = c_void_p
        self._sdl.SDL_JoystickSetVirtualAxis.argtypes = [c_void_p, c_int, c_int16]
        self._sdl.SDL_JoystickSetVirtualButton.argtypes = [c_void_p, c_int, c_uint8]
        self._index = self._sdl.SDL_JoystickAttachVirtual(_GAMEPAD, axes, buttons, 0)
        assert self._index >= 0
        self._joystick = self._sdl.SDL_JoystickOpen(self._index)
        assert self._joystick

    def move(self, axis: int, value: float) -> None:
        """Set the position of an axis, -1 to 1."""
        count = max(-32768, min(32767, round(value * 32768)))
        assert self._sdl.SDL_JoystickSetVirtualAxis(self._joystick, axis, count) == 0

    def press(self, button: int, *, down: bool = True) -> None:
        assert self._sdl.SDL_JoystickSetVirtualButton(self._joystick, button, int(down)) == 0

    def unplug(self) -> None:
        assert self._sdl.SDL_JoystickDetachVirtual(self._index) == 0
