from collections.abc import Iterator

import numpy as np
import pytest
from PySide6.QtGui import QColor, QImage, QPalette
from PySide6.QtWidgets import QApplication, QLabel
from pytestqt.qtbot import QtBot

from trex_gui.views.theme import theme
from trex_gui.views.widgets.live_plot import CurveStyle, LivePlot
from trex_gui.views.widgets.reduction import Floats

CURVES = [CurveStyle("m1", "Motor 1", "motor1", "1"), CurveStyle("m2", "Motor 2", "motor2", "2")]
TIMES: Floats = np.arange(0, 60, 1 / 80)


@pytest.fixture
def plot(qapp: QApplication, qtbot: QtBot) -> Iterator[LivePlot]:
    theme().install(qapp)
    theme().set_scheme("light")
    widget = LivePlot(CURVES, "A")
    qtbot.addWidget(widget)
    widget.resize(600, 300)
    widget.grab()
    yield widget
    theme().set_scheme("light")
    qapp.processEvents()


def steady(level: float) -> Floats:
    return np.full_like(TIMES, level)


def empty_label(plot: LivePlot) -> QLabel:
    label = plot.findChild(QLabel, "emptyLabel")
    assert label is not None
    return label


def legend(plot: LivePlot, name: str) -> str:
    return plot._legend[name].text()


def count(plot: LivePlot, color: str) -> int:
    """How many pixels of the plot's inside have this colour of the theme."""
    box = plot._plot.frame.toRect()
    box.translate(plot._plot.pos())
    picture = plot.grab(box).toImage().convertToFormat(QImage.Format.Format_RGB32)
    pixels = np.frombuffer(picture.constBits(), dtype=np.uint32)
    return int(np.count_nonzero(pixels == theme().color(color).rgb()))


def y_range(plot: LivePlot) -> tuple[float, float]:
    return plot.y_range


def test_without_samples_it_says_so(plot: LivePlot) -> None:
    assert empty_label(plot).isVisibleTo(plot)
    assert legend(plot, "m1") == "Motor 1 \N{EN DASH} A"


def test_samples_are_drawn_in_the_curves_colour(plot: LivePlot) -> None:
    assert count(plot, "motor1") == 0
    plot.set_samples("m1", TIMES, steady(0.5), 60)
    assert not empty_label(plot).isVisibleTo(plot)
    assert count(plot, "motor1") > 400
    assert count(plot, "motor2") == 0


def test_the_legend_tells_the_newest_value(plot: LivePlot) -> None:
    values = steady(1.0)
    values[-1] = 3.214
    plot.set_samples("m1", TIMES, values, 60)
    assert legend(plot, "m1") == "Motor 1 3.21 A"
    assert plot._legend["m1"].accessibleDescription() == "3.21 A"


def test_the_range_follows_all_curves_in_steps(plot: LivePlot) -> None:
    plot.set_samples("m1", TIMES, steady(3.0), 60)
    assert y_range(plot) == (0, 5)
    plot.set_samples("m2", TIMES, steady(12.0), 60)
    assert y_range(plot) == (0, 20)
    plot.set_samples("m2", TIMES, steady(0.1), 60)
    assert y_range(plot) == (0, 5)


def test_what_left_the_window_does_not_count(plot: LivePlot) -> None:
    values = steady(0.3)
    values[:800] = 19  # the first ten seconds
    plot.set_samples("m1", TIMES, values, 35)
    assert y_range(plot) == (0, 20)
    plot.set_samples("m1", TIMES, values, 60)
    assert y_range(plot) == (0, 1)


def test_samples_all_older_than_the_window_are_no_data(plot: LivePlot) -> None:
    plot.set_samples("m1", TIMES, steady(1), 200)
    assert empty_label(plot).isVisibleTo(plot)
    assert legend(plot, "m1") == "Motor 1 \N{EN DASH} A"


def test_few_points_reach_the_painter(plot: LivePlot) -> None:
    times = np.linspace(0, 30, 200_000)
    plot.set_samples("m1", times, np.sin(times * 900), 30)
    x, _ = plot._curves["m1"]._item.getData()
    assert len(x) < 1100
    assert x[-1] == 0


def test_missing_values_break_the_line(plot: LivePlot) -> None:
    values = steady(0.5)
    values[3000:4400] = np.nan
    plot.set_samples("m1", TIMES, values, 60)
    whole, broken = 400, count(plot, "motor1")
    assert 100 < broken < whole


def test_only_missing_values_are_no_data(plot: LivePlot) -> None:
    plot.set_samples("m1", TIMES, steady(np.nan), 60)
    assert empty_label(plot).isVisibleTo(plot)


def test_a_limit_in_range_is_drawn_and_named(plot: LivePlot) -> None:
    plot.set_samples("m1", TIMES, steady(3), 60)
    plot.set_limit("m1", 4)
    assert legend(plot, "m1") == "Motor 1 3.00 A limit 4.00 A"
    assert count(plot, "motor1") > 800  # the curve, and more than half of a line of dashes
    plot.set_limit("m1", 40)
    assert count(plot, "motor1") < 650
    assert "limit 40.00 A" in legend(plot, "m1")
    plot.set_limit("m1", None)
    assert legend(plot, "m1") == "Motor 1 3.00 A"


@pytest.mark.parametrize(
    ("seconds", "labels"),
    [
        (5, ["5 s", "4 s", "3 s", "2 s", "1 s", "now"]),
        (30, ["30 s", "25 s", "20 s", "15 s", "10 s", "5 s", "now"]),
        (120, ["2 min", "90 s", "1 min", "30 s", "now"]),
        (600, ["10 min", "8 min", "6 min", "4 min", "2 min", "now"]),
    ],
)
def test_the_time_axis_is_labelled_in_round_steps(
    plot: LivePlot, seconds: float, labels: list[str]
) -> None:
    plot.set_window(seconds)
    assert plot.window_seconds == seconds
    (shown,) = plot._plot.plot.getAxis("bottom")._tickLevels
    assert [text for _, text in shown] == labels


def test_a_window_of_nothing_is_refused(plot: LivePlot) -> None:
    with pytest.raises(ValueError, match="shows nothing"):
        plot.set_window(0)


def test_clearing_forgets_the_samples(plot: LivePlot) -> None:
    plot.set_samples("m1", TIMES, steady(18), 60)
    plot.clear()
    assert empty_label(plot).isVisibleTo(plot)
    assert y_range(plot) == (0, 1)
    assert count(plot, "motor1") == 0


def test_the_tags_name_the_ends_of_the_curves(plot: LivePlot) -> None:
    plot.set_samples("m1", TIMES, steady(0.2), 60)
    plot.set_samples("m2", TIMES, steady(0.8), 60)
    heights = plot._tags._heights
    assert heights["m2"] < heights["m1"]
    plot.grab()


def test_the_plot_takes_the_new_theme(plot: LivePlot) -> None:
    plot.set_samples("m1", TIMES, steady(0.5), 60)
    theme().set_scheme("dark")
    assert count(plot, "plot_background") > 10_000
    assert count(plot, "motor1") > 400


def beside(plot: LivePlot) -> set[str]:
    """The colours of the margins around the plot."""
    picture = plot.grab().toImage()
    frame = plot._plot.frame.toRect().translated(plot._plot.pos())
    places = [
        (2, frame.center().y()),
        (frame.left() - 3, frame.bottom() + 5),
        (plot.width() - 2, frame.bottom() - 2),
        (frame.center().x(), frame.top() - 3),
        (2, plot.height() - 2),
    ]
    return {picture.pixelColor(x, y).name() for x, y in places}


def test_no_margin_keeps_the_scheme_before(plot: LivePlot, qapp: QApplication) -> None:
    plot.show()
    for scheme in ("dark", "light"):
        theme().set_scheme(scheme)
        qapp.processEvents()  # the palette reaches the widgets as an event
        assert beside(plot) == {qapp.palette().window().color().name()}, scheme


def test_no_margin_keeps_a_palette_that_changed_without_the_theme(plot: LivePlot) -> None:
    plot.show()
    plot.grab()
    palette = QPalette(plot.palette())
    palette.setColor(QPalette.ColorRole.Window, QColor("#123456"))
    plot.setPalette(palette)
    assert beside(plot) == {"#123456"}
