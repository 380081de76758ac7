"""Base class of pages with a plot."""

from PySide6.QtCore import Signal
from PySide6.QtGui import QShowEvent
from PySide6.QtWidgets import QWidget


class PlotPage(QWidget):
    """Page that creates its plot when it is first shown, or soon after the program starts.

    A subclass imports pyqtgraph in `add_plot`, since pyqtgraph takes as long to load as Qt.
    """

    plot_added = Signal()

    _has_plot = False

    def ensure_plot(self) -> None:
        if not self._has_plot:
            self._has_plot = True
            self.add_plot()
            self.plot_added.emit()

    def add_plot(self) -> None:
        raise NotImplementedError

    def show_moment(self, time: float, text: str) -> None:
        """Show the event with this text. If there is none, show the time.

        A page without a time axis does nothing.
        """

    def showEvent(self, event: QShowEvent) -> None:
        super().showEvent(event)
        self.ensure_plot()
