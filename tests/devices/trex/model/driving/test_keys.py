"""Setpoints of held keys."""

import pytest

from trex_gui.devices.trex.model.momentary_drive import TURN_WHILE_GOING, Heading, keys_setpoint

KEYS = {"W": Heading.FORWARD, "S": Heading.BACK, "A": Heading.LEFT, "D": Heading.RIGHT}


@pytest.mark.parametrize(
    ("names", "setpoint"),
    [
        ("", (0, 0)),
        ("W", (1, 0)),
        ("S", (-1, 0)),
        ("A", (0, -1)),
        ("D", (0, 1)),
        ("WW", (1, 0)),
        ("WD", (1, TURN_WHILE_GOING)),
        ("SA", (-1, -TURN_WHILE_GOING)),
        ("WS", (0, 0)),
        ("AD", (0, 0)),
        ("WSD", (0, 1)),
        ("WAD", (1, 0)),
        ("WASD", (0, 0)),
    ],
)
def test_held_keys_are_combined(names: str, setpoint: tuple[float, float]) -> None:
    assert keys_setpoint(KEYS[name] for name in names) == setpoint
