"""What the next bench test is: a form."""

from dataclasses import replace

from PySide6.QtCore import QSignalBlocker, Qt, Slot
from PySide6.QtWidgets import (
    QCheckBox,
    QComboBox,
    QDoubleSpinBox,
    QFormLayout,
    QLabel,
    QSpinBox,
    QVBoxLayout,
    QWidget,
)

from trex_gui.devices.trex.bench.profile import LONGEST, SHORTEST, Profile, Shape
from trex_gui.devices.trex.model.bench.bench import Bench, Plan
from trex_gui.devices.trex.model.driving.motors import Motors
from trex_gui.devices.trex.protocol.calibration import FULL_SCALE


class PlanForm(QWidget):
    """Edits the plan of a bench; greyed while a test runs."""

    def __init__(self, bench: Bench, motors: Motors, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("benchPlan")
        self._bench = bench
        self._motors = motors

        self._motor = self._combo("benchMotor", self.tr("Motor to test"))
        for motor in (1, 2):
            self._motor.addItem(self.tr("Motor {0}").format(motor), motor)
        self._shape = self._combo("benchShape", self.tr("Course of the speed"))
        for shape, text in (
            (Shape.STEP, self.tr("Step: at once")),
            (Shape.RAMP, self.tr("Ramp: rising evenly")),
            (Shape.REVERSE, self.tr("Reverse: to and fro")),
            (Shape.SINE, self.tr("Sine: swinging")),
        ):
            self._shape.addItem(text, shape)
        self._direction = self._combo("benchDirection", self.tr("Direction it begins with"))
        self._direction.addItem(self.tr("Forward"), 1)
        self._direction.addItem(self.tr("Reverse"), -1)
        self._speed = QSpinBox(self)
        self._speed.setObjectName("benchSpeed")
        self._speed.setAccessibleName(self.tr("Greatest speed of the test"))
        self._duration = self._seconds("benchDuration", self.tr("Length of the test"))
        self._period_name = QLabel(self)
        self._period = self._seconds("benchPeriod", self.tr("Period of the test"))
        self._period_name.setBuddy(self._period)
        self._sent = self._combo("benchSent", self.tr("How speeds are sent"))
        self._sent.addItem(self.tr("Accelerate"), True)
        self._sent.addItem(self.tr("Set at once"), False)
        self._sent.setToolTip(
            self.tr(
                "Accelerate goes through the board's acceleration, brake duration and current "
                "limit; Set at once bypasses the first two, and for a moment the limit, too."
            )
        )
        self._abort = QDoubleSpinBox(self)
        self._abort.setObjectName("benchAbort")
        self._abort.setAccessibleName(self.tr("Current to abort at"))
        self._abort.setSuffix(self.tr(" A"))
        self._abort.setDecimals(2)
        self._abort.setToolTip(
            self.tr("One reading above it stops all motors and disarms. A start draws the most.")
        )
        self._at_limit = QCheckBox(self.tr("Abort at the board's &limit, too"), self)
        self._at_limit.setObjectName("benchAbortAtLimit")
        self._at_limit.setToolTip(
            self.tr("Stop as soon as the board reports that its own current limit was passed.")
        )
        for box in (self._speed, self._duration, self._period, self._abort):
            box.setKeyboardTracking(False)
            box.setFocusPolicy(Qt.FocusPolicy.StrongFocus)

        form = QFormLayout()
        form.setContentsMargins(0, 0, 0, 0)
        form.setVerticalSpacing(3)
        form.setFieldGrowthPolicy(QFormLayout.FieldGrowthPolicy.AllNonFixedFieldsGrow)
        form.addRow(self.tr("&Motor"), self._motor)
        form.addRow(self.tr("&Course"), self._shape)
        form.addRow(self.tr("&Begins"), self._direction)
        form.addRow(self.tr("&Speed"), self._speed)
        form.addRow(self.tr("&Lasts"), self._duration)
        form.addRow(self._period_name, self._period)
        form.addRow(self.tr("Se&nt as"), self._sent)
        form.addRow(self.tr("Abort &above"), self._abort)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.setSpacing(3)
        layout.addLayout(form)
        layout.addWidget(self._at_limit)

        for combo in (self._motor, self._shape, self._direction, self._sent):
            combo.currentIndexChanged.connect(self._on_edited)
        for spin in (self._duration, self._period, self._abort):
            spin.valueChanged.connect(self._on_edited)
        self._speed.valueChanged.connect(self._on_edited)
        self._at_limit.toggled.connect(self._on_edited)
        bench.changed.connect(self._on_bench_changed)
        self._on_bench_changed()

    def _combo(self, name: str, accessible: str) -> QComboBox:
        combo = QComboBox(self)
        combo.setObjectName(name)
        combo.setAccessibleName(accessible)
        combo.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        return combo

    def _seconds(self, name: str, accessible: str) -> QDoubleSpinBox:
        box = QDoubleSpinBox(self)
        box.setObjectName(name)
        box.setAccessibleName(accessible)
        box.setSuffix(self.tr(" s"))
        box.setDecimals(2)
        box.setSingleStep(0.5)
        box.setRange(SHORTEST, LONGEST)
        return box

    @Slot()
    def _on_edited(self) -> None:
        plan = self._bench.plan
        shape: Shape = self._shape.currentData()
        profile = Profile(
            shape=shape,
            speed=self._speed.value() * int(self._direction.currentData()),
            duration=round(self._duration.value(), 2),
            period=round(self._period.value(), 2),
        )
        self._bench.set_plan(
            replace(
                plan,
                motor=int(self._motor.currentData()),
                profile=profile,
                accelerate=bool(self._sent.currentData()),
                abort_current=round(self._abort.value(), 2),
                abort_at_limit=self._at_limit.isChecked(),
            )
        )

    @Slot()
    def _on_bench_changed(self) -> None:
        plan = self._bench.plan
        self._show_period(plan)
        fields = (
            *(self._motor, self._shape, self._direction, self._speed, self._duration),
            *(self._period, self._sent, self._abort, self._at_limit),
        )
        blockers = [QSignalBlocker(field) for field in fields]
        ceiling = self._motors.ceiling
        self._speed.setRange(1, ceiling)
        self._speed.setSuffix(f" / {FULL_SCALE}")
        self._speed.setToolTip(self._speed_tip(ceiling))
        self._abort.setRange(0.1, self._bench.highest_current)
        self._abort.setSingleStep(0.5)
        self._motor.setCurrentIndex(self._motor.findData(plan.motor))
        self._shape.setCurrentIndex(self._shape.findData(plan.profile.shape))
        self._direction.setCurrentIndex(0 if plan.profile.speed > 0 else 1)
        _put(self._speed, abs(plan.profile.speed))
        _put(self._duration, plan.profile.duration)
        _put(self._period, plan.profile.period)
        self._sent.setCurrentIndex(0 if plan.accelerate else 1)
        _put(self._abort, plan.abort_current)
        self._at_limit.setChecked(plan.abort_at_limit)
        del blockers
        self.setEnabled(not self._bench.is_driving)

    def _show_period(self, plan: Plan) -> None:
        shape = plan.profile.shape
        self._period_name.setText(
            self.tr("&Rises in") if shape is Shape.RAMP else self.tr("&Period")
        )
        self._period_name.setEnabled(shape.has_period)
        self._period.setEnabled(shape.has_period)
        tips = {
            Shape.STEP: self.tr("A step has no period."),
            Shape.RAMP: self.tr("How long the speed rises before it stays."),
            Shape.REVERSE: self.tr("Half of it one way, half of it the other."),
            Shape.SINE: self.tr("One swing forward and back."),
        }
        self._period.setToolTip(tips[shape])

    def _speed_tip(self, ceiling: int) -> str:
        if ceiling < FULL_SCALE:
            return self.tr("1 to {0}, the speed ceiling of the Motors page").format(ceiling)
        return self.tr("1 to {0}, full speed").format(FULL_SCALE)


def _put(box: QSpinBox | QDoubleSpinBox, value: float) -> None:
    """Show a value, unless it is shown already: setting it would tidy what is being typed."""
    if box.value() == value:
        return
    if isinstance(box, QSpinBox):
        box.setValue(int(value))
    else:
        box.setValue(value)
