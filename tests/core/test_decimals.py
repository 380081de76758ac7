import pytest
from hypothesis import given
from hypothesis import strategies as st

from tests.support.matrix import examples
from trex_gui.core.decimals import AmbiguousNumber, decimal, quantity
from trex_gui.core.errors import BadRequest


@pytest.mark.parametrize(
    ("text", "number"),
    [
        *((text, 1.5) for text in ("1.5", "1,5", " +1.50 ")),
        *((text, 0.125) for text in ("0.125", "0,125", ".125")),
        *(("5.", 5), ("1.2345", 1.2345), ("1000", 1000), ("1000.125", 1000.125)),
    ],
)
def test_point_and_comma_separate_decimals(text: str, number: float) -> None:
    assert decimal(text) == number


@pytest.mark.parametrize(
    ("text", "readings"),
    [("1,000", "1 or 1000"), ("1.500", "1.5 or 1500"), ("-999,125", "-999.125 or -999125")],
)
def test_separator_before_three_digits_is_ambiguous(text: str, readings: str) -> None:
    with pytest.raises(AmbiguousNumber, match=f"is ambiguous: write {readings}$"):
        decimal(text)
    assert decimal(text, thousands=False) == float(text.replace(",", "."))


@pytest.mark.parametrize(
    "text",
    [
        "",
        "nan",
        "inf",
        "1e3",
        "1_000",
        "1,000,000",
        "1.000,5",
        "9" * 400,
        "\N{ARABIC-INDIC DIGIT ONE}",
    ],
)
def test_invalid_number_is_rejected(text: str) -> None:
    with pytest.raises(BadRequest):
        decimal(text)


@pytest.mark.parametrize(
    ("text", "unit", "number"),
    [
        *(("1.5 s", "s", 1.5), ("1500ms", "s", 1.5), ("1.5", "ms", 1.5), ("1.5 S", "ms", 1500)),
        *(("2 kHz", "Hz", 2000), ("5", "", 5), ("5 m", "", None), ("5 m", "s", None)),
        *(("1500 us", "ms", 1.5), ("1500 µs", "ms", 1.5), ("2 kHz", "kHz", 2)),
    ],
)
def test_quantity_accepts_any_prefix_of_its_unit(
    text: str, unit: str, number: float | None
) -> None:
    assert quantity(text, unit) == number


def test_thousands_are_excluded_only_for_the_same_prefix() -> None:
    assert quantity("2.498 V", "V", thousands=False) == 2.498
    assert quantity("2.498", "µs", thousands=False) == 2.498
    for text, thousands in (("2,498 mV", False), ("2,498 V", True)):
        with pytest.raises(AmbiguousNumber):
            quantity(text, "V", thousands=thousands)


@examples(80)
@given(st.integers(0, 10**7), st.sampled_from(".,"), st.sampled_from(".,"))
def test_grouped_thousands_are_never_read_as_decimals(
    number: int, group: str, separator: str
) -> None:
    grouped = f"{number:,}".replace(",", group)
    for text in (grouped, f"{grouped}{separator}5"):
        try:
            read = decimal(text)
        except BadRequest:
            continue
        assert int(read) == number
