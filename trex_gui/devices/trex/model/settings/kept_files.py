"""Records of the connected board on this computer, read and saved in threads."""

from collections.abc import Mapping
from functools import partial

from PySide6.QtCore import QObject, Signal, Slot

from trex_gui.core.errors import StudioError
from trex_gui.core.translation import tr
from trex_gui.devices.trex.board.memory import DOUBTED, BoardMemory
from trex_gui.devices.trex.model.parameters.parameters import ParameterModel
from trex_gui.devices.trex.model.settings.board_files import BoardFiles
from trex_gui.devices.trex.model.settings.notes import Notes
from trex_gui.devices.trex.protocol.commands import Signature
from trex_gui.devices.trex.settings.accepted import AcceptedValues
from trex_gui.devices.trex.settings.board_records import BoardRecord, BoardRecords
from trex_gui.devices.trex.settings.edit_files import BoardIdentity
from trex_gui.ui.files import in_background
from trex_gui.ui.translations import error_sentence, error_text, local_time


class AcceptedMemory(QObject):
    """Values beyond inferred limits that boards of this kind have stored: see `AcceptedValues`.

    Tells the parameters of them. A simulated board says nothing about real ones.
    """

    failed = Signal(str)  # why something was not remembered, for the user

    def __init__(self, parameters: ParameterModel, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._parameters = parameters
        self._values = AcceptedValues()
        self._board: Signature | None = None

    def take_board(self, board: Signature, *, opened: bool, is_simulated: bool) -> None:
        """Take what boards of this kind have stored, if it is another one, or `opened`."""
        if opened or board != self._board:
            self._board = board
            self._parameters.set_accepted({})
            if not is_simulated:
                read, then = partial(self._values.of, board), self._parameters.set_accepted
                in_background(self, read, then, self._on_failed)

    def add(self, kind: Signature, values: Mapping[str, int]) -> None:
        add = partial(self._values.add, kind, values)
        in_background(self, add, self._parameters.set_accepted, self._on_failed)

    def _on_failed(self, error: StudioError) -> None:
        text = tr("What the board accepted was not remembered. {0}")
        self.failed.emit(text.format(error_text(error)))


class KeptFiles(QObject):
    """Serves a `BoardMemory` with its files."""

    changed = Signal()  # what `memory` knows
    failed = Signal(str)  # why nothing can be kept, for the user; once, until it works again
    doubted = Signal(str)  # that the record may be of another board, for the user

    def __init__(
        self, notes: Notes, accepted: AcceptedMemory, parent: QObject | None = None
    ) -> None:
        super().__init__(parent)
        self._notes = notes
        self._records = BoardRecords()
        self.memory = BoardMemory(self)
        self.files = BoardFiles[BoardRecord, BoardRecord](self._records, self)
        # For the memory:
        self.find, self.save, self.move = self.files.read, self.files.save, self.files.move
        self.add_accepted, self.note_change = accepted.add, self.changed.emit

        self.files.found.connect(self.memory.take_record)
        self.files.failed.connect(self._on_failed)
        notes.edited.connect(self._on_note_edited)

    def find_lost(self, board: BoardIdentity, adapter: str) -> None:
        find = partial(self._records.of_other_number, board, adapter)
        in_background(self, find, partial(self.memory.take_lost, board), self._on_failed)

    def doubt(self, record: BoardRecord) -> None:
        time = "" if record.time is None else local_time(record.time)
        self.doubted.emit(tr(DOUBTED).format(record.settings.product.name, time))

    def show_notes(self, notes: Mapping[str, str] | None, board: BoardIdentity) -> None:
        if notes is None:
            self._notes.forget()
        else:
            self._notes.load(notes, board)

    @Slot()
    def _on_note_edited(self) -> None:
        self.memory.set_notes(self._notes.all)

    @Slot(object)
    def _on_failed(self, failure: StudioError) -> None:
        text = tr("What was applied to this board cannot be remembered. {0}")
        self.failed.emit(text.format(error_sentence(failure)))
