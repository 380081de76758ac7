"""What stands in the dock of a simulated device: its state, groups of rows, a button to mend it."""

from collections.abc import Sequence
from itertools import pairwise
from typing import Generic

from PySide6.QtCore import Qt, Slot
from PySide6.QtGui import QHideEvent, QShowEvent
from PySide6.QtWidgets import QPushButton, QSizePolicy, QVBoxLayout, QWidget

from trex_gui.ui.devices.demo.dock import DemoUse
from trex_gui.ui.devices.demo.rows import Rows
from trex_gui.ui.devices.demo_device import DemoDevice, SnapshotT
from trex_gui.ui.widgets.labels import Note


class DemoPanelBody(QWidget, Generic[SnapshotT]):
    """Looks at a simulated device while it is seen, and shows what it says of itself.

    Who derives from it puts widgets in with `arrange`, and has words for the states.
    """

    def __init__(
        self,
        device: DemoDevice[SnapshotT],
        use: DemoUse,
        state_name: str,
        parent: QWidget | None = None,
    ) -> None:
        """Show `device`; the line that says how it is has the object name `state_name`."""
        super().__init__(parent)
        self._device = device
        self._use = use
        self._groups: Sequence[Rows[SnapshotT]] = ()
        self._mend: QPushButton | None = None
        self.setSizePolicy(QSizePolicy.Policy.Preferred, QSizePolicy.Policy.Preferred)
        self._state = Note(2, self)
        self._state.setObjectName(state_name)

    def arrange(self, head: QWidget, groups: Sequence[Rows[SnapshotT]], mend: QPushButton) -> None:
        """Put everything in its place, once; Tab goes through the groups, then to `mend`."""
        self._groups, self._mend = tuple(groups), mend
        layout = QVBoxLayout(self)
        layout.setContentsMargins(6, 6, 6, 6)
        layout.setSpacing(6)
        layout.addWidget(head)
        layout.addWidget(self._state)
        for group in groups:
            layout.addWidget(group)
        layout.addWidget(mend, 0, Qt.AlignmentFlag.AlignRight)
        layout.addStretch(1)
        controls = [control for group in groups for control in group.controls()]
        for control, following in pairwise([*controls, mend]):
            QWidget.setTabOrder(control, following)

        self._device.changed.connect(self.renew)
        self.renew()

    # --- Words and a head for the device --------------------------------------------------

    def absent_text(self, *, starts: bool) -> str:
        """Say that the device does not run, or that it is being started."""
        raise NotImplementedError

    def state_text(self, snapshot: SnapshotT) -> str:
        """Say what the device does."""
        raise NotImplementedError

    def show_head(self, snapshot: SnapshotT | None) -> None:
        """Show what stands above the state; `None` while the device does not run."""
        raise NotImplementedError

    # --- What is seen -----------------------------------------------------------------------

    def showEvent(self, event: QShowEvent) -> None:
        super().showEvent(event)
        self._device.watch(True)
        self.renew()

    def hideEvent(self, event: QHideEvent) -> None:
        super().hideEvent(event)
        self._device.watch(False)

    @Slot()
    def renew(self) -> None:
        """Show how everything is now."""
        snapshot = self._device.snapshot
        for group in self._groups:
            group.setEnabled(snapshot is not None)
        if self._mend is not None:
            self._mend.setEnabled(snapshot is not None)
        self.show_head(snapshot)
        if snapshot is None:
            starts = self._use.starting or self._use.port is not None
            self._state.show_note(self.absent_text(starts=starts), alarming=not starts)
            return
        todo = self._todo(snapshot)
        self._state.show_note(todo or self.state_text(snapshot), alarming=bool(todo))
        for group in self._groups:
            group.show_snapshot(snapshot)

    def _todo(self, snapshot: SnapshotT) -> str:
        """Say what is to be done before device and program can talk again."""
        if not snapshot.line.plugged:
            return self.tr("The cable is out. Tick “Plugged in”, then press Connect.")
        if self._use.demo_in_use and self._use.port is None:
            if not snapshot.power:
                return self.tr("The power is off. Switch it on, then press Connect.")
            return self.tr("The cable is in again. Press Connect.")
        return ""
