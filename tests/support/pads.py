"""Simulated gamepads."""

from dataclasses import replace

from trex_gui.gamepad.pads import GamepadUnavailable, Pad, PadState, SdlPads

PARTS = {"leftx": "a0", "lefty": "a1", "leftshoulder": "b4", "b": "b1"}
PAD = Pad(ident=1, guid="a" * 32, name="Test pad", axes=4, buttons=8, parts=PARTS)


class HeldPads(SdlPads):
    """Gamepads whose state the test sets."""

    def __init__(self, *pads: Pad, failure: str = "") -> None:
        self._states = {pad: PadState((0.0,) * pad.axes, (False,) * pad.buttons) for pad in pads}
        self._failure = failure
        self.is_open = False

    def plug_in(self, pad: Pad) -> None:
        self._states[pad] = PadState((0.0,) * pad.axes, (False,) * pad.buttons)

    def unplug(self, pad: Pad) -> None:
        del self._states[pad]

    def move(self, axis: int, value: float, pad: Pad = PAD) -> None:
        axes = list(self._states[pad].axes)
        axes[axis] = value
        self._states[pad] = replace(self._states[pad], axes=tuple(axes))

    def press(self, button: int, pad: Pad = PAD) -> None:
        self._set(button, pad, pressed=True)

    def release(self, button: int, pad: Pad = PAD) -> None:
        self._set(button, pad, pressed=False)

    def _set(self, button: int, pad: Pad, *, pressed: bool) -> None:
        buttons = list(self._states[pad].buttons)
        buttons[button] = pressed
        self._states[pad] = replace(self._states[pad], buttons=tuple(buttons))

    def open(self) -> None:
        if self._failure:
            raise GamepadUnavailable(self._failure)
        self.is_open = True

    def pads(self) -> tuple[Pad, ...]:
        return tuple(self._states) if self.is_open else ()

    def read(self, pad: Pad) -> PadState | None:
        return self._states.get(pad) if self.is_open else None

    def close(self) -> None:
        self.is_open = False
