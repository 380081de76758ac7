"""Comparison of a snapshot with the board or another snapshot."""

from dataclasses import replace
from pathlib import Path

from PySide6.QtCore import Qt, Signal, Slot
from PySide6.QtWidgets import QWidget

from trex_gui.core.errors import BadRequest
from trex_gui.core.translation import tr
from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.model.settings.draft import diff_against_draft
from trex_gui.devices.trex.model.settings.snapshots import SnapshotTable
from trex_gui.devices.trex.protocol.parameters import ParameterKey
from trex_gui.devices.trex.settings.comparison import compare
from trex_gui.devices.trex.settings.document import Settings
from trex_gui.devices.trex.settings.history import Snapshot
from trex_gui.devices.trex.views.comparison_view import ComparisonView
from trex_gui.ui.devices.connection import ConnectionState
from trex_gui.ui.notifier import Notifier
from trex_gui.ui.theme.theme import set_look
from trex_gui.ui.widgets import builders as ui
from trex_gui.ui.widgets.labels import Note


class SnapshotPane(QWidget):
    restore_requested = Signal()  # the edits are ready for review

    def __init__(
        self, device: Device, table: SnapshotTable, notifier: Notifier, parent: QWidget
    ) -> None:
        super().__init__(parent)
        self._notifier = notifier
        self._device = device
        self._table = table
        self._snapshots: tuple[Snapshot, ...] = ()
        self._shown: tuple[Path, str] | None = None  # snapshot path, title of the left column

        self._title = ui.label(self, "snapshotTitle", wrap=True, size="heading")
        self._rows = ComparisonView(self)
        self._note = ui.named(Note(2, self), "restoreNote")
        self._restore = ui.button(self, "restoreButton", default=False)
        set_look(self._restore, "primary")

        below = ui.row((self._note, 1), (self._restore, 0, Qt.AlignmentFlag.AlignTop))
        ui.column(self._title, (self._rows, 1), below, into=self, margins=(6, 0, 0, 0))
        self._restore.clicked.connect(self._on_restore_clicked)
        self._rows.ticked_changed.connect(self._update_restore)
        self.show_snapshots(())

    def show_snapshots(self, snapshots: tuple[Snapshot, ...]) -> None:
        """Compare a snapshot with the board, or two snapshots with each other."""
        self._snapshots = snapshots
        reason = tr("Select a snapshot to see what it would restore.")
        if 0 < len(snapshots) <= 2:
            reason = self._compare(snapshots[-1], snapshots[0] if len(snapshots) == 2 else None)
        elif snapshots:
            reason = tr("Select one snapshot, or two to compare them.")
        if reason:
            self._shown = None
            self._rows.show_nothing(reason)
        self._update_restore()

    def _compare(self, snapshot: Snapshot, other: Snapshot | None) -> str:
        """Compare a snapshot with `other` or the board. Return the reason for a failure, or `""`.

        If no board of the same model is connected, use the adjacent snapshot instead of the board.
        """
        self._describe(snapshot)
        settings = self._table.content_of(snapshot)
        if not isinstance(settings, Settings):
            return self._unreadable_text(snapshot)
        with_board = other is None and not self._board_blocker(snapshot)
        if with_board:
            title = tr("Now, with edits")
            comparison = diff_against_draft(self._device.draft, settings)
        elif adjacent := other or self._table.neighbor(snapshot):
            content = self._table.content_of(adjacent)
            if not isinstance(content, Settings):
                return self._unreadable_text(adjacent)
            title, comparison = self._table.time_text(adjacent), compare(content, settings)
        else:
            empty = replace(settings, parameters={}, calibrations={})
            title, comparison = "–", compare(empty, settings)
        shown, table = (snapshot.path, title), self._rows.table
        if shown != self._shown:
            self._rows.show_nothing()
        self._shown = shown
        self._rows.show_comparison(
            comparison,
            title,
            self._table.time_text(snapshot),
            with_ticks=with_board,
            summary="" if comparison.differing else tr("No setting differs."),
            tick_new=len(table.ticked) == table.comparison.offered,
        )
        return ""

    def _unreadable_text(self, snapshot: Snapshot) -> str:
        problem = self._table.content_of(snapshot)
        text = tr("This snapshot is damaged and cannot be restored. {0}")
        return text.format(problem) if problem else tr("Reading…")

    def _describe(self, snapshot: Snapshot) -> None:
        title = tr("{0}, before {1}") if snapshot.reason else "{0}"
        time = self._table.time_text(snapshot)
        self._title.setText(title.format(time[:1].upper() + time[1:], snapshot.reason))

    @Slot()
    def _update_restore(self) -> None:
        count, blocker = len(self._rows.table.ticked), self._blocker()
        self._restore.setText(tr("&Restore %n setting(s)…", "", count))
        self._restore.setEnabled(not blocker and count > 0)
        self._note.show_note(blocker or self._number_note())

    def _blocker(self) -> str:
        """Return the reason that prevents restoring, or an empty string."""
        if self._shown is None:
            return tr("Nothing is selected for restoring.")
        if len(self._snapshots) == 2:
            return tr("To restore a snapshot, select only this snapshot.")
        if blocker := self._board_blocker(self._snapshots[0]):
            return blocker
        if not self._device.is_connected:
            return tr("The board does not respond, so nothing can be restored.")
        if self._device.writer.running:
            return tr("Settings are being written. Wait until writing ends.")
        return ""

    def _board_blocker(self, snapshot: Snapshot) -> str:
        """Return the reason that prevents a comparison with the board, or an empty string."""
        closed = {ConnectionState.DISCONNECTED, ConnectionState.DISCONNECTING}
        state = self._device.state
        if state is None or self._device.link in closed:
            return tr("No board is connected. Connect one to restore a snapshot.")
        board = state.signature.model.name
        text = tr(
            "This snapshot is from a {0}, but the connected board is a {1}. The "
            "snapshot cannot be restored."
        )
        return "" if snapshot.product == board else text.format(snapshot.product, board)

    def _number_note(self) -> str:
        current = self._device.parameters.values.stored.get(ParameterKey.DEVICE_NUMBER)
        number = self._snapshots[0].device_number
        if number is None or current is None or number == current:
            return ""
        text = tr(
            "Note: this snapshot is from device number {0}, and the connected board has number {1}."
        )
        return text.format(number, current)

    @Slot()
    def _on_restore_clicked(self) -> None:
        self.show_snapshots(self._snapshots)  # the board may have changed
        if not self._restore.isEnabled():
            return
        text = tr("Restore snapshot of {0}").format(self._table.time_text(self._snapshots[0]))
        try:
            self._device.draft.stage(self._rows.table.ticked, text)
        except BadRequest as error:
            self._notifier.error.emit(tr("Nothing was restored: {0}").format(error))
        else:
            self.restore_requested.emit()
