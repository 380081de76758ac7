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
def test_title_has_no_mnemonic_and_no_ellipsis(text: str, name: str) -> None:
    assert title_of(text) == name
