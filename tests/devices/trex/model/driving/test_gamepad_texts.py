"""Names of the parts of a gamepad."""

from dataclasses import replace

from tests.support.pads import PAD
from trex_gui.devices.trex.model.gamepad import axis_text, button_text

UNKNOWN = replace(PAD, parts={})


def test_parts_are_numbered_from_one() -> None:
    assert axis_text(UNKNOWN, 0) == "axis 1"
    assert button_text(UNKNOWN, 4) == "button 5"


def test_parts_known_to_sdl_show_their_names() -> None:
    assert axis_text(PAD, 0) == "axis 1 (left stick, sideways)"
    assert button_text(PAD, 4) == "button 5 (left shoulder)"
    assert button_text(PAD, None) == "none"
