"""What hangs on the simulated board's motor outputs."""

from PySide6.QtCore import QObject, Slot
from PySide6.QtWidgets import QCheckBox, QLabel, QWidget

from trex_gui.devices.trex.model.demo.board import DemoBoard
from trex_gui.devices.trex.model.demo.snapshot import DemoMotor, DemoSnapshot
from trex_gui.devices.trex.views.demo.words import columns, motor_text
from trex_gui.ui.devices.demo.rows import Rows
from trex_gui.ui.widgets.sliders import StickSlider

_STEPS = 10  # slider positions in an ampere


class MotorRow(QObject):
    """One motor: how hard it has to work, whether its driver gave up, what it does."""

    def __init__(self, number: int, board: DemoBoard, rows: Rows[DemoSnapshot]) -> None:
        super().__init__(rows)
        self._number = number
        self._board = board

        self.load = StickSlider(0, 30 * _STEPS, 0, f"motor{number}", rows)
        self.load.setObjectName(f"demoLoad{number}")
        self.load.setSingleStep(_STEPS // 2)
        self.load.setPageStep(2 * _STEPS)
        self.load.setAccessibleName(self.tr("Load of motor {0}").format(number))
        self.load.setToolTip(
            self.tr(
                "The current that motor {0} draws once it runs; at the right end it stalls, and "
                "current limits and faults have something to do"
            ).format(number)
        )
        self._value = QLabel(rows)
        self._value.setObjectName(f"demoLoadValue{number}")
        self.fault = QCheckBox(rows)
        self.fault.setObjectName(f"demoFault{number}")
        self.fault.setAccessibleName(self.tr("Driver fault of motor {0}").format(number))
        self.fault.setToolTip(
            self.tr("The driver of motor {0} shuts down, as when hot or shorted").format(number)
        )
        self._doing = QLabel(rows)
        self._doing.setObjectName(f"demoMotor{number}")

        rows.add_row(self.tr("Motor {0}").format(number), self.load, self._value, (self.fault,))
        rows.add_words(self._doing)

        self.load.valueChanged.connect(self._on_load_moved)
        self.fault.clicked.connect(self._on_fault_clicked)

    def show_motor(self, seen: DemoMotor) -> None:
        """Show the motor as it is; the slider ends at the load that stalls it."""
        self.load.set_scale(0, round(seen.stall * _STEPS), 0)
        self.load.follow(round(seen.load * _STEPS))
        self._show_value()
        self.fault.setChecked(seen.fault)
        self._doing.setText(motor_text(seen))

    def _show_value(self) -> None:
        self._value.setText(f"{self.load.value() / _STEPS:.1f}\u00a0A")

    @Slot(int)
    def _on_load_moved(self, position: int) -> None:
        self._show_value()
        self._board.set_load(self._number, position / _STEPS)

    @Slot(bool)
    def _on_fault_clicked(self, fault: bool) -> None:
        self._board.set_fault(self._number, fault)


class DemoMotors(Rows[DemoSnapshot]):
    """Two motors."""

    def __init__(self, board: DemoBoard, parent: QWidget | None = None) -> None:
        super().__init__(columns(), parent)
        self.setTitle(self.tr("Motors"))
        self.add_headings(self.tr("Load"), self.tr("Fault"))
        self._rows = [MotorRow(number, board, self) for number in (1, 2)]

    def show_snapshot(self, snapshot: DemoSnapshot) -> None:
        """Show both motors."""
        for row, seen in zip(self._rows, snapshot.motors, strict=True):
            row.show_motor(seen)

    def controls(self) -> list[QWidget]:
        """Return everything that takes the focus, in the order of Tab."""
        return [widget for row in self._rows for widget in (row.load, row.fault)]
