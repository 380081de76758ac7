"""What a snapshot would restore, row by row."""

from PySide6.QtCore import Qt, Signal, Slot
from PySide6.QtWidgets import QWidget

from trex_gui.core.errors import BadRequest
from trex_gui.core.files import SettingsError
from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.model.settings.draft import diff_against_draft
from trex_gui.devices.trex.model.settings.snapshots import SnapshotTable
from trex_gui.devices.trex.protocol.parameters import ParameterKey
from trex_gui.devices.trex.settings.comparison import Comparison, compare
from trex_gui.devices.trex.settings.document import Settings
from trex_gui.devices.trex.settings.history import Snapshot
from trex_gui.devices.trex.views.comparison_view import ComparisonView
from trex_gui.devices.trex.views.history.present_choice import Present, PresentChoice
from trex_gui.ui.devices.connection_state import ConnectionState
from trex_gui.ui.notifier import Notifier
from trex_gui.ui.widgets.builders import button, column, label, row
from trex_gui.ui.widgets.labels import Note


class SnapshotPane(QWidget):
    """One snapshot beside the present, or two beside each other, and the way back.

    Left always stands what is there, right what the snapshot would bring back.

    Signals:
        present_chosen: the user chose what to compare with.
        restore_requested: rows of the snapshot were made edits; they are to be reviewed.
    """

    present_chosen = Signal()
    restore_requested = Signal()

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
        self._chosen: tuple[Snapshot, ...] = ()
        self._shown: tuple[str, Present] | None = None
        self._against_board = False

        self._title = label(self, "snapshotTitle", wrap=True, plain=True)
        font = self._title.font()
        font.setBold(True)
        self._title.setFont(font)
        self._details = label(self, "snapshotDetails", wrap=True, plain=True)
        self._choice = PresentChoice(device, table, notifier, self)
        self._rows = ComparisonView(self)
        self._note = Note(2, self)
        self._note.setObjectName("restoreNote")
        self._restore = button(
            self,
            "restoreButton",
            self.tr("&Restore selected as edits"),
            icon="undo",
            tip=self.tr(
                "Turn the selected values into edits and review them; only Apply writes them"
            ),
            default=False,
        )

        below = row((self._note, 1), (self._restore, 0, Qt.AlignmentFlag.AlignTop))
        column(
            self._title,
            self._details,
            self._choice,
            (self._rows, 1),
            below,
            into=self,
            margins=(6, 0, 0, 0),
        )

        self._choice.chosen.connect(self.present_chosen)
        self._rows.ticked_changed.connect(self._show_possibilities)
        self._restore.clicked.connect(self._on_restore_clicked)
        self.show_chosen(())

    def show_chosen(self, chosen: tuple[Snapshot, ...]) -> None:
        """Show one snapshot against the present, or two, the newer one as the present.

        The same ones again: as things are now; ticks stay.
        """
        self._chosen = chosen
        self._against_board = False
        match chosen:
            case (snapshot,):
                self._compare(snapshot, None)
            case (newer, older):
                self._compare(older, newer)
            case ():
                self._show_nothing(self.tr("Select a snapshot to see what it would restore."))
            case _:
                self._show_nothing(self.tr("Select one snapshot, or two to compare them."))
        self._show_possibilities()

    # --- What is compared ---------------------------------------------------------------

    def _show_nothing(self, why: str) -> None:
        self._shown = None
        self._title.clear()
        self._details.clear()
        self._choice.clear()
        self._rows.show_nothing(why)

    def _compare(self, snapshot: Snapshot, other: Snapshot | None) -> None:
        """Show what a snapshot would bring back, from another one or the chosen one."""
        self._describe(snapshot)
        settings = self._load(snapshot)
        if settings is None or (other is not None and self._load(other) is None):
            return
        present = self._choice.present_for(snapshot, settings, other)
        self._choice.offer(snapshot, present)
        if present.settings is not None:
            comparison = compare(present.settings, settings)
            summary = self._counts(comparison, snapshot, present)
        else:
            self._against_board = True
            comparison = diff_against_draft(self._device.draft, settings)
            summary = self._board_counts(comparison)
        shown = (str(snapshot.path), present)
        if shown == self._shown:
            table = self._rows.table
            all_ticked = len(table.ticked) == table.comparison.changed
            self._rows.renew(comparison, summary, tick_new=all_ticked)
            return
        self._shown = shown
        self._rows.show_comparison(
            comparison,
            present.title,
            self.tr("Snapshot of {0}").format(self._table.time_text(snapshot)),
            with_ticks=self._against_board,
            summary=summary,
        )

    def _load(self, snapshot: Snapshot) -> Settings | None:
        """Return what a snapshot holds; of a damaged one show what is wrong."""
        try:
            return self._table.load(snapshot)
        except SettingsError:
            self._show_damage(snapshot)
            return None

    def _describe(self, snapshot: Snapshot) -> None:
        title = self.tr("{0}, before {1}") if snapshot.reason else "{0}"
        when = _capital(self._table.time_text(snapshot))
        self._title.setText(title.format(when, snapshot.reason))
        number = snapshot.device_number
        parts = (
            f"{snapshot.product} {snapshot.firmware}".strip(),
            "" if number is None else self.tr("device number {0}").format(number),
            snapshot.adapter,
        )
        self._details.setText(", ".join(part for part in parts if part))
        self._details.setVisible(any(parts))

    def _show_damage(self, snapshot: Snapshot) -> None:
        self._shown = None
        self._choice.clear()
        self._rows.show_nothing(
            self.tr("{0} is damaged and cannot be restored. {1}").format(
                snapshot.path.name, self._table.problem_of(snapshot)
            )
        )

    def _board_counts(self, comparison: Comparison) -> str:
        if comparison.changed:
            text = self.tr("{0} would come back, {1} match.").format(
                self._settings(comparison.changed), comparison.equal
            )
        elif comparison.missing or comparison.left_out:
            text = self.tr("This snapshot has no differences to restore.")
        else:
            text = self.tr("The board, with the edits made here, is set like this snapshot.")
        if comparison.missing:
            stay = self.tr("Not in the snapshot, so as they are: {0}.")
            text += " " + stay.format(self._settings(comparison.missing))
        return text

    def _counts(self, comparison: Comparison, snapshot: Snapshot, present: Present) -> str:
        if present.key == "":
            return self.tr(
                "There is no other snapshot of a {0} to compare it with. It holds {1}."
            ).format(snapshot.product, self._settings(len(comparison.rows)))
        differing = len(comparison.differing)
        if differing == 0:
            return self.tr("Both are the same.")
        one, several = self.tr("{0} differs, {1} match."), self.tr("{0} differ, {1} match.")
        text = one if differing == 1 else several
        return text.format(self._settings(differing), comparison.equal)

    def _settings(self, count: int) -> str:
        return self.tr("1 setting") if count == 1 else self.tr("{0} settings").format(count)

    # --- What can be done ---------------------------------------------------------------

    @Slot()
    def _show_possibilities(self) -> None:
        why_not = self._why_no_restoring()
        self._restore.setEnabled(not why_not)
        self._note.show_note(why_not or self._caution(self._chosen[0]))

    def _why_no_restoring(self) -> str:
        """Say why nothing can be restored now; empty: it can."""
        chosen = self._chosen
        if not chosen or len(chosen) > 2:
            return self.tr("Nothing is selected to be restored.")
        if self._table.problem_of(chosen[-1]):
            return self.tr("A damaged snapshot cannot be restored.")
        if len(chosen) == 2:
            return self.tr("To restore one of the two, select it alone.")
        if why_not := self._choice.why_not_the_board(chosen[0]):
            return why_not
        if not self._against_board:
            return self.tr("To restore, compare with the board.")
        if self._device.link is not ConnectionState.CONNECTED:
            return self.tr("The board does not answer now, so nothing can be restored.")
        if self._device.applying:
            return self.tr("Settings are being written; wait for that.")
        if self._rows.table.comparison.changed == 0:
            return self.tr("There is nothing to restore.")
        if not self._rows.table.ticked:
            return self.tr("Select the settings to restore.")
        return ""

    def _caution(self, snapshot: Snapshot) -> str:
        """Show notes about restoring."""
        ticked = len(self._rows.table.ticked)
        edits = self.tr("an edit") if ticked == 1 else self.tr("edits")
        text = self.tr("{0} would become {1}; nothing is written before Apply.").format(
            self._settings(ticked), edits
        )
        here = self._device.parameters.stored_of(ParameterKey.DEVICE_NUMBER)
        number = snapshot.device_number
        if number is not None and here is not None and number != here:
            text += " " + self.tr(
                "Note: this snapshot is of device number {0}, the board here is number {1}."
            ).format(number, here)
        return text

    @Slot()
    def _on_restore_clicked(self) -> None:
        self.show_chosen(self._chosen)  # what stands there must be what is meant
        rows = self._rows.table.ticked
        if not self._restore.isEnabled():
            return
        when = self._table.time_text(self._chosen[0])
        try:
            self._device.draft.stage(rows, self.tr("Restore snapshot of {0}").format(when))
        except BadRequest as error:
            self._notifier.error.emit(self.tr("Nothing was restored: {0}").format(error))
            return
        self.restore_requested.emit()


def _capital(text: str) -> str:
    return text[:1].upper() + text[1:]
