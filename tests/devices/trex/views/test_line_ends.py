"""Typed lines get the line endings of their file."""

from hypothesis import given
from hypothesis import strategies as st

from trex_gui.devices.trex.views.settings_editor.text_page import EDITOR_BREAK, with_line_ends

some_text = st.text(st.sampled_from("ab \r\n\u2029"), max_size=20)


@given(some_text)
def test_unedited_lines_yield_the_same_text(text: str) -> None:
    assert with_line_ends(EDITOR_BREAK.split(text), text) == text


@given(some_text, st.lists(st.text(st.sampled_from("ab"), max_size=2), min_size=1))
def test_edited_lines_remain_as_typed(before: str, lines: list[str]) -> None:
    assert EDITOR_BREAK.split(with_line_ends(lines, before)) == lines


def test_lines_around_an_edit_retain_their_line_endings() -> None:
    assert with_line_ends(["a", "x", "y", "c", ""], "a\r\nb\nc\n") == "a\r\nx\r\ny\r\nc\n"


def test_text_without_line_endings_gets_line_feeds() -> None:
    assert with_line_ends(["a", "b"], "a") == "a\nb"
