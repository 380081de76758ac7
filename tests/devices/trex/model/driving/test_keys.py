"""Which way held keys mean."""

import pytest

from trex_gui.devices.trex.model.driving.momentary_drive import TURN_WHILE_GOING, Heading, HeldKeys

KEYS = {"W": Heading.FORWARD, "S": Heading.BACK, "A": Heading.LEFT, "D": Heading.RIGHT}


def held(*names: str) -> HeldKeys:
    keys = HeldKeys()
    for name in names:
        keys.press(ord(name), KEYS[name])
    return keys


@pytest.mark.parametrize(
    ("names", "wish"),
    [
        ("", (0, 0)),
        ("W", (1, 0)),
        ("S", (-1, 0)),
        ("A", (0, -1)),
        ("D", (0, 1)),
        ("WD", (1, TURN_WHILE_GOING)),
        ("SA", (-1, -TURN_WHILE_GOING)),
        ("WS", (0, 0)),
        ("AD", (0, 0)),
        ("WSD", (0, 1)),
        ("WAD", (1, 0)),
        ("WASD", (0, 0)),
    ],
)
def test_held_keys_are_combined(names: str, wish: tuple[float, float]) -> None:
    assert held(*names).setpoint == wish


def test_released_key_leaves_the_others_held() -> None:
    keys = held("W", "D")
    assert keys.release(ord("W"))
    assert keys.setpoint == (0, 1)


def test_heading_is_held_until_both_of_its_keys_are_released() -> None:
    keys = held("W")
    keys.press(1, Heading.FORWARD)
    keys.release(1)
    assert keys.setpoint == (1, 0)


def test_release_of_unpressed_key_is_ignored() -> None:
    assert not held("W").release(ord("S"))


def test_clear_releases_all_keys() -> None:
    keys = held("W", "A")
    keys.clear()
    assert not keys
    assert keys.setpoint == (0, 0)
