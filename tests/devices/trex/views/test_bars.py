"""Bars of the inputs, with their axes and colours."""

import pytest
from pytestqt.qtbot import QtBot

from tests.support.accessible_names import spoken_state
from trex_gui.devices.trex.protocol.calibration import DEFAULT_CALIBRATION, Calibration
from trex_gui.devices.trex.protocol.flags import InputSource
from trex_gui.devices.trex.views.bars import input_axis, widened
from trex_gui.devices.trex.views.learning.live_pages import InputStrip
from trex_gui.ui.theme.theme import theme

pytestmark = pytest.mark.usefixtures("light_scheme")

RC = DEFAULT_CALIBRATION[InputSource.RC]


@pytest.fixture
def strip(qtbot: QtBot) -> InputStrip:
    widget = InputStrip("learn", 1)
    qtbot.addWidget(widget)
    widget.resize(500, widget.sizeHint().height())
    return widget


def test_fill_within_the_deadband_is_neutral(strip: InputStrip) -> None:
    calibration = Calibration(2500, 3750, 5000, 500)
    for time, (raw, fill) in enumerate(((4200, "neutral"), (4400, "bar"))):
        strip.show_input(time, InputSource.RC, calibration, raw)
        picture = strip.grab().toImage()
        x = round(10 + (4000 - 2000) / 3500 * (strip.width() - 20))
        column = {picture.pixelColor(x, y).name() for y in range(strip.height())}
        assert theme().color(fill).name() in column


def test_axis_includes_value_and_calibration() -> None:
    assert input_axis(InputSource.RC, RC) == (2000, 5500)
    assert widened((2000, 5500), (5600,)) == (2000, 5750)
    assert widened((2000, 5750), (3750,)) == (2000, 5750)  # the axis does not shrink
    assert input_axis(InputSource.RC, Calibration(1500, 3750, 6000, 75)) == (1500, 6000)
    assert input_axis(InputSource.ANALOG, DEFAULT_CALIBRATION[InputSource.ANALOG]) == (0, 1023)


def test_spoken_input_has_the_unit_of_its_source(strip: InputStrip) -> None:
    strip.show_input(2, InputSource.RC, RC, 2500)
    assert spoken_state(strip).startswith("1000 µs")
    strip.show_input(3, InputSource.RC, RC, None)
    assert spoken_state(strip).startswith("no signal")
    strip.show_input(4, InputSource.ANALOG, None, 1023)
    assert spoken_state(strip).startswith("5.00 V")


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
def test_strip_is_painted_at_any_width_and_calibration(
    strip: InputStrip, calibration: Calibration | None
) -> None:
    for width in (1, 60, 120, 200, 2000):
        strip.resize(width, strip.height())
        for time, raw in enumerate((3000, 3705, None)):
            strip.show_input(width + time, InputSource.RC, calibration, raw, 64)
            assert not strip.grab().isNull()
