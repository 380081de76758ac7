"""The wire to the simulated TReX, with the errors that its UART reports."""

from PySide6.QtCore import Slot
from PySide6.QtWidgets import QWidget

from trex_gui.devices.trex.model.demo.board import DemoBoard
from trex_gui.devices.trex.model.demo.snapshot import DemoSnapshot
from trex_gui.devices.trex.views.demo.words import columns
from trex_gui.ui.devices.demo.cable import CableRows


class DemoCable(CableRows[DemoSnapshot]):
    """The cable, and single bytes with an error of the serial line."""

    def __init__(self, board: DemoBoard, parent: QWidget | None = None) -> None:
        super().__init__(board, "demo", columns(), parent)
        self._board = board
        self.plugged.setToolTip(
            self.tr("Pulled out, the port is gone and motors run on unless Serial Timeout is set")
        )
        self.mute.setToolTip(
            self.tr("The wire from SO is broken: the board hears and obeys, nothing comes back")
        )
        self.noise.setToolTip(
            self.tr("This share of the bytes is spoilt on the way, either way; CRC finds them")
        )
        self.mishaps.setObjectName("demoByteError")
        self.mishaps.setAccessibleName(self.tr("Error of one byte"))
        self.mishaps.setToolTip(self.tr("An error of the serial line that the board reports"))
        for text, error in (
            (self.tr("Framing error"), "framing"),
            (self.tr("Parity error"), "parity"),
            (self.tr("Overrun"), "overrun"),
        ):
            self.mishaps.addItem(text, error)
        self.once.setText(self.tr("Spoil one byte"))
        self.once.setObjectName("demoSpoil")
        self.once.setToolTip(
            self.tr(
                "The next byte reaches the board with this error; the Status page counts it. "
                "A parity error is only seen by a board that uses parity."
            )
        )
        self.once.clicked.connect(self._on_spoil_clicked)

    @Slot()
    def _on_spoil_clicked(self) -> None:
        self._board.spoil(str(self.mishaps.currentData()))
