"""The button that saves what a plot shows."""

from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import QToolButton, QWidget

from trex_gui.ui.plotting.export import TraceExport
from trex_gui.ui.plotting.plot import TracePlot
from trex_gui.ui.theme.icons import set_icon


class PictureButton(QToolButton):
    """Opens a menu of the formats.

    Signals:
        told: what was saved, for people.
        refused: why it could not be, for people.
    """

    told = Signal(str)
    refused = Signal(str)

    def __init__(self, plot: TracePlot, name: str, parent: QWidget) -> None:
        """Save pictures of this plot, in files that are called `name` at first."""
        super().__init__(parent)
        pictures = TraceExport(plot, parent, name=name, tables=False)
        self.setObjectName("pictureButton")
        self.setText(self.tr("&Picture"))
        self.setAccessibleName(self.tr("Picture"))
        self.setToolTip(self.tr("Save what the plot shows as PNG or SVG"))
        self.setToolButtonStyle(Qt.ToolButtonStyle.ToolButtonTextBesideIcon)
        self.setPopupMode(QToolButton.ToolButtonPopupMode.InstantPopup)
        self.setMenu(pictures.menu)
        set_icon(self, "save")

        pictures.told.connect(self.told)
        pictures.refused.connect(self.refused)
