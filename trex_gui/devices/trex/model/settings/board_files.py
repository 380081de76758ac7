"""One file for each board. Files are saved and read in a thread."""

import logging
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import Any

from PySide6.QtCore import QObject, Signal, Slot

from trex_gui.core.errors import StudioError
from trex_gui.core.files import SettingsError
from trex_gui.core.translation import tr
from trex_gui.devices.trex.board.memory import DOUBTED, BoardMemory
from trex_gui.devices.trex.model.settings.draft import SettingsDraft
from trex_gui.devices.trex.protocol.commands import Signature
from trex_gui.devices.trex.settings.accepted import Accepted, AcceptedValues
from trex_gui.devices.trex.settings.board_records import BoardRecord, BoardRecords
from trex_gui.devices.trex.settings.document import Settings
from trex_gui.devices.trex.settings.edit_files import BoardIdentity, EditFiles, put_aside
from trex_gui.ui.files import in_background
from trex_gui.ui.runtime import new_timer
from trex_gui.ui.translations import error_sentence, local_time
from trex_gui.ui.workers.file_worker import Done, FileTask, ProgressCallback

log = logging.getLogger(__name__)

_DELAY_MS = 500  # a crash loses at most the changes of this period

_CLOSING_MS = 1000  # time limit for the last save of `shut_down`

Content = Settings | BoardRecord | None  # `None` removes a file


@dataclass(frozen=True, slots=True)
class _Result:
    board: BoardIdentity | None  # the board whose file was read
    found: object
    failure: SettingsError | None
    unsaved: Mapping[BoardIdentity, Any]
    moved: frozenset[BoardIdentity] = frozenset()  # boards whose file may belong to another board
    aside: tuple[Path, ...] = ()  # new paths of renamed files


class BoardFiles(QObject):
    found = Signal(object, object)  # the board, and its content; `None` without a valid file
    failed = Signal(object)  # a `SettingsError`; not repeated until a save succeeds
    replaced = Signal(object)  # new `Path` of a renamed file of another board, see `move`

    def __init__(self, files: EditFiles | BoardRecords, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._files = files
        self._due: dict[BoardIdentity, Any] = {}  # the newest unsaved `Content` of each board
        self._moved: set[BoardIdentity] = set()  # boards whose file may belong to another board
        self._to_read: BoardIdentity | None = None  # board whose file will be read
        self._is_failing = False
        self._task = FileTask(self)
        self._timer = new_timer(self, _DELAY_MS, self._start, single_shot=True)
        self._task.done.connect(self._on_done)

    @property
    def is_idle(self) -> bool:
        is_saved = not self._due or self._is_failing
        return is_saved and not self._task.is_running and not self._timer.isActive()

    def save(self, board: BoardIdentity, content: Content) -> None:
        """Save a board's file. `None` removes the file."""
        self._due[board] = content
        if not self._timer.isActive():
            self._timer.start()

    def move(
        self, old: BoardIdentity, new: BoardIdentity, content: Content, *, keeps_old: bool = False
    ) -> None:
        """Save a board's file under another identity. An existing file of `new` is renamed.

        `keeps_old` retains the old file, which may belong to another board.
        """
        self._moved.discard(old)
        self._moved.add(new)
        if not keeps_old:
            self.save(old, None)
        self.save(new, content)

    def read(self, board: BoardIdentity) -> None:
        self._to_read = board
        self._start()

    def shut_down(self) -> bool:
        """Save unsaved content. Return whether saving ended in time."""
        self._timer.stop()
        in_time = self._task.close(0, finish_ms=_CLOSING_MS)
        if in_time and self._due:
            self._start()
            in_time = self._task.close(0, finish_ms=_CLOSING_MS)
        return in_time

    @Slot()
    def _start(self) -> None:
        if self._task.is_running:
            return  # `_on_done` starts the next task
        due, self._due = self._due, {}
        moved = self._moved & due.keys()
        self._moved -= moved
        self._task.start(partial(_save_and_read, self._files, due, moved, self._to_read))

    @Slot(object)
    def _on_done(self, done: Done) -> None:
        result = done.result
        if not isinstance(result, _Result):  # an internal error was logged
            result = _Result(self._to_read, None, None, {})
        if result.failure is not None and not self._is_failing:
            self.failed.emit(result.failure)
        self._is_failing = result.failure is not None
        self._due = {**result.unsaved, **self._due}  # newer content replaces unsaved content
        self._moved |= result.moved
        for path in result.aside:
            self.replaced.emit(path)
        if result.board is not None and result.board == self._to_read:
            self._to_read = None
            self.found.emit(result.board, result.found)
        has_new = self._due.keys() - result.unsaved.keys()  # failed files wait for the next change
        if has_new or self._to_read is not None:
            self._timer.start()


def _save_and_read(
    files: EditFiles | BoardRecords,
    due: Mapping[BoardIdentity, Any],
    moved: set[BoardIdentity],
    board: BoardIdentity | None,
    _progress: ProgressCallback,
) -> _Result:
    failure: SettingsError | None = None
    loaded: object = None
    unsaved: dict[BoardIdentity, Any] = {}
    aside: list[Path] = []
    for owner, content in due.items():
        try:
            if owner in moved and (renamed := put_aside(files.path(owner))) is not None:
                aside.append(renamed)
            moved.discard(owner)
            files.save(owner, content)
        except SettingsError as error:
            failure = error
            unsaved[owner] = content
    try:
        loaded = None if board is None else files.load(board)
    except SettingsError as error:
        log.warning("the file of a board was ignored: %s", error)
    return _Result(board, loaded, failure, unsaved, frozenset(moved), tuple(aside))


class RecordFiles(QObject):
    """Files of a `BoardMemory`, and `AcceptedValues` of the parameters."""

    changed = Signal()  # content of `memory`
    failed = Signal(str)  # reason for the user; not repeated until a save succeeds
    doubted = Signal(str)  # warning for the user: the record may belong to another board

    def __init__(self, draft: SettingsDraft, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._notes, self._parameters = draft.notes, draft.parameters
        self._records = BoardRecords()
        self._accepted = AcceptedValues()
        self._kind: Signature | None = None  # kind of board; `None` for a simulated board
        self.memory = BoardMemory(self)
        self.files = BoardFiles(self._records, self)
        # Called by `memory`
        self.find, self.save, self.move = self.files.read, self.files.save, self.files.move
        self.record_change = self.changed.emit

        self.files.found.connect(self.memory.handle_record)
        self.files.failed.connect(self._on_failed)
        self._notes.edited.connect(self._on_note_edited)

    def set_kind(self, kind: Signature, *, opened: bool, is_simulated: bool) -> None:
        """Set the kind of board, and read its accepted values. A simulated board has none."""
        if opened or kind != self._kind:
            self._kind = None if is_simulated else kind
            self._parameters.set_accepted({})
            if not is_simulated:
                self._set_accepted(kind, partial(self._accepted.of, kind))

    def add_accepted(self, kind: Signature, values: Mapping[str, int]) -> None:
        self._set_accepted(kind, partial(self._accepted.add, kind, values))

    def _set_accepted(self, kind: Signature, work: Callable[[], Accepted]) -> None:
        def set_values(accepted: Accepted) -> None:
            if kind == self._kind:  # otherwise, another board was connected meanwhile
                self._parameters.set_accepted(accepted)

        in_background(self, work, set_values, self._on_failed)

    def find_lost(self, board: BoardIdentity, adapter: str) -> None:
        find = partial(self._records.of_other_number, board, adapter)
        in_background(self, find, partial(self.memory.set_lost, board), self._on_failed)

    def warn_doubtful(self, record: BoardRecord) -> None:
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
        text = tr("The records of this board cannot be used. {0}")
        self.failed.emit(text.format(error_sentence(failure)))
