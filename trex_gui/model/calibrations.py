"""The channel calibrations: what the board stores for the input source in force, and edits."""

from collections.abc import Mapping, Sequence

from PySide6.QtCore import QObject, Signal
from PySide6.QtGui import QUndoStack

from trex_gui.link.writing import Written
from trex_gui.model.undo import Edit
from trex_gui.protocol.calibration import Calibration
from trex_gui.protocol.errors import BadRequest
from trex_gui.protocol.flags import InputSource


class Calibrations(QObject):
    """Stored beside edited, by channel; the board shows only one of its two sets at a time.

    Every edit goes over the undo stack that it is given (or has one of its own).

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
        self._stored: dict[int, Calibration] = {}
        self._edited: dict[int, Calibration] = {}

    @property
    def source(self) -> InputSource:
        """The input source that the calibrations belong to."""
        return self._source

    @property
    def pending(self) -> tuple[tuple[int, Calibration], ...]:
        """What Apply would write: channel and calibration."""
        return tuple(sorted(self._edited.items()))

    @property
    def all_stored(self) -> dict[int, Calibration]:
        """What the board stores, by channel."""
        return dict(self._stored)

    def stored(self, channel: int) -> Calibration | None:
        """What the board stores for a channel; `None` when it was not read."""
        return self._stored.get(channel)

    def load(self, model_key: str, source: InputSource, stored: Mapping[int, Calibration]) -> None:
        """Take what was read; edits stay while model and input source are the same."""
        if (model_key, source) != (self._model_key, self._source):
            self._edited.clear()
        self._model_key = model_key
        self._source = source
        self._stored = dict(stored)
        self._edited = {c: e for c, e in self._edited.items() if self._stored.get(c) != e}
        self._announce()

    def edit(self, channel: int, wanted: Calibration) -> None:
        """Take an edit; editing back to what is stored forgets it.

        Raises:
            BadRequest: the board would refuse the values.
        """
        if problem := wanted.problem():
            raise BadRequest(f"calibration of channel {channel}: {problem}")
        before = self._edited.get(channel, self._stored.get(channel))
        if wanted != before:
            text = self.tr("Calibration of channel {0}").format(channel)
            self._undo.push(Edit(text, self._put, (self._source, channel), before, wanted))

    def discard_edits(self) -> None:
        """Go back to what is stored; this can be undone."""
        if not self._edited:
            return
        self._undo.beginMacro(self.tr("Discard edits"))
        for channel, edited in self.pending:
            text = self.tr("Calibration of channel {0}").format(channel)
            place = (self._source, channel)
            self._undo.push(Edit(text, self._put, place, edited, self._stored.get(channel)))
        self._undo.endMacro()

    def _put(self, place: tuple[InputSource, int], wanted: Calibration | None) -> None:
        """Put a calibration in its place; one of the input source that is hidden now is not."""
        source, channel = place
        if source is not self._source:
            return
        if wanted is None or self._stored.get(channel) == wanted:
            self._edited.pop(channel, None)
        else:
            self._edited[channel] = wanted
        self._announce()

    def take_results(self, results: Sequence[Written]) -> None:
        """Take what was read back after a write."""
        for result in results:
            if isinstance(result.stored, Calibration):
                channel = int(result.what.removeprefix("channel "))
                self._stored[channel] = result.stored
                if self._edited.get(channel) == result.stored:
                    del self._edited[channel]
        self._announce()

    def _announce(self) -> None:
        self.changed.emit()
        self.pending_changed.emit(len(self._edited))
