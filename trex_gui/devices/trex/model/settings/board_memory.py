"""What this computer keeps of the board that is connected: see `BoardRecord`."""

from collections.abc import Callable, Collection
from dataclasses import replace
from functools import partial

from PySide6.QtCore import QObject, Signal, Slot

from trex_gui.core.errors import StudioError
from trex_gui.devices.trex.driving.timeout_stop import TimeoutTrial
from trex_gui.devices.trex.model.settings.board_files import BoardFiles
from trex_gui.devices.trex.model.settings.notes import Notes
from trex_gui.devices.trex.protocol.calibration import Calibration, CalibrationKey
from trex_gui.devices.trex.protocol.flags import InputSource
from trex_gui.devices.trex.settings.board_records import (
    BoardRecord,
    BoardRecords,
    Known,
    has_factory_line,
    utc_now,
)
from trex_gui.devices.trex.settings.comparison import Comparison
from trex_gui.devices.trex.settings.document import Settings
from trex_gui.devices.trex.settings.edit_files import BoardIdentity
from trex_gui.ui.files import in_background
from trex_gui.ui.translations import error_sentence, local_time

Change = Callable[[BoardRecord], BoardRecord]


class BoardMemory(QObject):
    """Reads the record of a board, follows what is read, written and noted, and saves it."""

    changed = Signal()  # `record` or `differing`
    failed = Signal(str)  # why nothing can be kept, for the user; once, until it works again
    doubted = Signal(str)  # that the record may be of another board, for the user

    def __init__(self, notes: Notes, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._notes = notes
        self.record: BoardRecord | None = None  # `None` until it was read from its file
        # Settings in which the board, at the left, differs from what was applied last; none for a
        # simulated board, which is a new one each time
        self.differing = Comparison(())
        self._records = BoardRecords()
        self.files = BoardFiles[BoardRecord, BoardRecord](self._records, self)
        self._board: BoardIdentity | None = None
        self._stored: Settings | None = None  # what the board stores, while it is connected
        self._source = InputSource.RC  # the active one
        self._adapter = ""
        self._lost: BoardRecord | None = None  # of the board that this may be, without its number
        self._is_doubted = False  # the record may be of another board
        self._is_renamed = False  # the next start of the board resets its number
        self._later: list[Change] = []  # what happened before the record was read
        self.files.found.connect(self._on_found)
        self.files.failed.connect(self._on_failed)
        self._notes.edited.connect(self._on_note_edited)

    # --- What is known ------------------------------------------------------------------

    def hidden_calibration(
        self, channel: int, source: InputSource
    ) -> tuple[Calibration | None, Known | None]:
        """Return the last known calibration for an input source, and since when it is known."""
        if self.record is None:
            return None, None
        found = self.record.settings.calibrations.get(CalibrationKey.of(source, channel))
        return found, self.record.known.get(source) if found is not None else None

    @property
    def expected(self) -> BoardRecord | None:
        """The record with what the board should store; `None`: not known.

        A board that lost its settings has lost its device number, too: one to which nothing was
        applied may be the board that was at the same adapter before.
        """
        is_new = self.record is not None and self.record.applied is None
        return self._lost if is_new and self._lost is not None else self.record

    @property
    def applied(self) -> Settings | None:
        """What was applied last, as far as the board shows it now; `None`: not known."""
        if self.expected is None or self._stored is None:
            return None
        return self.expected.applied_to(self._stored)

    def with_hidden(self, stored: Settings) -> tuple[Settings, list[str]]:
        """Return what the board stores with the calibrations that it hides, and their age."""
        if self.record is None:
            return stored, []
        return self.record.with_hidden(stored, self._source)

    # --- Reports of the device ----------------------------------------------------------

    def take_board(
        self,
        stored: Settings,
        source: InputSource,
        *,
        opened: bool,
        is_simulated: bool = False,
        adapter: str = "",
    ) -> None:
        """Take what was read; the record is read from its file for another board, or `opened`.

        `adapter` is the key of the one that the board is at; empty if that is not known.
        """
        self._stored, self._source, self._adapter = stored, source, adapter
        board = BoardIdentity.of(stored, is_simulated=is_simulated)
        is_same = self._board is not None and board.product == self._board.product
        if self._is_renamed and is_same and not opened and board != self._board:
            self._rename(board)
        self._is_renamed = False
        if opened or board != self._board:
            if board != self._board:
                self._notes.forget()
            self._board, self.record, self._later = board, None, []
            self._lost = None
            self.files.read(board)
            self._compare()
        self._change(lambda record: record.after_reading(stored, source, utc_now()))

    def leave_board(self) -> None:
        """Compare no more: the line was closed."""
        self._stored = None
        self._compare()

    def begin_writing(self, keys: Collection[str]) -> None:
        self._change(lambda record: record.before_writing(keys))

    def note_written(
        self, stored: Settings, source: InputSource, uncertain: Collection[str]
    ) -> None:
        """Take what the board stores after a write that began; some values may be `uncertain`."""
        self._stored, self._source = stored, source
        if self._board is not None:
            self._rename(BoardIdentity.of(stored, is_simulated=self._board.is_simulated))
        self._change(lambda record: record.after_writing(stored, source, uncertain, utc_now()))

    def note_reset(self) -> None:
        """Expect the factory defaults after the next start of the board."""
        self._is_renamed = True
        self._lost = None
        self._change(BoardRecord.after_reset)

    def _rename(self, board: BoardIdentity) -> None:
        """Follow another device number of the same board."""
        if self._board is None or board == self._board or self.record is None:
            return
        lost, self._lost = self._lost, None
        if lost is not None and board == BoardIdentity.of(lost.settings):
            self.record = self.record.together_with(lost)
            self.files.save(self._board, None)
            self.files.save(board, self.record)
        else:
            self.files.move(self._board, board, self.record, keeps_old=self._is_doubted)
        self._is_doubted = False
        self._board = board
        self._notes.load(self.record.settings.notes, board)

    # --- Decisions ----------------------------------------------------------------------

    def accept(self) -> None:
        """Take what the board stores in place of what was applied."""
        stored, source = self._stored, self._source
        if stored is not None:
            self._change(lambda record: record.accepting(stored, source, utc_now()))

    def record_trial(self, trial: TimeoutTrial) -> None:
        """Save what the user saw of the serial timeout of this board."""
        self._change(lambda record: replace(record, trial=trial))

    # --- The record ---------------------------------------------------------------------

    def _change(self, change: Change) -> None:
        if self.record is None:
            self._later.append(change)
            return
        before, self.record = self.record, change(self.record)
        if self._board is not None and self.record != before:
            self.files.save(self._board, self.record)
        self._compare()

    def _compare(self) -> None:
        self.differing = Comparison(())
        is_real = self._board is not None and not self._board.is_simulated
        if is_real and self.expected is not None and self._stored is not None:
            self.differing = self.expected.differences(self._stored)
        self.changed.emit()

    @Slot()
    def _on_note_edited(self) -> None:
        notes = self._notes.all
        self._change(lambda record: record.with_notes(notes))

    @Slot(object, object)
    def _on_found(self, board: BoardIdentity, found: BoardRecord | None) -> None:
        if board != self._board or self.record is not None:
            return
        self.record = found or BoardRecord(Settings(board.product, board.firmware))
        self._note_adapter(self.record)
        later, self._later = self._later, []
        for change in later:
            self._change(change)
        self._notes.load(self.record.settings.notes, board)
        stored, is_new = self._stored, self.record.applied is None
        if is_new and self._adapter and stored is not None and has_factory_line(stored):
            find = partial(self._records.of_other_number, board, self._adapter)
            in_background(self, find, partial(self._on_lost_found, board), self._on_failed)

    def _on_lost_found(self, board: BoardIdentity, found: BoardRecord | None) -> None:
        if board == self._board:
            self._lost = found
            self._compare()

    def _note_adapter(self, found: BoardRecord) -> None:
        """Say that a record may be of another board, if its board was at another adapter."""
        adapter = self._adapter
        self._is_doubted = bool(adapter and found.adapter) and adapter != found.adapter
        if not adapter or adapter == found.adapter:
            return
        self._change(lambda record: replace(record, adapter=adapter))
        if self._is_doubted and found.time is not None:
            text = self.tr(
                "What is kept here for this {0} (notes, calibrations, applied settings) is of {1}, "
                "when it was at another USB adapter or socket. If this is another board, give it "
                "a device number of its own: boards with the same number share what is kept."
            )
            self.doubted.emit(text.format(found.settings.product.name, local_time(found.time)))

    @Slot(object)
    def _on_failed(self, failure: StudioError) -> None:
        text = self.tr("What was applied to this board cannot be remembered. {0}")
        self.failed.emit(text.format(error_sentence(failure)))
