"""SDL itself, with a gamepad that exists only in it."""

import importlib
import os
import signal
import subprocess
import sys
from collections.abc import Iterator

import pytest

from tests.gamepad.virtual_pad import VirtualPad
from trex_gui.gamepad.pads import GamepadUnavailable
from trex_gui.gamepad.profile import Axis, default_profile
from trex_gui.gamepad.sdl import HOW_TO_INSTALL, SdlPads

pytestmark = pytest.mark.realtime


@pytest.fixture
def source() -> Iterator[SdlPads]:
    source = SdlPads()
    source.open()
    yield source
    source.close()


def test_without_a_gamepad_there_is_none(source: SdlPads) -> None:
    assert source.pads() == ()


def test_a_gamepad_that_is_plugged_in_is_there(source: SdlPads) -> None:
    virtual = VirtualPad()
    (pad,) = source.pads()
    assert (pad.axes, pad.buttons) == (6, 15)
    assert pad.name
    assert len(pad.guid) == 32
    virtual.unplug()


def test_what_is_moved_and_pressed_is_read(source: SdlPads) -> None:
    virtual = VirtualPad()
    (pad,) = source.pads()
    virtual.move(1, -1.0)
    virtual.press(4)
    source.pads()
    state = source.read(pad)
    assert state is not None
    assert state.axis(1) == pytest.approx(-1.0, abs=0.001)
    assert state.pressed(4)
    assert not state.pressed(3)
    virtual.unplug()


def test_a_gamepad_that_is_unplugged_is_gone_at_once(source: SdlPads) -> None:
    virtual = VirtualPad()
    (pad,) = source.pads()
    virtual.move(1, -1.0)
    virtual.unplug()
    assert source.pads() == ()
    assert source.read(pad) is None


def test_one_that_is_plugged_in_again_is_another_of_the_same_kind(source: SdlPads) -> None:
    first = VirtualPad()
    (before,) = source.pads()
    first.unplug()
    source.pads()
    second = VirtualPad()
    (after,) = source.pads()
    assert after.ident != before.ident
    assert after.guid == before.guid
    second.unplug()


def test_of_a_kind_that_sdl_knows_the_parts_have_names(source: SdlPads) -> None:
    virtual = VirtualPad()
    (pad,) = source.pads()
    assert pad.parts["lefty"] == "a1"
    shoulder = pad.button_of("leftshoulder")
    assert shoulder is not None
    assert default_profile(pad).hold == shoulder
    assert default_profile(pad).first == Axis(1, inverted=True)
    virtual.unplug()


def test_opening_again_finds_what_is_plugged_in_already() -> None:
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
    source.close()


def test_where_sdl_was_ended_by_others_every_gamepad_has_gone(source: SdlPads) -> None:
    virtual = VirtualPad()
    (pad,) = source.pads()
    virtual.unplug()
    importlib.import_module("pygame").display.quit()
    assert source.pads() == ()
    assert source.read(pad) is None


def test_one_that_sdl_has_closed_without_a_word_has_gone(source: SdlPads) -> None:
    virtual = VirtualPad()
    (pad,) = source.pads()
    importlib.import_module("pygame.joystick").Joystick(0).quit()
    assert source.pads() == (pad,)
    assert source.read(pad) is None
    assert source.pads() == ()
    virtual.unplug()


def test_reading_gamepads_leaves_environment_and_signals_alone() -> None:
    environment = dict(os.environ)
    handlers = [signal.getsignal(each) for each in (signal.SIGINT, signal.SIGTERM)]
    source = SdlPads()
    source.open()
    assert dict(os.environ) == environment
    assert [signal.getsignal(each) for each in (signal.SIGINT, signal.SIGTERM)] == handlers
    source.close()


def test_a_program_that_reads_gamepads_still_ends_when_told_to() -> None:
    script = (
        "import os, signal; from trex_gui.gamepad.sdl import SdlPads; "
        "source = SdlPads(); source.open(); source.pads(); "
        "os.kill(os.getpid(), signal.SIGTERM); source.pads(); print('goes on')"
    )
    ended = subprocess.run(
        [sys.executable, "-c", script], capture_output=True, text=True, timeout=30, check=False
    )
    assert ended.stdout == ""
    assert ended.returncode == -signal.SIGTERM


def test_without_the_extra_it_says_how_to_get_it(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "pygame", None)
    with pytest.raises(GamepadUnavailable, match="trex-gui") as raised:
        SdlPads().open()
    assert HOW_TO_INSTALL in str(raised.value)


def test_nothing_of_it_is_loaded_before_it_is_opened() -> None:
    script = (
        "import sys; from trex_gui.gamepad.sdl import SdlPads; SdlPads(); "
        "sys.exit('pygame' in sys.modules)"
    )
    assert subprocess.run([sys.executable, "-c", script], timeout=30, check=False).returncode == 0
