"""The channel calibrations: what is stored, for each input source, and the edits of it."""

from collections.abc import Mapping

from PySide6.QtCore import QObject, Signal
from PySide6.QtGui import QUndoStack

from trex_gui.core.errors import BadRequest
from trex_gui.devices.trex.protocol.calibration import Calibration, CalibrationKey
from trex_gui.devices.trex.protocol.flags import InputSource
from trex_gui.ui.devices.undo import Edit

Channel = int | CalibrationKey
"""A channel, 1-5, of the input source in force; or a key."""


class Calibrations(QObject):
    """Stored beside edited; a board shows one of its two sets at a time, a file may hold both.

    Every edit goes over the undo
    stack that it is given (or has one of its own).

    Signals:
        changed: a stored or an edited calibration.
        pending_changed: how many edits wait.
    """

    changed = Signal()
    pending_changed = Signal(int)

    def __init__(self, parent: QObject | None = None, undo: QUndoStack | None = None) -> None:
        super().__init__(parent)
        self._undo = undo or QUndoStack(self)
        self._model_key = ""
        self._source = InputSource.RC
        self._stored: dict[CalibrationKey, Calibration] = {}
        self._seen: dict[CalibrationKey, Calibration] = {}
        self._edited: dict[CalibrationKey, Calibration] = {}
        self._left_out: set[CalibrationKey] = set()
        self._open_ended = False

    @property
    def source(self) -> InputSource:
        """The input source in force: a board takes calibrations for this one only."""
        return self._source

    @property
    def pending(self) -> tuple[tuple[CalibrationKey, Calibration], ...]:
        """What Apply would write: the edits for the input source in force, by channel."""
        return tuple((k, self._edited[k]) for k in sorted(self._edited) if k.source is self._source)

    @property
    def edited(self) -> dict[CalibrationKey, Calibration]:
        """Every edit, whatever input source it is for."""
        return dict(self._edited)

    @property
    def left_out(self) -> frozenset[CalibrationKey]:
        """What is stored and would be left out; only a file can do that."""
        return frozenset(self._left_out)

    @property
    def all_stored(self) -> dict[CalibrationKey, Calibration]:
        """What is stored, as far as it is known."""
        return dict(self._stored)

    @property
    def all_shown(self) -> dict[CalibrationKey, Calibration]:
        """What would be stored after Apply."""
        edits = {p: e for p, e in self._edited.items() if self._open_ended or p in self._stored}
        given = {**self._stored, **edits}
        return {key: given[key] for key in given if key not in self._left_out}

    @property
    def out_of_reach(self) -> tuple[CalibrationKey, ...]:
        """Edits for the input source that the board does not show now; they are kept."""
        if self._open_ended:
            return ()
        return tuple(
            sorted((p for p in self._edited if p not in self._stored), key=lambda key: key.channel)
        )

    def stored(self, channel: Channel) -> Calibration | None:
        """What is stored for a channel; `None` when it is not known."""
        return self._stored.get(self._key(channel))

    def last_seen(self, channel: int, source: InputSource) -> Calibration | None:
        """What a board of this kind was last seen to store, also for the source not in force."""
        return self._seen.get(CalibrationKey.of(source, channel))

    def shown(self, channel: Channel) -> Calibration | None:
        """What would be stored for a channel after Apply; `None` when it is not known."""
        return self._shown(self._key(channel))

    def _shown(self, key: CalibrationKey) -> Calibration | None:
        if key in self._left_out:
            return None
        return self._edited.get(key, self._held(key))

    def _held(self, key: CalibrationKey) -> Calibration | None:
        """What is stored, or was when the board showed it last."""
        if self._open_ended:
            return self._stored.get(key)
        return self._stored.get(key, self._seen.get(key))

    def knows(self, channel: Channel) -> bool:
        """Whether there is a calibration, or could be one."""
        return self._open_ended or self._key(channel) in self._stored

    def load(self, model_key: str, source: InputSource, stored: Mapping[int, Calibration]) -> None:
        """Take what was read of a board; edits stay while it is the same model.

        Those for the other input source wait until the board shows that again.
        """
        keyed = {CalibrationKey.of(source, c): found for c, found in stored.items()}
        self.load_all(model_key, source, keyed)

    def load_all(
        self,
        model_key: str,
        source: InputSource,
        stored: Mapping[CalibrationKey, Calibration],
        *,
        open_ended: bool = False,
    ) -> None:
        """Take what was read for both input sources; `source` is the one in force.

        With `open_ended` (a file) what is not stored can be given, and what is can be left out.
        """
        if model_key != self._model_key:
            self._edited.clear()
            self._left_out.clear()
            self._seen.clear()
        self._model_key = model_key
        self._source = source
        self._open_ended = open_ended
        self._stored = dict(stored)
        self._seen.update(self._stored)
        self._edited = {p: e for p, e in self._edited.items() if self._held(p) != e}
        self._left_out &= self._stored.keys()
        self._announce()

    def edit(
        self,
        channel: Channel,
        wanted: Calibration,
        *,
        run: object = None,
    ) -> None:
        """Take an edit; editing back to what is stored forgets it.

        Edits of a channel with the same `run`, one right after the other, are one step to undo.

        Raises:
            BadRequest: the board would refuse the values.
        """
        key = self._key(channel)
        if problem := wanted.problem():
            raise BadRequest(f"calibration of channel {key.channel}: {problem}")
        before = self._shown(key)
        if wanted != before:
            self._undo.push(Edit(self._text(key), self._put, key, before, wanted, run=run))

    def restore(self, channel: int) -> None:
        """Go back to what is stored for a channel, for the input source in force; an edit."""
        key = self._key(channel)
        before, stored = self._shown(key), self._stored.get(key)
        if before != stored:
            self._undo.push(Edit(self._text(key), self._put, key, before, stored))

    def leave_out(self, channel: Channel) -> None:
        """Give no calibration for a channel, where that is possible; this can be undone."""
        key = self._key(channel)
        before = self._shown(key)
        if self._open_ended and before is not None:
            self._undo.push(Edit(self._text(key), self._put, key, before, None))

    def discard_edits(self) -> None:
        """Go back to what is stored; this can be undone."""
        if not self._edited and not self._left_out:
            return
        self._undo.beginMacro(self.tr("Discard edits"))
        for key in sorted({*self._edited, *self._left_out}, key=lambda key: key.channel):
            shown, stored = self._shown(key), self._held(key)
            self._undo.push(Edit(self._text(key), self._put, key, shown, stored))
        self._undo.endMacro()

    def _key(self, channel: Channel) -> CalibrationKey:
        if isinstance(channel, CalibrationKey):
            return channel
        return CalibrationKey.of(self._source, channel)

    def _text(self, key: CalibrationKey) -> str:
        return self.tr("Calibration of channel {0}").format(key.channel)

    def _put(self, key: CalibrationKey, wanted: Calibration | None) -> None:
        """Put a calibration in its key; one that was never seen is left alone."""
        if not self._open_ended and key.source is not self._source and self._held(key) is None:
            return
        self._left_out.discard(key)
        if wanted is None or self._held(key) == wanted:
            self._edited.pop(key, None)
        else:
            self._edited[key] = wanted
        if self._open_ended and wanted is None and key in self._stored:
            self._left_out.add(key)
        self._announce()

    def note_stored(self, stored: Mapping[int, Calibration]) -> None:
        """Take the stored calibrations of the input source in force after a verified write."""
        for channel, calibration in stored.items():
            key = self._key(channel)
            if self._stored.get(key) != calibration:
                self._stored[key] = self._seen[key] = calibration
                if self._edited.get(key) == calibration:
                    del self._edited[key]
        self._announce()

    def _announce(self) -> None:
        self.changed.emit()
        self.pending_changed.emit(len(self._edited) + len(self._left_out))
