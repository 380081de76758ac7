import pytest

from trex_gui.core.errors import BadRequest
from trex_gui.devices.aracna.protocol import commands

VALUES = [0, 9, 10, 99, 100, 999, 1000, 1023]


def test_command_has_one_number_for_each_motor_and_ends_with_newline() -> None:
    assert commands.positions(VALUES, 8) == b".c0,9,10,99,100,999,1000,1023\n"
    assert commands.speeds(VALUES[:2], 2) == b".v0,9\n"
    assert (commands.QUERY, commands.EMPTY) == (b".q\n", b"\n")


@pytest.mark.parametrize("count", [0, 1, 7, 9])
def test_wrong_number_of_values_is_rejected(count: int) -> None:
    with pytest.raises(BadRequest, match=f"8 motors need 8 values, not {count}"):
        commands.positions([512] * count, 8)


@pytest.mark.parametrize("bad", [-1, 1024, 1.5, "512", None, True])
def test_value_other_than_integer_0_to_1023_is_rejected(bad: object) -> None:
    values = [512] * 7 + [bad]
    with pytest.raises(BadRequest, match="motor 7 must be 0 to 1023"):
        commands.positions(values, 8)  # type: ignore[arg-type]  # on purpose
    with pytest.raises(BadRequest, match="speed of motor 7"):
        commands.speeds(values, 8)  # type: ignore[arg-type]  # on purpose
