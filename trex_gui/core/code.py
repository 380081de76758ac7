"""Python and Arduino source code, generated from Jinja templates."""

import unicodedata
from enum import Enum
from functools import cache
from typing import TYPE_CHECKING

from trex_gui.core.resource_files import resource

if TYPE_CHECKING:
    from jinja2 import Template

_COMMENT_COLUMN = 46  # rightmost column at which comments are aligned


class Language(Enum):
    """Programming language. The value is its command-line name."""

    ARDUINO = "arduino"
    PYTHON = "python"

    @property
    def title(self) -> str:
        return "Arduino sketch" if self is Language.ARDUINO else "Python program"

    @property
    def suffix(self) -> str:
        return ".ino" if self is Language.ARDUINO else ".py"


def render(name: str, **values: object) -> str:
    return _template(name).render(values)


@cache  # compiling takes longer than rendering
def _template(name: str) -> "Template":
    from jinja2 import Environment, StrictUndefined  # noqa: PLC0415 - only for an export

    environment = Environment(
        trim_blocks=True,
        keep_trailing_newline=True,
        undefined=StrictUndefined,
        autoescape=False,  # noqa: S701 - source code, not HTML; `plain` makes text safe
    )
    environment.filters |= {"hex": hexadecimal, "aligned": _aligned}
    return environment.from_string(resource(name).read_text(encoding="utf-8"))


def plain(text: str) -> str:
    """Return printable ASCII text that is safe in C++ and Python.

    The result fits on one line of a comment or string. It has no `/*`, `*/`, double quote,
    backslash or trigraph (`??/`). A non-ASCII character becomes the nearest letter or `?`.
    """
    letters = unicodedata.normalize("NFKD", text.translate(_ASCII))
    kept = (c for c in letters if not unicodedata.combining(c))
    safe = "".join(c if c.isascii() and c.isprintable() else "?" for c in kept)
    safe = safe.replace("\\", "/").replace('"', "'")
    for pair in ("*/", "/*", "??"):
        while pair in safe:
            safe = safe.replace(pair, f"{pair[0]} {pair[1]}")
    return safe.strip()


_ASCII = str.maketrans({"µ": "u", "μ": "u", "−": "-", "–": "-", "—": "-", "×": "x", "…": "..."})


def _aligned(rows: str) -> str:
    pairs = [line.partition(" // ")[::2] for line in rows.splitlines()]
    width = min(max(len(code) for code, _ in pairs), _COMMENT_COLUMN)
    lines = [f"{code:{width}} // {comment}" if comment else code for code, comment in pairs]
    return "".join(f"{line}\n" for line in lines)


def hexadecimal(byte: int) -> str:
    return f"0x{byte:02X}"
