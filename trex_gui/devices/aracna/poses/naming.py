"""Names of poses and sequences: what a file can hold, and one of each."""

from collections.abc import Iterable
from collections.abc import Set as AbstractSet

from trex_gui.core.errors import BadRequest

_LONGEST = 100
_FORBIDDEN = ":,|"
"""Signs that part names and values in a pose file."""


def free_name(name: str, taken: Iterable[str]) -> str:
    """Return a name that is not taken: the one given, or with the first number that is free."""
    others = set(taken)
    return free_number(name, others)[0] if name in others else name


def free_number(name: str, taken: AbstractSet[str], first: int = 2) -> tuple[str, int]:
    """Return a name with the first number from `first` on that is free, and the number after it."""
    number = first
    while f"{name} {number}" in taken:
        number += 1
    return f"{name} {number}", number + 1


def checked_name(name: str, taken: Iterable[str]) -> str:
    """Return a name without blanks around it.

    Raises:
        BadRequest: it is empty, too long or taken, or has signs that a file cannot hold.
    """
    found = name.strip()
    if not found:
        raise BadRequest("a name has at least one letter")
    if len(found) > _LONGEST:
        raise BadRequest(f"a name has at most {_LONGEST} letters, not {len(found)}")
    for sign in found:
        if sign in _FORBIDDEN:
            raise BadRequest(f"a name has no colon, comma or bar, for a file's sake: {found}")
        if not sign.isprintable():
            raise BadRequest("a name has letters and blanks only, no control characters")
    if found in set(taken):
        raise BadRequest(f"the name {found} is taken")
    return found
