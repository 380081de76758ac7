"""A user calibrates channels by pointing, in the main window, on a simulated board.

What the page shows is in tests/views/test_calibration_page.py.
"""

import pytest

from tests.support.pages.calibration import CalibrationPage
from tests.support.simulator import SimulatedDevice
from tests.support.window import WindowDriver
from trex_gui.devices.trex.model.calibration_moves import Handle
from trex_gui.devices.trex.protocol.calibration import DEFAULT_CALIBRATION
from trex_gui.devices.trex.protocol.flags import CHANNELS, InputSource
from trex_gui.devices.trex.views.pages.calibration import page as widgets
from trex_gui.devices.trex.views.pages.calibration.curve_plot import InputTrace

FACTORY = DEFAULT_CALIBRATION[InputSource.RC]


@pytest.fixture
def page(window: WindowDriver) -> CalibrationPage:
    window.open_page("calibrationPage")
    widget = window.find(widgets.CalibrationPage, "calibrationPage")
    return CalibrationPage(widget, window.device, window.qtbot)


def test_calibration_is_dragged_undone_and_written(
    window: WindowDriver, page: CalibrationPage, quick_simulator: SimulatedDevice
) -> None:
    window.window.resize(1300, 800)
    assert page.has("calibrationEmpty")
    assert "Connect to a board" in page.text("calibrationEmpty")
    assert not page.has("learnButton")
    window.connect(quick_simulator.url)
    assert not page.has("calibrationEmpty")
    assert page.text("learnedLabel") == "not learned: defaults"

    undo = window.device.draft.undo
    for handle, count in (
        (Handle.MINIMUM, 2300),
        (Handle.MAXIMUM, 5200),
        (Handle.NEUTRAL, 3600),
        (Handle.DEADBAND_HIGH, 3900),
        (Handle.DEADBAND_LOW, 3500),
    ):
        before, steps = page.shown(), undo.count()
        page.drag_handle(handle, count)
        after = page.shown()
        assert after != before, handle
        assert undo.count() == steps + 1, handle
        undo.undo()
        assert page.shown() == before, handle
        undo.redo()
        assert page.shown() == after, handle
        assert page.text("minimumCounts") == f"= {after.minimum} counts"
    assert "edited" in page.row(1)
    assert page.text("learnedLabel") == "not learned yet: will be after Apply"
    assert window.device.calibrations.stored(1) == FACTORY

    edited = page.shown()
    window.click("applyButton")
    window.click("writeButton")
    window.wait(lambda: not window.device.writer.running)
    assert window.device.calibrations.stored(1) == edited
    assert window.device.draft.pending == 0
    assert "edited" not in page.row(1)
    assert page.text("learnedLabel").startswith("learned")


def test_input_trace_is_high_enough_in_a_small_window(
    window: WindowDriver, page: CalibrationPage, quick_simulator: SimulatedDevice
) -> None:
    window.window.resize(900, 600)
    window.connect(quick_simulator.url)
    for channel in CHANNELS:
        page.select_channel(channel)
        page.widget.grab()  # lets the layout settle
        trace = page.find(InputTrace, "inputTrace")
        assert trace.frame.height() >= 4.5 * trace.fontMetrics().height(), channel
