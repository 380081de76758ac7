"""Driving both motors and the auxiliary by hand."""

from functools import partial

from PySide6.QtCore import QEvent, Signal, Slot
from PySide6.QtGui import QHideEvent, QShowEvent
from PySide6.QtWidgets import QGridLayout, QGroupBox, QWidget

from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.model.drive_status import SafeStartWatch, drive_inputs
from trex_gui.devices.trex.model.drive_texts import (
    auxiliary_report_text,
    channel_text,
    report_text,
    setpoint_text,
)
from trex_gui.devices.trex.model.motors import MomentaryDrive
from trex_gui.devices.trex.views.driving.gamepad_panel import GamepadPanel
from trex_gui.devices.trex.views.driving.key_driver import KeyDriver
from trex_gui.devices.trex.views.pages.motors.drive_control import DriveControl
from trex_gui.devices.trex.views.pages.motors.drive_pad import DrivePad
from trex_gui.devices.trex.views.pages.motors.options import Options
from trex_gui.devices.trex.views.pages.motors.status_lines import Facts, Head
from trex_gui.ui.devices.connection_state import ConnectionState
from trex_gui.ui.runtime import runtime
from trex_gui.ui.theme.theme import theme
from trex_gui.ui.widgets import builders as ui
from trex_gui.ui.widgets.behaviour import only_when_visible

_AUXILIARY = 3
"""The auxiliary motor among the controls: it goes by the number of its channel."""


class MotorsPage(QWidget):
    """Nothing moves before the motors were armed; leaving the page lets go of everything.

    Signals:
        parameter_wanted: the key of a parameter that the user wants to see or change.
    """

    parameter_wanted = Signal(str)

    def __init__(self, device: Device, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("motorsPage")
        self._device = device
        self._motors = device.motors
        self._pad_drive = MomentaryDrive(device.motors, "drive pad")
        self._key_drive = MomentaryDrive(device.motors, "keyboard")

        self._safe_start = SafeStartWatch(device, self)

        self._holder = ""
        self._dragged: int | None = None
        self._forget_holder = runtime().timer(self)
        self._forget_holder.setSingleShot(True)
        self._forget_holder.setInterval(0)

        self._head = Head(self)
        self._drive_box = QGroupBox(self.tr("Drive"), self)
        self._pad = DrivePad(self._drive_box)
        self._controls = {
            1: DriveControl(self.tr("Motor 1"), "motor1", parent=self._drive_box),
            2: DriveControl(self.tr("Motor 2"), "motor2", parent=self._drive_box),
            _AUXILIARY: DriveControl(
                self.tr("Auxiliary (one way)"), "aux", two_way=False, parent=self._drive_box
            ),
        }
        self._options = Options(device.motors, self)
        self._facts = Facts(device.parameters, self)
        self._keys = KeyDriver(self._key_drive, device.motors, self, self._pad)

        drive = ui.row(self._pad, into=self._drive_box, spacing=16)
        column = ui.column(*self._controls.values(), 1, spacing=8)
        drive.addLayout(column, 1)
        self._docks = QGridLayout()
        self.dock(GamepadPanel(device, self))
        ui.column(
            self._head, self._drive_box, self._options, self._facts, self._docks, 1, into=self
        )

        self._forget_holder.timeout.connect(self._on_event_over)
        self._head.run_wanted.connect(self._motors.arm)
        for number, control in self._controls.items():
            control.speed_wanted.connect(partial(self._on_speed_wanted, number))
            control.brake_wanted.connect(partial(self._on_brake_wanted, number))
            control.grabbed.connect(partial(self._on_grabbed, number))
            control.released.connect(partial(self._on_released, number))
        self._pad.steered.connect(self._on_pad_steered)
        self._pad.released.connect(self._pad_drive.let_go)
        self._keys.steered.connect(self._pad.show_position)
        self._options.keys_toggled.connect(self._keys.set_enabled)
        self._facts.parameter_wanted.connect(self.parameter_wanted)
        motors = self._motors
        motors.holder_changed.connect(self._on_holder_changed)
        motors.setpoints_changed.connect(self._show_setpoints)
        motors.arming_changed.connect(self._show_setpoints)
        for signal in (
            motors.arming_changed,
            motors.availability_changed,
            motors.options_changed,
            motors.lockout_changed,
        ):
            signal.connect(self._show_options)
        self._motors.stop_requested.connect(self._on_stop_requested)
        device.link_changed.connect(self._show_options)
        device.state_changed.connect(self._on_state_changed)
        theme().changed.connect(self._on_state_changed)
        device.telemetry.updated.connect(self._on_telemetry_updated)
        self._on_state_changed()

    def dock(self, panel: QWidget) -> None:
        """Take in another way to drive, below the options."""
        self._docks.addWidget(panel)

    # --- User actions -------------------------------------------------------------------

    def _on_speed_wanted(self, number: int, speed: int) -> None:
        holder = _name(number) if self._motors.holder == _name(number) else ""
        if number == _AUXILIARY:
            self._motors.set_auxiliary(speed, holder)
            taken = self._motors.auxiliary == speed
        else:
            self._motors.set_speed(number, speed, holder)
            drive = self._motors.drive(number)
            taken = drive is not None and drive.signed == speed
        if not taken:  # it is not to stay on the slider
            self._show_setpoints()

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
            self._pad.let_go()

    # --- What has changed ---------------------------------------------------------------

    @Slot()
    def _on_stop_requested(self) -> None:
        for control in self._controls.values():
            control.let_go()
        self._pad.let_go()

    @Slot()
    def _on_state_changed(self) -> None:
        joint = self._device.is_joint
        for drive in (self._pad_drive, self._key_drive):
            drive.joint = joint
        self._controls[1].set_title(self.tr("Motor (joint)") if joint else self.tr("Motor 1"))
        self._options.set_joint(joint)
        self._facts.refresh(joint=joint)
        self._show_setpoints()
        self._show_options()

    @Slot()
    def _on_holder_changed(self) -> None:
        self._note_holder()
        if self._pad.held and not self._pad_drive.held:
            self._pad.let_go()

    @Slot()
    def _show_options(self) -> None:
        """Let every control offer what can be done now."""
        motors = self._motors
        self._pad.setEnabled(motors.armed)
        self._pad.set_can_turn(self._pad_drive.can_turn)
        brake = self.tr("Brake with {0:.0f} %: Brake strength, below").format(
            100 * motors.release_brake / 127
        )
        for number, control in self._controls.items():
            control.setEnabled(motors.armed and not self._is_unused(number))
            control.set_ceiling(motors.ceiling)
            control.set_brake_text(brake)
        self._on_telemetry_updated()

    def _is_unused(self, number: int) -> bool:
        return number == 2 and self._device.is_joint

    @Slot()
    def _show_setpoints(self) -> None:
        motors = self._motors
        for number in (1, 2):
            drive = motors.drive(number)
            text = setpoint_text(drive) if motors.armed else ""
            if self._is_unused(number):
                text = self.tr("Joint mode: follows motor 1")
            self._controls[number].show_setpoint(drive.signed if drive else 0, text)
        text = self.tr("Setpoint: {0}").format(motors.auxiliary) if motors.armed else ""
        self._controls[_AUXILIARY].show_setpoint(motors.auxiliary, text)

    @Slot()
    @only_when_visible
    def _on_telemetry_updated(self) -> None:
        device, motors = self._device, self._motors
        inputs = drive_inputs(device, perhaps_held=self._safe_start.may_hold)
        can_run = motors.is_available and not motors.armed and not motors.locked_for
        self._head.show_status(inputs, can_run=can_run)
        driven = self._channels_drive()
        self._pad.setVisible(not driven)
        for number, control in self._controls.items():
            control.set_channel_driven(driven)
            if driven:
                self._show_channel(number, control)
            if number == _AUXILIARY:
                control.show_report(auxiliary_report_text(device))
            elif self._is_unused(number):
                control.show_report("")
            else:
                control.show_report(report_text(device, number))

    def _channels_drive(self) -> bool:
        """Whether channels have the motors, so that there is nothing to do here but look."""
        state = self._device.state
        if (
            state is None
            or self._device.link is not ConnectionState.CONNECTED
            or state.mode.is_serial
        ):
            return False
        return not self._device.telemetry.serial_controls

    def _show_channel(self, number: int, control: DriveControl) -> None:
        telemetry = self._device.telemetry
        there = telemetry.raw is None or telemetry.raw_of(number) is not None
        control.setEnabled(not self._is_unused(number))
        control.show_channel(telemetry.remapped_of(number) if there else None)
        if not self._is_unused(number):
            control.show_setpoint(0, channel_text(self._device, number))

    def showEvent(self, event: QShowEvent) -> None:
        super().showEvent(event)
        self._show_options()

    def hideEvent(self, event: QHideEvent) -> None:
        """Stop what is held here: who cannot see the page does not see the motors' controls.

        A slider under a hand counts as held, also where it stays when it is let go.
        """
        is_dragged = self._dragged is not None and self._motors.armed
        self._dragged = None
        if self._holder or is_dragged:
            self._motors.stop(self.tr("The Motors page was left while a control was held."))
        super().hideEvent(event)

    def _note_holder(self) -> None:
        """Remember what is held here until the event is over that ended it.

        A page that goes takes the focus from its controls first, and they let go by themselves.
        """
        own = {self._pad_drive.name, self._key_drive.name, *map(_name, self._controls)}
        if self._motors.holder in own:
            self._holder = self._motors.holder
        elif self._holder:
            self._forget_holder.start()

    def changeEvent(self, event: QEvent) -> None:
        if event.type() == QEvent.Type.ActivationChange and self.isActiveWindow():
            self._forget_holder.start()
        super().changeEvent(event)

    @Slot()
    def _on_event_over(self) -> None:
        """Forget who held; not while the window is inactive: it may be on its way to be minimised.

        A window that is minimised is deactivated first, in an event of its own.
        """
        if self.isActiveWindow() and not any(each.is_held for each in self._controls.values()):
            self._dragged = None
        if self._motors.holder != self._holder:
            self._holder = ""


def _name(number: int) -> str:
    """What the motors know a slider by."""
    return "auxiliary slider" if number == _AUXILIARY else f"motor {number} slider"
