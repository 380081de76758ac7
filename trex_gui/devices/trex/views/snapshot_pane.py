"""What a snapshot would restore, compared with the board, another snapshot or a file."""

from dataclasses import dataclass, replace
from itertools import islice
from pathlib import Path

from PySide6.QtCore import Qt, Signal, Slot
from PySide6.QtGui import QStandardItemModel
from PySide6.QtWidgets import QComboBox, QSizePolicy, QWidget

from trex_gui.core.errors import BadRequest, StudioError
from trex_gui.core.files import load
from trex_gui.core.translation import tr
from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.model.settings.draft import diff_against_draft
from trex_gui.devices.trex.model.settings.snapshots import SnapshotTable
from trex_gui.devices.trex.protocol.parameters import ParameterKey
from trex_gui.devices.trex.settings.comparison import Comparison, compare
from trex_gui.devices.trex.settings.document import Settings
from trex_gui.devices.trex.settings.history import Snapshot
from trex_gui.devices.trex.settings.reader import read_settings
from trex_gui.devices.trex.views.comparison_view import ComparisonView
from trex_gui.ui.devices.connection import ConnectionState
from trex_gui.ui.files import in_background
from trex_gui.ui.notifier import Notifier
from trex_gui.ui.widgets import builders as ui
from trex_gui.ui.widgets import file_questions
from trex_gui.ui.widgets.labels import Note

_BOARD, _FILE = "board", "file"
_MOST_OFFERED = 100  # snapshots in the list; others are compared by selecting both


class SnapshotPane(QWidget):
    """A snapshot at the right of the present, or of a newer one, with a restore button."""

    restore_requested = Signal()  # settings of the snapshot are edits now; they are to be reviewed

    def __init__(
        self, device: Device, table: SnapshotTable, notifier: Notifier, parent: QWidget
    ) -> None:
        super().__init__(parent)
        self._notifier = notifier
        self._device = device
        self._table = table
        self._chosen: tuple[Snapshot, ...] = ()
        self._shown: tuple[str, _Present] | None = None
        self._against_board = False

        self._title = ui.label(self, "snapshotTitle", wrap=True, bold=True)
        self._details = ui.label(self, "snapshotDetails", wrap=True)
        self.choice = _PresentChoice(device, table, notifier, self)
        self._rows = ComparisonView(self)
        self._note = ui.named(Note(2, self), "restoreNote")
        text = tr("&Restore selected as edits")
        tip = tr("Turn the selected values into edits and review them; only Apply writes them")
        self._restore = ui.button(self, "restoreButton", text, icon="undo", tip=tip, default=False)

        below = ui.row((self._note, 1), (self._restore, 0, Qt.AlignmentFlag.AlignTop))
        above = self._title, self._details, self.choice, (self._rows, 1)
        ui.column(*above, below, into=self, margins=(6, 0, 0, 0))
        self._restore.clicked.connect(self._on_restore_clicked)
        self._rows.ticked_changed.connect(self._update_restore)
        self.show_chosen(())

    def show_chosen(self, chosen: tuple[Snapshot, ...]) -> None:
        """Show or update one snapshot against the present, or the older of two and the newer."""
        self._chosen = chosen
        self._against_board = False
        match chosen:
            case (snapshot,):
                self._compare(snapshot, None)
            case (newer, older):
                self._compare(older, newer)
            case ():
                self._show_nothing(tr("Select a snapshot to see what it would restore."))
            case _:
                self._show_nothing(tr("Select one snapshot, or two to compare them."))
        self._update_restore()

    def _show_nothing(self, reason: str) -> None:
        self._title.clear()
        self._details.clear()
        self._show_no_rows(reason)

    def _show_no_rows(self, reason: str) -> None:
        self._shown = None
        self.choice.clear()
        self._rows.show_nothing(reason)

    def _compare(self, snapshot: Snapshot, other: Snapshot | None) -> None:
        """Compare a snapshot with another one, or with the user's choice."""
        self._describe(snapshot)
        settings = self._content_of(snapshot)
        if settings is None or (other is not None and self._content_of(other) is None):
            return
        present = self.choice.present_for(snapshot, settings, other)
        if present is None:
            self._show_no_rows(tr("Reading…"))
            return
        self.choice.offer(snapshot, present)
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
            all_ticked = len(table.ticked) == table.comparison.offered
            self._rows.renew(comparison, summary, tick_new=all_ticked)
            return
        self._shown = shown
        title, ticks = self.choice.title_of(snapshot), self._against_board
        self._rows.show_comparison(
            comparison, present.title, title, with_ticks=ticks, summary=summary
        )

    def _content_of(self, snapshot: Snapshot) -> Settings | None:
        """Return the settings in a snapshot; if it is damaged or not read yet, show that."""
        content = self._table.content_of(snapshot)
        if isinstance(content, Settings):
            return content
        text = tr("Reading…")
        if content is not None:
            text = tr("{0} is damaged and cannot be restored. {1}")
        self._show_no_rows(text.format(snapshot.path.name, content))
        return None

    def _describe(self, snapshot: Snapshot) -> None:
        title = tr("{0}, before {1}") if snapshot.reason else "{0}"
        time = self._table.time_text(snapshot)
        self._title.setText(title.format(time[:1].upper() + time[1:], snapshot.reason))
        number = snapshot.device_number
        parts = (
            f"{snapshot.product} {snapshot.firmware}".strip(),
            "" if number is None else tr("device number {0}").format(number),
            snapshot.adapter,
        )
        self._details.setText(", ".join(part for part in parts if part))
        self._details.setVisible(any(parts))

    def _board_counts(self, comparison: Comparison) -> str:
        if comparison.offered:
            text = tr("%n setting(s) would be restored, {0} match.", "", comparison.offered)
            text = text.format(comparison.equal)
        elif comparison.missing or comparison.left_out:
            text = tr("This snapshot has no differences to restore.")
        else:
            text = tr("The board, with the edits made here, matches this snapshot.")
        missing = tr("%n setting(s) not in the snapshot would stay.", "", comparison.missing)
        return f"{text} {missing}" if comparison.missing else text

    def _counts(self, comparison: Comparison, snapshot: Snapshot, present: "_Present") -> str:
        if present.key == "":
            return tr(
                "There is no other snapshot of a {0} to compare with. This one has %n setting(s).",
                "",
                len(comparison.rows),
            ).format(snapshot.product)
        differing = len(comparison.differing)
        if differing == 0:
            return tr("Both are the same.")
        text = tr("%n setting(s) differ, {0} match.", "", differing)
        return text.format(comparison.equal)

    @Slot()
    def _update_restore(self) -> None:
        blocker = self._restore_blocker()
        self._restore.setEnabled(not blocker)
        self._note.show_note(blocker or self._restore_note(self._chosen[0]))

    def _restore_blocker(self) -> str:
        """Return why nothing can be restored now; empty if it can."""
        chosen = self._chosen
        if not chosen or len(chosen) > 2:
            return tr("Nothing is selected to be restored.")
        if self._table.problem_of(chosen[-1]):
            return tr("A damaged snapshot cannot be restored.")
        if self._shown is None:
            return tr("The snapshot is being read.")
        if len(chosen) == 2:
            return tr("To restore one of the two, select it alone.")
        if blocker := self.choice.board_blocker(chosen[0]):
            return blocker
        if not self._against_board:
            return tr("To restore, compare with the board.")
        if not self._device.is_connected:
            return tr("The board does not respond, so nothing can be restored.")
        if self._device.writer.running:
            return tr("Settings are being written; wait until that is done.")
        if self._rows.table.comparison.offered == 0:
            return tr("There is nothing to restore.")
        if not self._rows.table.ticked:
            return tr("Select the settings to restore.")
        return ""

    def _restore_note(self, snapshot: Snapshot) -> str:
        text = tr(
            "%n setting(s) would become edits; nothing is written until you click Apply.",
            "",
            len(self._rows.table.ticked),
        )
        here = self._device.parameters.values.stored.get(ParameterKey.DEVICE_NUMBER)
        number = snapshot.device_number
        if number is not None and here is not None and number != here:
            text += " " + tr(
                "Note: this snapshot is of device number {0}, the board here is number {1}."
            ).format(number, here)
        return text

    @Slot()
    def _on_restore_clicked(self) -> None:
        self.show_chosen(self._chosen)  # the board may have changed since
        if not self._restore.isEnabled():
            return
        when = self._table.time_text(self._chosen[0])
        try:
            text = tr("Restore snapshot of {0}").format(when)
            self._device.draft.stage(self._rows.table.ticked, text)
        except BadRequest as error:
            self._notifier.error.emit(tr("Nothing was restored: {0}").format(error))
        else:
            self.restore_requested.emit()


@dataclass(frozen=True, slots=True)
class _Present:
    """The left side of a comparison."""

    key: str  # the data of its item in the list; empty without anything to compare with
    title: str  # the title of its column
    settings: Settings | None = None  # `None` for the board with its edits


class _PresentChoice(QWidget):
    """`Compare with:` and a list. By default it is the board, or without one the next snapshot."""

    chosen = Signal()

    def __init__(
        self, device: Device, table: SnapshotTable, notifier: Notifier, parent: QWidget
    ) -> None:
        super().__init__(parent)
        self._notifier = notifier
        self._device = device
        self._table = table
        self._choice = _BOARD
        self._file: _Present | None = None
        self._offered: tuple[str, _Present | None, list[Snapshot]] | None = None

        self._box = ui.combo_box(self, "compareWithCombo", "", on_activate=self._on_activated)
        adjust = QComboBox.SizeAdjustPolicy.AdjustToMinimumContentsLengthWithIcon
        self._box.setSizeAdjustPolicy(adjust)
        self._box.setMinimumContentsLength(28)
        self._box.setMaxVisibleItems(20)
        self._box.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
        self._box.setPlaceholderText(tr("nothing"))
        label = ui.label(self, text=tr("Compare &with:"), buddy=self._box)
        ui.row(label, (self._box, 1), into=self, margins=0)

    def present_for(
        self, snapshot: Snapshot, settings: Settings, other: Snapshot | None
    ) -> _Present | None:
        """Return the left side; `None` while a snapshot is being read for it."""
        if other is not None:
            return self._of_snapshot(other)
        if self._choice == _FILE and self._file is not None:
            return self._file
        if self._choice not in {_BOARD, _FILE, str(snapshot.path)}:
            row = self._table.row_of(Path(self._choice))
            chosen = None if row is None else self._table.snapshots[row]
            if chosen is not None and not self._table.problem_of(chosen):
                return self._of_snapshot(chosen)
        if not self.board_blocker(snapshot):
            return _Present(_BOARD, tr("Now, with edits"))
        if (neighbour := self._table.neighbour(snapshot)) is not None:
            return self._of_snapshot(neighbour)  # if it turns out damaged, the next is tried
        return _Present("", "–", replace(settings, parameters={}, calibrations={}))

    def _of_snapshot(self, snapshot: Snapshot) -> _Present | None:
        """Return a snapshot as the left side; `None` if it is not read yet, or damaged."""
        settings = self._table.content_of(snapshot)
        if not isinstance(settings, Settings):
            return None
        return _Present(str(snapshot.path), self.title_of(snapshot), settings)

    def title_of(self, snapshot: Snapshot) -> str:
        return tr("Snapshot of {0}").format(self._table.time_text(snapshot))

    def board_blocker(self, snapshot: Snapshot) -> str:
        """Return why a snapshot cannot be compared with the board; empty if it can."""
        closed = {ConnectionState.DISCONNECTED, ConnectionState.DISCONNECTING}
        state = self._device.state
        if state is None or self._device.link in closed:
            return tr("No board is connected. Connect one to restore a snapshot.")
        board = state.signature.model.name
        text = tr("This snapshot is of a {0}, and the board here is a {1}: it cannot be restored.")
        return "" if snapshot.product == board else text.format(snapshot.product, board)

    def clear(self) -> None:
        self._offered = None
        self._box.clear()
        self._box.setEnabled(False)

    def offer(self, snapshot: Snapshot, present: _Present) -> None:
        """Offer what this snapshot can be compared with; of the snapshots, the newest."""
        blocker = self.board_blocker(snapshot)
        sound = (each for each in self._table.snapshots if not self._table.problem_of(each))
        others = list(islice((e for e in sound if e.path != snapshot.path), _MOST_OFFERED))
        offered = (blocker, self._file, others)
        if offered != self._offered:  # a hundred take their time
            self._offered = offered
            self._fill(blocker, others)
        if present.key and self._box.findData(present.key) < 0:  # an older one
            self._box.addItem(present.title, present.key)
        self._box.setCurrentIndex(self._box.findData(present.key) if present.key else -1)
        self._box.setToolTip(ui.plain(self._box.currentText()))

    def _fill(self, blocker: str, others: list[Snapshot]) -> None:
        box = self._box
        box.clear()
        box.setEnabled(True)
        box.addItem(tr("the board as it is now, with edits"), _BOARD)
        model = box.model()
        if blocker and isinstance(model, QStandardItemModel):
            item = model.item(0)
            item.setEnabled(False)
            item.setToolTip(ui.plain(blocker))
        if self._file is not None:
            box.addItem(self._file.title, self._file.key)
        box.addItem(tr("a settings file…"), "")
        box.insertSeparator(box.count())
        plain, with_reason = tr("snapshot of {0}"), tr("snapshot of {0}, before {1}")
        for other in others:
            text = with_reason if other.reason else plain
            when = self._table.time_text(other)
            box.addItem(text.format(when, other.reason), str(other.path))

    @Slot(int)
    def _on_activated(self, index: int) -> None:
        if key := str(self._box.itemData(index) or ""):
            self._choice = key
        else:
            self._ask_for_file()
        self.chosen.emit()

    def _ask_for_file(self) -> None:
        """Let the user choose a settings file to compare with."""
        path = file_questions.ask_to_open(self, tr("Compare with a settings file"))
        if path is None:
            return

        def on_read(settings: Settings) -> None:
            file_questions.remember_folder(path)
            self._file = _Present(_FILE, path.name, settings)
            self._choice = _FILE
            self.chosen.emit()

        def on_failed(error: StudioError) -> None:
            text = tr("{0} cannot be compared with: {1}")
            self._notifier.error.emit(text.format(path.name, error))

        in_background(self, lambda: read_settings(load(path), path.name)[0], on_read, on_failed)
