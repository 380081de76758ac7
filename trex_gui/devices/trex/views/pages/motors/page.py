"""Page to drive both motors and the auxiliary by hand."""

from functools import partial
from html import escape

from PySide6.QtCore import QEvent, Qt, Signal, Slot
from PySide6.QtGui import QHideEvent, QShowEvent
from PySide6.QtWidgets import QWidget

from trex_gui.core.translation import tr
from trex_gui.devices.trex.board.drive_status import drive_statuses
from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.model.drive_status import drive_inputs
from trex_gui.devices.trex.model.drive_texts import channel_text, report_text, setpoint_text
from trex_gui.devices.trex.model.momentary_drive import MomentaryDrive
from trex_gui.devices.trex.model.parameters.parameters import ParameterModel
from trex_gui.devices.trex.protocol.calibration import FULL_SCALE
from trex_gui.devices.trex.protocol.parameters import ParameterKey
from trex_gui.devices.trex.views.board.page import SIGNS
from trex_gui.devices.trex.views.pages.motors.drive_control import DriveControl
from trex_gui.devices.trex.views.pages.motors.drive_pad import DrivePad
from trex_gui.devices.trex.views.pages.motors.gamepad_panel import GamepadPanel
from trex_gui.devices.trex.views.pages.motors.key_driver import KeyDriver
from trex_gui.devices.trex.views.pages.motors.options import Options, SpeedCeiling
from trex_gui.ui.runtime import new_timer
from trex_gui.ui.theme.theme import theme
from trex_gui.ui.widgets import builders as ui
from trex_gui.ui.widgets.behaviour import only_when_visible
from trex_gui.ui.widgets.labels import LinkLabel, Note, Sign

_AUXILIARY = 3  # number of the auxiliary motor among the controls: that of its channel
_UNLIMITED = 16_777_215  # the height of widgets without a limit, QWIDGETSIZE_MAX in C++
_USUAL_COUNTS = 100  # of current, without a limit: 15 A, on a Jr 4 A, as bench tests allow


class MotorsPage(QWidget):
    """Nothing moves before the motors are armed; leaving the page releases every control."""

    parameter_wanted = Signal(str)  # the key of a parameter that the user wants to see or change

    def __init__(self, device: Device, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("motorsPage")
        self._device = device
        self._motors = device.motors
        self._pad_drive = MomentaryDrive(device.motors, "drive pad")
        self._key_drive = MomentaryDrive(device.motors, "keyboard")
        self._holder = ""
        self._dragged: int | None = None
        self._is_held_still = False
        self._forget_holder = new_timer(self, 0, self._on_event_over, single_shot=True)

        self._sign = Sign(self)
        self._reason = ui.named(Note(2, self), "motorsReason")
        self._reason.setTextFormat(Qt.TextFormat.RichText)
        self._reason.setAlignment(Qt.AlignmentFlag.AlignVCenter)
        self._drive_box = drive_box = ui.Card(tr("Drive"), self)
        ceiling = SpeedCeiling(device.motors, drive_box)
        self._pad = DrivePad(drive_box)
        auxiliary_title = tr("Auxiliary (one way)")
        self._controls = {
            1: DriveControl(tr("Motor 1"), "motor1", parent=drive_box),
            2: DriveControl(tr("Motor 2"), "motor2", parent=drive_box),
            _AUXILIARY: DriveControl(auxiliary_title, "aux", two_way=False, parent=drive_box),
        }
        self._options = Options(device.motors, self)
        self._stored = LinkLabel("motorsStored", self)
        self._stored.setToolTip(tr("Stored settings; click a value to open its parameter"))
        self._keys = KeyDriver(self._key_drive, device.motors, self, self._pad)

        head = ui.row(self._sign, (self._reason, 1), spacing=10)
        first, second, auxiliary = self._controls.values()
        controls = ui.column(first, 1, second, 1, auxiliary, 1, spacing=4)
        drive = ui.row(self._pad, (controls, 1), spacing=10)
        ui.column(ceiling, (drive, 1), into=drive_box)
        gamepad = GamepadPanel(device, self)
        ui.column(
            head, (drive_box, 1), self._options, self._stored, gamepad, 0, into=self, margins=4
        )

        for number, control in self._controls.items():
            control.speed_wanted.connect(partial(self._on_speed_wanted, number))
            control.brake_wanted.connect(partial(self._on_brake_wanted, number))
            control.slider.grabbed.connect(partial(self._on_grabbed, number))
            control.slider.released.connect(partial(self._on_released, number))
        self._pad.steered.connect(self._on_pad_steered)
        self._pad.released.connect(self._pad_drive.release)
        self._keys.steered.connect(self._pad.show_position)
        self._options.keys_toggled.connect(self._keys.set_enabled)
        self._stored.linkActivated.connect(self.parameter_wanted)
        motors = self._motors
        motors.holder_changed.connect(self._on_holder_changed)
        for signal in (motors.setpoints_changed, motors.arming_changed):
            signal.connect(self._show_setpoints)
        for signal in (
            motors.arming_changed,
            motors.availability_changed,
            motors.options_changed,
            motors.lockout_changed,
            device.link_changed,
        ):
            signal.connect(self._show_options)
        motors.stop_requested.connect(self._on_stop_requested)
        device.link_changed.connect(self._show_stored)
        device.state_changed.connect(self._on_state_changed)
        theme().changed.connect(self._on_state_changed)
        device.telemetry.frame_due.connect(self._on_frame_due)
        device.telemetry.text_due.connect(self._on_text_due)
        self._on_state_changed()

    def _on_speed_wanted(self, number: int, speed: int) -> None:
        holder = _name(number) if self._motors.holder == _name(number) else ""
        if number == _AUXILIARY:
            self._motors.set_auxiliary(speed, holder)
        else:
            self._motors.set_speed(number, speed, holder)
        self._show_setpoints()  # a rejected speed must not stay on the slider

    def _on_brake_wanted(self, number: int) -> None:
        self._motors.set_brake(number, self._motors.release_brake)

    def _on_grabbed(self, number: int) -> None:
        self._dragged = number
        if self._options.returns_to_zero:
            self._motors.acquire(_name(number))

    def _on_released(self, number: int) -> None:
        self._forget_holder.start()
        self._motors.release(_name(number))
        self._show_setpoints()

    @Slot(float, float)
    def _on_pad_steered(self, forward: float, turn: float) -> None:
        if not self._pad_drive.steer(forward, turn):
            self._pad.release()

    @Slot()
    def _on_stop_requested(self) -> None:
        for control in self._controls.values():
            control.release()
        self._pad.release()

    @Slot()
    def _on_state_changed(self) -> None:
        joint = self._device.board.is_joint
        for drive in (self._pad_drive, self._key_drive):
            drive.joint = joint
        self._controls[1].set_title(tr("Motor (joint)") if joint else tr("Motor 1"))
        self._options.set_joint(joint)
        if (state := self._device.state) is not None:
            usual = _USUAL_COUNTS * state.signature.model.current_unit
            for number in (1, 2):
                self._controls[number].current.set_scale(usual, self._device.current_limit(number))
        self._show_stored()
        self._show_setpoints()
        self._show_options()

    @Slot()
    def _show_stored(self) -> None:
        """Show the stored settings; grey, and without links, while the board may store others."""
        device, is_connected = self._device, self._device.is_connected
        text = _stored_text(device.parameters, joint=device.board.is_joint, linked=is_connected)
        self._stored.setText(text)
        self._stored.setEnabled(is_connected)
        self._stored.setAccessibleName("" if text else tr("Stored motor settings: not known"))

    @Slot()
    def _on_holder_changed(self) -> None:
        """Remember a held control until the event that ends the hold is over.

        A page that is hidden first takes the focus from its controls, which releases them.
        """
        own = {self._pad_drive.name, self._key_drive.name, *map(_name, self._controls)}
        if self._motors.holder in own:
            self._holder = self._motors.holder
        elif self._holder:
            self._forget_holder.start()
        if self._pad.held and not self._pad_drive.held:
            self._pad.release()

    @Slot()
    def _show_options(self) -> None:
        motors = self._motors
        self._pad.setEnabled(motors.armed)
        self._pad.set_can_turn(self._pad_drive.can_turn)
        self._pad.set_ceiling(motors.ceiling)
        share = 100 * motors.release_brake / FULL_SCALE
        brake = tr("Brake with {0:.0f} % (see Brake strength below)").format(share)
        for number, control in self._controls.items():
            control.setEnabled(motors.armed and not self._is_unused(number))
            control.set_ceiling(motors.ceiling)
            control.current.set_connected(
                self._device.is_connected and not self._device.board.is_joint
            )
            control.brake.setToolTip(ui.plain(brake))
        self._on_text_due()

    def _is_unused(self, number: int) -> bool:
        return number == 2 and self._device.board.is_joint

    @Slot()
    def _show_setpoints(self) -> None:
        motors = self._motors
        for number in (1, 2):
            drive = motors.drive(number)
            text = setpoint_text(drive) if motors.armed else ""
            if self._is_unused(number):
                text = tr("Joint mode: follows motor 1")
            self._controls[number].show_setpoint(drive.signed if drive else 0, text)
        text = tr("Setpoint: {0}").format(motors.auxiliary) if motors.armed else ""
        self._controls[_AUXILIARY].show_setpoint(motors.auxiliary, text)

    @Slot()
    @only_when_visible
    def _on_frame_due(self) -> None:
        if self._channels_drive():
            for number, control in self._controls.items():
                self._show_channel(number, control)
        for number, amps in enumerate(self._device.telemetry.motor_currents or (), 1):
            self._controls[number].current.set_value(amps)

    @Slot()
    @only_when_visible
    def _on_text_due(self) -> None:
        device = self._device
        self._hold_still()
        self._show_status()
        driven = self._channels_drive()
        self._pad.setVisible(not driven)
        for number, control in self._controls.items():
            control.set_channel_driven(driven)
            if driven:
                self._show_channel(number, control)
                if not self._is_unused(number):
                    control.show_setpoint(0, channel_text(device, number))
            report = "" if self._is_unused(number) else report_text(device, number)
            control.reported.show_text(report)

    def _hold_still(self) -> None:
        """Move no control while the motors are armed, whatever needs more room below."""
        armed = self._motors.armed
        if armed != self._is_held_still:
            self._is_held_still = armed
            height = self._drive_box.height()
            self._drive_box.setMinimumHeight(height if armed else 0)
            self._drive_box.setMaximumHeight(height if armed else _UNLIMITED)

    def _show_status(self) -> None:
        """Show what matters most in bold, and every other reason behind it."""
        inputs = drive_inputs(self._device)
        first, *others = drive_statuses(inputs)
        name, color = SIGNS[first.blocker.effect]
        self._sign.show_sign(name, color)
        lines = [f"<b>{escape(first.text)}</b> {_plain(first.remedy)}"]
        lines += [_plain(other.text) for other in others]
        # While a control may be held, what is below must not move.
        text = (" " if self._motors.armed else "<br>").join(lines)
        self._reason.show_note(text, alarming=color == "warning")
        spoken = [first.text, first.remedy, *(other.text for other in others)]
        self._reason.setAccessibleName(" ".join(filter(None, spoken)))

    def _channels_drive(self) -> bool:
        state = self._device.state
        if state is None or not self._device.is_connected or state.mode.is_serial:
            return False
        return not self._device.telemetry.serial_controls

    def _show_channel(self, number: int, control: DriveControl) -> None:
        telemetry = self._device.telemetry
        there = telemetry.raw is None or telemetry.raw_of(number) is not None
        control.setEnabled(not self._is_unused(number))
        control.show_channel(telemetry.remapped_of(number) if there else None)

    def showEvent(self, event: QShowEvent) -> None:
        super().showEvent(event)
        self._show_options()

    def hideEvent(self, event: QHideEvent) -> None:
        """Stop the motors if a control is held or a slider pressed, or if the user wants that."""
        is_dragged = self._dragged is not None and self._motors.armed
        self._dragged = None
        if self._holder or is_dragged:
            self._motors.stop(tr("The Motors page was left while a control was held."))
        elif self._options.stops_on_leaving and self._motors.armed:
            self._motors.stop(tr("The Motors page was left."))
        super().hideEvent(event)

    def changeEvent(self, event: QEvent) -> None:
        if event.type() == QEvent.Type.ActivationChange and self.isActiveWindow():
            self._forget_holder.start()
        super().changeEvent(event)

    @Slot()
    def _on_event_over(self) -> None:
        """Forget the control, unless the window is inactive: it may be about to be minimised."""
        sliders = [control.slider for control in self._controls.values()]
        if self.isActiveWindow() and not any(slider.held for slider in sliders):
            self._dragged = None
        if self._motors.holder != self._holder:
            self._holder = ""


def _plain(text: str) -> str:
    """Return a text that is not bold in an alarming note either."""
    return f'<span style="font-weight:400">{escape(text)}</span>'


def _name(number: int) -> str:
    return "auxiliary slider" if number == _AUXILIARY else f"motor {number} slider"


def _stored_text(parameters: ParameterModel, *, joint: bool, linked: bool) -> str:
    """Return the stored settings; `linked`: each value is a link to the key of its parameter."""

    def link(key: str) -> str:
        wire = parameters.values.stored.get(key)
        if wire is None:
            return ""
        value = escape(parameters.values.specs[key].text(wire))
        if not linked:
            return value
        return f'<a href="{key}" style="color:{theme().color("link").name()}">{value}</a>'

    names = {
        "acceleration": tr("acceleration"),
        "brake_duration": tr("brake duration"),
        "current_limit": tr("current limit"),
    }
    stored = parameters.values.stored.get
    same = all(stored(f"motor1_{key}") == stored(f"motor2_{key}") for key in names)
    parts = []
    for motor in (1,) if same or joint else (1, 2):
        links = {name: link(f"motor{motor}_{key}") for key, name in names.items()}
        title = tr("Both motors") if same else tr("Motor {0}").format(motor)
        if joint:
            title = tr("Motor (joint)")
        pair = tr("{0}: {1}")
        if values := ", ".join(pair.format(*both) for both in links.items() if both[1]):
            parts.append(f"<b>{title}</b> \u2013 {values}.")
    if timeout := link(ParameterKey.SERIAL_TIMEOUT):
        parts.append(f"<b>{tr('Serial timeout')}</b> \u2013 {timeout}.")
    return " ".join(parts)
