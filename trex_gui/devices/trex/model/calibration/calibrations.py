"""The channel calibrations: what is stored, for each input source, and the edits of it."""

from collections.abc import Mapping, Sequence

from PySide6.QtCore import QObject, Signal
from PySide6.QtGui import QUndoStack

from trex_gui.core.errors import BadRequest
from trex_gui.devices.trex.client.writing import WriteResult
from trex_gui.devices.trex.protocol.calibration import Calibration
from trex_gui.devices.trex.protocol.flags import InputSource
from trex_gui.ui.devices.undo import Edit

Place = tuple[InputSource, int]
"""An input source and a channel, 1-5: what one calibration is for."""


class Calibrations(QObject):
    """Stored beside edited; a board shows one of its two sets at a time, a file may hold both.

    Where no input source is named, the one in force is meant. Every edit goes over the undo
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
        self._stored: dict[Place, Calibration] = {}
        self._seen: dict[Place, Calibration] = {}
        self._edited: dict[Place, Calibration] = {}
        self._left_out: set[Place] = set()
        self._open_ended = False

    @property
    def source(self) -> InputSource:
        """The input source in force: a board takes calibrations for this one only."""
        return self._source

    @property
    def pending(self) -> tuple[tuple[int, Calibration], ...]:
        """What Apply would write: channel and calibration, of the input source in force."""
        edits = sorted(self._edited.items(), key=lambda item: item[0][1])
        return tuple((channel, c) for (source, channel), c in edits if source is self._source)

    @property
    def edited(self) -> dict[Place, Calibration]:
        """Every edit, whatever input source it is for."""
        return dict(self._edited)

    @property
    def left_out(self) -> frozenset[Place]:
        """What is stored and would be left out; only a file can do that."""
        return frozenset(self._left_out)

    @property
    def all_stored(self) -> dict[Place, Calibration]:
        """What is stored, as far as it is known."""
        return dict(self._stored)

    @property
    def all_shown(self) -> dict[Place, Calibration]:
        """What would be stored after Apply."""
        edits = {p: e for p, e in self._edited.items() if self._open_ended or p in self._stored}
        given = {**self._stored, **edits}
        return {place: given[place] for place in given if place not in self._left_out}

    @property
    def out_of_reach(self) -> tuple[Place, ...]:
        """Edits for the input source that the board does not show now; they are kept."""
        if self._open_ended:
            return ()
        return tuple(sorted((p for p in self._edited if p not in self._stored), key=_channel))

    def stored(self, channel: int, source: InputSource | None = None) -> Calibration | None:
        """What is stored for a channel; `None` when it is not known."""
        return self._stored.get((source or self._source, channel))

    def last_seen(self, channel: int, source: InputSource) -> Calibration | None:
        """What a board of this kind was last seen to store, also for the source not in force."""
        return self._seen.get((source, channel))

    def shown(self, channel: int, source: InputSource | None = None) -> Calibration | None:
        """What would be stored for a channel after Apply; `None` when it is not known."""
        return self._shown((source or self._source, channel))

    def _shown(self, place: Place) -> Calibration | None:
        if place in self._left_out:
            return None
        return self._edited.get(place, self._held(place))

    def _held(self, place: Place) -> Calibration | None:
        """What is stored, or was when the board showed it last."""
        if self._open_ended:
            return self._stored.get(place)
        return self._stored.get(place, self._seen.get(place))

    def knows(self, channel: int, source: InputSource | None = None) -> bool:
        """Whether there is a calibration, or could be one."""
        return self._open_ended or (source or self._source, channel) in self._stored

    def load(self, model_key: str, source: InputSource, stored: Mapping[int, Calibration]) -> None:
        """Take what was read of a board; edits stay while it is the same model.

        Those for the other input source wait until the board shows that again.
        """
        self.load_all(model_key, source, {(source, c): found for c, found in stored.items()})

    def load_all(
        self,
        model_key: str,
        source: InputSource,
        stored: Mapping[Place, Calibration],
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
        channel: int,
        wanted: Calibration,
        source: InputSource | None = None,
        *,
        run: object = None,
    ) -> None:
        """Take an edit; editing back to what is stored forgets it.

        Edits of a channel with the same `run`, one right after the other, are one step to undo.

        Raises:
            BadRequest: the board would refuse the values.
        """
        if problem := wanted.problem():
            raise BadRequest(f"calibration of channel {channel}: {problem}")
        place = (source or self._source, channel)
        before = self._shown(place)
        if wanted != before:
            text = self._text(channel)
            self._undo.push(Edit(text, self._put, place, before, wanted, run=run))

    def restore(self, channel: int) -> None:
        """Go back to what is stored for a channel, for the input source in force; an edit."""
        place = (self._source, channel)
        before, stored = self._shown(place), self._stored.get(place)
        if before != stored:
            self._undo.push(Edit(self._text(channel), self._put, place, before, stored))

    def leave_out(self, channel: int, source: InputSource | None = None) -> None:
        """Give no calibration for a channel, where that is possible; this can be undone."""
        place = (source or self._source, channel)
        before = self._shown(place)
        if self._open_ended and before is not None:
            self._undo.push(Edit(self._text(channel), self._put, place, before, None))

    def discard_edits(self) -> None:
        """Go back to what is stored; this can be undone."""
        if not self._edited and not self._left_out:
            return
        self._undo.beginMacro(self.tr("Discard edits"))
        for place in sorted({*self._edited, *self._left_out}, key=_channel):
            shown, stored = self._shown(place), self._held(place)
            self._undo.push(Edit(self._text(place[1]), self._put, place, shown, stored))
        self._undo.endMacro()

    def _text(self, channel: int) -> str:
        return self.tr("Calibration of channel {0}").format(channel)

    def _put(self, place: Place, wanted: Calibration | None) -> None:
        """Put a calibration in its place; one that was never seen is left alone."""
        if not self._open_ended and place[0] is not self._source and self._held(place) is None:
            return
        self._left_out.discard(place)
        if wanted is None or self._held(place) == wanted:
            self._edited.pop(place, None)
        else:
            self._edited[place] = wanted
        if self._open_ended and wanted is None and place in self._stored:
            self._left_out.add(place)
        self._announce()

    def take_results(self, results: Sequence[WriteResult]) -> None:
        """Take what was read back after a write."""
        for result in results:
            if isinstance(result.stored, Calibration) and result.channel is not None:
                place = (self._source, result.channel)
                self._stored[place] = self._seen[place] = result.stored
                if self._edited.get(place) == result.stored:
                    del self._edited[place]
        self._announce()

    def _announce(self) -> None:
        self.changed.emit()
        self.pending_changed.emit(len(self._edited) + len(self._left_out))


def _channel(place: Place) -> int:
    return place[1]
