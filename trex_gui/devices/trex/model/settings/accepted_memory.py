"""Values beyond inferred limits that boards of this kind have stored: see `AcceptedValues`."""

from functools import partial

from PySide6.QtCore import QObject, Signal

from trex_gui.core.errors import StudioError
from trex_gui.devices.trex.model.parameters.parameters import ParameterModel
from trex_gui.devices.trex.protocol.commands import Signature
from trex_gui.devices.trex.session.messages import Written
from trex_gui.devices.trex.settings.accepted import AcceptedValues
from trex_gui.devices.trex.settings.document import open_values
from trex_gui.ui.files import in_background
from trex_gui.ui.translations import error_text


class AcceptedMemory(QObject):
    """Tells the parameters what boards have accepted, and remembers what one accepts now.

    A simulated board says nothing about real ones.
    """

    failed = Signal(str)  # why something was not remembered, for the user

    def __init__(self, parameters: ParameterModel, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._parameters = parameters
        self._values = AcceptedValues()
        self._board: Signature | None = None
        self._is_simulated = False

    def take_board(self, board: Signature, *, opened: bool, is_simulated: bool) -> None:
        """Take what boards of this kind have stored, if it is another one, or `opened`."""
        self._is_simulated = is_simulated
        if opened or board != self._board:
            self._board = board
            self._parameters.set_accepted({})
            if not is_simulated:
                read, then = partial(self._values.of, board), self._parameters.set_accepted
                in_background(self, read, then, self._on_failed)

    def note_written(self, written: Written) -> None:
        verified = {
            result.key: result.stored
            for result in written.results
            if result.error is None and isinstance(result.stored, int)
        }
        if (values := open_values(written.state.specs, verified)) and not self._is_simulated:
            add = partial(self._values.add, written.state.signature, values)
            in_background(self, add, self._parameters.set_accepted, self._on_failed)

    def _on_failed(self, error: StudioError) -> None:
        text = self.tr("What the board accepted was not remembered. {0}")
        self.failed.emit(text.format(error_text(error)))
