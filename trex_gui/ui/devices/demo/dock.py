"""A dock for what hands do to a simulated device: there while that is in use, unless closed."""

from typing import Protocol

from PySide6.QtCore import QSettings, Qt, Signal, Slot
from PySide6.QtGui import QCloseEvent
from PySide6.QtWidgets import QDockWidget, QFrame, QScrollArea, QWidget

from trex_gui.ui.devices.ports import Port


class DemoUse(Protocol):
    """What tells whether a simulated device is in use."""

    @property
    def demo_in_use(self) -> bool:
        """Whether it was chosen last, and not given up since."""
        ...

    @property
    def starting(self) -> bool:
        """Whether it is being started, and will be connected to."""
        ...

    @property
    def port(self) -> Port | None:
        """The port that is connected, or about to be."""
        ...


class DemoDock(QDockWidget):
    """There while the simulated device is in use, unless its user has closed it.

    Signals:
        wanted_changed: `wanted`.
    """

    wanted_changed = Signal(bool)

    def __init__(self, name: str, key: str, use: DemoUse, parent: QWidget | None = None) -> None:
        """Be found by `name`; remember under `key` whether it is wanted.

        Whoever makes it says with `show_if_wanted` when `use` has changed.
        """
        super().__init__(parent)
        self.setObjectName(name)
        self._key = key
        self._use = use
        self._store = QSettings(self)
        self._width = self._width_before = 0
        self._wanted = self._store.value(key, "true") in {True, "true"}
        self.hide()

    def hold(self, view: QWidget) -> None:
        """Show `view`, as wide as it needs at least; it scrolls where a screen is too low."""
        scroll = QScrollArea(self)
        scroll.setFrameShape(QFrame.Shape.NoFrame)
        scroll.setWidgetResizable(True)
        scroll.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        scroll.setFocusPolicy(Qt.FocusPolicy.NoFocus)
        scroll.setWidget(view)
        bar = scroll.verticalScrollBar().sizeHint().width()
        scroll.setMinimumWidth(view.minimumSizeHint().width() + bar)
        self.setWidget(scroll)

    @property
    def wanted(self) -> bool:
        """Whether its user wants to see it, the simulated device being in use."""
        return self._wanted

    def set_wanted(self, wanted: bool) -> None:
        """Want it, or not, now and the next time."""
        if wanted != self._wanted:
            self._wanted = wanted
            self._store.setValue(self._key, wanted)
            self.wanted_changed.emit(wanted)
        self.show_if_wanted()

    @Slot()
    def toggle(self) -> None:
        """Want it if it was not wanted, and the other way round."""
        self.set_wanted(not self._wanted)

    @Slot()
    def show_if_wanted(self) -> None:
        """Be there, or not; the window makes room, and takes it back."""
        there = self._wanted and self._use.demo_in_use
        if there and self.isHidden():
            self._make_room()
            self.show()
        elif not there and not self.isHidden():
            self.leave()

    def leave(self) -> None:
        """Hide; the window is as wide as before, unless its user has given it another width.

        To be called before the window's geometry is saved, too. A floating panel would even
        outlive the window.
        """
        window = self.parentWidget()
        unchanged = window is not None and window.width() in {
            self._width,
            window.minimumSizeHint().width(),
        }
        self.hide()
        if window is not None and unchanged and self._width_before:
            if layout := window.layout():
                layout.activate()
            window.resize(self._width_before, window.height())
        self._width_before = 0

    def _make_room(self) -> None:
        """Widen the window so that the pages keep their width, as far as the screen goes."""
        window = self.parentWidget()
        if window is None or self.isFloating() or not window.isVisible() or window.isMaximized():
            return
        free = window.screen().availableGeometry().right() - window.frameGeometry().right()
        self._width_before = window.width()
        self._width = window.width() + max(min(self.sizeHint().width(), free), 0)
        window.resize(self._width, window.height())

    def closeEvent(self, event: QCloseEvent) -> None:
        super().closeEvent(event)
        self.set_wanted(False)
