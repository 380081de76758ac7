"""A user calibrates channels by pointing, in the main window, on a simulated board.

What the page shows is in tests/views/test_calibration_page.py.
"""

import pytest

from tests.support.pages.calibration import CalibrationPage
from tests.support.simulator import SimulatedDevice
from tests.support.window import WindowDriver
from trex_gui.devices.trex.model.calibration_moves import Handle
from trex_gui.devices.trex.protocol.calibration import DEFAULT_CALIBRATION
from trex_gui.devices.trex.protocol.flags import InputSource
from trex_gui.devices.trex.views.pages.calibration import page as widgets

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
    page.drag_handle(Handle.MINIMUM, 2300)
    edited = page.shown()
    assert edited != FACTORY
    assert undo.count() == 1
    undo.undo()
    assert page.shown() == FACTORY
    undo.redo()
    assert page.shown() == edited
    assert page.text("minimumCounts") == f"= {edited.minimum} counts"
    assert "edited" in page.row(1)
    assert page.text("learnedLabel") == "not learned yet: will be after Apply"
    assert window.device.calibrations.stored(1) == FACTORY

    window.click("applyButton")
    window.click("writeButton")
    window.wait(lambda: not window.device.writer.running)
    assert window.device.calibrations.stored(1) == edited
    assert window.device.draft.pending == 0
    assert "edited" not in page.row(1)
    assert page.text("learnedLabel").startswith("learned")
