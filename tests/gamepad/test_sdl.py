"""Gamepads that SDL reads, with a virtual gamepad."""

import importlib
import os
import signal
import subprocess
import sys
from collections.abc import Iterator

import pytest

from tests.gamepad.virtual_pad import VirtualPad
from trex_gui.gamepad.pads import GamepadUnavailable, Pad, SdlPads
from trex_gui.gamepad.profile import Axis, default_profile

pytestmark = pytest.mark.realtime


@pytest.fixture
def source() -> Iterator[SdlPads]:
    source = SdlPads()
    source.open()
    yield source
    source.close()


@pytest.fixture
def gamepad(source: SdlPads) -> Iterator[VirtualPad]:
    gamepad = VirtualPad()
    yield gamepad
    gamepad.unplug()


@pytest.fixture
def pad(source: SdlPads, gamepad: VirtualPad) -> Pad:
    (pad,) = source.pads()
    return pad


def test_plugged_in_gamepad_is_listed(pad: Pad) -> None:
    assert (pad.axes, pad.buttons) == (6, 15)
    assert pad.name
    assert len(pad.guid) == 32


def test_moved_axis_and_pressed_button_are_read(
    source: SdlPads, gamepad: VirtualPad, pad: Pad
) -> None:
    gamepad.move(1, -1.0)
    gamepad.press(4)
    source.pads()
    state = source.read(pad)
    assert state is not None
    assert state.axis(1) == pytest.approx(-1.0, abs=0.001)
    assert state.is_pressed(4)
    assert not state.is_pressed(3)


def test_unplugged_gamepad_is_removed_and_gets_a_new_ident_later(source: SdlPads) -> None:
    virtual = VirtualPad()
    (pad,) = source.pads()
    virtual.move(1, -1.0)
    virtual.unplug()
    assert source.pads() == ()
    assert source.read(pad) is None
    second = VirtualPad()
    (after,) = source.pads()
    assert after.ident != pad.ident
    assert after.guid == pad.guid
    second.unplug()


def test_parts_of_a_gamepad_known_to_sdl_have_names(pad: Pad) -> None:
    assert pad.parts["lefty"] == "a1"
    shoulder = pad.part_number("b", "leftshoulder")
    assert shoulder is not None
    assert default_profile(pad).hold == shoulder
    assert default_profile(pad).first == Axis(1, inverted=True)


def test_source_can_be_closed_twice_and_reopened() -> None:
    source = SdlPads()
    source.open()
    virtual = VirtualPad()
    assert len(source.pads()) == 1
    virtual.unplug()
    source.close()
    source.close()
    assert source.pads() == ()
    source.open()
    assert source.pads() == ()
    virtual = VirtualPad()
    assert len(source.pads()) == 1
    virtual.unplug()
    source.close()


def test_source_lists_no_gamepad_after_display_quit(source: SdlPads) -> None:
    virtual = VirtualPad()
    (pad,) = source.pads()
    virtual.unplug()
    importlib.import_module("pygame").display.quit()
    assert source.pads() == ()
    assert source.read(pad) is None


def test_gamepad_closed_in_sdl_is_removed_when_read(source: SdlPads, pad: Pad) -> None:
    importlib.import_module("pygame.joystick").Joystick(0).quit()
    assert source.pads() == (pad,)
    assert source.read(pad) is None
    assert source.pads() == ()


def test_open_changes_neither_environment_nor_signal_handlers() -> None:
    environment = dict(os.environ)
    numbers = signal.SIGINT, signal.SIGTERM
    handlers = list(map(signal.getsignal, numbers))
    source = SdlPads()
    source.open()
    assert dict(os.environ) == environment
    assert list(map(signal.getsignal, numbers)) == handlers
    source.close()


def test_sigterm_ends_program_that_reads_gamepads() -> None:
    script = (
        "import os, signal; from trex_gui.gamepad.pads import SdlPads; "
        "source = SdlPads(); source.open(); source.pads(); "
        "os.kill(os.getpid(), signal.SIGTERM); source.pads(); print('still runs')"
    )
    process = subprocess.run(
        [sys.executable, "-c", script], capture_output=True, text=True, timeout=30, check=False
    )
    assert process.stdout == ""
    assert process.returncode == -signal.SIGTERM


def test_missing_pygame_is_reported_with_install_hint(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "pygame", None)
    with pytest.raises(GamepadUnavailable, match="pip install pygame-ce"):
        SdlPads().open()


def test_pygame_is_not_imported_before_open() -> None:
    script = (
        "import sys; from trex_gui.gamepad.pads import SdlPads; SdlPads(); "
        "sys.exit('pygame' in sys.modules)"
    )
    assert subprocess.run([sys.executable, "-c", script], timeout=30, check=False).returncode == 0
