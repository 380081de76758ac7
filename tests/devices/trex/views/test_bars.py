from collections.abc import Callable

import pytest
from PySide6.QtGui import QImage
from PySide6.QtWidgets import QApplication
from pytestqt.qtbot import QtBot

from tests.support.accessible_names import spoken_state
from trex_gui.devices.trex.protocol.calibration import DEFAULT_CALIBRATION, Calibration
from trex_gui.devices.trex.protocol.flags import InputSource
from trex_gui.devices.trex.views.bars import ChannelBar, OutputBar
from trex_gui.ui.theme.theme import theme
from trex_gui.ui.widgets.bar import Bar, BarState

RC = DEFAULT_CALIBRATION[InputSource.RC]


@pytest.fixture(autouse=True)
def _light(qapp: QApplication) -> None:
    theme().install(qapp)
    theme().set_scheme("light")


@pytest.fixture
def bar(qtbot: QtBot) -> ChannelBar:
    widget = ChannelBar()
    qtbot.addWidget(widget)
    widget.resize(500, widget.sizeHint().height())
    widget.set_calibration(RC)
    widget.set_connected(True)
    return widget


@pytest.fixture
def output(qtbot: QtBot) -> OutputBar:
    widget = OutputBar()
    qtbot.addWidget(widget)
    widget.resize(400, widget.sizeHint().height())
    widget.set_connected(True)
    return widget


def colours(widget: Bar, left: float, right: float) -> set[str]:
    """All colours along the middle of the track, from `left` to `right`, ends left out."""
    picture: QImage = widget.grab().toImage()
    y = widget._track().center().y()
    return {picture.pixelColor(x, y).name() for x in range(round(left) + 2, round(right) - 2)}


def named(name: str) -> str:
    return theme().color(name).name()


def test_fill_within_the_deadband_is_neutral(bar: ChannelBar) -> None:
    wide = Calibration(2500, 3750, 5000, 500)
    bar.set_calibration(wide)
    bar.set_raw(4200)
    assert colours(bar, bar.x_of(3750), bar.x_of(4200)) == {named("neutral")}
    shown = colours(bar, bar.x_of(2000), bar.x_of(5500))
    assert named("bar") not in shown
    assert spoken_state(bar) == "1680 µs, neutral"


@pytest.mark.parametrize("raw", [None, 3000])
def test_disconnected_bar_shows_no_value(bar: ChannelBar, raw: int | None) -> None:
    bar.set_raw(raw)
    bar.set_connected(False)
    assert bar.state is BarState.DISCONNECTED
    shown = colours(bar, bar.x_of(2000), bar.x_of(5500))
    assert shown == {named("track_off"), named("mark")}
    assert spoken_state(bar) == "not connected"
    bar.set_connected(True)
    assert spoken_state(bar) == "no data yet"


def test_missing_signal_is_hatched_and_described(bar: ChannelBar) -> None:
    bar.set_raw(4000)
    bar.set_raw(None)
    assert bar.state is BarState.NO_SIGNAL
    assert spoken_state(bar) == "no signal"
    shown = colours(bar, bar.x_of(2600), bar.x_of(3200))
    assert len(shown) > 2
    assert shown.isdisjoint({named("bar"), named("track")})


def test_axis_holds_value_and_calibration(bar: ChannelBar) -> None:
    bar.set_raw(5600)
    assert bar.axis == (2000, 5750)
    bar.set_raw(3750)
    assert bar.axis == (2000, 5750)  # stays: it must not breathe with the stick
    bar.set_calibration(Calibration(1500, 3750, 6000, 75))
    assert bar.axis == (1500, 6000)
    bar.set_calibration(RC)
    assert bar.axis == (2000, 5500)
    bar.set_raw(2500)
    assert spoken_state(bar) == "1000 µs, 500 µs below neutral"
    bar.set_calibration(None)
    assert spoken_state(bar) == "1000 µs"


@pytest.mark.parametrize(("raw", "axis"), [(9000, (2000, 6250)), (10, (1250, 5500))])
def test_axis_ends_at_the_measurable_limit(
    bar: ChannelBar, raw: int, axis: tuple[int, int]
) -> None:
    bar.set_raw(raw)
    assert bar.axis == axis
    track = bar._track()
    assert bar.x_of(raw) in {track.left(), track.left() + track.width()}
    bar.grab()


def test_voltages_have_their_own_axis(bar: ChannelBar) -> None:
    bar.set_raw(3000)
    bar.set_source(InputSource.ANALOG)
    bar.set_calibration(DEFAULT_CALIBRATION[InputSource.ANALOG])
    assert bar.state is BarState.WAITING
    bar.set_raw(1023)
    assert bar.axis == (0, 1023)
    assert spoken_state(bar) == "5.00 V, 2.50 V above neutral"


@pytest.mark.parametrize(
    "calibration",
    [
        RC,
        None,
        Calibration(3700, 3700, 3710, 0),
        Calibration(0, 0, 16383, 16383),
        Calibration(5000, 3000, 1000, 5),
    ],
)
def test_bar_is_painted_at_any_width_and_calibration(
    bar: ChannelBar, calibration: Calibration | None
) -> None:
    bar.set_calibration(calibration)
    for width in (1, 60, 120, 200, 2000):
        bar.resize(width, bar.height())
        for raw in (3000, 3705, None):
            bar.set_raw(raw)
            assert not bar.grab().isNull()


@pytest.mark.parametrize("make", [ChannelBar, OutputBar])
def test_bar_grows_with_the_font(qtbot: QtBot, make: Callable[[], Bar]) -> None:
    widget = make()
    qtbot.addWidget(widget)
    before = widget.sizeHint()
    font = widget.font()
    font.setPointSizeF(font.pointSizeF() * 2)
    widget.setFont(font)
    assert widget.sizeHint().height() > before.height() * 1.5
    assert widget.sizeHint().width() > before.width() * 1.5


def test_output_is_described_for_screen_readers(output: OutputBar) -> None:
    for value, spoken in ((64, "+64 of 127"), (0, "0 of 127"), (None, "no signal")):
        output.set_value(value)
        assert spoken_state(output) == spoken
    output.grab()
