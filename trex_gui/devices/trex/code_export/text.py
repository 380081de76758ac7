"""Text that may stand in a comment or in quotes of C, C++ and Python alike."""

import unicodedata

_ASCII = str.maketrans({"µ": "u", "μ": "u", "−": "-", "–": "-", "—": "-", "×": "x", "…": "..."})
_MEANINGFUL = str.maketrans({"\\": "/", '"': "'"})
"""What ends a quote or continues a line."""


def plain(text: str) -> str:
    """Return text as printable ASCII in one line that no compiler takes for anything else.

    No comment begins or ends in it (`/*`, `*/`) and no trigraph is left (`??/`). What ASCII
    lacks becomes the nearest letter or `?`.
    """
    letters = unicodedata.normalize("NFKD", text.translate(_ASCII))
    kept = (c for c in letters if not unicodedata.combining(c))
    ascii_only = "".join(c if c.isascii() and c.isprintable() else "?" for c in kept)
    safe = ascii_only.translate(_MEANINGFUL)
    for pair in ("*/", "/*", "??"):
        while pair in safe:
            safe = safe.replace(pair, f"{pair[0]} {pair[1]}")
    return safe.strip()
