"""The dock of a simulated device: its state, groups of rows, a button that resets everything."""

from collections.abc import Sequence
from itertools import pairwise
from typing import Generic, Protocol

from PySide6.QtCore import QSettings, Qt, Signal, Slot
from PySide6.QtGui import QCloseEvent, QHideEvent, QShowEvent
from PySide6.QtWidgets import QDockWidget, QFrame, QPushButton, QScrollArea, QSizePolicy, QWidget

from trex_gui.ui.devices.demo.device import DemoDevice, SnapshotT
from trex_gui.ui.devices.demo.rows import Rows
from trex_gui.ui.devices.ports import Port
from trex_gui.ui.widgets.builders import column, named
from trex_gui.ui.widgets.labels import Note


class DemoUse(Protocol):
    """Whether a simulated device is in use."""

    @property
    def demo_in_use(self) -> bool:
        """Whether it is the device that the user chose last and has not disconnected."""
        ...

    @property
    def starting(self) -> bool:
        """Whether the simulator is being started."""
        ...

    @property
    def port(self) -> Port | None:
        """The port that is connected or being connected."""
        ...


class DemoDock(QDockWidget):
    """Visible while the simulated device is in use, unless the user has closed it.

    Signals:
        wanted_changed: `wanted`.
    """

    wanted_changed = Signal(bool)

    def __init__(self, name: str, key: str, use: DemoUse, parent: QWidget | None = None) -> None:
        """Create a dock with an object name; `key` stores whether it is wanted.

        Call `show_if_wanted` when `use` has changed.
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
        """Show `view` at its minimum width at least; it scrolls on a low screen."""
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
        """Whether the user wants to see it while the device is in use."""
        return self._wanted

    def set_wanted(self, wanted: bool) -> None:
        """Show or hide it, now and at the next start."""
        if wanted != self._wanted:
            self._wanted = wanted
            self._store.setValue(self._key, wanted)
            self.wanted_changed.emit(wanted)
        self.show_if_wanted()

    @Slot()
    def toggle(self) -> None:
        self.set_wanted(not self._wanted)

    @Slot()
    def show_if_wanted(self) -> None:
        """Show or hide it; the width of the window follows."""
        there = self._wanted and self._use.demo_in_use
        if there and self.isHidden():
            self._make_room()
            self.show()
        elif not there and not self.isHidden():
            self.leave()

    def leave(self) -> None:
        """Hide, and restore the width of the window unless the user has changed it.

        Call it before the window's geometry is saved: a floating panel would outlive the window.
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


class DemoPanelBody(QWidget, Generic[SnapshotT]):
    """Polls a simulated device while visible, and shows its state.

    A subclass calls `arrange` once, and provides the head and the texts for states.
    """

    def __init__(
        self,
        device: DemoDevice[SnapshotT],
        use: DemoUse,
        state_name: str,
        parent: QWidget | None = None,
    ) -> None:
        """Show `device`; the label with its state has the object name `state_name`."""
        super().__init__(parent)
        self._device = device
        self._use = use
        self._groups: Sequence[Rows[SnapshotT]] = ()
        self._reset: QPushButton | None = None
        self.setSizePolicy(QSizePolicy.Policy.Preferred, QSizePolicy.Policy.Preferred)
        self._state = named(Note(2, self), state_name)

    def arrange(self, head: QWidget, groups: Sequence[Rows[SnapshotT]], reset: QPushButton) -> None:
        """Lay out everything; Tab goes through the groups, then to `reset`."""
        self._groups, self._reset = groups, reset
        right = (reset, 0, Qt.AlignmentFlag.AlignRight)
        column(head, self._state, *groups, right, 1, into=self, margins=6, spacing=6)
        controls = [control for group in groups for control in group.controls]
        for control, following in pairwise([*controls, reset]):
            QWidget.setTabOrder(control, following)
        self._device.changed.connect(self.refresh)
        self.refresh()

    def absent_text(self, *, starting: bool) -> str:
        """Return a text for a simulator that does not run, or is being started."""
        raise NotImplementedError

    def state_text(self, snapshot: SnapshotT) -> str:
        """Return what the device does."""
        raise NotImplementedError

    def show_head(self, snapshot: SnapshotT | None) -> None:
        """Update what is above the state; `None` while the simulator does not run."""
        raise NotImplementedError

    def showEvent(self, event: QShowEvent) -> None:
        super().showEvent(event)
        self._device.watch(True)
        self.refresh()

    def hideEvent(self, event: QHideEvent) -> None:
        super().hideEvent(event)
        self._device.watch(False)

    @Slot()
    def refresh(self) -> None:
        """Show the current state."""
        snapshot = self._device.snapshot
        for widget in (*self._groups, self._reset):
            if widget is not None:
                widget.setEnabled(snapshot is not None)
        self.show_head(snapshot)
        if snapshot is None:
            starting = self._use.starting or self._use.port is not None
            self._state.show_note(self.absent_text(starting=starting), alarming=not starting)
            return
        todo = self._todo(snapshot)
        self._state.show_note(todo or self.state_text(snapshot), alarming=bool(todo))
        for group in self._groups:
            group.show_snapshot(snapshot)

    def _todo(self, snapshot: SnapshotT) -> str:
        """Return what the user has to do before the program can connect again."""
        if not snapshot.line.plugged:
            return self.tr("The cable is unplugged. Check “Plugged in”, then press Connect.")
        if self._use.demo_in_use and self._use.port is None:
            if not snapshot.power:
                return self.tr("The power is off. Switch it on, then press Connect.")
            return self.tr("The cable is plugged in again. Press Connect.")
        return ""
