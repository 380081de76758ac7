"""Layouts of a plot as small TOML files: time shown, range, and each curve with its colour."""

import tomllib
from collections.abc import Collection, Iterator, Mapping
from dataclasses import dataclass
from reprlib import repr as shortened  # limits nested tables, too
from typing import Any

from trex_gui.core.files import Finding, SettingsError, decode
from trex_gui.core.translation import tr, tr_noop
from trex_gui.ui.plotting.axes import MAX_SPAN, MIN_SPAN

VERSION = 1
LARGEST_FILE = 64 * 1024  # bytes; a typical layout has about 600
LARGEST_TOP = 1e6

COLORS = {
    "blue": ("motor1", tr_noop("Blue")),
    "orange": ("motor2", tr_noop("Orange")),
    "green": ("good", tr_noop("Green")),
    "yellow": ("warning", tr_noop("Yellow")),
    "purple": ("dirty", tr_noop("Purple")),
    "red": ("danger", tr_noop("Red")),
    "teal": ("teal", tr_noop("Teal")),
    "pink": ("pink", tr_noop("Pink")),
    "grey": ("muted", tr_noop("Grey")),
    "foreground": ("plot_text", tr_noop("As text")),
}
"""Curve colours by name in files: the name in the theme, and the name that the user sees."""

_RANGES = {"seconds": (MIN_SPAN, MAX_SPAN), "top": (0, LARGEST_TOP)}
_KEYS = dict.fromkeys(("version", *_RANGES, "curves")).keys()


def color_name(color: str) -> str:
    """Return the name that files use for a theme colour."""
    return next((name for name, (own, _) in COLORS.items() if own == color), "foreground")


@dataclass(frozen=True, slots=True)
class PlotLayout:
    seconds: float  # how much time is shown
    top: float  # end of the left axis, in its unit; 0 fits the axis to the curves
    curves: Mapping[str, str]  # colour of each drawn curve, a key of `COLORS`


def write_layout(layout: PlotLayout) -> str:
    lines = [
        "# Plot layout of TReX Studio",
        f"version = {VERSION}",
        f"seconds = {layout.seconds:.10g}  # time shown",
        f"top = {layout.top:.10g}  # where the left axis ends; 0: where the values do",
        "",
        f"[curves]  # those that are drawn: {', '.join(COLORS)}",
        *(f'{name} = "{color}"' for name, color in layout.curves.items()),
    ]
    return "".join(f"{line}\n" for line in lines)


def read_layout(data: bytes, name: str, known: Collection[str]) -> PlotLayout:
    """Read the bytes of a file called `name` for a plot with the `known` curves.

    Raises:
        SettingsError: this is not a layout, or not for this plot. Lists every problem.
    """
    try:
        found: dict[str, Any] = tomllib.loads(decode(data, name))
    except (ValueError, RecursionError) as error:
        why = tr("it is nested too deeply") if isinstance(error, RecursionError) else error
        raise SettingsError.of(name, tr("this is not a plot layout: {0}").format(why)) from error
    version = found.get("version")
    if version != VERSION or isinstance(version, bool):
        why = f"version = {shortened(version)}"
        raise SettingsError.of(name, tr("this is not a plot layout: {0}").format(why))
    if problems := [Finding(None, *problem) for problem in _problems(found, known)]:
        raise SettingsError(name, problems)
    return PlotLayout(float(found["seconds"]), float(found["top"]), found["curves"])


def _problems(found: Mapping[str, Any], known: Collection[str]) -> Iterator[tuple[str, str]]:
    """Yield what is wrong in a layout: the key, and the message."""
    is_not = tr("is {0}, not {1}")
    curves = found.get("curves", {})
    for key in _KEYS:
        if key not in found:
            yield key, tr("is missing")
    for key, (lowest, highest) in _RANGES.items():
        value = found.get(key, lowest)
        is_number = isinstance(value, int | float) and not isinstance(value, bool)
        if not (is_number and lowest <= value <= highest):
            yield key, is_not.format(shortened(value), f"{lowest:g}–{highest:g}")
    if not isinstance(curves, dict):
        yield "curves", is_not.format(shortened(curves), "[curves]")
        curves = {}
    for keys, valid in ((found, _KEYS), (curves, known)):
        for key in keys:
            if key not in valid:
                yield key, tr("is none of {0}").format(", ".join(valid))
    for curve, color in curves.items():
        if not isinstance(color, str) or color not in COLORS:
            yield curve, is_not.format(shortened(color), ", ".join(COLORS))
