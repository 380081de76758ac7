"""Power and jumpers of the simulated board: they belong together, power-up reads the jumpers."""

from PySide6.QtCore import Slot
from PySide6.QtWidgets import QCheckBox, QLabel, QPushButton, QWidget

from trex_gui.devices.trex.model.demo.board import DemoBoard
from trex_gui.devices.trex.model.demo.snapshot import DemoSnapshot
from trex_gui.devices.trex.views.demo.words import columns, jumper_hint
from trex_gui.ui.devices.demo.rows import Rows, side_by_side
from trex_gui.ui.theme.icons import set_icon
from trex_gui.ui.widgets.builders import NoWheelComboBox
from trex_gui.ui.widgets.labels import Note
from trex_gui.ui.widgets.sliders import StickSlider

_STEPS = 10  # slider positions in a volt
_LOWEST, _HIGHEST, _USUAL = 4.0, 16.0, 12.0  # V; below about 6 a TReX resets


class DemoSupply(Rows[DemoSnapshot]):
    """The switch, the battery and the jumpers."""

    def __init__(self, board: DemoBoard, parent: QWidget | None = None) -> None:
        super().__init__(columns(), parent)
        self.setTitle(self.tr("Power and jumpers"))
        self._board = board

        self._power = QCheckBox(self.tr("Power on"), self)
        self._power.setObjectName("demoPower")
        self._power.setToolTip(self.tr("The board's power switch: off, nothing answers"))
        self._cycle = QPushButton(self.tr("Power cycle"), self)
        self._cycle.setObjectName("demoPowerCycle")
        self._cycle.setToolTip(
            self.tr("Off for a second: jumpers are read, stored settings come into force")
        )
        set_icon(self._cycle, "power")
        self._battery = StickSlider(
            round(_LOWEST * _STEPS), round(_HIGHEST * _STEPS), round(_LOWEST * _STEPS), "bar", self
        )
        self._battery.setObjectName("demoBattery")
        self._battery.setValue(round(_USUAL * _STEPS))
        self._battery.setSingleStep(_STEPS // 2)
        self._battery.setAccessibleName(self.tr("Battery voltage"))
        self._battery.setToolTip(
            self.tr("A weak battery sags when the motors start, and the board resets")
        )
        self._volts = QLabel(self)
        self._volts.setObjectName("demoBatteryValue")
        self._at_board = QLabel(self)
        self._at_board.setObjectName("demoSupply")
        self._mode = NoWheelComboBox(self)
        self._mode.setObjectName("demoMode")
        self._mode.setAccessibleName(self.tr("Mode jumper"))
        self._mode.setToolTip(self.tr("The mode jumper; the board reads it when power comes on"))
        for text, mode in (
            (self.tr("No jumper: serial"), "serial"),
            (self.tr("RC"), "rc"),
            (self.tr("Analog"), "analog"),
        ):
            self._mode.addItem(text, mode)
        self._mix = QCheckBox(self.tr("Mix"), self)
        self._mix.setObjectName("demoMix")
        self._mix.setToolTip(
            self.tr("The mix jumper: input 2 drives forward, input 1 turns; acts at once")
        )
        self._so_ground = QCheckBox(self.tr("SO–G"), self)
        self._so_ground.setObjectName("demoSoGround")
        self._so_ground.setToolTip(
            self.tr("SO joined to ground; with Mix a power-up then learns the inputs' calibration")
        )
        for box in (self._power, self._mix, self._so_ground):
            box.setAccessibleName(box.text())
        self._hint = Note(1, self)
        self._hint.setObjectName("demoHint")

        self.add_wide(side_by_side(self, (self._power, 1), (self._cycle, 0)))
        self.add_row(self.tr("Battery"), self._battery, self._volts)
        self.add_words(self._at_board)
        self.add_wide(side_by_side(self, (self._mode, 1), (self._mix, 0), (self._so_ground, 0)))
        self.add_wide(self._hint)

        self._power.clicked.connect(board.set_power)
        self._cycle.clicked.connect(board.power_cycle)
        self._battery.valueChanged.connect(self._on_battery_moved)
        self._mode.activated.connect(self._on_mode_activated)
        self._mix.clicked.connect(board.set_mix)
        self._so_ground.clicked.connect(board.set_so_ground)

    def show_snapshot(self, snapshot: DemoSnapshot) -> None:
        """Show switch and jumpers as they are, and what waits for a power cycle."""
        self._power.setChecked(snapshot.power)
        self._battery.follow(round(snapshot.battery * _STEPS))
        self._show_volts()
        if not snapshot.power:
            self._at_board.setText(self.tr("switched off"))
        else:
            self._at_board.setText(self.tr("{0:.1f}\u00a0V at the board").format(snapshot.supply))
        index = self._mode.findData(snapshot.jumpers.mode)
        if index != self._mode.currentIndex() and not self._mode.view().isVisible():
            self._mode.setCurrentIndex(index)
        self._mix.setChecked(snapshot.jumpers.mix)
        self._so_ground.setChecked(snapshot.jumpers.so_ground)
        hint = jumper_hint(snapshot)
        self._hint.show_note(
            hint or self.tr("Mode is read at power-up; Mix acts at once."), alarming=bool(hint)
        )

    def controls(self) -> list[QWidget]:
        """Return everything that takes the focus, in the order of Tab."""
        return [
            self._power,
            self._cycle,
            self._battery,
            self._mode,
            self._mix,
            self._so_ground,
        ]

    def _show_volts(self) -> None:
        self._volts.setText(f"{self._battery.value() / _STEPS:.1f}\u00a0V")

    @Slot(int)
    def _on_battery_moved(self, position: int) -> None:
        self._show_volts()
        self._board.set_battery(position / _STEPS)

    @Slot(int)
    def _on_mode_activated(self, index: int) -> None:
        self._board.set_mode_jumper(str(self._mode.itemData(index)))
