import pytest

from trex_gui.core.texts import title_of


@pytest.mark.parametrize(
    ("text", "name"),
    [
        ("&Save settings file…", "Save settings file"),
        ("Compare &with:", "Compare with"),
        ("Comparer a&vec\N{NO-BREAK SPACE}:", "Comparer avec"),
    ],
)
def test_name_has_neither_letter_nor_dots(text: str, name: str) -> None:
    assert title_of(text) == name
