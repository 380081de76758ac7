"""Values of curves as a person reads them."""

import math

from PySide6.QtCore import QCoreApplication

from trex_gui.ui.plotting.data.history import Statistics
from trex_gui.ui.widgets.bar import MINUS, NO_VALUE


def value_text(value: float, unit: str) -> str:
    """A value: two digits behind the point with a unit; plain counts whole, with a sign."""
    if not math.isfinite(value):
        return NO_VALUE
    text = f"{value:.2f} {unit}" if unit else f"{value:+.0f}" if round(value) else "0"
    return text.replace("-", MINUS)


def mean_text(value: float, unit: str) -> str:
    """A value that is known better than a single sample."""
    if not math.isfinite(value):
        return NO_VALUE
    return (f"{value:.3f} {unit}" if unit else f"{value:.1f}").replace("-", MINUS)


def charge_text(found: Statistics) -> str:
    """A current's charge in Ah, or in mAh while it is small."""
    if not found.seconds:
        return NO_VALUE
    charge = found.per_hour
    text = f"{charge:.3f} Ah" if abs(charge) >= 1 else f"{charge * 1000:.2f} mAh"
    return text.replace("-", MINUS)


def keys_text() -> str:
    """What the keys do in a plot, for who does not see it."""
    return QCoreApplication.translate(
        "TracePlot",
        "Left and Right move the cursor, with Shift in large steps; its values are told here. "
        "M sets a mark, plus and minus zoom, L goes back to live.",
    )
