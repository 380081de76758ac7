"""How speeds are sent: ceiling, ramp, brake strength, lock, spring return."""

from collections.abc import Callable
from functools import partial

from PySide6.QtCore import QObject, QSignalBlocker, Qt, Signal, Slot
from PySide6.QtGui import QWheelEvent
from PySide6.QtWidgets import QCheckBox, QSizePolicy, QSlider, QWidget

from trex_gui.core.translation import Number, tr
from trex_gui.devices.trex.model.motors import LONGEST, Motors
from trex_gui.devices.trex.protocol.calibration import FULL_SCALE
from trex_gui.devices.trex.views.pages.motors.drive_control import SpeedEntry
from trex_gui.ui.preferences import Preferences
from trex_gui.ui.widgets import builders as ui
from trex_gui.ui.widgets.labels import Note

_SPACING = 6  # pixels

Apply = Callable[[int], object]


class _StrengthEntry(SpeedEntry):
    """Shows beside the number its share of full scale."""

    def put(self, speed: int) -> None:
        with QSignalBlocker(self):  # writing a suffix writes the text anew
            self.setSuffix(f" ({100 * speed / FULL_SCALE:.0f} %)")
        super().put(speed)


class _Slider(QSlider):
    def wheelEvent(self, event: QWheelEvent) -> None:
        event.ignore()


class Level(QObject):
    """Label, slider and entry of one value, as `widgets`; a typed number counts with Enter."""

    def __init__(
        self, title: str, name: str, lowest: int, parent: QWidget, *, tip: str, apply: Apply
    ) -> None:
        super().__init__(parent)
        self._apply = apply
        plain = title.replace("&", "")
        self._slider = ui.named(
            _Slider(Qt.Orientation.Horizontal, parent), f"{name}Slider", accessible=plain, tip=tip
        )
        self._slider.setPageStep(16)
        self._slider.setMinimumWidth(90)
        self._slider.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        accessible = tr("{0}, as a number").format(plain)
        self.entry = ui.named(
            _StrengthEntry(parent), f"{name}Entry", accessible=accessible, tip=tip
        )
        for widget in (self._slider, self.entry):
            widget.setRange(lowest, FULL_SCALE)
        self.entry.put(FULL_SCALE)
        self.entry.setMinimumWidth(self.entry.sizeHint().width())
        label = ui.label(parent, "", title, tip=tip, buddy=self.entry)
        self.widgets = (label, self._slider, self.entry)

        self._slider.valueChanged.connect(self._on_chosen)
        self.entry.chosen.connect(self._on_chosen)

    def set_value(self, value: int) -> None:
        """Show a value without applying it."""
        with QSignalBlocker(self._slider):
            self._slider.setValue(value)
        self.entry.show_setpoint(value)

    @Slot(int)
    def _on_chosen(self, value: int) -> None:
        self.set_value(value)
        self._apply(value)


class SpeedCeiling(QWidget):
    """The ceiling of the board, and why it is low at first."""

    def __init__(self, motors: Motors, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._motors = motors
        tip = tr(
            "Highest speed that this program sends to this board; full deflection of pad, "
            "keys and gamepad gives this speed. Raising it does not speed up a running motor."
        )
        title = tr("&Speed ceiling")
        self._level = Level(title, "ceiling", 1, self, tip=tip, apply=motors.set_ceiling)
        self._note = ui.named(Note(1, self), "ceilingNote")
        self._note.setAlignment(Qt.AlignmentFlag.AlignVCenter)
        label, slider, entry = self._level.widgets
        ui.row(label, (slider, 1), entry, (self._note, 2), into=self, margins=0)
        motors.options_changed.connect(self._on_options_changed)
        self._on_options_changed()

    @Slot()
    def _on_options_changed(self) -> None:
        motors = self._motors
        self._level.set_value(motors.ceiling)
        self.setEnabled(bool(motors.board))
        text = tr("Remembered for this board.")
        if motors.is_first_drive:
            text = tr("New board: raise this once its motors turn the right way.")
        self._note.show_note(text if motors.board else "")


class Options(ui.Card):
    """Brake strength, lock, spring return and stop on leaving are stored; the others are not."""

    keys_toggled = Signal(bool)  # whether keys drive wherever the focus is

    def __init__(self, motors: Motors, parent: QWidget | None = None) -> None:
        super().__init__(tr("Options"), parent)
        self.setObjectName("motorsOptions")
        self._motors = motors
        self._joint = False
        self._store = Preferences()

        text = tr("Accelerate along the board's ra&mp")
        tip = tr(
            "The board ramps speeds at the Acceleration setting and pauses for the brake "
            "duration before reversing"
        )
        accelerate = ui.radio_button(self, "accelerateButton", text, tip=tip)
        tip = tr("Bypasses ramp and brake duration, and for a moment also the current limit")
        at_once = ui.radio_button(self, "setButton", tr("Se&t at once"), tip=tip)
        (accelerate if motors.accelerate else at_once).setChecked(True)
        tip = tr(
            "Held keys drive wherever the focus is on this page, except in number fields, "
            "tables and lists; sliders then get no arrow keys. In the pad they always drive."
        )
        text = tr("Drive with arrow &keys or WASD")
        self._keys = ui.check_box(self, "driveWithKeys", text, tip=tip)
        self._link = ui.check_box(
            self, "linkMotors", tr("&Link both motors"), on_toggle=motors.set_linked
        )
        tip = tr(
            "How hard Brake and letting go of pad, keys and held sliders brake; Stop always "
            "brakes fully"
        )
        title = tr("&Brake strength")
        self._brake = Level(title, "brake", 0, self, tip=tip, apply=self._on_brake_chosen)
        motors.set_release_brake(self._store.integer("motors/brake", FULL_SCALE, 0, FULL_SCALE))
        self._brake.entry.setSpecialValueText(tr("coast (0 %)"))
        self._lock = lock = self._make_lock()
        lock_label = ui.label(self, "", tr("L&ock after Stop"), tip=lock.toolTip(), buddy=lock)
        # Off by default: who looks at Currents or changes a parameter may want the motors to go on.
        text = tr("Stop when you lea&ve this page")
        tip = tr(
            "Stop both motors and the auxiliary when another page is shown or the window is "
            "minimised"
        )
        self._leave = self._make_stored("stopOnLeaving", text, tip, "motors/stop_on_leaving")
        text = tr("Return slider to &zero when it is released")
        tip = tr("A slider drives only while you hold it; letting go brakes its motor")
        self._return = self._make_stored("returnToZero", text, tip, "motors/return_to_zero")

        # Without a spacing of its own a column would take that of its row.
        left = ui.column(accelerate, at_once, self._keys, self._link, 1, spacing=_SPACING)
        right = ui.grid(spacing=(_SPACING, _SPACING), stretch=[(1, 1)])
        for column, widget in enumerate(self._brake.widgets):
            right.addWidget(widget, 0, column)
        right.addWidget(lock_label, 1, 0)
        right.addLayout(ui.row(self._lock, 1), 1, 1, 1, 2)
        right.addWidget(self._leave, 2, 0, 1, 3)
        right.addWidget(self._return, 3, 0, 1, 3)
        ui.row(left, (right, 1), into=self)
        self.setSizePolicy(QSizePolicy.Policy.Preferred, QSizePolicy.Policy.Fixed)

        self._keys.toggled.connect(self.keys_toggled)
        accelerate.toggled.connect(partial(setattr, motors, "accelerate"))
        self._lock.chosen.connect(motors.set_lockout)
        motors.options_changed.connect(self._on_options_changed)
        motors.board_changed.connect(self._on_board_changed)
        motors.setpoints_changed.connect(self._show_link)
        self._on_options_changed()

    def _make_stored(self, name: str, text: str, tip: str, key: str) -> QCheckBox:
        """Create a check box whose state is stored; it is cleared by default."""
        checked, store = self._store.flag(key, default=False), partial(self._store.set, key)
        return ui.check_box(self, name, text, tip=tip, checked=checked, on_toggle=store)

    def _make_lock(self) -> SpeedEntry:
        tip = tr(
            "How long arming stays locked after Stop or Esc, so that a slider or key that is "
            "still held cannot restart a motor (0 to {0:g} s)"
        ).format(Number(LONGEST))
        accessible = tr("Seconds for which arming is locked after Stop")
        lock = ui.named(SpeedEntry(self), "lockoutEntry", accessible=accessible, tip=tip)
        lock.setRange(0, round(LONGEST))
        lock.setSuffix(tr(" s"))
        lock.setSpecialValueText(tr("none (0 s)"))
        lock.setMinimumWidth(lock.sizeHint().width())  # as wide with any text
        return lock

    @property
    def returns_to_zero(self) -> bool:
        return self._return.isChecked()

    @property
    def stops_on_leaving(self) -> bool:
        return self._leave.isChecked()

    def set_joint(self, joint: bool) -> None:
        self._joint = joint
        self._show_link()

    @Slot()
    def _show_link(self) -> None:
        """Allow linking only motors at the same speed: it must not start or speed up one."""
        motors = self._motors
        can_link = motors.linked or motors.can_link
        self._link.setChecked(motors.linked)
        self._link.setEnabled(can_link and not self._joint)
        linked = tr("Either slider sets both motors; the robot does not turn")
        blocked = tr("The motors run differently: stop both, or give both the same speed")
        self._link.setToolTip(linked if can_link else blocked)

    def _on_brake_chosen(self, duty: int) -> None:
        self._motors.set_release_brake(duty)
        self._store.set("motors/brake", duty)

    @Slot()
    def _on_options_changed(self) -> None:
        self._brake.set_value(self._motors.release_brake)
        self._lock.show_setpoint(round(self._motors.lockout))
        self._show_link()

    @Slot()
    def _on_board_changed(self) -> None:
        self._keys.setChecked(False)
