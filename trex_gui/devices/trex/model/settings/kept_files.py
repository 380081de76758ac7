"""Records of the connected board on this computer, read and saved in threads."""

from collections.abc import Callable, Mapping
from functools import partial

from PySide6.QtCore import QObject, Signal, Slot

from trex_gui.core.errors import StudioError
from trex_gui.core.translation import tr
from trex_gui.devices.trex.board.memory import DOUBTED, BoardMemory
from trex_gui.devices.trex.model.settings.board_files import BoardFiles
from trex_gui.devices.trex.model.settings.draft import SettingsDraft
from trex_gui.devices.trex.protocol.commands import Signature
from trex_gui.devices.trex.settings.accepted import Accepted, AcceptedValues
from trex_gui.devices.trex.settings.board_records import BoardRecord, BoardRecords
from trex_gui.devices.trex.settings.edit_files import BoardIdentity
from trex_gui.ui.files import in_background
from trex_gui.ui.translations import error_sentence, local_time


class KeptFiles(QObject):
    """Files of a `BoardMemory`, and `AcceptedValues` of the parameters."""

    changed = Signal()  # content of `memory`
    failed = Signal(str)  # why records cannot be saved, for the user; once until saving works again
    doubted = Signal(str)  # warning that the record may be of another board, for the user

    def __init__(self, draft: SettingsDraft, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._notes, self._parameters = draft.notes, draft.parameters
        self._records = BoardRecords()
        self._accepted = AcceptedValues()
        self._kind: Signature | None = None  # kind of board whose accepted values are set
        self.memory = BoardMemory(self)
        self.files = BoardFiles(self._records, self)
        # For the memory
        self.find, self.save, self.move = self.files.read, self.files.save, self.files.move
        self.record_change = self.changed.emit

        self.files.found.connect(self.memory.handle_record)
        self.files.failed.connect(self._on_failed)
        self._notes.edited.connect(self._on_note_edited)

    def set_kind(self, kind: Signature, *, opened: bool, is_simulated: bool) -> None:
        """Read the values that boards of this kind accepted. Skipped for simulated boards."""
        if opened or kind != self._kind:
            self._kind = kind
            self._parameters.set_accepted({})
            if not is_simulated:
                self._set_accepted(partial(self._accepted.of, kind))

    def add_accepted(self, kind: Signature, values: Mapping[str, int]) -> None:
        self._set_accepted(partial(self._accepted.add, kind, values))

    def _set_accepted(self, work: Callable[[], Accepted]) -> None:
        in_background(self, work, self._parameters.set_accepted, self._on_failed)

    def find_lost(self, board: BoardIdentity, adapter: str) -> None:
        find = partial(self._records.of_other_number, board, adapter)
        in_background(self, find, partial(self.memory.set_lost, board), self._on_failed)

    def doubt(self, record: BoardRecord) -> None:
        time = "" if record.time is None else local_time(record.time)
        self.doubted.emit(tr(DOUBTED).format(record.settings.product.name, time))

    def show_notes(self, notes: Mapping[str, str] | None, board: BoardIdentity) -> None:
        if notes is None:
            self._notes.clear()
        else:
            self._notes.load(notes, board)

    @Slot()
    def _on_note_edited(self) -> None:
        self.memory.set_notes(self._notes.all)

    @Slot(object)
    def _on_failed(self, failure: StudioError) -> None:
        text = tr("What was applied to this board cannot be remembered. {0}")
        self.failed.emit(text.format(error_sentence(failure)))
