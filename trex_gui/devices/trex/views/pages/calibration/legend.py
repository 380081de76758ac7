"""What the lines of the curve mean, and the live value as text."""

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QWidget

from trex_gui.ui.plotting.legend import LegendKey
from trex_gui.ui.widgets.builders import row


class CurveLegend(QWidget):
    """One row: the live dot with its value, the curve, and the stored one while it differs."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("curveLegend")
        self.setAccessibleName(self.tr("Live value"))
        self._live = LegendKey("", "motor2", self, style=None)
        self._curve = LegendKey("", "motor1", self)
        self._stored = LegendKey(self.tr("stored now"), "muted", self, Qt.PenStyle.DashLine)
        row(self._live, 1, self._curve, self._stored, into=self, margins=0, spacing=16)

    def set_live(self, text: str) -> None:
        """Show the live value."""
        self._live.setText(text)
        self.setAccessibleDescription(text)

    def set_curves(self, known: bool, *, differs: bool, live: bool) -> None:
        """Name the lines: none, one, or a dashed second one with what is stored."""
        self._live.set_color("motor2" if live else "muted")
        self._curve.setVisible(known)
        self._stored.setVisible(known and live and differs)
        if not live:
            self._curve.setText(self.tr("as last seen"))
        else:
            self._curve.setText(
                self.tr("after Apply") if differs else self.tr("stored in the board")
            )
