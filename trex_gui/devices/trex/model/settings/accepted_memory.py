"""Values beyond inferred limits that boards of this kind have stored: see `AcceptedValues`."""

from collections.abc import Mapping
from functools import partial

from PySide6.QtCore import QObject, Signal

from trex_gui.core.errors import StudioError
from trex_gui.core.translation import tr
from trex_gui.devices.trex.model.parameters.parameters import ParameterModel
from trex_gui.devices.trex.protocol.commands import Signature
from trex_gui.devices.trex.settings.accepted import AcceptedValues
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

    def take_board(self, board: Signature, *, opened: bool, is_simulated: bool) -> None:
        """Take what boards of this kind have stored, if it is another one, or `opened`."""
        if opened or board != self._board:
            self._board = board
            self._parameters.set_accepted({})
            if not is_simulated:
                read, then = partial(self._values.of, board), self._parameters.set_accepted
                in_background(self, read, then, self._on_failed)

    def add(self, kind: Signature, values: Mapping[str, int]) -> None:
        """Remember what a real board has stored."""
        add = partial(self._values.add, kind, values)
        in_background(self, add, self._parameters.set_accepted, self._on_failed)

    def _on_failed(self, error: StudioError) -> None:
        text = tr("What the board accepted was not remembered. {0}")
        self.failed.emit(text.format(error_text(error)))
