"""Numbers that users type: the decimal separator is a point or a comma."""

import math
import re

from trex_gui.core.errors import BadRequest
from trex_gui.core.translation import tr, with_decimal_point

DECIMAL = r"[-+]?(?:[0-9]+(?:[.,][0-9]*)?|[.,][0-9]+)"  # pattern of a number that `decimal` reads

_QUANTITY = re.compile(rf"\s*({DECIMAL})\s*(.*?)\s*")
_PREFIXES = {"µ": 1e-6, "μ": 1e-6, "u": 1e-6, "m": 1e-3, "k": 1e3, "": 1.0}
_GROUPED = re.compile(r"([-+]?[1-9][0-9]{0,2})[.,]([0-9]{3})")


class AmbiguousNumber(BadRequest):
    """The separator of a number may mark decimals or thousands."""


def decimal(text: str, *, thousands: bool = True) -> float:
    """Return the number in `text`.

    `thousands`: whether 1000 or more is plausible in the unit. 2.498 V never means 2498 V.

    Raises:
        AmbiguousNumber: one separator is followed by exactly three digits, such as 1,500.
        BadRequest: it is not a number.
    """
    number = text.strip()
    value = float(number.replace(",", ".")) if re.fullmatch(DECIMAL, number) else math.inf
    if not math.isfinite(value):
        raise BadRequest(tr("{0} is not a number").format(number or tr("empty")))
    if thousands and (parts := _GROUPED.fullmatch(number)):
        whole, rest = parts.groups()
        broken = with_decimal_point(f"{float(f'{whole}.{rest}'):g}")
        text = tr("{0} may be {1} or {2}: write the one that you mean")
        raise AmbiguousNumber(text.format(number, broken, whole + rest))
    return value


def quantity(text: str, unit: str, *, thousands: bool = True) -> float | None:
    """Return the number in `text`, converted to `unit`. Text may have another prefix or no unit.

    `None`: it is not a number, or has another unit. `thousands` applies to `unit` itself.
    """
    if (found := _QUANTITY.fullmatch(text)) is None:
        return None
    own = unit[0] if len(unit) > 1 and unit[0] in _PREFIXES else ""
    base = unit.removeprefix(own).casefold()
    given = found[2].casefold() or unit.casefold()
    for prefix, factor in _PREFIXES.items() if base else [("", 1.0)]:
        if given == prefix + base:
            number = decimal(found[1], thousands=thousands or prefix != own)
            return number * (factor / _PREFIXES[own])
    return None
