"""A form for the next bench test."""

from dataclasses import replace

from PySide6.QtCore import QSignalBlocker, Qt, Slot
from PySide6.QtWidgets import QDoubleSpinBox, QFormLayout, QSpinBox, QWidget

from trex_gui.devices.trex.bench.profile import LONGEST, SHORTEST, Plan, Profile, Shape
from trex_gui.devices.trex.model.bench import Bench
from trex_gui.devices.trex.model.motors import Motors
from trex_gui.devices.trex.protocol.calibration import FULL_SCALE
from trex_gui.ui.widgets.builders import (
    check_box,
    column,
    combo_box,
    double_spin_box,
    label,
    spin_box,
)


class PlanForm(QWidget):
    """Edits the plan of a bench; disabled while a test runs."""

    def __init__(self, bench: Bench, motors: Motors, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("benchPlan")
        self._bench = bench
        self._motors = motors
        edited = self._on_edited

        self._motor = combo_box(
            self,
            "benchMotor",
            self.tr("Motor to test"),
            items=[(self.tr("Motor {0}").format(motor), motor) for motor in (1, 2)],
            on_change=edited,
        )
        self._shape = combo_box(
            self,
            "benchShape",
            self.tr("Speed profile"),
            items=[
                (self.tr("Step: at once"), Shape.STEP),
                (self.tr("Ramp: rising linearly"), Shape.RAMP),
                (self.tr("Reverse: back and forth"), Shape.REVERSE),
                (self.tr("Sine"), Shape.SINE),
            ],
            on_change=edited,
        )
        self._direction = combo_box(
            self,
            "benchDirection",
            self.tr("First direction"),
            items=[(self.tr("Forward"), 1), (self.tr("Reverse"), -1)],
            on_change=edited,
        )
        self._speed = spin_box(
            self,
            "benchSpeed",
            self.tr("Highest speed of the test"),
            1,
            FULL_SCALE,
            suffix=f" / {FULL_SCALE}",
            on_change=edited,
        )
        self._duration = self._seconds("benchDuration", self.tr("Duration of the test"))
        self._period = self._seconds("benchPeriod", self.tr("Period of the test"))
        self._period_name = label(self, buddy=self._period)
        self._sent = combo_box(
            self,
            "benchSent",
            self.tr("How setpoints are sent"),
            items=[(self.tr("Accelerate"), True), (self.tr("Set at once"), False)],
            tip=self.tr(
                "Accelerate uses the board's acceleration, brake duration and current limit; "
                "Set at once bypasses the first two, and for a moment the limit, too."
            ),
            on_change=edited,
        )
        self._abort = double_spin_box(
            self,
            "benchAbort",
            self.tr("Abort current"),
            0.1,
            bench.highest_current,
            decimals=2,
            step=0.5,
            suffix=self.tr(" A"),
            tip=self.tr("One reading above it stops and disarms all motors. A start draws most."),
            on_change=edited,
        )
        self._at_limit = check_box(
            self,
            "benchAbortAtLimit",
            self.tr("Abort at the board's &limit, too"),
            tip=self.tr("Stop when the board reports that its own current limit was exceeded."),
            on_toggle=edited,
        )
        for box in (self._speed, self._duration, self._period, self._abort):
            box.setFocusPolicy(Qt.FocusPolicy.StrongFocus)

        form = QFormLayout()
        form.setContentsMargins(0, 0, 0, 0)
        form.setVerticalSpacing(3)
        form.setFieldGrowthPolicy(QFormLayout.FieldGrowthPolicy.AllNonFixedFieldsGrow)
        form.addRow(self.tr("&Motor"), self._motor)
        form.addRow(self.tr("Pro&file"), self._shape)
        form.addRow(self.tr("&Begins"), self._direction)
        form.addRow(self.tr("&Speed"), self._speed)
        form.addRow(self.tr("&Duration"), self._duration)
        form.addRow(self._period_name, self._period)
        form.addRow(self.tr("Se&nt as"), self._sent)
        form.addRow(self.tr("Abort &above"), self._abort)
        column(form, self._at_limit, into=self, margins=0, spacing=3)

        bench.changed.connect(self._on_bench_changed)
        self._on_bench_changed()

    def _seconds(self, name: str, accessible: str) -> QDoubleSpinBox:
        return double_spin_box(
            self,
            name,
            accessible,
            SHORTEST,
            LONGEST,
            decimals=2,
            step=0.5,
            suffix=self.tr(" s"),
            on_change=self._on_edited,
        )

    @Slot()
    def _on_edited(self) -> None:
        profile = Profile(
            shape=self._shape.currentData(),
            speed=self._speed.value() * int(self._direction.currentData()),
            duration=round(self._duration.value(), 2),
            period=round(self._period.value(), 2),
        )
        self._bench.set_plan(
            replace(
                self._bench.plan,
                motor=int(self._motor.currentData()),
                profile=profile,
                accelerate=bool(self._sent.currentData()),
                abort_current=round(self._abort.value(), 2),
                abort_at_limit=self._at_limit.isChecked(),
            )
        )

    @Slot()
    def _on_bench_changed(self) -> None:
        plan, ceiling = self._bench.plan, self._motors.ceiling
        self._show_period(plan)
        fields = (
            *(self._motor, self._shape, self._direction, self._speed, self._duration),
            *(self._period, self._sent, self._abort, self._at_limit),
        )
        blockers = [QSignalBlocker(field) for field in fields]
        self._speed.setRange(1, ceiling)
        tip = self.tr("1 to {0}, full speed")
        if ceiling < FULL_SCALE:
            tip = self.tr("1 to {0}, the speed ceiling of the Motors page")
        self._speed.setToolTip(tip.format(ceiling))
        self._abort.setRange(0.1, self._bench.highest_current)
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
            Shape.RAMP: self.tr("How long the speed rises before it is constant."),
            Shape.REVERSE: self.tr("Half of it in each direction."),
            Shape.SINE: self.tr("One swing forward and back."),
        }
        self._period.setToolTip(tips[shape])


def _put(box: QSpinBox | QDoubleSpinBox, value: float) -> None:
    """Show a value, unless it is shown already: setting it would reformat what is being typed."""
    if box.value() == value:
        return
    if isinstance(box, QSpinBox):
        box.setValue(int(value))
    else:
        box.setValue(value)
