"""The Currents page of a simulated board."""

from pathlib import Path

import pytest
from PySide6.QtWidgets import QApplication, QLabel, QTableView
from shiboken6 import Shiboken

from tests.support.keyboard import check_keyboard
from tests.support.simulator import SimulatedDevice
from tests.support.window import WidgetDriver, WindowDriver
from trex_gui.devices.trex.views.pages.currents_panel import PlotWindow
from trex_gui.ui.plotting.figures import TraceColumn
from trex_gui.ui.plotting.panel import TracePanel


class CurrentsPage(WindowDriver):
    """Currents page of a window with a connected board."""

    def __init__(self, window: WindowDriver) -> None:
        super().__init__(window.program, window.qtbot)
        self.panel = self.open_page("currentsPage").find_only(TracePanel)
        self.parts = WidgetDriver(self.panel, self.qtbot)

    def wait_for_cell(self, row: int, column: int, text: str) -> None:
        model = self.parts.find(QTableView, "traceTable").model()
        self.wait(lambda: str(model.index(row, column).data()) == text)


@pytest.fixture
def page(connected_window: WindowDriver) -> CurrentsPage:
    return CurrentsPage(connected_window)


def test_currents_are_shown_and_their_picture_names_the_board(
    page: CurrentsPage, quick_simulator: SimulatedDevice, tmp_path: Path
) -> None:
    quick_simulator.do("current 1 6", "current 2 3")
    page.wait_for_cell(0, 1, "6.00 A")
    page.wait_for_cell(1, 1, "3.00 A")

    page.device.disconnect_line()
    page.wait(lambda: page.device.state is None)
    page.panel.export.save_picture(tmp_path / "currents.svg")
    page.wait_for_files()
    picture = (tmp_path / "currents.svg").read_text(encoding="utf-8")
    assert ">Motor currents, TReX 1.2, device 7, 2" in picture


def test_plot_window_is_updated_beside_another_page(
    page: CurrentsPage, quick_simulator: SimulatedDevice
) -> None:
    page.trigger("plot")
    page.open_page("motorsPage")
    (shown,) = (each for each in QApplication.topLevelWidgets() if isinstance(each, PlotWindow))
    shown.panel.plot.select_length(10)
    quick_simulator.do("current 1 6")
    model = WidgetDriver(shown, page.qtbot).find(QTableView, "traceTable").model()
    page.wait(lambda: model.index(0, TraceColumn.NOW).data() == "6.00 A")
    assert page.panel.plot.span.length == 30, "each plot has its own time span"
    note = WidgetDriver(shown, page.qtbot).find(QLabel, "pageState")
    assert "One count of this board is 150 mA" in note.text()
    shown.resize(shown.minimumSizeHint())
    page.wait(lambda: note.height() < 2 * note.fontMetrics().lineSpacing())
    check_keyboard(shown)
    page.trigger("plot")
    assert shown.isVisible(), "no second window opens"
    shown.close()
    page.wait(lambda: not Shiboken.isValid(shown))
    page.trigger("plot")
    (reopened,) = (each for each in QApplication.topLevelWidgets() if isinstance(each, PlotWindow))
    assert reopened.panel.plot.span.length == 30
    page.window.close()  # also closes the plot
    page.wait(lambda: not Shiboken.isValid(reopened))
