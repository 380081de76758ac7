"""Texts in the language of the window; where there is none, as on the command line, in English."""

from collections.abc import Callable

_translate: Callable[[str], str] = str


def tr(text: str) -> str:
    """Return a text for users in their language, with the same places: `{0}`."""
    return _translate(text)


def use_translations(translate: Callable[[str], str]) -> None:
    """Translate with this function from now on."""
    global _translate  # noqa: PLW0603 - the program has one language
    _translate = translate
