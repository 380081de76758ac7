"""Only complete, strictly formed lines are sent."""

import re

import pytest
from hypothesis import given
from hypothesis import strategies as st

from trex_gui.core.errors import BadRequest
from trex_gui.devices.aracna.protocol import commands

VALUES = st.lists(st.integers(0, 1023), min_size=8, max_size=8)


@given(values=VALUES)
def test_line_has_one_number_of_1_to_4_digits_for_each_motor(values: list[int]) -> None:
    for letter, make in (("c", commands.positions), ("v", commands.speeds)):
        line = make(values, 8)
        assert re.fullmatch(rb"\.%b\d{1,4}(,\d{1,4}){7}\n" % letter.encode(), line)
        assert [int(field) for field in line[2:-1].split(b",")] == values


def test_longest_line_fits_firmware_buffer() -> None:
    assert len(commands.positions([1023] * 8, 8)) == 42


def test_query_is_three_bytes_long() -> None:
    assert commands.QUERY == b".q\n"
    assert len(commands.QUERY) == 3


def test_lines_contain_no_carriage_return() -> None:
    every = [commands.QUERY, commands.EMPTY, commands.speeds([5, 6], 2)]
    assert not any(b"\r" in line for line in every)


@pytest.mark.parametrize("count", [0, 1, 7, 9])
def test_wrong_number_of_values_is_rejected(count: int) -> None:
    with pytest.raises(BadRequest, match=f"8 motors need 8 values, not {count}"):
        commands.positions([512] * count, 8)


@pytest.mark.parametrize("bad", [-1, 1024, 9999, 12345, 1.5, "512", None, True])
def test_value_other_than_integer_0_to_1023_is_rejected(bad: object) -> None:
    values = [512] * 7 + [bad]
    with pytest.raises(BadRequest, match="motor 7 is 0 to 1023"):
        commands.positions(values, 8)  # type: ignore[arg-type]  # on purpose
    with pytest.raises(BadRequest, match="speed of motor 7"):
        commands.speeds(values, 8)  # type: ignore[arg-type]  # on purpose
