"""Currents of both motors against time, with setpoints, channels and events."""

from PySide6.QtWidgets import QWidget

from trex_gui.devices.trex.model.device import Device
from trex_gui.ui.plotting.page import PlotPage
from trex_gui.ui.widgets.builders import column
from trex_gui.ui.widgets.labels import PAGE_MARGINS


class CurrentsPage(PlotPage):
    def __init__(self, device: Device, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("currentsPage")
        self._device = device

    def add_plot(self) -> None:
        from trex_gui.devices.trex.views.pages.currents_panel import (  # noqa: PLC0415
            CurrentsPanel,
        )

        panel = CurrentsPanel(self._device, self)
        self._show_moment = panel.show_moment
        column(panel, into=self, margins=PAGE_MARGINS)

    def show_moment(self, time: float, text: str) -> None:
        self._show_moment(time, text)
