"""Files of bench tests."""

from dataclasses import replace

import pytest
from hypothesis import given
from hypothesis import strategies as st

from tests.devices.trex.bench.runs import run_of
from tests.devices.trex.bench.test_profile import PROFILES
from tests.support.matrix import examples
from trex_gui.devices.trex.bench.files import BenchFileError, from_csv, to_csv
from trex_gui.devices.trex.bench.run import End, Run

SAVED = run_of([(0.0125, 0.0), (0.025, 4.5)])


def multiples(unit: int, highest: int) -> st.SearchStrategy[float]:
    """Return multiples of `1 / unit`, the resolution of the file."""
    return st.integers(0, highest).map(lambda count: count / unit)


@st.composite
def runs(draw: st.DrawFn) -> Run:
    times = sorted(draw(st.sets(multiples(10_000, 1_200_000), max_size=30)))
    currents = draw(st.lists(multiples(10_000, 400_000), min_size=len(times), max_size=len(times)))
    profile = draw(PROFILES)
    duration, period = round(profile.duration, 2), round(profile.period, 2)
    return run_of(
        list(zip(times, currents, strict=True)),
        replace(profile, duration=duration, period=period),
        ended=draw(multiples(10_000, 1_200_000)),
        end=draw(st.sampled_from(End)),
        reason=draw(st.sampled_from(["", "Motor 1 drew 12.00 A: more, than allowed."])),
        motor=draw(st.sampled_from([1, 2])),
    )


@examples(40)
@given(run=runs())
def test_saved_run_is_read_back_equal(run: Run) -> None:
    assert from_csv(to_csv(run)) == run


def test_csv_has_headings_with_units_and_a_row_per_reading() -> None:
    lines = [line for line in to_csv(SAVED).splitlines() if not line.startswith("#")]
    assert lines == [
        "time_s,setpoint,current_a",
        "0.0000,40,",
        "0.0125,40,0.0000",
        "0.0250,40,4.5000",
    ]


def test_file_header_lists_motor_shape_and_settings() -> None:
    text = to_csv(SAVED)
    assert "# motor: 1" in text
    assert "# shape: step" in text
    assert "# stored Motor 1 Acceleration: 20 per 100 ms" in text


@pytest.mark.parametrize(
    ("old", "new", "words"),
    [
        ("# TReX Studio bench test", "product: TReX", "line 1: a bench test begins with"),
        ("# motor: 1", "# motor 1", "line 3: expected a name and a value"),
        ("# motor: 1\n", "", "the line “# motor: …” is missing"),
        ("# motor: 1", "# motor: 7", "expected 1 or 2, not 7"),
        ("# shape: step", "# shape: square", "shape: invalid value “square”"),
        ("# speed: 40", "# speed: 400", "not 400"),
        ("time_s,", "seconds,", "expected the columns time_s, setpoint, current_a"),
        ("0.0250,40,4.5000", "0.0250,40", "line 17: invalid row “0.0250,40”"),
        ("0.0250,40,4.5000", "0.0250,40,many", "line 17: invalid row “0.0250,40,many”"),
        ("0.0250,40,4.5000", "0.0250,40,nan", "line 17: invalid row “0.0250,40,nan”"),
    ],
)
def test_damaged_file_is_rejected_with_a_reason(old: str, new: str, words: str) -> None:
    text = to_csv(SAVED)
    assert old in text
    with pytest.raises(BenchFileError) as error:
        from_csv(text.replace(old, new, 1))
    assert words in str(error.value)
