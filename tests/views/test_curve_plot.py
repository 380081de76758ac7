"""The curve with its handles, by itself."""

from collections.abc import Iterator
from dataclasses import replace

import numpy as np
import pytest
from PySide6.QtCore import QPoint, Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QWidget
from pytestqt.qtbot import QtBot

from trex_gui.model.calibration_moves import Handle
from trex_gui.model.channel_curve import ChannelCurve
from trex_gui.protocol.calibration import Calibration
from trex_gui.protocol.flags import InputSource
from trex_gui.views.theme import theme
from trex_gui.views.widgets.curve_plot import CurvePlot
from trex_gui.views.widgets.input_trace import InputTrace

USUAL = ChannelCurve(Calibration(2500, 3750, 5000, 75))


@pytest.fixture
def plot(qapp: QApplication, qtbot: QtBot) -> Iterator[CurvePlot]:
    theme().install(qapp)
    theme().set_scheme("light")
    widget = CurvePlot()
    qtbot.addWidget(widget)
    widget.resize(700, 420)
    widget.show_channel(1, InputSource.RC, USUAL, USUAL, editable=True)
    widget.show()
    widget.grab()
    yield widget
    theme().set_scheme("light")
    qapp.processEvents()


def viewport(plot: CurvePlot) -> QWidget:
    found = plot.findChild(QWidget, "curveViewport")
    assert found is not None
    return found


def place(plot: CurvePlot, handle: Handle) -> QPoint:
    return plot.place_of(handle).toPoint()


def press(plot: CurvePlot, where: QPoint) -> None:
    QTest.mousePress(viewport(plot), Qt.MouseButton.LeftButton, pos=where)


def release(plot: CurvePlot, where: QPoint) -> None:
    QTest.mouseRelease(viewport(plot), Qt.MouseButton.LeftButton, pos=where)


def drag(plot: CurvePlot, handle: Handle, count: int) -> None:
    """Take a handle and pull it to a count in a few steps."""
    start = place(plot, handle)
    end = QPoint(round(plot.x_of(count)), start.y() + 30 if handle is Handle.NEUTRAL else start.y())
    press(plot, start)
    for step in (0.3, 0.7, 1.0):
        QTest.mouseMove(viewport(plot), start + (end - start) * step)
    release(plot, end)


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
def test_a_dragged_handle_changes_its_value_once_on_release(
    plot: CurvePlot, handle: Handle, field: str, target: int, expected: int
) -> None:
    wished: list[Calibration] = []
    previewed: list[Calibration] = []
    plot.wished.connect(wished.append)
    plot.previewed.connect(previewed.append)
    drag(plot, handle, target)
    assert len(wished) == 1
    assert len(previewed) == 3
    assert wished[0] == previewed[-1]
    pixel = 3700 / viewport(plot).width()
    assert abs(getattr(wished[0], field) - expected) <= pixel
    unchanged = replace(USUAL.calibration, **{field: getattr(wished[0], field)})
    assert wished[0] == unchanged


def test_what_is_dragged_is_drawn_while_it_is_held(plot: CurvePlot) -> None:
    plot.set_raw(2600)
    start = place(plot, Handle.MINIMUM)
    press(plot, start)
    QTest.mouseMove(viewport(plot), QPoint(round(plot.x_of(2600)), start.y()))
    assert plot.curve is not None
    assert abs(plot.curve.calibration.minimum - 2600) < 8
    assert plot.dot == (2600, plot.curve.output(2600))
    release(plot, QPoint(round(plot.x_of(2600)), start.y()))


def test_a_handle_cannot_pass_another_and_says_so_beside_it(plot: CurvePlot) -> None:
    start = place(plot, Handle.MINIMUM)
    beyond = QPoint(round(plot.x_of(4200)), start.y())
    wished: list[Calibration] = []
    plot.wished.connect(wished.append)
    press(plot, start)
    QTest.mouseMove(viewport(plot), beyond)
    assert plot.message == "Minimum cannot pass neutral."
    plot.grab()
    release(plot, beyond)
    assert plot.message == ""
    assert wished == [Calibration(3750, 3750, 5000, 75)]


def test_a_handle_that_comes_back_to_where_it_was_is_let_go(plot: CurvePlot, qtbot: QtBot) -> None:
    flat = ChannelCurve(Calibration(3750, 3750, 5000, 75))
    plot.show_channel(1, InputSource.RC, flat, flat, editable=True)
    start = place(plot, Handle.MINIMUM)
    end = QPoint(round(plot.x_of(4100)), start.y())
    press(plot, start)
    QTest.mouseMove(viewport(plot), end)
    assert plot.message == "Minimum cannot pass neutral."
    with qtbot.assertNotEmitted(plot.wished), qtbot.waitSignal(plot.let_go):
        release(plot, end)
    assert plot.message == ""


def test_the_axis_goes_with_a_handle_as_far_as_the_input_can_be(plot: CurvePlot) -> None:
    for handle, count, reached, words in (
        (Handle.MAXIMUM, 5800, 5800, ""),
        (Handle.MAXIMUM, 7000, 6250, "A pulse cannot be longer than 2500 µs."),
        (Handle.MINIMUM, 1600, 1600, ""),
        (Handle.MINIMUM, 300, 1250, "A pulse cannot be shorter than 500 µs."),
    ):
        start = place(plot, handle)
        end = QPoint(round(plot.x_of(count)), start.y())
        press(plot, start)
        QTest.mouseMove(viewport(plot), end)
        assert plot.curve is not None
        assert abs(handle.count(plot.curve.calibration) - reached) < 8
        assert plot.message == words
        assert plot.message_at is (handle if words else None)
        low, high = plot.axis
        assert low <= handle.count(plot.curve.calibration) <= high
        shown = round(plot.x_of(handle.count(plot.curve.calibration)))
        assert 0 < shown < viewport(plot).width(), "the handle can be seen"
        release(plot, end)
        assert plot.axis == (2000, 5500), "nobody took the wish"


def test_a_handle_at_the_end_of_the_axis_goes_on_bit_by_bit(plot: CurvePlot) -> None:
    start = place(plot, Handle.MAXIMUM)
    edge = QPoint(round(plot.x_of(5520)), start.y())
    press(plot, start)
    counts = []
    for _ in range(3):
        QTest.mouseMove(viewport(plot), edge - QPoint(1, 0))
        QTest.mouseMove(viewport(plot), edge)
        assert plot.curve is not None
        counts.append(plot.curve.calibration.maximum)
    release(plot, edge)
    assert counts == sorted(counts)
    assert counts[-1] < 5700


def test_a_value_that_was_not_taken_is_told_beside_its_handle(plot: CurvePlot) -> None:
    plot.say_beside(Handle.MINIMUM, "Minimum cannot be there.")
    assert (plot.message_at, plot.message) == (Handle.MINIMUM, "Minimum cannot be there.")
    QTest.mouseMove(viewport(plot), QPoint(1, 1))
    QTest.mouseMove(viewport(plot), place(plot, Handle.NEUTRAL))
    picture = plot.grab().toImage()
    box = {
        picture.pixelColor(x, y).name()
        for x in range(round(plot.x_of(2500)), round(plot.x_of(3500)))
        for y in range(picture.height() // 2)
    }
    assert theme().color("warning").name() in box
    press(plot, place(plot, Handle.MAXIMUM))
    assert plot.message == ""
    release(plot, place(plot, Handle.MAXIMUM))
    plot.say_beside(Handle.MINIMUM, "Minimum cannot be there.")
    plot.show_channel(2, InputSource.RC, USUAL, USUAL, editable=True)
    assert plot.message_at is None


def test_the_trace_is_high_enough_to_show_noise_and_its_times_can_be_read(plot: CurvePlot) -> None:
    plot.resize(plot.width(), plot.minimumSizeHint().height())
    picture = plot.grab().toImage()
    trace = plot.findChild(InputTrace)
    assert trace is not None
    line = trace.fontMetrics().height()
    frame = trace.frame
    assert frame.height() >= 4.5 * line
    top = trace.mapTo(plot, frame.topLeft().toPoint())
    background, capital = picture.pixelColor(1, 1), plot.fontMetrics().capHeight()
    written = [
        y
        for y in range(top.y() - line, top.y() + line)
        if any(picture.pixelColor(x, y) != background for x in range(2, top.x() - 3))
    ]
    assert written[-1] - written[0] + 1 >= 0.8 * capital, "as high as a capital letter"
    assert picture.pixelColor(top.x() // 2, written[0] - 1) == background


def test_a_click_moves_nothing(plot: CurvePlot, qtbot: QtBot) -> None:
    with qtbot.assertNotEmitted(plot.wished):
        for handle in Handle:
            QTest.mouseClick(
                viewport(plot), Qt.MouseButton.LeftButton, pos=place(plot, handle) + QPoint(3, 0)
            )


def test_where_nothing_is_to_be_edited_nothing_can_be_dragged(
    plot: CurvePlot, qtbot: QtBot
) -> None:
    plot.show_channel(1, InputSource.RC, USUAL, USUAL, editable=False)
    with qtbot.assertNotEmitted(plot.previewed):
        drag(plot, Handle.MAXIMUM, 5200)


def test_a_handle_that_is_held_is_let_go_when_the_board_is_gone(
    plot: CurvePlot, qtbot: QtBot
) -> None:
    start = place(plot, Handle.MAXIMUM)
    press(plot, start)
    QTest.mouseMove(viewport(plot), start + QPoint(20, 0))
    plot.show_channel(1, InputSource.RC, USUAL, USUAL, editable=False)
    with qtbot.assertNotEmitted(plot.wished):
        release(plot, start + QPoint(20, 0))
    assert plot.curve == USUAL


def test_handles_near_each_other_are_told_apart_by_height(plot: CurvePlot) -> None:
    narrow = ChannelCurve(Calibration(2500, 3750, 5000, 5))
    plot.show_channel(1, InputSource.RC, narrow, narrow, editable=True)
    wished: list[Calibration] = []
    plot.wished.connect(wished.append)
    drag(plot, Handle.NEUTRAL, 3500)
    drag(plot, Handle.DEADBAND_HIGH, 4000)
    assert wished[0].neutral < 3600
    assert wished[0].deadband == 5
    assert wished[1].neutral == 3750
    assert wished[1].deadband > 200


def test_the_mouse_pointer_tells_what_can_be_dragged(plot: CurvePlot) -> None:
    QTest.mouseMove(viewport(plot), QPoint(1, 1))  # or it was there already and does not move
    QTest.mouseMove(viewport(plot), place(plot, Handle.NEUTRAL))
    assert viewport(plot).cursor().shape() is Qt.CursorShape.SizeHorCursor
    QTest.mouseMove(viewport(plot), place(plot, Handle.NEUTRAL) + QPoint(60, 20))
    assert viewport(plot).cursor().shape() is Qt.CursorShape.ArrowCursor


def test_the_axis_reaches_what_lies_further_out(plot: CurvePlot) -> None:
    assert plot.axis == (2000, 5500)
    wide = ChannelCurve(Calibration(1500, 3750, 6000, 75))
    plot.show_channel(1, InputSource.RC, USUAL, wide, editable=True)
    assert plot.axis[0] < 1500
    assert plot.axis[1] > 6000
    plot.show_channel(1, InputSource.ANALOG, None, None, editable=False)
    assert plot.axis == (0, 1023)
    plot.grab()


def test_without_a_signal_there_is_no_dot(plot: CurvePlot) -> None:
    dots = []
    for raw in (None, 5000, None):
        plot.set_raw(raw)
        dots.append(plot.dot)
    assert dots == [None, (5000, 127), None]


def test_both_schemes_can_be_drawn_with_everything_on_it(plot: CurvePlot) -> None:
    times = np.arange(0, 20, 0.02)
    counts = 3750 + 900 * np.sin(times)
    counts[100:150] = np.nan
    for channel in (4, 5):
        for scheme in ("light", "dark"):
            theme().set_scheme(scheme)
            QApplication.processEvents()  # the palette reaches widgets with the next events
            edited = ChannelCurve(Calibration(2600, 3700, 5100, 90), channel == 5, True)
            plot.show_channel(channel, InputSource.RC, USUAL, edited, editable=True)
            plot.set_raw(4000)
            plot.set_trace(times, counts, 20.0)
            picture = plot.grab().toImage()
            assert picture.pixelColor(1, 1) == theme().color("window")
            colours = {
                picture.pixelColor(x, y).name() for x in range(0, 700, 2) for y in range(0, 420, 3)
            }
            for name in ("motor1", "motor2", "limit", "mark", "plot_background"):
                assert theme().color(name).name() in colours, (scheme, name)
