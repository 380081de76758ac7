"""References that the Qt binding counts. Losing them would end the process."""

import sys

import pytest
from PySide6.QtWidgets import QWidget

from tests.support.window import WidgetDriver, WindowDriver


def repaint_pages(window: WindowDriver, times: int) -> None:
    """Repaint all widgets of all pages, each time with new telemetry."""
    tabs = window.window.pages
    for index in range(tabs.count()):
        tabs.setCurrentIndex(index)
        for _ in range(times):
            window.device.telemetry.updated.emit()
            page = WidgetDriver(tabs.currentWidget(), window.qtbot)
            for widget in page.find_all(QWidget):
                widget.repaint()


@pytest.mark.skipif(sys.version_info >= (3, 12), reason="None is immortal and not counted")
@pytest.mark.timeout(300)
@pytest.mark.parametrize("times", [2, pytest.param(60, marks=pytest.mark.slow)])
def test_repainting_loses_no_references_to_none(window: WindowDriver, times: int) -> None:
    window.connect_to_demo()
    window.wait(lambda: window.device.telemetry.raw is not None)
    repaint_pages(window, 1)  # creates buffers with many references
    before = sys.getrefcount(None)
    repaint_pages(window, times)
    assert sys.getrefcount(None) > before - times, "each repaint loses a reference"
