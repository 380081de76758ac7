"""What a snapshot is compared with: the board, another snapshot, a settings file."""

from dataclasses import dataclass, replace
from pathlib import Path

from PySide6.QtCore import QSettings, Signal, Slot
from PySide6.QtGui import QStandardItemModel
from PySide6.QtWidgets import QComboBox, QFileDialog, QLabel, QSizePolicy, QWidget

from trex_gui.core.files import SettingsError, load
from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.model.settings.snapshots import SnapshotTable
from trex_gui.devices.trex.settings.document import Settings
from trex_gui.devices.trex.settings.history import Snapshot
from trex_gui.devices.trex.settings.reader import read_settings
from trex_gui.ui.devices.connection_state import ConnectionState
from trex_gui.ui.notifier import Notifier
from trex_gui.ui.widgets.builders import NoWheelComboBox, row

FOLDER = "settings/folder"
FILTER = "Text files (*.txt);;All files (*)"
_BOARD, _FILE = "board", "file"


@dataclass(frozen=True, slots=True)
class Present:
    """The left side of a comparison.

    Attributes:
        key: what the list to choose from calls it; empty where there is nothing to compare with.
        title: the head of its column.
        settings: what it holds; `None` for the board, whose edits count.
    """

    key: str
    title: str
    settings: Settings | None = None


class PresentChoice(QWidget):
    """`Compare with:` and a list; what a person chose stays chosen from snapshot to snapshot.

    By default it is the board, or without one the next snapshot.

    Signals:
        chosen: the user chose something.
    """

    chosen = Signal()

    def __init__(
        self,
        device: Device,
        table: SnapshotTable,
        notifier: Notifier,
        parent: QWidget | None = None,
    ) -> None:
        super().__init__(parent)
        self._notifier = notifier
        self._device = device
        self._table = table
        self._store = QSettings(self)
        self._choice = _BOARD
        self._file: Present | None = None
        self._offered: tuple[str, Present | None, list[Snapshot]] | None = None

        self._box = NoWheelComboBox(self)
        self._box.setObjectName("compareWithCombo")
        self._box.setSizeAdjustPolicy(
            QComboBox.SizeAdjustPolicy.AdjustToMinimumContentsLengthWithIcon
        )
        self._box.setMinimumContentsLength(28)
        self._box.setMaxVisibleItems(20)
        self._box.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
        label = QLabel(self.tr("Compare &with:"), self)
        label.setBuddy(self._box)

        row(label, (self._box, 1), into=self, margins=0)

        self._box.setPlaceholderText(self.tr("nothing"))
        self._box.activated.connect(self._on_activated)

    # --- What there is ------------------------------------------------------------------

    def present_for(
        self, snapshot: Snapshot, settings: Settings, other: Snapshot | None
    ) -> Present:
        """Return what to compare with: another snapshot, the chosen one, or what there is."""
        if other is not None and (found := self._snapshot_as_present(other)):
            return found
        if self._choice == _FILE and self._file is not None:
            return self._file
        if found := self._chosen_snapshot(snapshot):
            return found
        if not self.why_not_the_board(snapshot):
            return Present(_BOARD, self.tr("Now, with edits"))
        while (neighbour := self._table.neighbour(snapshot)) is not None:
            if found := self._snapshot_as_present(neighbour):
                return found  # else it is known to be damaged now, and no neighbour any more
        return Present("", "–", replace(settings, parameters={}, calibrations={}))

    def _chosen_snapshot(self, beside: Snapshot) -> Present | None:
        """Return the snapshot that a person chose, if it is there and another one."""
        if self._choice in {_BOARD, _FILE, str(beside.path)}:
            return None
        row = self._table.row_of(Path(self._choice))
        return None if row is None else self._snapshot_as_present(self._table.snapshots[row])

    def _snapshot_as_present(self, snapshot: Snapshot) -> Present | None:
        """Return a snapshot as the left side; `None` for a damaged one."""
        try:
            settings = self._table.load(snapshot)
        except SettingsError:
            return None
        title = self.tr("Snapshot of {0}").format(self._table.time_text(snapshot))
        return Present(str(snapshot.path), title, settings)

    def why_not_the_board(self, snapshot: Snapshot) -> str:
        """Say why a snapshot cannot be compared with the board, nor restored; empty: it can."""
        state = self._device.state
        if state is None or self._device.link in {
            ConnectionState.DISCONNECTED,
            ConnectionState.DISCONNECTING,
        }:
            return self.tr("No board is connected. Connect one to restore a snapshot.")
        board = state.signature.model.name
        if snapshot.product != board:
            return self.tr(
                "This snapshot is of a {0}, and the board here is a {1}: it cannot be restored."
            ).format(snapshot.product, board)
        return ""

    # --- The list -----------------------------------------------------------------------

    def clear(self) -> None:
        """Offer nothing."""
        self._offered = None
        self._box.clear()
        self._box.setEnabled(False)

    def offer(self, snapshot: Snapshot, present: Present) -> None:
        """Offer everything that this snapshot can be compared with."""
        why_not = self.why_not_the_board(snapshot)
        others = [
            other
            for other in self._table.snapshots
            if other.path != snapshot.path and not self._table.problem_of(other)
        ]
        offered = (why_not, self._file, others)
        if offered != self._offered:  # hundreds take their time
            self._offered = offered
            self._fill(why_not, others)
        self._box.setCurrentIndex(self._box.findData(present.key) if present.key else -1)
        self._box.setToolTip(self._box.currentText())

    def _fill(self, why_not: str, others: list[Snapshot]) -> None:
        box = self._box
        box.clear()
        box.setEnabled(True)
        box.addItem(self.tr("the board as it is now, with edits"), _BOARD)
        model = box.model()
        if why_not and isinstance(model, QStandardItemModel):
            item = model.item(0)
            item.setEnabled(False)
            item.setToolTip(why_not)
        if self._file is not None:
            box.addItem(self._file.title, self._file.key)
        box.addItem(self.tr("a settings file…"), "")
        box.insertSeparator(box.count())
        for other in others:
            text = (
                self.tr("snapshot of {0}, before {1}")
                if other.reason
                else self.tr("snapshot of {0}")
            )
            when = self._table.time_text(other)
            box.addItem(text.format(when, other.reason), str(other.path))

    @Slot(int)
    def _on_activated(self, index: int) -> None:
        key = str(self._box.itemData(index) or "")
        if key or self._ask_for_file():
            self._choice = key or _FILE
        self.chosen.emit()

    def _ask_for_file(self) -> bool:
        """Let the user choose a settings file to compare with; return whether one can be used."""
        chosen, _ = QFileDialog.getOpenFileName(
            self,
            self.tr("Compare with a settings file"),
            str(self._store.value(FOLDER, str(Path.home()))),
            FILTER,
        )
        if not chosen:
            return False
        path = Path(chosen)
        try:
            settings, _ = read_settings(load(path), path.name)
        except SettingsError as error:
            self._notifier.error.emit(
                self.tr("{0} cannot be compared with: {1}").format(path.name, error)
            )
            return False
        self._store.setValue(FOLDER, str(path.parent))
        self._file = Present(_FILE, path.name, settings)
        return True
