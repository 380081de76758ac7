"""Lines that were typed, as text with the line ends that the file had before."""

import re
from collections.abc import Sequence

EDITOR_BREAK = re.compile("\r\n|[\n\r\u2029\ufdd0\ufdd1]")
"""What an editor shows as the end of a line; YAML counts two more characters as one."""


def with_line_ends(lines: Sequence[str], before: str) -> str:
    """Return lines as text; those that stand as before, at head and tail, keep their ends.

    The others get the end of the first line.
    """
    ends = [found[0] for found in EDITOR_BREAK.finditer(before)]
    usual = ends[0] if ends else "\n"
    old, count = EDITOR_BREAK.split(before), len(lines)
    if list(lines) == old:
        return before
    head = _equal(lines, old)
    tail = _equal(lines[::-1], old[::-1])
    text = []
    for number, line in enumerate(lines[:-1]):
        place = number if number < head else len(old) - (count - number)
        is_known = (number < head or number >= count - tail) and place < len(ends)
        text += [line, ends[place] if is_known else usual]
    return "".join([*text, *lines[-1:]])


def _equal(one: Sequence[str], other: Sequence[str]) -> int:
    """Return how many lines are the same from the beginning."""
    pairs = zip(one, other, strict=False)
    return next((n for n, (a, b) in enumerate(pairs) if a != b), min(len(one), len(other)))
