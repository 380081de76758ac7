"""How the parts of a gamepad are named."""

from dataclasses import replace

import pytest
from PySide6.QtCore import QCoreApplication

from tests.support.pads import PAD
from trex_gui.devices.trex.model.driving.gamepad import GamepadWords

UNKNOWN = replace(PAD, parts={})


@pytest.fixture
def words(qapp: QCoreApplication) -> GamepadWords:
    return GamepadWords()


def test_parts_are_numbered_from_one(words: GamepadWords) -> None:
    assert words.axis(UNKNOWN, 0) == "axis 1"
    assert words.button(UNKNOWN, 4) == "button 5"


def test_parts_known_to_sdl_show_their_names(words: GamepadWords) -> None:
    assert words.axis(PAD, 0) == "axis 1 (left stick, sideways)"
    assert words.button(PAD, 4) == "button 5 (left shoulder)"
    assert words.button(PAD, None) == "none"
