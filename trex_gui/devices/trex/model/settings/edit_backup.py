"""Backup of unapplied edits, which survives a crash."""

from collections.abc import Collection
from dataclasses import dataclass, replace

from PySide6.QtCore import QObject, Signal, Slot

from trex_gui.core.files import SettingsError
from trex_gui.core.translation import tr
from trex_gui.devices.trex.model.settings.board_files import BoardFiles
from trex_gui.devices.trex.model.settings.draft import SettingsDraft, diff_against_draft
from trex_gui.devices.trex.settings.comparison import ComparisonRow
from trex_gui.devices.trex.settings.document import Settings
from trex_gui.devices.trex.settings.edit_files import BoardIdentity, EditFiles, SavedEdits
from trex_gui.ui.translations import error_sentence


@dataclass(frozen=True, slots=True)
class EditOffer:
    rows: tuple[ComparisonRow, ...]
    saved: SavedEdits


class EditBackup(QObject):
    """Saves edits, and offers the edits of an earlier run."""

    offered = Signal()  # `offer` was set or cleared
    failed = Signal(str)  # reason for the user; not repeated until a save succeeds

    def __init__(self, draft: SettingsDraft, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self.offer: EditOffer | None = None  # saved until restored or discarded
        self._draft = draft
        self.files = BoardFiles(EditFiles(), self)
        self._board: BoardIdentity | None = None  # board to which the edits in the draft belong
        self._is_read = False  # the file of this board was read
        self._has_file = False
        self._undecided: Settings | None = None  # saved edits that are not in the draft
        # Board, `_is_read` and edits at the last `close_board`
        self._closed: tuple[BoardIdentity | None, bool] = (None, False)
        self._closed_edits: Settings | None = None
        self._parked: dict[BoardIdentity, Settings] = {}  # edits of boards that are not selected
        self.files.found.connect(self._on_found)
        self.files.failed.connect(self._on_failed)
        draft.pending_changed.connect(self._on_changed)

    def close_board(self, *, is_deselected: bool = False) -> None:
        """Pause saving while the draft is loaded, until `set_board`.

        `is_deselected` is true if another board on the line was selected. The edits return when
        this board is selected again.
        """
        stored = self._draft.stored
        if is_deselected and stored is not None and self._board is not None and self._draft.pending:
            self._parked[self._board] = replace(
                stored,
                parameters=dict(self._draft.parameters.values.pending),
                calibrations=dict(self._draft.calibrations.edited),
            )
        self._closed = self._board, self._is_read
        self._closed_edits = None if stored is None else self._edits(stored)
        self._board = None

    def set_board(self, *, opened: bool, is_simulated: bool = False) -> None:
        """Start saving the edits of this board. Offer the edits of an earlier run.

        Simulated and real boards have separate files. For the same board, an open offer is repeated
        only if `opened`. Edits of settings that could not be read stay saved.
        """
        stored = self._draft.stored
        if stored is None:
            return
        self._board = BoardIdentity.of(stored, is_simulated=is_simulated)
        if (self._board, True) != self._closed:
            self._is_read = self._has_file = False
            self._undecided = None
            self._set_offer(None)
            if parked := self._parked.pop(self._board, None):
                rows = diff_against_draft(self._draft, parked).rows
                self._draft.stage(rows, tr("Edits of this board"))
            self.files.read(self._board)
            return
        if self._closed_edits is not None:
            keys = set() if self._undecided is None else self._undecided.keys
            keys |= self._out_of_reach(self._closed_edits)
            self._undecided = _subset(self._closed_edits, keys)
        self._on_changed()
        if self._undecided is not None and (opened or self.offer is None):
            self._is_read = False
            self.files.read(self._board)

    # --- Decisions ----------------------------------------------------------------------

    def restore(self) -> None:
        """Restore the offered edits, except for settings with newer edits."""
        if self.offer is None:
            return
        rows = [row for row in self.offer.rows if not self._draft.is_modified(row.key)]
        if self._undecided is not None:
            self._undecided = _subset(self._undecided, self._out_of_reach(self._undecided))
        self._draft.stage(rows, tr("Restore edits"))
        self._set_offer(None)

    def discard_offer(self) -> None:
        self._undecided = None
        self._set_offer(None)

    def discard(self) -> None:
        """Stop saving, and remove the edits in the draft from the file."""
        if self._board is not None and self._has_file and self._draft.pending:
            self.files.save(self._board, self._undecided)
        self._board = None

    def _set_offer(self, offer: EditOffer | None) -> None:
        if offer is not self.offer:
            self.offer = offer
            self.offered.emit()
        self._on_changed()

    # --- Files --------------------------------------------------------------------------

    @Slot()
    def _on_changed(self) -> None:
        stored = self._draft.stored
        if self._board is None or stored is None or not self._is_read:
            return
        board = BoardIdentity.of(stored, is_simulated=self._board.is_simulated)
        edits = self._edits(stored)
        before, self._board = self._board, board
        if board != before and edits is not None:  # the device number was written
            self.files.move(before, board, edits)
        elif board != before:
            self.files.save(before, None)
        elif edits is not None or self._has_file:
            self.files.save(board, edits)
        self._has_file = edits is not None

    def _edits(self, stored: Settings) -> Settings | None:
        parameters = dict(self._draft.parameters.values.pending)
        calibrations = dict(self._draft.calibrations.edited)
        if self._undecided is not None:
            parameters = {**self._undecided.parameters, **parameters}
            calibrations = {**self._undecided.calibrations, **calibrations}
        if not parameters and not calibrations:
            return None
        return replace(stored, parameters=parameters, calibrations=calibrations, notes={})

    @Slot(object)
    def _on_failed(self, failure: SettingsError) -> None:
        text = tr("Unapplied edits cannot be saved for the next start. {0}")
        self.failed.emit(text.format(error_sentence(failure)))

    @Slot(object, object)
    def _on_found(self, board: BoardIdentity, saved: SavedEdits | None) -> None:
        if board != self._board or self._is_read:
            return
        offer = None
        self._is_read, self._has_file = True, saved is not None
        if saved is not None:
            changes = diff_against_draft(self._draft, saved.settings).rows
            is_modified = self._draft.is_modified
            rows = tuple(row for row in changes if row.changed and not is_modified(row.key))
            keys = {row.key for row in rows} | self._out_of_reach(saved.settings)
            self._undecided = _subset(saved.settings, keys)
            offer = EditOffer(rows, saved) if rows else None
        self._set_offer(offer)

    def _out_of_reach(self, edits: Settings) -> set[str]:
        """Return the keys of edits that the draft neither contains nor accepts."""
        can_edit, is_modified = self._draft.can_edit, self._draft.is_modified
        return {key for key in edits.keys if not can_edit(key) and not is_modified(key)}


def _subset(edits: Settings, keys: Collection[str]) -> Settings | None:
    subset = edits.only(keys)
    return subset if subset.keys else None
