"""Numbers typed by users, with a decimal point or comma."""

import math
import re

from trex_gui.core.errors import BadRequest
from trex_gui.core.translation import tr, with_decimal_point

DECIMAL = r"[-+]?(?:[0-9]+(?:[.,][0-9]*)?|[.,][0-9]+)"  # numbers that `decimal` accepts

_QUANTITY = re.compile(rf"\s*({DECIMAL})\s*(.*?)\s*")
_PREFIXES = {"µ": 1e-6, "μ": 1e-6, "u": 1e-6, "m": 1e-3, "k": 1e3, "": 1.0}
_GROUPED = re.compile(r"([-+]?[1-9][0-9]{0,2})[.,]([0-9]{3})")


class AmbiguousNumber(BadRequest):
    """Number whose separator may mark decimals or thousands."""


def decimal(text: str, *, thousands: bool = True) -> float:
    """Return the number in `text`.

    `thousands`: True if 1000 or more is plausible. For example, 2.498 V never means 2498 V.

    Raises:
        AmbiguousNumber: exactly three digits follow a single separator, as in 1,500.
        BadRequest: the text is not a number.
    """
    number = text.strip()
    value = float(number.replace(",", ".")) if re.fullmatch(DECIMAL, number) else math.inf
    if not math.isfinite(value):
        raise BadRequest(tr("{0} is not a number").format(number or tr("empty")))
    if thousands and (parts := _GROUPED.fullmatch(number)):
        whole, rest = parts.groups()
        fraction = with_decimal_point(f"{float(f'{whole}.{rest}'):g}")
        text = tr("{0} may be {1} or {2}: write the one that you mean")
        raise AmbiguousNumber(text.format(number, fraction, whole + rest))
    return value


def quantity(text: str, unit: str, *, thousands: bool = True) -> float | None:
    """Return the number in `text`, converted to `unit`.

    The text may have another prefix or no unit. Return None if it has no number or another unit.
    `thousands` is ignored if the text has another prefix.
    """
    if (match := _QUANTITY.fullmatch(text)) is None:
        return None
    own_prefix = unit[0] if len(unit) > 1 and unit[0] in _PREFIXES else ""
    base = unit.removeprefix(own_prefix).casefold()
    given = match[2].casefold() or unit.casefold()
    for prefix, factor in _PREFIXES.items() if base else [("", 1.0)]:
        if given == prefix + base:
            number = decimal(match[1], thousands=thousands or prefix != own_prefix)
            return number * (factor / _PREFIXES[own_prefix])
    return None
