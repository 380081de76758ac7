"""Figures of benchmarks, and their comparison with an earlier run."""

from pathlib import Path

import pytest

from tests.benchmarks.conftest import Figure, earlier_values


def test_figures_are_read_back_from_saved_output(tmp_path: Path) -> None:
    latency = Figure("stop to wire at 19200 baud", 4.25, "ms", at_most=10)
    rate = Figure("simulator", 25_000, "/s")
    output = f"== test session starts ==\n{latency.to_json()}\n.\n\n{rate.to_json()}\n1 passed\n"
    (tmp_path / "run.txt").write_text(output, encoding="utf-8")
    assert earlier_values(tmp_path / "run.txt") == {latency.figure: 4.25, rate.figure: 25_000}


def test_output_without_figures_is_rejected(tmp_path: Path) -> None:
    (tmp_path / "run.txt").write_text("1 passed\n", encoding="utf-8")
    with pytest.raises(ValueError, match="no figures"):
        earlier_values(tmp_path / "run.txt")


def test_row_shows_the_ratio_to_an_earlier_value() -> None:
    row = Figure("start", 1.5, "s", at_most=2).row(1.0)
    assert row.split() == ["start", "1.5", "s", "1.50", "at", "most", "2"]
    for earlier in (None, 0.0):
        assert Figure("start", 1.5, "s").row(earlier).split() == ["start", "1.5", "s"]


@pytest.mark.parametrize(
    ("value", "is_within"), [(0.9, False), (1, True), (1.5, True), (2, True), (2.1, False)]
)
def test_figure_at_a_limit_is_within_its_bounds(value: float, is_within: bool) -> None:
    assert Figure("pace", value, "ratio", at_least=1, at_most=2).is_within_bounds is is_within
