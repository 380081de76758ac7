"""Translation of texts. Without a window, the language is English."""

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from contextvars import ContextVar
from functools import cache, wraps
from typing import ParamSpec, TypeVar

P = ParamSpec("P")
T = TypeVar("T")


def _english(text: str, comment: str, count: int) -> str:
    del comment
    return text if count < 0 else text.replace("%n", str(count))


_translate: Callable[[str, str, int], str] = _english
_decimal_point = "."
_cache_resets: list[Callable[[], None]] = []
_is_english = ContextVar("_is_english", default=False)


def tr(text: str, comment: str = "", count: int = -1) -> str:
    """Translate a text with placeholders such as `{0}`.

    `comment` distinguishes equal texts that need different translations. `count` replaces `%n` and
    selects the plural form.
    """
    return (_english if _is_english.get() else _translate)(text, comment, count)


def tr_noop(text: str, comment: str = "") -> str:
    """Mark a constant for a later `tr` with the same comment."""
    del comment
    return text


def cached_text(function: Callable[P, T]) -> Callable[P, T]:
    """Cache a text function until the language changes."""

    @cache
    def cached(in_english: bool, *args: P.args, **kwargs: P.kwargs) -> T:
        del in_english
        return function(*args, **kwargs)

    call: Callable[..., T] = cached
    _cache_resets.append(cached.cache_clear)

    @wraps(function)
    def text(*args: P.args, **kwargs: P.kwargs) -> T:
        return call(_is_english.get(), *args, **kwargs)

    return text


class Number(float):
    """Number that is formatted with the decimal separator of the language: `1,5` in German.

    A percentage has a space before `%`.
    """

    def __format__(self, spec: str) -> str:
        return with_decimal_point(super().__format__(spec).replace("%", "\u00a0%"))


def with_decimal_point(number: str) -> str:
    return number if _is_english.get() else number.replace(".", _decimal_point)


@contextmanager
def in_english() -> Iterator[None]:
    """Use English within a `with` block, even if the window uses another language."""
    token = _is_english.set(True)
    try:
        yield
    finally:
        _is_english.reset(token)


def use_translations(translate: Callable[[str, str, int], str], decimal_point: str = ".") -> None:
    global _translate, _decimal_point
    _translate, _decimal_point = translate, decimal_point
    for reset in _cache_resets:
        reset()
