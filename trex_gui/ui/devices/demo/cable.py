"""The wire between this computer and a simulated device."""

from PySide6.QtCore import Slot
from PySide6.QtWidgets import QCheckBox, QLabel, QPushButton, QWidget

from trex_gui.ui.devices.demo.rows import Columns, Rows, side_by_side
from trex_gui.ui.devices.demo_device import DemoDevice, SnapshotT
from trex_gui.ui.widgets.builders import NoWheelComboBox
from trex_gui.ui.widgets.sliders import StickSlider

_STEPS = 10  # slider positions in a per cent
_HIGHEST = 5  # per cent of the bytes; more than that is no line any more


class CableRows(Rows[SnapshotT]):
    """The plug, and what may go wrong with bytes on their way.

    Who derives from it says in tool tips what each does to the device, and puts into `mishaps`
    what may happen once, with what `once` then does.
    """

    def __init__(
        self,
        device: DemoDevice[SnapshotT],
        prefix: str,
        columns: Columns,
        parent: QWidget | None = None,
    ) -> None:
        """Handle the wire of `device`; object names begin with `prefix`."""
        super().__init__(columns, parent)
        self.setTitle(self.tr("CableRows"))
        self._device = device

        self.plugged = QCheckBox(self.tr("Plugged in"), self)
        self.plugged.setObjectName(f"{prefix}Cable")
        self.plugged.setAccessibleName(self.tr("Cable plugged in"))
        self.mute = QCheckBox(self.tr("Answers lost"), self)
        self.mute.setObjectName(f"{prefix}Mute")
        self.mute.setAccessibleName(self.tr("Answers lost"))
        self.noise = StickSlider(0, _HIGHEST * _STEPS, 0, "bar", self)
        self.noise.setObjectName(f"{prefix}Noise")
        self.noise.setPageStep(_STEPS)
        self.noise.setAccessibleName(self.tr("Noise on the line"))
        self._share = QLabel(self)
        self._share.setObjectName(f"{prefix}NoiseValue")
        self.mishaps = NoWheelComboBox(self)
        self.once = QPushButton(self)

        self.add_wide(side_by_side(self, (self.plugged, 1), (self.mute, 1)))
        self.add_row(self.tr("Noise"), self.noise, self._share)
        self.add_wide(side_by_side(self, (self.mishaps, 1), (self.once, 0)))

        self.plugged.clicked.connect(device.set_plugged)
        self.mute.clicked.connect(device.set_mute)
        self.noise.valueChanged.connect(self._on_noise_moved)

    def show_snapshot(self, snapshot: SnapshotT) -> None:
        """Show the wire as it is."""
        line = snapshot.line
        self.plugged.setChecked(line.plugged)
        self.mute.setChecked(line.mute)
        self.noise.follow(round(line.noise * 100 * _STEPS))
        self._show_share()
        for widget in self.controls()[1:]:
            widget.setEnabled(line.plugged)

    def controls(self) -> list[QWidget]:
        """Return everything that takes the focus, in the order of Tab."""
        return [self.plugged, self.mute, self.noise, self.mishaps, self.once]

    def _show_share(self) -> None:
        self._share.setText(f"{self.noise.value() / _STEPS:.1f}\u00a0%")

    @Slot(int)
    def _on_noise_moved(self, position: int) -> None:
        self._show_share()
        self._device.set_noise(position / _STEPS / 100)
