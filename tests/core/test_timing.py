import pytest

from trex_gui.core.timing import seconds_left


@pytest.mark.parametrize(
    ("elapsed", "done", "total", "left"),
    [(0.6, 2, 102, None), (1.0, 4, 100, 25), (1.0, 4, 5, 5), (30.0, 100, 100, None)],
)
def test_time_left_is_estimated_after_some_steps(
    elapsed: float, done: int, total: int, left: int | None
) -> None:
    assert seconds_left(elapsed, done, total) == left
