"""Numbers that users type with a decimal point or a decimal comma."""

import math
import re

from trex_gui.core.errors import BadRequest
from trex_gui.core.translation import tr, with_decimal_point

DECIMAL = r"[-+]?(?:[0-9]+(?:[.,][0-9]*)?|[.,][0-9]+)"  # numbers that `decimal` accepts

_QUANTITY = re.compile(rf"\s*({DECIMAL})\s*(.*?)\s*")
_PREFIXES = {"μ": 1e-6, "u": 1e-6, "m": 1e-3, "k": 1e3, "": 1.0}  # `casefold` converts µ to μ
_GROUPED = re.compile(r"([-+]?[1-9][0-9]{0,2})[.,]([0-9]{3})")


class AmbiguousNumber(BadRequest):
    """Number whose separator may be a decimal or a thousands separator."""


def decimal(text: str, *, thousands: bool = True) -> float:
    """Return the number in `text`.

    `thousands`: True if a value of 1000 or more is plausible. For example, it is False for
    voltages, because 2.498 V never means 2498 V.

    Raises:
        AmbiguousNumber: exactly three digits follow a single separator, as in 1,500.
        BadRequest: the text is not a number.
    """
    number = text.strip()
    value = float(number.replace(",", ".")) if re.fullmatch(DECIMAL, number) else math.inf
    if not math.isfinite(value):
        raise BadRequest(tr("{0} is not a number").format(number or tr("an empty text")))
    if thousands and (parts := _GROUPED.fullmatch(number)):
        whole, rest = parts.groups()
        fraction = with_decimal_point(f"{float(f'{whole}.{rest}'):g}")
        text = tr("{0} is ambiguous: write {1} or {2}")
        raise AmbiguousNumber(text.format(number, fraction, whole + rest))
    return value


def quantity(text: str, unit: str, *, thousands: bool = True) -> float | None:
    """Return the number in `text`, converted to `unit`.

    The unit in the text may have a different metric prefix, or may be missing. Return `None` if
    the text has no number or a different unit. With a different prefix, `thousands` counts as True.
    """
    if (match := _QUANTITY.fullmatch(text)) is None:
        return None
    unit = unit.casefold()
    own_prefix = unit[0] if len(unit) > 1 and unit[0] in _PREFIXES else ""
    base = unit.removeprefix(own_prefix)
    given = match[2].casefold() or unit
    for prefix, factor in _PREFIXES.items() if base else [("", 1.0)]:
        if given == prefix + base:
            number = decimal(match[1], thousands=thousands or prefix != own_prefix)
            return number * (factor / _PREFIXES[own_prefix])
    return None
