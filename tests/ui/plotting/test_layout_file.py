"""Layouts of plots in files."""

import pytest

from trex_gui.core.files import SettingsError
from trex_gui.ui.plotting.layout_file import PlotLayout, read_layout, write_layout

KNOWN = ("motor1", "motor2", "channel1")
GOOD = 'version = 1\nseconds = 10\ntop = 0\n[curves]\nmotor1 = "blue"\n'


def test_written_layout_is_read_back() -> None:
    layout = PlotLayout(12.5, 20, {"motor2": "pink", "channel1": "foreground"})
    text = write_layout(layout)
    assert text.startswith("# Plot layout of TReX Studio\nversion = 1\n")
    assert read_layout(text.encode(), "a.toml", KNOWN) == layout


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("version 1", "a.toml: this is not a plot layout: Expected '='"),
        ("x = " + 3000 * "[", "a.toml: this is not a plot layout: it is nested too deeply"),
        (f"version.{3000 * 'a.'}a = 1", "a.toml: has the version {'a': {'a':"),
        (f"version = {5000 * '9'}", "a.toml: this is not a plot layout: Exceeds the limit"),
        ("\0", "a.toml: line 1: this is a binary file"),
        ("", "a.toml: has no version; this program reads layouts of version 1"),
        ("version = 2", "a.toml: has the version 2; this program reads"),
        ("version = true", "a.toml: has the version True;"),
        (GOOD.replace("10", "0"), "a.toml: seconds: is 0, not a number from 0.05 to 14400"),
        (GOOD.replace("10", "nan"), "a.toml: seconds: is nan, not a number"),
        (GOOD.replace("10", "true"), "a.toml: seconds: is True, not a number"),
        (GOOD.replace("top = 0", "top = -1"), "a.toml: top: is -1, not a number from 0 to 1e+06"),
        (GOOD.replace("top = 0\n", ""), "a.toml: top: is missing"),
        (GOOD.replace("[curves]", "[colours]"), "curves: is missing\ncolours: is not known"),
        ("version = 1\nseconds = 1\ntop = 0\ncurves = 1", "curves: is not a table of curves"),
        (GOOD.replace("blue", "mauve"), "motor1: has the colour 'mauve', which is none of blue,"),
        (GOOD.replace('"blue"', "[]"), "motor1: has the colour [], which is none of"),
        (GOOD + 'motor3 = "red"', "motor3: is no curve of this plot, which has motor1, motor2,"),
    ],
)
def test_invalid_layout_is_rejected_with_the_reason(text: str, message: str) -> None:
    with pytest.raises(SettingsError) as error:
        read_layout(text.encode(), "a.toml", KNOWN)
    assert message in str(error.value)
