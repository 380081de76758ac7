"""Settings and notes with their edits and undo stack."""

from collections.abc import Iterable, Iterator, Mapping
from contextlib import contextmanager
from dataclasses import replace

from PySide6.QtCore import QObject, Signal
from PySide6.QtGui import QUndoStack

from trex_gui.core.errors import BadRequest
from trex_gui.core.translation import tr
from trex_gui.devices.trex.calibration.channel_curve import ChannelCurve
from trex_gui.devices.trex.client.reading import DeviceState
from trex_gui.devices.trex.model.parameters.parameters import ParameterModel
from trex_gui.devices.trex.model.settings.calibrations import Calibrations, Channel
from trex_gui.devices.trex.protocol.calibration import CALIBRATION_KEYS, Calibration, CalibrationKey
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.devices.trex.protocol.device_table import Model
from trex_gui.devices.trex.protocol.flags import InputSource
from trex_gui.devices.trex.protocol.parameters import ParameterKey
from trex_gui.devices.trex.settings.comparison import Comparison, ComparisonRow, compare
from trex_gui.devices.trex.settings.document import Settings, settings_of, specs_for
from trex_gui.devices.trex.settings.edit_files import BoardIdentity
from trex_gui.devices.trex.settings.notes import LONGEST_NOTE, clean_note
from trex_gui.ui.devices.undo import Edit


class Notes(QObject):
    """Notes by key. Edits can be undone and need no Apply.

    A board cannot store notes. They are saved on this computer, see `BoardMemory`.
    """

    changed = Signal()
    edited = Signal()  # the user edited a note, or undid an edit

    def __init__(self, parent: QObject | None = None, undo: QUndoStack | None = None) -> None:
        super().__init__(parent)
        self.are_known = False  # the notes were read
        self._undo = undo or QUndoStack(self)
        self._notes: dict[str, str] = {}
        self._owner: object = None

    @property
    def all(self) -> dict[str, str]:
        return dict(self._notes)

    def of(self, key: str) -> str:
        return self._notes.get(key, "")

    def load(self, notes: Mapping[str, str], owner: object = None) -> None:
        """Load saved notes. Undo affects notes of this owner only."""
        self._notes, self._owner, self.are_known = dict(notes), owner, True
        self.changed.emit()

    def clear(self) -> None:
        self._notes, self._owner, self.are_known = {}, None, False
        self.changed.emit()

    def edit(self, key: str, text: str, *, name: str = "", run: object = None) -> None:
        """Replace a note. An empty text removes the note.

        The undo text contains `name`. Consecutive edits of a note with the same `run` form one undo
        step.
        """
        before, after = self.of(key), clean_note(text)[:LONGEST_NOTE].rstrip()
        if self.are_known and after != before:
            title = tr("Note on {0}").format(name or key)
            self._undo.push(
                Edit(title, self._apply_edit, (self._owner, key), before, after, run=run)
            )

    def _apply_edit(self, owner_and_key: tuple[object, str], text: str) -> None:
        owner, key = owner_and_key
        if owner != self._owner or not self.are_known:
            return  # the note belongs to another board
        self._notes.pop(key, None)
        if text:
            self._notes[key] = text
        self.changed.emit()
        self.edited.emit()


class SettingsDraft(QObject):
    """Stored settings, their edits, and an undo stack."""

    loaded = Signal()  # the stored settings were read again
    pending_changed = Signal()  # `pending` or an edit has changed

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self.undo = QUndoStack(self)
        self.parameters = ParameterModel(self, self.undo)
        self.calibrations = Calibrations(self, self.undo)
        self.notes = Notes(self, self.undo)
        self.reset_pending = False  # the board resets its parameters at the next start
        self._product: Model | None = None
        self._firmware: str | None = None
        # Stored values, active values and `reset_pending` of boards that are not selected
        self._set_aside: dict[BoardIdentity, tuple[dict[str, int], dict[str, int], bool]] = {}

        self.parameters.pending_changed.connect(self.pending_changed)
        self.calibrations.changed.connect(self.pending_changed)

    # --- Stored settings ----------------------------------------------------------------

    def name_of(self, key: str) -> str:
        if key in CALIBRATION_KEYS:
            return CALIBRATION_KEYS[key].label
        if key == ParameterKey.FACTORY_RESET:
            return tr("Reset to factory defaults")
        parameters = self.parameters
        return parameters.values.specs[key].name if parameters.index_of(key).isValid() else key

    def stored_curve(self, channel: Channel) -> ChannelCurve | None:
        calibration = self.calibrations.stored(channel)
        if calibration is None:
            return None
        number = channel.channel if isinstance(channel, CalibrationKey) else channel
        return ChannelCurve.stored(number, calibration, self.parameters.values.stored.get)

    def select_state(self, state: DeviceState, connection: ConnectionSettings | None) -> None:
        """Load the settings of another board on the line. Discard edits.

        Values that are active only until a power cycle are restored when their board is selected
        again.
        """
        values = self.parameters.values
        if (before := self.stored) is not None:
            known = values.all_stored, dict(values.active), self.reset_pending
            self._set_aside[BoardIdentity.of(before)] = known
        board = BoardIdentity.of(settings_of(state))
        stored, active, reset_pending = self._set_aside.pop(board, ({}, {}, False))
        self.undo.clear()
        self._update(state, connection, active, keep_edits=False)
        self.reset_pending = reset_pending and stored == values.all_stored
        self.loaded.emit()

    def set_state(
        self,
        state: DeviceState,
        connection: ConnectionSettings | None,
        *,
        power_cycled: bool,
        opened: bool = False,
    ) -> None:
        """Load the settings of a board. Edits stay if the model is the same.

        A pending reset is complete if the stored values have changed. `opened` is true if the line
        was just opened.
        """
        if opened:
            self._set_aside.clear()
        if power_cycled or self.parameters.values.all_stored != state.parameters:
            self.reset_pending = False
        self._update(state, connection, {}, power_cycled=power_cycled)
        self.loaded.emit()

    def _update(
        self,
        state: DeviceState,
        connection: ConnectionSettings | None,
        active: Mapping[str, int],
        *,
        power_cycled: bool = True,
        keep_edits: bool = True,
    ) -> None:
        model = state.signature.model
        self._start(model, state.signature.firmware)
        self.parameters.load(
            state.specs,
            state.parameters,
            state.unread,
            active={**active, **state.active_parameters(connection)},
            power_cycled=power_cycled,
            keep_edits=keep_edits,
        )
        self.calibrations.load(model.key, state.source, state.calibrations, keep_edits=keep_edits)

    def record_stored(self, state: DeviceState) -> None:
        self.parameters.record_stored(state.parameters)
        self.calibrations.record_stored(state.calibrations)

    def load_settings(self, settings: Settings) -> None:
        self._start(settings.product, settings.firmware)
        specs = specs_for(settings.product, settings.firmware)
        is_analog = settings.parameters.get(ParameterKey.CHANNEL_INPUT_SOURCE) == 1
        source = InputSource.ANALOG if is_analog else InputSource.RC
        self.parameters.load(specs, settings.parameters, {}, power_cycled=True, open_ended=True)
        self.calibrations.load(settings.product.key, source, settings.calibrations, open_ended=True)
        self.notes.load(settings.notes)
        self.loaded.emit()

    def _start(self, product: Model, firmware: str | None) -> None:
        if self._product is None or self._product.key != product.key:
            self.undo.clear()  # the edits belong to another model
        self._product = product
        self._firmware = firmware

    @property
    def stored(self) -> Settings | None:
        return self._settings(self.parameters.values.all_stored, self.calibrations.all_stored)

    @property
    def shown(self) -> Settings | None:
        """Settings after Apply or Save."""
        return self._settings(self.parameters.values.all_shown, self.calibrations.all_shown)

    def _settings(
        self, parameters: Mapping[str, int], calibrations: Mapping[CalibrationKey, Calibration]
    ) -> Settings | None:
        if self._product is None:
            return None
        return Settings(self._product, self._firmware, parameters, calibrations, self.notes.all)

    # --- Edits --------------------------------------------------------------------------

    @property
    def pending(self) -> int:
        return len(self.parameters.values.modified) + len(self.calibrations.modified)

    def is_modified(self, key: str) -> bool:
        if key in CALIBRATION_KEYS:
            return CALIBRATION_KEYS[key] in self.calibrations.modified
        return self.parameters.values.is_modified(key)

    def can_edit(self, key: str) -> bool:
        if key in CALIBRATION_KEYS:
            return self.calibrations.can_edit(CALIBRATION_KEYS[key])
        return self.parameters.values.can_edit(key)

    def stage(self, rows: Iterable[ComparisonRow], text: str) -> None:
        """Set settings and notes to the right side of a comparison.

        The edits form one undo step. Rows without an editable right side are skipped.

        Raises:
            BadRequest: a value is invalid for every board. Nothing is changed.
        """
        all_rows = list(rows)
        edits = [row for row in all_rows if row.after is not None and self.can_edit(row.key)]
        for row in edits:
            if isinstance(row.after, Calibration):
                row.after.encode()
            elif row.after is not None and row.after != self.parameters.values.stored.get(row.key):
                self.parameters.values.specs[row.key].check(row.after, forced=True)
        with self.one_edit(text):
            for row in edits:
                if isinstance(row.after, Calibration):
                    self.calibrations.edit(CALIBRATION_KEYS[row.key], row.after)
                elif row.after is not None:
                    self.parameters.edit(row.key, row.after, alone=True, forced=True)
            for row in all_rows:
                if row.adds_note:
                    self.notes.edit(row.key, row.note_after, name=row.name)

    def discard_edits(self) -> None:
        if self.pending:
            with self.one_edit(tr("Discard edits")):
                self.parameters.discard_edits()
                self.calibrations.discard_edits()

    @contextmanager
    def one_edit(self, text: str) -> Iterator[None]:
        """Combine edits into one undo step with this text. Without edits, add no step."""
        self.undo.beginMacro(text)
        try:
            yield
        finally:
            self.undo.endMacro()
            step = self.undo.command(self.undo.count() - 1)
            if step.childCount() == 0:
                step.setObsolete(True)
                self.undo.undo()


def diff_against_draft(
    draft: SettingsDraft, settings: Settings, *, is_stored: bool = False
) -> Comparison:
    """Return the changes that `settings` would make to the draft.

    If `is_stored`, edits in the draft are ignored. The result also names settings that the board
    lacks or does not accept now.

    Raises:
        BadRequest: the settings are for another model, or the draft is empty.
    """
    shown = draft.stored if is_stored else draft.shown
    if shown is None:
        raise BadRequest(tr("There are no settings to compare with"))
    if settings.product.key != shown.product.key:
        message = tr("These settings are for a {0}, not a {1}")
        raise BadRequest(message.format(settings.product.name, shown.product.name))
    known = shown.specs.readable_by_key
    unread = [key for key in settings.parameters if key in known and not draft.can_edit(key)]
    hidden = [key for key in settings.calibrations if not draft.can_edit(key)]
    result = compare(shown, settings.without([*unread, *hidden]))
    not_read = tr("{0} is left out because it could not be read from the board.")
    not_shown = tr(
        "The {0} calibrations are left out: the board accepts them only while its input "
        "source is {0}."
    )
    left_out = [not_read.format(known[key].name) for key in unread]
    left_out += [not_shown.format(name) for name in sorted({key.source.word for key in hidden})]
    return replace(result, left_out=(*result.left_out, *left_out))
