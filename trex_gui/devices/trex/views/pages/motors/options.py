"""Driving options, and controls other than the pad and the sliders."""

from collections.abc import Callable
from functools import partial

from PySide6.QtCore import QSignalBlocker, Qt, Slot
from PySide6.QtWidgets import QCheckBox, QRadioButton, QWidget

from trex_gui.core.texts import title_of
from trex_gui.core.translation import Number, tr
from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.model.motors import MAX_LOCKOUT, Motors
from trex_gui.devices.trex.protocol.calibration import FULL_SCALE
from trex_gui.devices.trex.views.pages.motors.drive_control import SpeedEntry
from trex_gui.devices.trex.views.pages.motors.gamepad_panel import GamepadPanel
from trex_gui.ui.preferences import Preferences
from trex_gui.ui.theme.theme import set_look, set_style_property
from trex_gui.ui.widgets import builders as ui
from trex_gui.ui.widgets.labels import ElidedLabel

_SPACING = 6  # pixels


class _StrengthEntry(SpeedEntry):
    def __init__(self, lowest: int, apply: Callable[[int], object], parent: QWidget) -> None:
        super().__init__(parent)
        self.setRange(lowest, FULL_SCALE)
        self.set_speed(FULL_SCALE)
        self.setMinimumWidth(self.sizeHint().width())
        self.chosen.connect(apply)

    def set_speed(self, speed: int) -> None:
        with QSignalBlocker(self):  # a new suffix also changes the text
            self.setSuffix(f" ({100 * speed / FULL_SCALE:.0f} %)")
        super().set_speed(speed)


class SpeedCeiling(QWidget):
    """Field for a board's speed ceiling. A hint is shown until the user has set the ceiling."""

    def __init__(self, motors: Motors, parent: QWidget) -> None:
        super().__init__(parent)
        self._motors = motors
        tip = tr(
            "Maximum speed that this program sends to this board. Full deflection of the "
            "pad, the keys or the gamepad gives this speed. Raising the ceiling does not "
            "speed up a running motor."
        )
        text = tr("&Speed ceiling")
        accessible = text.replace("&", "")
        entry = _StrengthEntry(1, motors.set_ceiling, self)
        self._entry = ui.named(entry, "ceilingEntry", accessible=accessible, tip=tip)
        self._note = ui.named(ElidedLabel("", self), "ceilingNote")
        title = ui.label(self, "", text, tip=tip, buddy=entry, size="caption")
        set_style_property(self._note, "textSize", "caption")
        self._note.setWordWrap(True)
        left = entry, 0, Qt.AlignmentFlag.AlignLeft
        ui.column(title, left, self._note, 1, into=self, margins=0, spacing=2)
        motors.options_changed.connect(self._on_options_changed)
        self._on_options_changed()

    @Slot()
    def _on_options_changed(self) -> None:
        motors = self._motors
        self._entry.show_setpoint(motors.ceiling)
        self.setEnabled(bool(motors.board))
        text = tr("Raise the ceiling once the motors turn the right way.")
        self._note.show_text(text if motors.board and motors.is_first_drive else "")


class DriveWith(ui.Card):
    """Controls other than the pad and the sliders. All are off when the program starts."""

    def __init__(self, device: Device, parent: QWidget) -> None:
        super().__init__(tr("Drive with"), parent)
        self.setObjectName("driveWith")
        self._device = device
        self._motors = motors = device.motors
        tip = tr(
            "Held keys drive wherever the focus is on this page, except in number fields, "
            "tables and lists. Arrow keys then no longer move the sliders. While the pad has "
            "the focus, keys always drive."
        )
        self.keys = ui.check_box(self, "driveWithKeys", tr("Arrow ke&ys or WASD"), tip=tip)
        text = tr("Both motors &linked")
        self._link = ui.check_box(self, "linkMotors", text, on_toggle=motors.set_linked)
        gamepad = GamepadPanel(device, self)
        self.more = ui.button(self, "moreOptions", tr("E&xtra options"), checkable=True)
        set_look(self.more, "link")
        more = self.more, 0, Qt.AlignmentFlag.AlignLeft
        ui.column(self.keys, self._link, gamepad, more, 1, into=self, margins=0, spacing=4)
        for changed in (motors.options_changed, motors.setpoints_changed, device.state_changed):
            changed.connect(self._show_link)
        motors.board_changed.connect(lambda: self.keys.setChecked(False))
        self._show_link()

    @Slot()
    def _show_link(self) -> None:
        """Enable linking only at equal speeds, so that it cannot start or accelerate a motor."""
        motors = self._motors
        can_link = motors.linked or motors.can_link
        self._link.setChecked(motors.linked)
        self._link.setEnabled(can_link and not self._device.board.is_joint)
        linked = tr("Either slider sets both motors, so the robot does not turn")
        blocked = tr("The motors run at different speeds: stop both, or set both to the same speed")
        self._link.setToolTip(linked if can_link else blocked)


class Options(ui.Card):
    """Rarely changed options. All options except the ramp are saved."""

    def __init__(self, motors: Motors, parent: QWidget) -> None:
        super().__init__(title_of(tr("E&xtra options")), parent)
        self.setObjectName("motorsOptions")
        self._motors = motors
        self._store = Preferences()

        text = tr("Accelerate along the board's ra&mp")
        tip = tr(
            "The board ramps speeds at the Acceleration setting and pauses for the brake "
            "duration before reversing"
        )
        accelerate = ui.named(QRadioButton(text, self), "accelerateButton", tip=tip)
        tip = tr("Bypasses the ramp and the brake duration, and briefly the current limit")
        at_once = ui.named(QRadioButton(tr("Se&t at once"), self), "setButton", tip=tip)
        (accelerate if motors.accelerate else at_once).setChecked(True)
        tip = tr(
            "Strength of braking with the Brake button, and after you release the pad, a key "
            "or a held slider. Stop always brakes fully"
        )
        title = tr("&Brake strength")
        brake = _StrengthEntry(0, self._on_brake_chosen, self)
        self._brake = ui.named(brake, "brakeEntry", accessible=title.replace("&", ""), tip=tip)
        self._brake.setSpecialValueText(tr("coast (0 %)"))
        motors.set_release_brake(self._store.integer("motors/brake", FULL_SCALE, 0, FULL_SCALE))
        tip = tr(
            "How long arming stays locked after Stop or Esc, so that a slider or key that is "
            "still held cannot restart a motor (0 to {0:g} s)"
        ).format(Number(MAX_LOCKOUT))
        lock_title = tr("Loc&k after Stop")
        accessible = lock_title.replace("&", "")
        lock = ui.named(SpeedEntry(self), "lockoutEntry", accessible=accessible, tip=tip)
        self._lock = lock
        lock.setRange(0, round(MAX_LOCKOUT))
        lock.setSuffix(tr(" s"))
        lock.setSpecialValueText(tr("none (0 s)"))
        lock.setMinimumWidth(lock.sizeHint().width())
        # Off by default: motors may need to run while another page is open.
        text = tr("Stop when you lea&ve this page")
        tip = tr(
            "Stop both motors and the auxiliary when another page is shown or the window is "
            "minimized"
        )
        key = "motors/stop_on_leaving"
        self.stop_on_leaving = self._create_saved_box("stopOnLeaving", text, tip, key)
        text = tr("Sliders return to &zero")
        tip = tr(
            "A slider drives its motor only while you hold the slider. Releasing the "
            "slider brakes the motor"
        )
        key = "motors/return_to_zero"
        self.return_to_zero = self._create_saved_box("returnToZero", text, tip, key)

        numbers = ui.grid(spacing=(_SPACING, _SPACING), stretch=[(0, 1)])
        for row, (text, entry) in enumerate(((title, brake), (lock_title, lock))):
            label = ui.label(self, "", text, tip=entry.toolTip(), buddy=entry)
            numbers.addWidget(label, row, 0)
            numbers.addWidget(entry, row, 1)
        parts = accelerate, at_once, numbers, self.stop_on_leaving, self.return_to_zero, 1
        ui.column(*parts, into=self, margins=0, spacing=_SPACING)

        accelerate.toggled.connect(partial(setattr, motors, "accelerate"))
        lock.chosen.connect(motors.set_lockout)
        motors.options_changed.connect(self._on_options_changed)
        self._on_options_changed()

    def _create_saved_box(self, name: str, text: str, tip: str, key: str) -> QCheckBox:
        checked, save = self._store.flag(key, default=False), partial(self._store.set, key)
        return ui.check_box(self, name, text, tip=tip, checked=checked, on_toggle=save)

    def _on_brake_chosen(self, duty: int) -> None:
        self._motors.set_release_brake(duty)
        self._store.set("motors/brake", duty)

    @Slot()
    def _on_options_changed(self) -> None:
        self._brake.show_setpoint(self._motors.release_brake)
        self._lock.show_setpoint(round(self._motors.lockout))
