"""Curve plot and its handles."""

from dataclasses import replace

import pytest
from PySide6.QtCore import QLocale, QPoint
from PySide6.QtGui import QFontMetrics
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication
from pytestqt.qtbot import QtBot

from tests.support.catalogs import in_language
from tests.support.pages.channels import CurvePlotDriver
from tests.support.window import LEFT
from trex_gui.core.translation import tr
from trex_gui.devices.trex.calibration.channel_curve import ChannelCurve
from trex_gui.devices.trex.model.calibration_moves import Handle
from trex_gui.devices.trex.protocol.calibration import Calibration
from trex_gui.devices.trex.protocol.flags import InputSource
from trex_gui.devices.trex.views.pages.channels.curve_plot import CurvePlot
from trex_gui.ui.plotting.canvas import PlotCanvas
from trex_gui.ui.theme.theme import theme
from trex_gui.ui.translations import LANGUAGES

CURVE = ChannelCurve(Calibration(2500, 3750, 5000, 75))


@pytest.fixture
def plot(qapp: QApplication, qtbot: QtBot) -> CurvePlot:
    theme().install(qapp)
    theme().set_scheme("light")
    widget = CurvePlot()
    qtbot.addWidget(widget)
    widget.resize(700, 420)
    widget.show_channel(1, InputSource.RC, CURVE, CURVE, editable=True)
    widget.show()
    widget.grab()
    return widget


@pytest.fixture
def driver(plot: CurvePlot, qtbot: QtBot) -> CurvePlotDriver:
    return CurvePlotDriver(plot, qtbot)


@pytest.mark.parametrize(
    ("handle", "field", "target", "expected"),
    [
        (Handle.MINIMUM, "minimum", 2300, 2300),
        (Handle.NEUTRAL, "neutral", 3600, 3600),
        (Handle.MAXIMUM, "maximum", 5200, 5200),
        (Handle.DEADBAND_LOW, "deadband", 3550, 200),
        (Handle.DEADBAND_HIGH, "deadband", 4000, 250),
    ],
)
def test_dragged_handle_changes_its_value_once_on_release(
    driver: CurvePlotDriver, handle: Handle, field: str, target: int, expected: int
) -> None:
    edited: list[Calibration] = []
    previewed: list[Calibration] = []
    driver.plot.edited.connect(edited.append)
    driver.plot.previewed.connect(previewed.append)
    driver.drag_handle(handle, target)
    assert len(edited) == 1
    assert len(previewed) == 3
    assert edited[0] == previewed[-1]
    pixel = 3700 / driver.viewport.width()
    assert abs(getattr(edited[0], field) - expected) <= pixel
    unchanged = replace(CURVE.calibration, **{field: getattr(edited[0], field)})
    assert edited[0] == unchanged


def test_curve_follows_a_held_handle(plot: CurvePlot, driver: CurvePlotDriver) -> None:
    dots = [plot.dot]
    plot.set_raw(2600)
    driver.drag_handle(Handle.MINIMUM, 2600, release=False)
    assert plot.curve is not None
    assert abs(plot.curve.calibration.minimum - 2600) < 8
    assert plot.dot == (2600, plot.curve.output(2600))
    driver.release(driver.place(Handle.MINIMUM))
    plot.set_raw(None)
    assert [*dots, plot.dot] == [None, None]


def test_handle_blocked_by_another_shows_the_reason(driver: CurvePlotDriver) -> None:
    edited: list[Calibration] = []
    driver.plot.edited.connect(edited.append)
    driver.drag_handle(Handle.MINIMUM, 4200, release=False)
    assert driver.plot.handles.message == "Minimum cannot pass neutral."
    colour, picture = theme().color("warning"), driver.plot.grab().toImage()
    x = round(driver.plot.x_of(3750)) + 10
    assert any(picture.pixelColor(x, y) == colour for y in range(picture.height()))
    driver.release(driver.place(Handle.MINIMUM))
    assert driver.plot.handles.message == ""
    assert edited == [Calibration(3750, 3750, 5000, 75)]


def test_handle_back_at_its_start_changes_nothing(driver: CurvePlotDriver, qtbot: QtBot) -> None:
    flat = ChannelCurve(Calibration(3750, 3750, 5000, 75))
    driver.plot.show_channel(1, InputSource.RC, flat, flat, editable=True)
    driver.drag_handle(Handle.MINIMUM, 4100, release=False)
    assert driver.plot.handles.message == "Minimum cannot pass neutral."
    with qtbot.assertNotEmitted(driver.plot.edited), qtbot.waitSignal(driver.plot.released):
        driver.release(driver.place(Handle.MINIMUM))
    assert driver.plot.handles.message == ""


def test_axis_follows_a_handle_up_to_the_input_limits(driver: CurvePlotDriver) -> None:
    for handle, count, limited, message in (
        (Handle.MAXIMUM, 5800, 5800, ""),
        (Handle.MAXIMUM, 7000, 6250, "Pulses range from 500 µs to 2500 µs."),
        (Handle.MINIMUM, 1600, 1600, ""),
        (Handle.MINIMUM, 300, 1250, "Pulses range from 500 µs to 2500 µs."),
    ):
        start = driver.place(handle)
        end = QPoint(round(driver.plot.x_of(count)), start.y())
        driver.press(start)
        driver.move(end)
        assert driver.plot.curve is not None
        dragged = handle.count(driver.plot.curve.calibration)
        assert abs(dragged - limited) < 8
        assert driver.plot.handles.message == message
        low, high = driver.plot.axis
        assert low <= dragged <= high
        assert 0 < driver.place(handle).x() < driver.viewport.width(), "the handle is visible"
        driver.release(end)
        assert driver.plot.axis == (2000, 5500), "no edit was applied"


def test_handle_at_the_axis_end_moves_in_small_steps(driver: CurvePlotDriver) -> None:
    start = driver.place(Handle.MAXIMUM)
    edge = QPoint(round(driver.plot.x_of(5520)), start.y())
    driver.press(start)
    counts = []
    for _ in range(3):
        driver.move(edge - QPoint(1, 0))
        driver.move(edge)
        assert driver.plot.curve is not None
        counts.append(driver.plot.curve.calibration.maximum)
    driver.release(edge)
    assert counts == sorted(counts)
    assert counts[-1] < 5700


def test_click_or_read_only_drag_moves_no_handle(
    plot: CurvePlot, driver: CurvePlotDriver, qtbot: QtBot
) -> None:
    with qtbot.assertNotEmitted(plot.edited):
        for handle in Handle:
            QTest.mouseClick(driver.viewport, LEFT, pos=driver.place(handle) + QPoint(3, 0))
    plot.show_channel(1, InputSource.RC, CURVE, CURVE, editable=False)
    with qtbot.assertNotEmitted(plot.previewed):
        driver.drag_handle(Handle.MAXIMUM, 5200)


def test_held_handle_is_released_when_editing_is_disabled(
    driver: CurvePlotDriver, qtbot: QtBot
) -> None:
    start = driver.place(Handle.MAXIMUM)
    driver.press(start)
    driver.move(start + QPoint(20, 0))
    driver.plot.show_channel(1, InputSource.RC, CURVE, CURVE, editable=False)
    with qtbot.assertNotEmitted(driver.plot.edited):
        driver.release(start + QPoint(20, 0))
    assert driver.plot.curve == CURVE


def test_nearby_handles_are_distinguished_by_height(driver: CurvePlotDriver) -> None:
    narrow = ChannelCurve(Calibration(2500, 3750, 5000, 5))
    driver.plot.show_channel(1, InputSource.RC, narrow, narrow, editable=True)
    edited: list[Calibration] = []
    driver.plot.edited.connect(edited.append)
    driver.drag_handle(Handle.NEUTRAL, 3500)
    driver.drag_handle(Handle.DEADBAND_HIGH, 4000)
    assert edited[0].neutral < 3600
    assert edited[0].deadband == 5
    assert edited[1].neutral == 3750
    assert edited[1].deadband > 200


def test_names_and_minimum_heights_follow_the_font_size(plot: CurvePlot) -> None:
    before = plot.minimumSizeHint().height(), plot.handles.height_above()
    theme().set_font_size(150)
    plot.grab()
    after = plot.minimumSizeHint().height(), plot.handles.height_above()
    assert after[0] > 1.4 * before[0]
    assert after[1] > 1.2 * before[1]


@pytest.mark.parametrize("language", LANGUAGES)
def test_output_label_fits_in_each_language(
    qapp: QApplication, qtbot: QtBot, language: str
) -> None:
    with in_language(qapp, QLocale(language)):
        plot = CurvePlot()
        qtbot.addWidget(plot)
        plot.resize(500, 400)
        plot.show()
        text = tr("Output")
    (canvas,) = plot.findChildren(PlotCanvas)
    assert canvas.frame.left() > QFontMetrics(canvas.small_font()).horizontalAdvance(text)
