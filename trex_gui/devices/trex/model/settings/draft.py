"""The settings of a board or a file with their edits and undo."""

from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from dataclasses import replace

from PySide6.QtCore import QObject, Signal, Slot
from PySide6.QtGui import QUndoStack

from trex_gui.core.errors import BadRequest, sentence
from trex_gui.core.files import SettingsError
from trex_gui.devices.trex.client.reading import DeviceState
from trex_gui.devices.trex.model.parameters.parameters import ParameterModel
from trex_gui.devices.trex.model.settings.calibrations import Calibrations
from trex_gui.devices.trex.protocol.calibration import CALIBRATION_KEYS, Calibration
from trex_gui.devices.trex.protocol.device_table import Model
from trex_gui.devices.trex.protocol.flags import InputSource
from trex_gui.devices.trex.protocol.parameters import ParameterKey
from trex_gui.devices.trex.settings.comparison import Comparison, ComparisonRow, compare
from trex_gui.devices.trex.settings.document import Settings, specs_for
from trex_gui.devices.trex.settings.history import SettingsHistory
from trex_gui.ui.notifier import Notifier


class SettingsDraft(QObject):
    """What is stored, what is edited, and the undo stack that both kinds of edits share.

    Signals:
        loaded: what is stored was read anew.
        replacing: settings of another kind take this place next, and these edits go: what was
            shown, as `Settings`.
        pending_changed: how many edits wait.

    Attributes:
        undo: every edit since settings of this kind of board were there.
        parameters, calibrations: the two halves.
    """

    loaded = Signal()
    replacing = Signal(object)
    pending_changed = Signal(int)

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self.undo = QUndoStack(self)
        self.parameters = ParameterModel(self, self.undo)
        self.calibrations = Calibrations(self, self.undo)
        self._product: Model | None = None
        self._firmware: str | None = None

        self.parameters.pending_changed.connect(self._on_pending_changed)
        self.calibrations.pending_changed.connect(self._on_pending_changed)

    # --- What is stored -----------------------------------------------------------------

    def take_state(self, state: DeviceState, *, power_cycled: bool) -> None:
        """Take what a board stores; edits stay when it is the same kind of board."""
        model = state.signature.model
        self._begin(model, state.signature.firmware)
        self.parameters.load(state.specs, state.parameters, state.unread, power_cycled=power_cycled)
        self.calibrations.load(model.key, state.source, state.calibrations)
        self.loaded.emit()

    def note_stored(self, state: DeviceState) -> None:
        """Take what a board stores after a verified write."""
        self.parameters.note_stored(state.parameters)
        self.calibrations.note_stored(state.calibrations)

    def take_settings(self, settings: Settings) -> None:
        """Take what a file holds; a setting that it does not give can be given."""
        self._begin(settings.product, settings.firmware)
        specs = specs_for(settings.product, settings.firmware)
        source = InputSource.ANALOG if _is_analog(settings) else InputSource.RC
        self.parameters.load(specs, settings.parameters, {}, power_cycled=True, open_ended=True)
        self.calibrations.load_all(
            settings.product.key, source, settings.calibrations, open_ended=True
        )
        self.loaded.emit()

    def _begin(self, product: Model, firmware: str | None) -> None:
        if self._product is None or self._product.key != product.key:
            if self.pending:
                self.replacing.emit(self.shown)
            self.undo.clear()  # what was edited belonged to another kind of board
        self._product = product
        self._firmware = firmware

    @property
    def stored(self) -> Settings | None:
        """What the board or the file holds; `None` before the first."""
        if self._product is None:
            return None
        return Settings(
            self._product,
            self._firmware,
            self.parameters.all_stored,
            self.calibrations.all_stored,
        )

    @property
    def shown(self) -> Settings | None:
        """What would be held after Apply: stored values with the edits in their place."""
        if self._product is None:
            return None
        return Settings(
            self._product,
            self._firmware,
            self.parameters.all_shown,
            self.calibrations.all_shown,
        )

    # --- Edits --------------------------------------------------------------------------

    @property
    def pending(self) -> int:
        """How many edits of parameters and calibrations wait."""
        calibrations = len(self.calibrations.edited) + len(self.calibrations.left_out)
        return len(self.parameters.modified) + calibrations

    def stage(self, rows: Iterable[ComparisonRow], text: str) -> None:
        """Make what comes after in each of the rows an edit; together one step to undo.

        Rows that give nothing, or whose setting is not known here, are left out.

        Raises:
            BadRequest: a value is none that the board would take; nothing was changed.
        """
        wanted = [row for row in rows if row.after is not None and self.knows(row.key)]
        for row in wanted:
            self._check(row)
        with self.one_edit(text):
            for row in wanted:
                if isinstance(row.after, Calibration):
                    self.calibrations.edit(CALIBRATION_KEYS[row.key], row.after)
                elif row.after is not None:
                    self.parameters.edit(row.key, row.after, alone=True)

    def knows(self, key: str) -> bool:
        """Whether a setting can be edited: the board takes it now, or the file holds it."""
        if key in CALIBRATION_KEYS:
            return self.calibrations.knows(CALIBRATION_KEYS[key])
        return self.parameters.knows(key)

    def _check(self, row: ComparisonRow) -> None:
        if isinstance(row.after, Calibration):
            row.after.encode()
        elif row.after is not None and row.after != self.parameters.stored_of(row.key):
            self.parameters.spec_of(row.key).check(row.after)

    def discard_edits(self) -> None:
        """Go back to what is stored; one step to undo."""
        if self.pending:
            with self.one_edit(self.tr("Discard edits")):
                self.parameters.discard_edits()
                self.calibrations.discard_edits()

    @contextmanager
    def one_edit(self, text: str) -> Iterator[None]:
        """Let all edits made within be one step to undo and redo, under this name."""
        self.undo.beginMacro(text)
        try:
            yield
        finally:
            self.undo.endMacro()
            step = self.undo.command(self.undo.count() - 1)
            if step.childCount() == 0:  # nothing was another value: there is nothing to undo
                step.setObsolete(True)
                self.undo.undo()

    @Slot()
    def _on_pending_changed(self) -> None:
        self.pending_changed.emit(self.pending)


def _is_analog(settings: Settings) -> bool:
    """Whether a board with these settings reads voltages, as far as they tell."""
    return settings.parameters.get(ParameterKey.CHANNEL_INPUT_SOURCE) == 1


class EditBackup(QObject):
    """Saves what a draft shows before the settings of another kind replace it."""

    def __init__(
        self, history: SettingsHistory, notifier: Notifier, parent: QObject | None = None
    ) -> None:
        super().__init__(parent)
        self._notifier = notifier
        self._history = history

    @Slot(object)
    def keep(self, shown: Settings) -> None:
        """Save settings with edits that no board of their kind is there for any more."""
        name = f"{shown.product.name} {shown.firmware or ''}".strip()
        reason = self.tr("another board; with edits that were not applied")
        try:
            self._history.take(shown, adapter="", reason=reason)
        except SettingsError as error:
            text = self.tr("The edits for the {0} before could not be saved. {1}")
            self._notifier.error.emit(text.format(name, sentence(error)))
            return
        text = self.tr(
            "The settings of the {0} before, with the edits that were not applied, are kept in "
            "File, History."
        )
        self._notifier.delayed_info.emit(text.format(name))


def diff_against_draft(draft: SettingsDraft, settings: Settings) -> Comparison:
    """Compare what a draft shows with what it would show after taking other settings in.

    What the board does not take now, or does not have, is left out and named.

    Raises:
        BadRequest: the settings are for another model, or nothing is there to compare with.
    """
    shown = draft.shown
    if shown is None:
        raise BadRequest("no settings are there to compare with")
    if settings.product.key != shown.product.key:
        message = (
            f"these are settings of a {settings.product.name}, and here is a {shown.product.name}"
        )
        raise BadRequest(message)
    known = {spec.key for spec in shown.specs.readable}
    unread = [key for key in settings.parameters if key in known and not draft.knows(key)]
    hidden = [key for key in settings.calibrations if not draft.knows(key)]
    fitted = replace(
        settings,
        parameters={k: w for k, w in settings.parameters.items() if k not in unread},
        calibrations={
            key: calibration
            for key, calibration in settings.calibrations.items()
            if key not in hidden
        },
    )
    notes = [f"{key} is left out: it could not be read from the board." for key in unread]
    notes += [
        f"The {name} calibrations are left out: the board takes them only while its inputs are "
        f"read as {name}."
        for name in sorted({key.source.value for key in hidden})
    ]
    result = compare(shown, fitted)
    return replace(result, left_out=(*result.left_out, *notes))
