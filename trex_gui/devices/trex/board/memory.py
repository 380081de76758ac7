"""Record of the connected board on this computer. `Files` does the I/O."""

from collections.abc import Callable, Collection, Mapping
from dataclasses import replace
from datetime import datetime
from typing import Protocol

from trex_gui.core.translation import tr_noop
from trex_gui.devices.trex.driving.timeout_stop import TimeoutTrial
from trex_gui.devices.trex.protocol.calibration import Calibration, CalibrationKey
from trex_gui.devices.trex.protocol.commands import Signature
from trex_gui.devices.trex.protocol.flags import InputSource
from trex_gui.devices.trex.settings.board_records import BoardRecord, Provenance, has_factory_line
from trex_gui.devices.trex.settings.comparison import Comparison
from trex_gui.devices.trex.settings.document import Settings
from trex_gui.devices.trex.settings.edit_files import BoardIdentity

DOUBTED = tr_noop(  # {0}: model, {1}: date of the record
    "The notes, calibrations and applied settings saved for this {0} date from {1}, when it "
    "was connected through another USB adapter or socket. If this is another board, give it "
    "its own device number: boards with the same number share these files."
)


class Files(Protocol):
    """Requests from a `BoardMemory`, handled at once or later."""

    def find(self, board: BoardIdentity, /) -> None:
        """Read the record of a board, then call `handle_record`."""

    def find_lost(self, board: BoardIdentity, adapter: str) -> None:
        """Find the newest record for this adapter and another number, then call `set_lost`."""

    def save(self, board: BoardIdentity, record: BoardRecord | None, /) -> None:
        """Replace the record of a board. `None` removes it."""

    def move(
        self, old: BoardIdentity, new: BoardIdentity, record: BoardRecord, /, *, keeps_old: bool
    ) -> None:
        """Save a record under a new identity. Set aside any file that already has that identity.

        `keeps_old` retains the old file, because it may belong to another board.
        """

    def add_accepted(self, kind: Signature, values: Mapping[str, int], /) -> None:
        """Save values outside inferred limits that a board of this kind has accepted."""

    def warn_doubtful(self, record: BoardRecord) -> None:
        """Warn that the record is from another adapter, so it may belong to another board."""

    def show_notes(self, notes: Mapping[str, str] | None, board: BoardIdentity) -> None:
        """Show the notes of a board. `None` until the notes are known."""

    def record_change(self) -> None:
        """Report that the memory may have changed."""


_Change = Callable[[BoardRecord], BoardRecord]


class BoardMemory:
    """Record of a board. Times are in UTC."""

    def __init__(self, files: Files) -> None:
        self._files = files
        self.record: BoardRecord | None = None  # `None` until the record is found
        # Differences between the board (before) and the last applied settings (after). They are
        # empty for a simulated board, because each start creates a new board.
        self.differing = Comparison(())
        self._board: BoardIdentity | None = None
        self._stored: Settings | None = None  # settings of the board while it is connected
        self._source = InputSource.RC  # the active input source
        self._adapter = ""
        self._lost: BoardRecord | None = None  # record of the board that may have lost its number
        self._is_doubted = False  # True if the record may belong to another board
        self._resets_number = False  # True if the next start of the board resets its number
        self._pending: list[_Change] = []  # changes made before the record was found

    # --- Known settings -----------------------------------------------------------------

    def hidden_calibration(
        self, channel: int, source: InputSource
    ) -> tuple[Calibration | None, Provenance | None]:
        """Return a calibration from the record, and the time when it was written or read."""
        if self.record is None:
            return None, None
        calibration = self.record.settings.calibrations.get(CalibrationKey.of(source, channel))
        provenance = None if calibration is None else self.record.provenance.get(source)
        return calibration, provenance

    @property
    def expected(self) -> BoardRecord | None:
        """Record of the settings that the board should store. `None` if unknown.

        A board that has lost its settings has also lost its device number. Therefore, a board
        without applied settings may be the previous board at the same adapter.
        """
        is_new = self.record is not None and self.record.applied is None
        return self._lost if is_new and self._lost is not None else self.record

    @property
    def applied(self) -> Settings | None:
        """Last applied settings without hidden calibrations. `None` if unknown."""
        if self.expected is None or self._stored is None:
            return None
        return self.expected.applied_to(self._stored)

    def with_hidden(self, stored: Settings) -> tuple[Settings, list[str]]:
        """Return `stored` with hidden calibrations added, and remarks on their age."""
        if self.record is None:
            return stored, []
        return self.record.with_hidden(stored, self._source)

    # --- Reports from the board ---------------------------------------------------------

    def set_board(
        self,
        stored: Settings,
        source: InputSource,
        now: datetime,
        *,
        opened: bool,
        is_simulated: bool = False,
        adapter: str = "",
    ) -> None:
        """Set the board that was read. If the board is new or newly opened, find its record.

        `adapter` is the key of the board's adapter. It is empty if unknown.
        """
        self._stored, self._source, self._adapter = stored, source, adapter
        board = BoardIdentity.of(stored, is_simulated=is_simulated)
        is_same = self._board is not None and board.product == self._board.product
        if self._resets_number and is_same and not opened and board != self._board:
            self._rename(board)
        self._resets_number = False
        if opened or board != self._board:
            if board != self._board:
                self._files.show_notes(None, board)
            self._board, self.record, self._pending = board, None, []
            self._lost = None
            self._files.find(board)
            self._compare()
        self._change(lambda record: record.after_reading(stored, source, now))

    def close_board(self) -> None:
        self._stored = None
        self._compare()

    def _rename(self, board: BoardIdentity) -> None:
        if self._board is None or board == self._board or self.record is None:
            return
        lost, self._lost = self._lost, None
        if lost is not None and board == BoardIdentity.of(lost.settings):
            self.record = self.record.merged_with(lost)
            self._files.save(self._board, None)
            self._files.save(board, self.record)
        else:
            self._files.move(self._board, board, self.record, keeps_old=self._is_doubted)
        self._is_doubted = False
        self._board = board
        self._files.show_notes(self.record.settings.notes, board)

    # --- Writes -------------------------------------------------------------------------

    def start_writing(self, keys: Collection[str]) -> None:
        """Clear the expected values of these keys until the stored values are known."""
        self._change(lambda record: record.before_writing(keys))

    def record_written(
        self, stored: Settings, source: InputSource, uncertain: Collection[str], now: datetime
    ) -> None:
        self._stored, self._source = stored, source
        if self._board is not None:
            self._rename(BoardIdentity.of(stored, is_simulated=self._board.is_simulated))
        self._change(lambda record: record.after_writing(stored, source, uncertain, now))

    def restore(self, record: BoardRecord) -> None:
        self._change(lambda _record: record)

    def record_reset(self) -> None:
        """Expect the factory defaults after the next start of the board."""
        self._resets_number = True
        self._lost = None
        self._change(BoardRecord.after_reset)

    def record_accepted(self, kind: Signature, values: Mapping[str, int]) -> None:
        """Record accepted values outside inferred limits, except those of a simulated board."""
        if values and self._board is not None and not self._board.is_simulated:
            self._files.add_accepted(kind, values)

    # --- Decisions ----------------------------------------------------------------------

    def accept(self, now: datetime) -> None:
        stored, source = self._stored, self._source
        if stored is not None:
            self._change(lambda record: record.accepting(stored, source, now))

    def record_trial(self, trial: TimeoutTrial) -> None:
        self._change(lambda record: replace(record, trial=trial))

    def set_notes(self, notes: Mapping[str, str]) -> None:
        self._change(lambda record: record.with_notes(notes))

    # --- The record ---------------------------------------------------------------------

    def _change(self, change: _Change) -> None:
        if self.record is None:
            self._pending.append(change)
            return
        before, self.record = self.record, change(self.record)
        if self._board is not None and self.record != before:
            self._files.save(self._board, self.record)
        self._compare()

    def _compare(self) -> None:
        self.differing = Comparison(())
        is_real = self._board is not None and not self._board.is_simulated
        if is_real and self.expected is not None and self._stored is not None:
            self.differing = self.expected.differences(self._stored)
        self._files.record_change()

    def handle_record(self, board: BoardIdentity, record: BoardRecord | None) -> None:
        if board != self._board or self.record is not None:
            return
        self.record = record or BoardRecord(Settings(board.product, board.firmware))
        self._record_adapter(self.record)
        pending, self._pending = self._pending, []
        for change in pending:
            self._change(change)
        self._files.show_notes(self.record.settings.notes, board)
        stored, is_new = self._stored, self.record.applied is None
        if is_new and self._adapter and stored is not None and has_factory_line(stored):
            self._files.find_lost(board, self._adapter)

    def set_lost(self, board: BoardIdentity, record: BoardRecord | None) -> None:
        if board == self._board:
            self._lost = record
            self._compare()

    def _record_adapter(self, saved: BoardRecord) -> None:
        adapter = self._adapter
        self._is_doubted = bool(adapter and saved.adapter) and adapter != saved.adapter
        if not adapter or adapter == saved.adapter:
            return
        self._change(lambda record: replace(record, adapter=adapter))
        if self._is_doubted and saved.time is not None:
            self._files.warn_doubtful(saved)
