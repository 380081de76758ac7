"""Visible time span, and labels of the time axis."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from tests.support.matrix import examples
from trex_gui.ui.plotting.axes import (
    MIN_SPAN,
    Span,
    ValueAxis,
    ago_labels,
    clock_text,
    since_labels,
)


@pytest.fixture
def span() -> Span:
    span = Span(30)
    span.set_available(0, 100)
    return span


def test_live_span_ends_at_newest_sample_unless_frozen(span: Span) -> None:
    assert (span.start, span.end) == (70, 100)
    span.set_available(0, 101)
    assert (span.start, span.end) == (71, 101)
    span.freeze()
    span.set_available(0, 200)
    assert (span.start, span.end) == (71, 101)
    span.go_live()
    assert span.end == 200


def test_zoom_does_not_move_the_time_under_the_mouse(span: Span) -> None:
    span.show(40, 80)
    span.zoom(0.5, 50)
    assert (span.start, span.end) == pytest.approx((45, 65))


def test_zoom_keeps_a_live_span_live(span: Span) -> None:
    span.zoom(0.5, 80)
    assert span.live
    assert (span.start, span.end) == (85, 100)


def test_live_span_is_restored_with_its_length(span: Span) -> None:
    span.show(40, 41)
    span.zoom(0.5, 40.5)
    span.go_live()
    assert (span.start, span.end) == (70, 100)
    span.freeze()
    span.select_length(10)
    span.go_live()
    assert (span.start, span.end) == (90, 100)


def test_span_can_be_selected_backwards_and_is_never_empty(span: Span) -> None:
    span.show(80, 40)
    assert (span.start, span.end) == (40, 80)
    assert not span.live
    span.show(50, 50)
    assert span.length == MIN_SPAN
    assert (span.start + span.end) / 2 == pytest.approx(50)


@examples(40)
@given(moves=st.lists(st.floats(-1000, 1000), max_size=20))
def test_panning_never_leaves_the_recorded_time(moves: list[float]) -> None:
    span = Span(30)
    span.set_available(0, 100)
    for move in moves:
        span.pan(move)
        assert span.end > 0
        assert span.start < 100


def test_times_are_formatted_as_minutes_and_seconds() -> None:
    assert clock_text(0, 1) == "0:00"
    assert clock_text(75.25, 0.1) == "1:15.2"
    assert clock_text(3723.4567) == "1:02:03.457"
    assert clock_text(59.9996) == "1:00.000"
    assert clock_text(-5, 1) == "\N{MINUS SIGN}0:05"


@pytest.mark.parametrize(
    ("seconds", "labels"),
    [
        (5, ["5 s", "4 s", "3 s", "2 s", "1 s", "now"]),
        (30, ["30 s", "25 s", "20 s", "15 s", "10 s", "5 s", "now"]),
        (120, ["2 min", "1.5 min", "1 min", "30 s", "now"]),
        (600, ["10 min", "8 min", "6 min", "4 min", "2 min", "now"]),
        (3600, ["1 h", "50 min", "40 min", "30 min", "20 min", "10 min", "now"]),
    ],
)
def test_live_axis_has_labels_in_round_steps(seconds: float, labels: list[str]) -> None:
    assert [text for _, text in ago_labels(seconds)] == labels


def test_axis_of_a_past_span_counts_from_the_beginning() -> None:
    labels = since_labels(60, 70)
    assert [text for _, text in labels] == ["1:00", "1:02", "1:04", "1:06", "1:08", "1:10"]
    assert labels[0][0] == -10


def test_value_is_mapped_to_the_other_axis() -> None:
    ampere, counts = ValueAxis("A"), ValueAxis("")
    ampere.fit([(0, 9)])
    assert list(ampere.ends) == [0, 10]
    assert counts.map_to(ampere, 127) == pytest.approx(10)
    assert counts.map_to(ampere, 0) == pytest.approx(5)
    assert counts.map_to(ampere, -127) == pytest.approx(0)
