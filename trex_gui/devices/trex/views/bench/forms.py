"""Forms for the plan of a bench test and for the tuned parameters."""

from dataclasses import replace
from functools import partial

from PySide6.QtCore import QSignalBlocker, Slot
from PySide6.QtWidgets import QDoubleSpinBox, QFormLayout, QLabel, QSizePolicy, QSpinBox, QWidget

from trex_gui.core.errors import BadRequest
from trex_gui.core.texts import title_of
from trex_gui.core.translation import tr
from trex_gui.devices.trex.bench.run import MAX_SECONDS, MIN_SECONDS, Profile, Shape
from trex_gui.devices.trex.model.bench import Bench
from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.protocol.calibration import FULL_SCALE
from trex_gui.devices.trex.protocol.parameters import MotorParameter
from trex_gui.devices.trex.views.pages.parameters.editors import Editor, editor_for
from trex_gui.ui.theme.theme import set_text_color
from trex_gui.ui.widgets import builders as ui

_WIDEST, _FRAME = "127 per 100 ms (127 ms)", 40  # widest text of an editor, pixels around it


def _form(parent: QWidget | None = None) -> QFormLayout:
    form = QFormLayout(parent)
    form.setContentsMargins(0, 0, 0, 0)
    form.setVerticalSpacing(3)
    form.setFieldGrowthPolicy(QFormLayout.FieldGrowthPolicy.AllNonFixedFieldsGrow)
    return form


def _align(form: QFormLayout) -> None:
    """Centre each title vertically beside its field."""
    for number in range(form.rowCount()):
        item = form.itemAt(number, QFormLayout.ItemRole.LabelRole)
        if item is not None and (title := item.widget()) is not None:
            title.setSizePolicy(QSizePolicy.Policy.Preferred, QSizePolicy.Policy.Expanding)


class PlanForm(ui.Card):
    def __init__(self, device: Device, bench: Bench, parent: QWidget) -> None:
        super().__init__(tr("Test"), parent)
        self._bench = bench
        self._motors = device.motors
        form = _form()
        combo = partial(ui.combo_box, self, accessible="", on_change=self._on_edited)
        spin = partial(ui.double_spin_box, self, accessible="", decimals=2, step=0.5)
        number = partial(spin, on_change=self._on_edited)
        seconds = partial(number, lowest=MIN_SECONDS, highest=MAX_SECONDS, suffix=tr(" s"))

        def add(text: str, field: ui.WidgetT) -> ui.WidgetT:
            field.setAccessibleName(text.replace("&", ""))
            form.addRow(text, field)
            return field

        motors = [(tr("Motor {0}").format(motor), motor) for motor in (1, 2)]
        self._motor = add(tr("&Motor"), combo("benchMotor", items=motors))
        shapes = [
            (tr("Step: at once"), Shape.STEP),
            (tr("Ramp: rising linearly"), Shape.RAMP),
            (tr("Reverse: back and forth"), Shape.REVERSE),
            (tr("Sine"), Shape.SINE),
        ]
        self._shape = add(tr("Pro&file"), combo("benchShape", items=shapes))
        directions = [(tr("Forward"), 1), (tr("Reverse"), -1)]
        self._direction = add(tr("Direc&tion"), combo("benchDirection", items=directions))
        speed = ui.spin_box(self, "benchSpeed", "", 1, FULL_SCALE, on_change=self._on_edited)
        speed.setSuffix(f" / {FULL_SCALE}")
        self._speed = add(tr("&Speed"), speed)
        self._duration = add(tr("&Duration"), seconds("benchDuration"))
        self._period = seconds("benchPeriod")
        self._period_name = ui.label(self, buddy=self._period)
        form.addRow(self._period_name, self._period)
        methods = [(tr("Accelerate"), True), (title_of(tr("Se&t at once")), False)]
        tip = tr(
            "“Accelerate” uses the board's acceleration, brake duration and current limit. "
            "“Set at once” bypasses the acceleration and the brake duration, and briefly the "
            "current limit."
        )
        self._sent = add(tr("Se&nt as"), combo("benchSent", items=methods, tip=tip))
        tip = tr(
            "A single reading above this current stops and disarms all motors. A motor draws "
            "the most current when it starts."
        )
        abort = number("benchAbort", lowest=0.1, highest=bench.highest_current, suffix=tr(" A"))
        self._abort = add(tr("Abort &above"), abort)
        abort.setToolTip(ui.plain(tip))
        text = tr("Abort also at the board's current &limit")
        tip = tr("Stop when the board reports that its own current limit was exceeded.")
        check_box = partial(ui.check_box, self, on_toggle=self._on_edited)
        self._at_limit = check_box("benchAbortAtLimit", text, tip=tip)
        form.addRow(self._at_limit)
        _align(form)
        ui.column(form, into=self)

        bench.changed.connect(self._on_bench_changed)
        self._on_bench_changed()

    @Slot()
    def _on_edited(self) -> None:
        plan = replace(
            self._bench.plan,
            motor=int(self._motor.currentData()),
            profile=Profile(
                shape=self._shape.currentData(),
                speed=self._speed.value() * int(self._direction.currentData()),
                duration=round(self._duration.value(), 2),
                period=round(self._period.value(), 2),
            ),
            accelerate=bool(self._sent.currentData()),
            abort_current=round(self._abort.value(), 2),
            abort_at_limit=self._at_limit.isChecked(),
        )
        self._bench.set_plan(plan)

    @Slot()
    def _on_bench_changed(self) -> None:
        plan, ceiling = self._bench.plan, self._motors.ceiling
        combos = {
            self._motor: plan.motor,
            self._shape: plan.profile.shape,
            self._direction: 1 if plan.profile.speed > 0 else -1,
            self._sent: plan.accelerate,
        }
        numbers: dict[QSpinBox | QDoubleSpinBox, float] = {
            self._speed: abs(plan.profile.speed),
            self._duration: plan.profile.duration,
            self._period: plan.profile.period,
            self._abort: plan.abort_current,
        }
        blockers = [QSignalBlocker(field) for field in (*combos, *numbers, self._at_limit)]
        self._show_period(plan.profile.shape)
        self._speed.setRange(1, ceiling)
        tip = tr("1 to {0}, full speed")
        if ceiling < FULL_SCALE:
            tip = tr("1 to {0}, the speed ceiling of the Motors page")
        self._speed.setToolTip(ui.plain(tip.format(ceiling)))
        self._abort.setRange(0.1, self._bench.highest_current)
        for combo, data in combos.items():
            combo.setCurrentIndex(combo.findData(data))
        for box, value in numbers.items():
            if box.value() != value:  # setting the same value would reformat typed text
                box.setValue(value)  # type: ignore[arg-type]  # the speed is an int
        self._at_limit.setChecked(plan.abort_at_limit)
        del blockers
        self.setEnabled(not self._bench.is_driving)

    def _show_period(self, shape: Shape) -> None:
        name = tr("R&ises in") if shape is Shape.RAMP else tr("&Period")
        self._period_name.setText(name)
        self._period.setAccessibleName(name.replace("&", ""))
        self._period_name.setEnabled(shape.has_period)
        self._period.setEnabled(shape.has_period)


class TuningForm(ui.Card):
    """Form for the tuned parameters of a motor: ramps and current limit."""

    def __init__(self, device: Device, bench: Bench, parent: QWidget) -> None:
        super().__init__("", parent)
        self._device = device
        self._bench = bench
        self._shown: tuple[str, tuple[str, ...]] | None = None
        self._fields: dict[str, tuple[QLabel, Editor]] = {}

        text = tr("Connect to a board to see its settings.")
        self._empty = ui.label(self, text=text, wrap=True)
        self._editors = QWidget(self)  # before the button in the Tab order
        self._edited = ui.label(self, "benchEdited", wrap=True)
        set_text_color(self._edited, "dirty")
        text, tip = tr("Appl&y…"), tr("Review and write all pending edits, including these")
        button = partial(ui.button, self, icon="apply", default=False)
        self.apply = button("benchApplyButton", text, tip=tip)
        self._form = _form(self._editors)
        ui.column(self._empty, self._editors, self._edited, 1, self.apply, into=self, spacing=4)

        pending_changed = device.draft.pending_changed
        for changed in (bench.changed, device.state_changed, pending_changed, device.link_changed):
            changed.connect(self._on_changed)
        self._on_changed()

    @Slot()
    def _on_changed(self) -> None:
        device = self._device
        keys = tuple(
            key for key in self._bench.tuned_keys() if device.parameters.values.can_edit(key)
        )
        if (device.parameters.model_key, keys) != self._shown:
            self._shown = device.parameters.model_key, keys
            self._create_editors(keys)
        self.setTitle(tr("Settings of motor {0}").format(self._bench.plan.motor))
        self._empty.setVisible(not keys)
        self._show_values()
        can_edit = device.is_writable and not self._bench.is_driving
        for _, editor in self._fields.values():
            editor.setEnabled(can_edit)
        self.apply.setEnabled(can_edit and device.draft.pending > 0)

    def _create_editors(self, keys: tuple[str, ...]) -> None:
        while self._form.rowCount():
            self._form.removeRow(0)
        self._fields.clear()
        for key in keys:
            spec = self._device.parameters.values.specs[key]
            editor = editor_for(spec, self._editors)
            editor.setObjectName(f"bench_{key}")
            editor.setAccessibleName(spec.name)
            editor.setToolTip(ui.plain(f"{spec.description} ({editor.toolTip()})"))
            editor.setMinimumWidth(editor.fontMetrics().horizontalAdvance(_WIDEST) + _FRAME)
            # The card title names the motor, and the full name of parameter P is too long.
            is_limit_p = key.endswith(MotorParameter.CURRENT_LIMIT_P)
            name = tr("Limit P") if is_limit_p else spec.short_name
            label = ui.label(self._editors, text=name, tip=spec.description)
            self._form.addRow(label, editor)
            editor.valueChanged.connect(partial(self._on_edited, key))
            self._fields[key] = label, editor
        _align(self._form)
        ui.tab_order(self.apply, *(editor for _, editor in self._fields.values()), self.apply)

    def _on_edited(self, key: str, wire: int) -> None:
        try:
            self._device.parameters.edit(key, wire, alone=True)
        except (BadRequest, KeyError):
            self._show_values()  # the board was disconnected

    def _show_values(self) -> None:
        parameters = self._device.parameters
        edited = []
        for key, (label, editor) in self._fields.items():
            wire, stored = parameters.values.value_of(key), parameters.values.stored.get(key)
            if wire is None:
                continue
            if editor.value() != wire:
                with QSignalBlocker(editor):
                    editor.setValue(wire)
            if parameters.values.is_modified(key) and stored is not None:
                stored_text = parameters.values.specs[key].text(stored)
                edited.append(tr("{0} (stored: {1})").format(label.text(), stored_text))
        self._edited.setText(tr("Not applied: {0}").format(", ".join(edited)))
        self._edited.setVisible(bool(edited))
