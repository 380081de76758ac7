"""The guided power cycle, for when no write has just led to it."""

from PySide6.QtWidgets import QDialog, QWidget

from trex_gui.devices.trex.model.power_cycle import PowerCycle
from trex_gui.devices.trex.views.review.power_cycle_panel import PowerCyclePanel
from trex_gui.ui.widgets.builders import button, column, row


class PowerCycleDialog(QDialog):
    """Beside the window, never in its way."""

    def __init__(self, cycle: PowerCycle, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("powerCycleDialog")
        self.setWindowTitle(self.tr("Switch the board off and on"))
        self.resize(560, 240)
        self._cycle = cycle

        panel = PowerCyclePanel(cycle, self)
        close = button(self, "powerCycleCloseButton", self.tr("Close"))

        buttons = row(1, close)
        column((panel, 1), buttons, into=self)

        close.clicked.connect(self.close)
        self.finished.connect(cycle.end)

    def guide(self) -> None:
        """Show how far the power cycle is; the caller has begun it."""
        self.show()
        self.activateWindow()
