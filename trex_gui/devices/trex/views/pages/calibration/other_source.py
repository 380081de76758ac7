"""What to do when the calibrations of the other input source are wanted."""

from PySide6.QtCore import Signal, Slot
from PySide6.QtWidgets import QHBoxLayout, QLabel, QPushButton, QVBoxLayout, QWidget

from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.protocol.channel_text import SOURCE_NAMES, way_to
from trex_gui.devices.trex.protocol.flags import InputSource
from trex_gui.devices.trex.protocol.parameter_keys import ParameterKey
from trex_gui.ui.devices.connection_state import ConnectionState
from trex_gui.ui.theme.icons import set_icon

_KEY = ParameterKey.CHANNEL_INPUT_SOURCE


class OtherSource(QWidget):
    """Says how the board comes to read the other source, and makes the edit for it.

    Signals:
        power_cycle_requested: the edit is stored; lead through switching off and on.
    """

    power_cycle_requested = Signal()

    def __init__(self, device: Device, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._device = device
        self._source = InputSource.ANALOG
        self._words = QLabel(self)
        self._words.setObjectName("otherSourceWords")
        self._words.setWordWrap(True)
        self._switch = QPushButton(self)
        self._switch.setObjectName("switchSourceButton")
        self._switch.setAccessibleName(self.tr("Read the other input source"))
        set_icon(self._switch, "calibrate")
        self._cycle = QPushButton(self.tr("Make active…"), self)
        self._cycle.setObjectName("switchSourceCycleButton")
        set_icon(self._cycle, "power")
        buttons = QHBoxLayout()
        buttons.addWidget(self._switch)
        buttons.addWidget(self._cycle)
        buttons.addStretch(1)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.addWidget(self._words)
        layout.addLayout(buttons)

        self._switch.clicked.connect(self._on_switch_clicked)
        self._cycle.clicked.connect(self.power_cycle_requested)

    def show_source(self, source: InputSource, seen: bool) -> None:
        """Speak of a source that is not in force; `seen`: its calibrations are shown below."""
        state = self._device.state
        self._source = source
        name = SOURCE_NAMES[source]
        self._switch.setText(self.tr("Read {0} after the next power cycle").format(name))
        if state is None:
            self._words.setText(self.tr("No board answers."))
            self._switch.hide()
            self._cycle.hide()
            return
        parameters, wire = self._device.parameters, int(source is InputSource.ANALOG)
        is_up = self._device.link is ConnectionState.CONNECTED
        is_wished = parameters.value_of(_KEY) == wire
        is_stored = parameters.stored_of(_KEY) == wire
        words = way_to(source, state.mode)
        if state.mode.is_serial and is_stored and is_wished:
            words = self.tr(
                "The board reads {0} once it is switched off and on: that is stored."
            ).format(name)
        elif state.mode.is_serial and is_wished:
            words = self.tr(
                "The board is to read {0}: apply this edit, then switch the board off and on."
            ).format(name)
        kept = (
            self.tr("Below is what was last seen of them since the program was started.")
            if seen
            else self.tr("None of them were seen since the program was started.")
        )
        self._words.setText(f"{words} {kept}")
        self._switch.setVisible(state.mode.is_serial and not is_wished)
        self._switch.setEnabled(is_up and parameters.knows(_KEY))
        self._cycle.setVisible(state.mode.is_serial and is_wished and is_stored)
        self._cycle.setEnabled(is_up)

    @Slot()
    def _on_switch_clicked(self) -> None:
        self._device.parameters.edit(_KEY, int(self._source is InputSource.ANALOG))
