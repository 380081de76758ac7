"""The button that saves what a plot shows."""

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QToolButton, QWidget

from trex_gui.ui.notifier import Notifier
from trex_gui.ui.plotting.export import TraceExport
from trex_gui.ui.plotting.plot import TracePlot
from trex_gui.ui.theme.icons import set_icon


class PictureButton(QToolButton):
    """Opens a menu of the formats."""

    def __init__(self, plot: TracePlot, name: str, notifier: Notifier, parent: QWidget) -> None:
        """Save pictures of this plot, in files that are called `name` at first."""
        super().__init__(parent)
        pictures = TraceExport(plot, notifier, parent, name=name, tables=False)
        self.setObjectName("pictureButton")
        self.setText(self.tr("&Picture"))
        self.setAccessibleName(self.tr("Picture"))
        self.setToolTip(self.tr("Save what the plot shows as PNG or SVG"))
        self.setToolButtonStyle(Qt.ToolButtonStyle.ToolButtonTextBesideIcon)
        self.setPopupMode(QToolButton.ToolButtonPopupMode.InstantPopup)
        self.setMenu(pictures.menu)
        set_icon(self, "save")
