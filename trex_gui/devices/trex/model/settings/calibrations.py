"""Channel calibrations with their edits."""

from collections.abc import Mapping

from PySide6.QtCore import QObject, Signal
from PySide6.QtGui import QUndoStack

from trex_gui.core.errors import BadRequest
from trex_gui.core.translation import tr
from trex_gui.devices.trex.protocol.calibration import Calibration, CalibrationKey
from trex_gui.devices.trex.protocol.flags import InputSource
from trex_gui.ui.devices.undo import Edit

Channel = int | CalibrationKey  # a key, or a channel (1-5) of the active input source


class Calibrations(QObject):
    """Calibrations of both input sources. A board reports only those of the active source."""

    changed = Signal()  # a stored or an edited calibration has changed

    def __init__(self, parent: QObject | None = None, undo: QUndoStack | None = None) -> None:
        super().__init__(parent)
        self.source = InputSource.RC  # the only source for which a board accepts calibrations
        self.edited: dict[CalibrationKey, Calibration] = {}  # edits for both input sources
        self.removed: set[CalibrationKey] = set()  # stored keys that Save omits
        self._undo = undo or QUndoStack(self)
        self._model_key = ""
        self._stored: dict[CalibrationKey, Calibration] = {}
        self._last_known: dict[CalibrationKey, Calibration] = {}  # includes the inactive source
        self._open_ended = False  # a file, in which every calibration is optional

    # --- Values -------------------------------------------------------------------------

    @property
    def pending(self) -> tuple[tuple[CalibrationKey, Calibration], ...]:
        """Edits for the active input source, which Apply writes."""
        return tuple((k, self.edited[k]) for k in sorted(self.edited) if k.source is self.source)

    @property
    def modified(self) -> list[CalibrationKey]:
        return sorted(self.edited.keys() | self.removed)

    @property
    def all_stored(self) -> dict[CalibrationKey, Calibration]:
        return dict(self._stored)

    @property
    def all_shown(self) -> dict[CalibrationKey, Calibration]:
        """Calibrations after Apply or Save."""
        edits = {k: e for k, e in self.edited.items() if self.can_edit(k)}
        return {k: c for k, c in {**self._stored, **edits}.items() if k not in self.removed}

    @property
    def out_of_reach(self) -> list[CalibrationKey]:
        """Keys of edits that the board does not accept now."""
        return [key for key in self.modified if not self.can_edit(key)]

    def stored(self, channel: Channel) -> Calibration | None:
        return self._stored.get(self._key(channel))

    def shown(self, channel: Channel) -> Calibration | None:
        """Return the calibration after Apply or Save. `None` if there is none."""
        key = self._key(channel)
        return None if key in self.removed else self.edited.get(key, self._latest(key))

    def can_edit(self, channel: Channel) -> bool:
        return self._open_ended or self._key(channel) in self._stored

    def _latest(self, key: CalibrationKey) -> Calibration | None:
        """Return the stored calibration, or else the last known calibration."""
        last_known = None if self._open_ended else self._last_known.get(key)
        return self._stored.get(key, last_known)

    def _key(self, channel: Channel) -> CalibrationKey:
        if isinstance(channel, CalibrationKey):
            return channel
        return CalibrationKey.of(self.source, channel)

    # --- Reports from the device --------------------------------------------------------

    def load(
        self,
        model_key: str,
        source: InputSource,
        stored: Mapping[int, Calibration] | Mapping[CalibrationKey, Calibration],
        *,
        open_ended: bool = False,
        keep_edits: bool = True,
    ) -> None:
        """Load stored calibrations.

        `keep_edits` retains edits if the model is the same. `open_ended` is for a file, in which
        every calibration is optional.
        """
        if model_key != self._model_key or not keep_edits:
            self.edited.clear()
            self.removed.clear()
            self._last_known.clear()
        self._model_key = model_key
        self.source = source
        self._open_ended = open_ended
        self._stored = {self._key(channel): calibration for channel, calibration in stored.items()}
        self._last_known.update(self._stored)
        self.edited = {k: e for k, e in self.edited.items() if self._latest(k) != e}
        self.removed &= self._stored.keys()
        self.changed.emit()

    def clear_last_known(self) -> None:
        """Clear the last known calibrations, except for edited channels."""
        known = self._last_known.items()
        self._last_known = {key: value for key, value in known if key in self.edited}

    def record_stored(self, stored: Mapping[int, Calibration]) -> None:
        for channel, calibration in stored.items():
            key = self._key(channel)
            if self._stored.get(key) != calibration:
                self._stored[key] = self._last_known[key] = calibration
                if self.edited.get(key) == calibration:
                    del self.edited[key]
        self.changed.emit()

    # --- Edits --------------------------------------------------------------------------

    def edit(self, channel: Channel, calibration: Calibration, *, run: object = None) -> None:
        """Edit a calibration. Setting the stored calibration removes the edit.

        Consecutive edits with the same `run` form one undo step.

        Raises:
            BadRequest: the board would reject the values.
        """
        key = self._key(channel)
        if problem := calibration.problem():
            raise BadRequest(tr("calibration of channel {0}: {1}").format(key.channel, problem))
        self._change(key, calibration, run=run)

    def restore(self, channel: int) -> None:
        self._change(self._key(channel), self.stored(channel))

    def remove(self, channel: Channel) -> None:
        """Remove a calibration from a file. Has no effect on a board."""
        if self._open_ended:
            self._change(self._key(channel), None)

    def discard_edits(self) -> None:
        for key in self.modified:
            self._change(key, self._latest(key))

    def _change(
        self, key: CalibrationKey, calibration: Calibration | None, *, run: object = None
    ) -> None:
        before = self.shown(key)
        if calibration != before:
            text = tr("Calibration of channel {0}").format(key.channel)
            self._undo.push(Edit(text, self._apply_edit, key, before, calibration, run=run))

    def _apply_edit(self, key: CalibrationKey, calibration: Calibration | None) -> None:
        latest = self._latest(key)
        if not self._open_ended and key.source is not self.source and latest is None:
            return
        self.removed.discard(key)
        if calibration is None or latest == calibration:
            self.edited.pop(key, None)
        else:
            self.edited[key] = calibration
        if self._open_ended and calibration is None and key in self._stored:
            self.removed.add(key)
        self.changed.emit()
