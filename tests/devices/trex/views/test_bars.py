from collections.abc import Callable

import pytest
from PySide6.QtWidgets import QApplication
from pytestqt.qtbot import QtBot

from tests.support.accessible_names import spoken_state
from trex_gui.devices.trex.protocol.calibration import DEFAULT_CALIBRATION, Calibration
from trex_gui.devices.trex.protocol.flags import InputSource
from trex_gui.devices.trex.views.bars import ChannelBar, OutputBar
from trex_gui.ui.theme.theme import theme
from trex_gui.ui.widgets.bar import Bar

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
    widget.set_scale(InputSource.RC, RC)
    widget.set_connected(True)
    return widget


@pytest.fixture
def output(qtbot: QtBot) -> OutputBar:
    widget = OutputBar()
    qtbot.addWidget(widget)
    widget.resize(400, widget.sizeHint().height())
    widget.set_connected(True)
    return widget


def test_fill_within_the_deadband_is_neutral(bar: ChannelBar) -> None:
    bar.set_scale(InputSource.RC, Calibration(2500, 3750, 5000, 500))
    for value, fill, spoken in (
        (4200, "neutral", "1680 µs, neutral"),
        (4400, "bar", "1760 µs, 260 µs above neutral"),
    ):
        bar.set_value(value)
        picture, track = bar.grab().toImage(), bar.track()
        x = round(track.left() + (4000 - 2000) / 3500 * track.width())
        assert picture.pixelColor(x, round(track.center().y())) == theme().color(fill)
        assert spoken_state(bar) == spoken


@pytest.mark.parametrize("raw", [None, 3000])
def test_disconnected_bar_shows_no_value(bar: ChannelBar, raw: int | None) -> None:
    bar.set_value(raw)
    bar.set_connected(False)
    assert spoken_state(bar) == "not connected"
    bar.set_connected(True)
    assert spoken_state(bar) == "no data yet"


def test_axis_holds_value_and_calibration(bar: ChannelBar) -> None:
    bar.set_value(5600)
    assert bar.axis == (2000, 5750)
    bar.set_value(3750)
    assert bar.axis == (2000, 5750)  # stays: it must not breathe with the stick
    bar.set_scale(InputSource.RC, Calibration(1500, 3750, 6000, 75))
    assert bar.axis == (1500, 6000)
    bar.set_scale(InputSource.RC, RC)
    assert bar.axis == (2000, 5500)
    bar.set_value(2500)
    assert spoken_state(bar) == "1000 µs, 500 µs below neutral"
    bar.set_scale(InputSource.RC, None)
    assert spoken_state(bar) == "1000 µs"
    bar.set_value(None)
    assert spoken_state(bar) == "no signal"


def test_voltages_have_their_own_axis(bar: ChannelBar) -> None:
    bar.set_value(3000)
    bar.set_scale(InputSource.ANALOG, DEFAULT_CALIBRATION[InputSource.ANALOG])
    assert spoken_state(bar) == "no data yet"
    bar.set_value(1023)
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
    bar.set_scale(InputSource.RC, calibration)
    for width in (1, 60, 120, 200, 2000):
        bar.resize(width, bar.height())
        for raw in (3000, 3705, None):
            bar.set_value(raw)
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
