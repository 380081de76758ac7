"""The wire between this computer and the simulated board."""

from PySide6.QtCore import Slot
from PySide6.QtWidgets import QCheckBox, QLabel, QPushButton, QWidget

from trex_gui.model.demo_board import DemoBoard
from trex_gui.model.demo_snapshot import DemoSnapshot
from trex_gui.views.demo.rows import Rows, side_by_side
from trex_gui.views.widgets.calm_combo_box import CalmComboBox
from trex_gui.views.widgets.stick_slider import StickSlider

_STEPS = 10  # slider positions in a per cent
_HIGHEST = 5  # per cent of the bytes; more than that is no line any more


class DemoCable(Rows):
    """The plug, and what may go wrong with bytes on their way."""

    def __init__(self, board: DemoBoard, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setTitle(self.tr("Cable"))
        self._board = board

        self._plugged = QCheckBox(self.tr("Plugged in"), self)
        self._plugged.setObjectName("demoCable")
        self._plugged.setAccessibleName(self.tr("Cable plugged in"))
        self._plugged.setToolTip(
            self.tr("Pulled out, the port is gone and motors run on unless Serial Timeout is set")
        )
        self._mute = QCheckBox(self.tr("Answers lost"), self)
        self._mute.setObjectName("demoMute")
        self._mute.setAccessibleName(self.tr("Answers lost"))
        self._mute.setToolTip(
            self.tr("The wire from SO is broken: the board hears and obeys, nothing comes back")
        )
        self._noise = StickSlider(0, _HIGHEST * _STEPS, 0, "bar", self)
        self._noise.setObjectName("demoNoise")
        self._noise.setPageStep(_STEPS)
        self._noise.setAccessibleName(self.tr("Noise on the line"))
        self._noise.setToolTip(
            self.tr("This share of the bytes is spoilt on the way, either way; CRC finds them")
        )
        self._share = QLabel(self)
        self._share.setObjectName("demoNoiseValue")
        self._error = CalmComboBox(self)
        self._error.setObjectName("demoByteError")
        self._error.setAccessibleName(self.tr("Error of one byte"))
        self._error.setToolTip(self.tr("An error of the serial line that the board reports"))
        for text, error in (
            (self.tr("Framing error"), "framing"),
            (self.tr("Parity error"), "parity"),
            (self.tr("Overrun"), "overrun"),
        ):
            self._error.addItem(text, error)
        self._spoil = QPushButton(self.tr("Spoil one byte"), self)
        self._spoil.setObjectName("demoSpoil")
        self._spoil.setToolTip(
            self.tr(
                "The next byte reaches the board with this error; the Status page counts it. "
                "A parity error is only seen by a board that uses parity."
            )
        )

        self.add_wide(side_by_side(self, (self._plugged, 1), (self._mute, 1)))
        self.add_row(self.tr("Noise"), self._noise, self._share, None)
        self.add_wide(side_by_side(self, (self._error, 1), (self._spoil, 0)))

        self._plugged.clicked.connect(board.set_plugged)
        self._mute.clicked.connect(board.set_mute)
        self._noise.valueChanged.connect(self._on_noise_moved)
        self._spoil.clicked.connect(self._on_spoil_clicked)

    def show_snapshot(self, snapshot: DemoSnapshot) -> None:
        """Show the wire as it is."""
        line = snapshot.line
        self._plugged.setChecked(line.plugged)
        self._mute.setChecked(line.mute)
        self._noise.follow(round(line.noise * 100 * _STEPS))
        self._show_share()
        for widget in (self._mute, self._noise, self._error, self._spoil):
            widget.setEnabled(line.plugged)

    def controls(self) -> list[QWidget]:
        """Return everything that takes the focus, in the order of Tab."""
        return [self._plugged, self._mute, self._noise, self._error, self._spoil]

    def _show_share(self) -> None:
        self._share.setText(f"{self._noise.value() / _STEPS:.1f}\u00a0%")

    @Slot(int)
    def _on_noise_moved(self, position: int) -> None:
        self._show_share()
        self._board.set_noise(position / _STEPS / 100)

    @Slot()
    def _on_spoil_clicked(self) -> None:
        self._board.spoil(str(self._error.currentData()))
