"""A ring of samples against a plain list."""

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from tests.support.matrix import examples
from trex_gui.ui.plotting.data.ring import Ring

modest = examples(40)


def rows(ring: Ring, columns: int) -> list[tuple[float, ...]]:
    return list(zip(ring.times, *(ring.values(column) for column in range(columns)), strict=True))


def test_empty_ring_has_no_rows() -> None:
    ring = Ring(3, columns=2)
    assert len(ring) == 0
    assert ring.times.size == 0
    assert ring.values(1).size == 0


def test_full_ring_drops_the_oldest_row() -> None:
    ring = Ring(3, columns=1)
    for number in range(5):
        ring.append(number, number * 10)
    assert rows(ring, 1) == [(2, 20), (3, 30), (4, 40)]


def test_columns_are_returned_without_copying() -> None:
    ring = Ring(3, columns=1)
    ring.append(1, 2)
    assert np.shares_memory(ring.times, ring.values(0).base)
    assert ring.times.base is not None


@modest
@given(
    capacity=st.integers(1, 7),
    columns=st.integers(0, 3),
    steps=st.lists(st.one_of(st.floats(-1e9, 1e9), st.just("clear")), max_size=60),
)
def test_ring_equals_the_end_of_a_list(
    *, capacity: int, columns: int, steps: list[float | str]
) -> None:
    ring = Ring(capacity, columns)
    expected: list[tuple[float, ...]] = []
    for number, step in enumerate(steps):
        if isinstance(step, str):
            ring.clear()
            expected.clear()
        else:
            values = [step + column for column in range(columns)]
            ring.append(float(number), *values)
            expected.append((float(number), *values))
        kept = expected[-capacity:]
        assert len(ring) == len(kept)
        assert rows(ring, columns) == kept
