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
        (f"version.{3000 * 'a.'}a = 1", "a.toml: this is not a plot layout: version = {'a': {'a':"),
        (f"version = {5000 * '9'}", "a.toml: this is not a plot layout: Exceeds the limit"),
        ("\0", "a.toml: line 1: this is a binary file"),
        ("", "a.toml: this is not a plot layout: version = None"),
        ("version = 2", "a.toml: this is not a plot layout: version = 2"),
        ("version = true", "a.toml: this is not a plot layout: version = True"),
        (GOOD.replace("10", "0"), "a.toml: seconds: is 0, not 0.05–14400"),
        (GOOD.replace("10", "nan"), "a.toml: seconds: is nan, not 0.05"),
        (GOOD.replace("10", "true"), "a.toml: seconds: is True, not 0.05"),
        (GOOD.replace("top = 0", "top = -1"), "a.toml: top: is -1, not 0–1e+06"),
        (GOOD.replace("top = 0\n", ""), "a.toml: top: is missing"),
        (
            GOOD.replace("[curves]", "[colours]"),
            "curves: is missing\ncolours: is none of version, seconds",
        ),
        ("version = 1\nseconds = 1\ntop = 0\ncurves = 1", "curves: is 1, not [curves]"),
        (GOOD.replace("blue", "mauve"), "motor1: is 'mauve', not blue,"),
        (GOOD.replace('"blue"', "[]"), "motor1: is [], not blue,"),
        (GOOD + 'motor3 = "red"', "motor3: is none of motor1, motor2"),
    ],
)
def test_invalid_layout_is_rejected_with_the_reason(text: str, message: str) -> None:
    with pytest.raises(SettingsError) as error:
        read_layout(text.encode(), "a.toml", KNOWN)
    assert message in str(error.value)
