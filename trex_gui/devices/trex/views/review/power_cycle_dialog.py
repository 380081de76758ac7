"""The guided power cycle, for when no write has just led to it."""

from PySide6.QtWidgets import QDialog, QHBoxLayout, QPushButton, QVBoxLayout, QWidget

from trex_gui.devices.trex.model.power_cycle import PowerCycle
from trex_gui.devices.trex.views.review.power_cycle_panel import PowerCyclePanel


class PowerCycleDialog(QDialog):
    """Beside the window, never in its way."""

    def __init__(self, cycle: PowerCycle, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("powerCycleDialog")
        self.setWindowTitle(self.tr("Switch the board off and on"))
        self.resize(560, 240)
        self._cycle = cycle

        panel = PowerCyclePanel(cycle, self)
        close = QPushButton(self.tr("Close"), self)
        close.setObjectName("powerCycleCloseButton")

        buttons = QHBoxLayout()
        buttons.addStretch(1)
        buttons.addWidget(close)
        layout = QVBoxLayout(self)
        layout.addWidget(panel, 1)
        layout.addLayout(buttons)

        close.clicked.connect(self.close)
        self.finished.connect(cycle.end)

    def guide(self) -> None:
        """Show how far the power cycle is; the caller has begun it."""
        self.show()
        self.activateWindow()
