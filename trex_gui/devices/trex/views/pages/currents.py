"""Page of the motor currents over time, with setpoints, channels and events."""

from PySide6.QtWidgets import QWidget

from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.model.group import BoardGroup
from trex_gui.devices.trex.views.group import GroupCards, SideBySide
from trex_gui.ui.plotting.page import PlotPage
from trex_gui.ui.widgets.builders import column
from trex_gui.ui.widgets.labels import PAGE_MARGINS


class CurrentsPage(PlotPage):
    def __init__(self, device: Device, group: BoardGroup, parent: QWidget) -> None:
        super().__init__(parent)
        self.setObjectName("currentsPage")
        self._device, self._group = device, group

    def add_plot(self) -> None:
        from trex_gui.devices.trex.views.pages.currents_panel import (  # noqa: PLC0415
            CurrentsPanel,
        )

        plots = SideBySide(self)
        panel = CurrentsPanel(self._device, plots)
        self._show_moment = panel.show_moment
        plots.add(panel)
        other_panels: list[QWidget] = []

        def follow_group() -> None:
            while other_panels:
                plots.remove(other_panels.pop())
            for number, device in self._group.devices.items():
                if device is not self._device:
                    other_panels.append(CurrentsPanel(device, plots, key=f"currents{number}"))
                    plots.add(other_panels[-1])

        self._group.changed.connect(follow_group)
        follow_group()
        cards = GroupCards(self._group, self)
        column(cards, (plots, 1), into=self, margins=PAGE_MARGINS)

    def show_moment(self, time: float, text: str) -> None:
        self._show_moment(time, text)
