"""How speeds are sent: ramp, ceiling, brake strength, lock, spring return."""

from PySide6.QtCore import QEvent, QObject, QSettings, QSignalBlocker, Qt, Signal, Slot
from PySide6.QtWidgets import (
    QGridLayout,
    QGroupBox,
    QLabel,
    QRadioButton,
    QSizePolicy,
    QSlider,
    QWidget,
)

from trex_gui.devices.trex.model.motors import LONGEST, Motors, remember_lockout
from trex_gui.devices.trex.protocol.calibration import FULL_SCALE
from trex_gui.devices.trex.views.pages.motors.drive_control import SpeedEntry
from trex_gui.ui.widgets import builders as ui


class _StrengthEntry(SpeedEntry):
    """A box that shows beside the number what share of full it is."""

    def put(self, speed: int) -> None:
        with QSignalBlocker(self):  # writing a suffix writes the text anew
            self.setSuffix(_share(speed))
        super().put(speed)


class Level(QObject):
    """Lies in three cells of a row of a grid. The mouse wheel leaves it alone.

    A number that is typed counts with Enter only, as a speed does: a ceiling that was half typed
    would let a motor run faster than intended.

    Signals:
        changed: a value that the user chose.
    """

    changed = Signal(int)

    def __init__(self, title: str, name: str, lowest: int, parent: QWidget) -> None:
        super().__init__(parent)
        self._label = QLabel(title, parent)
        self._slider = ui.named(QSlider(Qt.Orientation.Horizontal, parent), f"{name}Slider")
        self._slider.setRange(lowest, FULL_SCALE)
        self._slider.setPageStep(16)
        self._slider.setMinimumWidth(90)
        self._entry = ui.named(_StrengthEntry(parent), f"{name}Entry")
        self._entry.setRange(lowest, FULL_SCALE)
        self._label.setBuddy(self._entry)
        plain = title.replace("&", "")
        self._slider.setAccessibleName(plain)
        self._entry.setAccessibleName(self.tr("{0}, as a number").format(plain))
        for widget in (self._slider, self._entry):
            widget.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
            widget.installEventFilter(self)
        self._entry.put(FULL_SCALE)
        self._entry.setMinimumWidth(self._entry.sizeHint().width())

        self._slider.valueChanged.connect(self._on_chosen)
        self._entry.chosen.connect(self._on_chosen)

    def add_to(self, grid: QGridLayout, row: int) -> None:
        """Take three cells of a row."""
        for column, widget in enumerate((self._label, self._slider, self._entry)):
            grid.addWidget(widget, row, column)

    def explain(self, text: str) -> None:
        for widget in (self._label, self._slider, self._entry):
            widget.setToolTip(text)

    def name_lowest(self, text: str) -> None:
        """Show this in place of the lowest number."""
        self._entry.setSpecialValueText(text)

    def set_value(self, value: int) -> None:
        """Show a value that no person chose."""
        with QSignalBlocker(self._slider):
            self._slider.setValue(value)
        self._entry.show_setpoint(value)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        if event.type() == QEvent.Type.Wheel:
            event.ignore()
            return True
        return super().eventFilter(watched, event)

    @Slot(int)
    def _on_chosen(self, value: int) -> None:
        self.set_value(value)
        self.changed.emit(value)


def _share(value: int) -> str:
    return f" ({100 * value / FULL_SCALE:.0f} %)"


_SPACING = 6  # pixels


class Options(QGroupBox):
    """Ceiling, brake strength, lock and spring return are remembered; what drives is not.

    Signals:
        keys_toggled: whether keys drive wherever the focus is.
    """

    keys_toggled = Signal(bool)

    def __init__(self, motors: Motors, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setTitle(self.tr("Options"))
        self.setObjectName("motorsOptions")
        self._motors = motors
        self._joint = False
        self._store = QSettings(self)

        self._create_choices()
        self._ceiling, self._brake = self._levels()
        self._create_lock()
        self._lay_out()
        self._restore()
        self._connect()
        self._on_options_changed()

    def _create_choices(self) -> None:
        self._accelerate = ui.named(
            QRadioButton(self.tr("&Accelerate along the board's ramp"), self),
            "accelerateButton",
            tip=self.tr("Speeds grow as Acceleration says, reversing waits for the brake duration"),
        )
        self._set = ui.named(
            QRadioButton(self.tr("Se&t at once"), self),
            "setButton",
            tip=self.tr(
                "Bypasses ramp and brake duration, and for a moment also the current limit"
            ),
        )
        self._accelerate.setChecked(self._motors.accelerate)
        self._set.setChecked(not self._motors.accelerate)
        self._return = ui.check_box(
            self,
            "returnToZero",
            self.tr("Return slider to &zero when it is released"),
            tip=self.tr("A slider drives only while you hold it; letting go brakes its motor"),
        )
        self._link = ui.check_box(self, "linkMotors", self.tr("&Link both motors"))
        self._keys = ui.check_box(
            self,
            "driveWithKeys",
            self.tr("Drive with arrow &keys or WASD"),
            tip=self.tr(
                "Keys drive while they are held, wherever the focus is on this page, except in "
                "number fields, tables and lists; sliders get no arrow keys meanwhile. In the pad "
                "they always do."
            ),
        )

    def _levels(self) -> tuple[Level, Level]:
        ceiling = Level(self.tr("&Speed ceiling"), "ceiling", 1, self)
        ceiling.explain(
            self.tr("Highest speed sent; full deflection of pad or keys gives this speed")
        )
        brake = Level(self.tr("&Brake strength"), "brake", 0, self)
        brake.name_lowest(self.tr("coast (0 %)"))
        brake.explain(
            self.tr(
                "How hard Brake and letting go of pad, keys and held sliders brake; Stop always "
                "brakes fully"
            )
        )
        return ceiling, brake

    def _create_lock(self) -> None:
        self._lock = ui.named(
            SpeedEntry(self),
            "lockoutEntry",
            accessible=self.tr("Seconds that Run motor is locked after Stop"),
        )
        self._lock.setRange(0, round(LONGEST))
        self._lock.setSuffix(self.tr(" s"))
        self._lock.setSpecialValueText(self.tr("none (0 s)"))
        self._lock.setMinimumWidth(self._lock.sizeHint().width())  # as wide with any text
        tip = self.tr(
            "How long Run motor stays locked after Stop or Esc, so that a slider or key still held "
            "cannot restart a motor (0 to {0:g} s)"
        ).format(LONGEST)
        self._lock.setToolTip(tip)
        self._lock_name = ui.label(self, "", self.tr("L&ock after Stop"), tip=tip, buddy=self._lock)

    def _lay_out(self) -> None:
        # Without a spacing of its own it would take that of its row.
        how = ui.column(self._accelerate, self._set, self._keys, 1, spacing=_SPACING)
        hold = ui.grid(spacing=(2 * _SPACING, _SPACING))
        self._ceiling.add_to(hold, 0)
        self._brake.add_to(hold, 1)
        checks = ui.row(self._return, self._link, 1, spacing=3 * _SPACING)
        hold.addWidget(self._lock_name, 2, 0)
        hold.addWidget(self._lock, 2, 2)
        hold.addLayout(checks, 3, 0, 1, 3)
        hold.setColumnStretch(1, 1)
        ui.row(how, (hold, 1), into=self, spacing=4 * _SPACING)

        self.setSizePolicy(QSizePolicy.Policy.Preferred, QSizePolicy.Policy.Fixed)

    def _connect(self) -> None:
        self._accelerate.toggled.connect(self._on_accelerate_toggled)
        self._return.toggled.connect(self._on_return_toggled)
        self._link.toggled.connect(self._motors.set_linked)
        self._keys.toggled.connect(self.keys_toggled)
        self._lock.chosen.connect(self._on_lock_chosen)
        self._ceiling.changed.connect(self._on_ceiling_changed)
        self._brake.changed.connect(self._on_brake_changed)
        self._motors.options_changed.connect(self._on_options_changed)
        self._motors.setpoints_changed.connect(self._show_link)

    @property
    def returns_to_zero(self) -> bool:
        """Whether a slider drives only while it is held."""
        return self._return.isChecked()

    def set_joint(self, joint: bool) -> None:
        """Offer to link the motors, or not: there is only one."""
        self._joint = joint
        self._show_link()

    @Slot()
    def _show_link(self) -> None:
        """Tick it only over motors that do the same: a tick must not start or speed up one."""
        motors = self._motors
        can_link = motors.linked or motors.can_link
        self._link.setChecked(motors.linked)
        self._link.setEnabled(can_link and not self._joint)
        tip = self.tr("Both motors do what either slider says; nothing turns")
        if not can_link:
            tip = self.tr("The motors run differently: stop both, or give both the same speed")
        self._link.setToolTip(tip)

    def _restore(self) -> None:
        self._motors.set_ceiling(_stored(self._store, "motors/ceiling", 1))
        self._motors.set_release_brake(_stored(self._store, "motors/brake", 0))
        self._return.setChecked(self._store.value("motors/return_to_zero") in {True, "true"})

    @Slot(bool)
    def _on_accelerate_toggled(self, accelerate: bool) -> None:
        self._motors.accelerate = accelerate

    @Slot(bool)
    def _on_return_toggled(self, wanted: bool) -> None:
        self._store.setValue("motors/return_to_zero", wanted)

    @Slot(int)
    def _on_lock_chosen(self, seconds: int) -> None:
        self._motors.lockout = float(seconds)
        remember_lockout(seconds)

    @Slot(int)
    def _on_ceiling_changed(self, speed: int) -> None:
        self._motors.set_ceiling(speed)
        self._store.setValue("motors/ceiling", speed)

    @Slot(int)
    def _on_brake_changed(self, duty: int) -> None:
        self._motors.set_release_brake(duty)
        self._store.setValue("motors/brake", duty)

    @Slot()
    def _on_options_changed(self) -> None:
        self._ceiling.set_value(self._motors.ceiling)
        self._brake.set_value(self._motors.release_brake)
        self._lock.show_setpoint(round(self._motors.lockout))
        self._show_link()


def _stored(store: QSettings, key: str, lowest: int) -> int:
    """Return a number that was remembered, or full where it is none."""
    text = str(store.value(key, FULL_SCALE))
    return max(lowest, min(FULL_SCALE, int(text))) if text.isdigit() else FULL_SCALE
