"""What this computer keeps of the board that is connected, read and saved beside the window."""

from collections.abc import Mapping
from functools import partial

from PySide6.QtCore import QObject, Signal, Slot

from trex_gui.core.errors import StudioError
from trex_gui.core.translation import tr
from trex_gui.devices.trex.board.memory import DOUBTED, BoardMemory
from trex_gui.devices.trex.model.settings.accepted_memory import AcceptedMemory
from trex_gui.devices.trex.model.settings.board_files import BoardFiles
from trex_gui.devices.trex.model.settings.notes import Notes
from trex_gui.devices.trex.protocol.commands import Signature
from trex_gui.devices.trex.settings.board_records import BoardRecord, BoardRecords
from trex_gui.devices.trex.settings.edit_files import BoardIdentity
from trex_gui.ui.files import in_background
from trex_gui.ui.translations import error_sentence, local_time


class KeptFiles(QObject):
    """Serves a `BoardMemory` with its files."""

    changed = Signal()  # what `memory` knows
    failed = Signal(str)  # why nothing can be kept, for the user; once, until it works again
    doubted = Signal(str)  # that the record may be of another board, for the user

    def __init__(
        self,
        notes: Notes,
        accepted: AcceptedMemory,
        folder: BoardRecords | None = None,
        parent: QObject | None = None,
    ) -> None:
        super().__init__(parent)
        self._notes = notes
        self._accepted = accepted
        self._records = folder or BoardRecords()
        self.memory = BoardMemory(self)
        self.files = BoardFiles[BoardRecord, BoardRecord](self._records, self)
        self.files.found.connect(self.memory.take_record)
        self.files.failed.connect(self._on_failed)
        notes.edited.connect(self._on_note_edited)

    # --- For the memory -----------------------------------------------------------------

    def find(self, board: BoardIdentity) -> None:
        self.files.read(board)

    def find_lost(self, board: BoardIdentity, adapter: str) -> None:
        find = partial(self._records.of_other_number, board, adapter)
        in_background(self, find, partial(self.memory.take_lost, board), self._on_failed)

    def save(self, board: BoardIdentity, record: BoardRecord | None) -> None:
        self.files.save(board, record)

    def move(
        self, old: BoardIdentity, new: BoardIdentity, record: BoardRecord, *, keeps_old: bool
    ) -> None:
        self.files.move(old, new, record, keeps_old=keeps_old)

    def add_accepted(self, kind: Signature, values: Mapping[str, int]) -> None:
        self._accepted.add(kind, values)

    def doubt(self, record: BoardRecord) -> None:
        time = "" if record.time is None else local_time(record.time)
        self.doubted.emit(tr(DOUBTED).format(record.settings.product.name, time))

    def show_notes(self, notes: Mapping[str, str] | None, board: BoardIdentity) -> None:
        if notes is None:
            self._notes.forget()
        else:
            self._notes.load(notes, board)

    def note_change(self) -> None:
        self.changed.emit()

    @Slot()
    def _on_note_edited(self) -> None:
        self.memory.set_notes(self._notes.all)

    @Slot(object)
    def _on_failed(self, failure: StudioError) -> None:
        text = tr("What was applied to this board cannot be remembered. {0}")
        self.failed.emit(text.format(error_sentence(failure)))
