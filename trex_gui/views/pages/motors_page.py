"""Driving both motors and the auxiliary by hand."""

from PySide6.QtCore import Slot
from PySide6.QtGui import QShowEvent
from PySide6.QtWidgets import QGroupBox, QLabel, QRadioButton, QVBoxLayout, QWidget

from trex_gui.model.device import Device, Link
from trex_gui.views.widgets.drive_control import DriveControl
from trex_gui.views.widgets.visible import only_when_visible


class MotorsPage(QWidget):
    """Sliders that send nothing before the motors were armed."""

    def __init__(self, device: Device, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("motorsPage")
        self._device = device
        self._motors = device.motors

        self._control = QLabel(self)
        self._control.setObjectName("motorsControl")
        self._control.setWordWrap(True)
        self._armed = QLabel(self)
        self._armed.setObjectName("motorsArmed")
        self._armed.setWordWrap(True)
        self._how = QGroupBox(self.tr("How speeds are sent"), self)
        self._accelerate = QRadioButton(
            self.tr("&Accelerate: with the board's ramp, brake time and current limit"), self._how
        )
        self._accelerate.setObjectName("accelerateButton")
        self._set = QRadioButton(
            self.tr("S&et at once: bypasses ramp and brake time, for a moment also the limit"),
            self._how,
        )
        self._set.setObjectName("setButton")
        self._accelerate.setChecked(self._motors.accelerate)
        self._controls = {
            1: DriveControl(self.tr("Motor 1"), "motor1", parent=self),
            2: DriveControl(self.tr("Motor 2"), "motor2", parent=self),
        }
        self._auxiliary = DriveControl(
            self.tr("Auxiliary motor (one way)"), "aux", two_way=False, parent=self
        )

        how = QVBoxLayout(self._how)
        how.addWidget(self._accelerate)
        how.addWidget(self._set)
        layout = QVBoxLayout(self)
        layout.addWidget(self._armed)
        layout.addWidget(self._control)
        for control in (*self._controls.values(), self._auxiliary):
            layout.addWidget(control)
        layout.addWidget(self._how)
        layout.addStretch(1)

        for motor, control in self._controls.items():
            control.speed_wanted.connect(
                lambda speed, motor=motor: self._motors.set_speed(motor, speed)
            )
            control.brake_wanted.connect(lambda motor=motor: self._motors.set_brake(motor, 127))
        self._auxiliary.speed_wanted.connect(self._motors.set_auxiliary)
        self._accelerate.toggled.connect(self._on_accelerate_toggled)
        self._motors.changed.connect(self._on_motors_changed)
        self._motors.stop_requested.connect(self._on_stop_requested)
        device.link_changed.connect(self._on_motors_changed)
        device.state_changed.connect(self._on_motors_changed)
        device.telemetry.updated.connect(self._on_telemetry_updated)
        self._on_motors_changed()

    @Slot(bool)
    def _on_accelerate_toggled(self, accelerate: bool) -> None:
        self._motors.accelerate = accelerate

    @Slot()
    def _on_stop_requested(self) -> None:
        for control in (*self._controls.values(), self._auxiliary):
            control.let_go()

    @Slot()
    def _on_motors_changed(self) -> None:
        armed = self._motors.armed
        joint = self._device.is_joint
        self._armed.setText(self._armed_text())
        for motor, control in self._controls.items():
            control.setEnabled(armed and not (joint and motor == 2))
            drive = self._motors.drive(motor)
            control.show_wish(drive.signed if drive else 0, self._wish_text(motor))
        self._auxiliary.setEnabled(armed)
        speed = self._motors.auxiliary
        self._auxiliary.show_wish(speed, self.tr("Asked: {0}").format(speed) if armed else "")
        self._how.setEnabled(self._motors.can_arm)
        self._on_telemetry_updated()

    def _armed_text(self) -> str:
        if self._device.link is Link.SILENT:
            return self.tr("The board does not answer.")
        if self._device.link is not Link.UP:
            return self.tr("Connect to a board to drive its motors.")
        if not self._motors.can_arm:
            return self.tr("This program cannot drive the motors now.")
        if self._motors.armed:
            return self.tr("The motors are armed: sliders move them. Esc stops everything.")
        return self.tr("Nothing is sent yet. Put the robot on blocks, then press Run motor below.")

    def _wish_text(self, motor: int) -> str:
        if not self._motors.armed:
            return ""
        drive = self._motors.drive(motor)
        if drive is None:
            return self.tr("Asked: nothing yet")
        if drive.is_brake:
            return self.tr("Asked: brake, {0:.0f} %").format(100 * drive.speed / 127)
        if drive.speed == 0:
            return self.tr("Asked: 0")
        direction = self.tr("forward") if drive.signed > 0 else self.tr("reverse")
        return self.tr("Asked: {0} {1} ({2:.0f} %)").format(
            direction, drive.speed, 100 * drive.speed / 127
        )

    @Slot()
    @only_when_visible
    def _on_telemetry_updated(self) -> None:
        telemetry = self._device.telemetry
        self._control.setText(self._device.control_text)
        for motor, control in self._controls.items():
            control.show_report(self._report_text(motor))
        if telemetry.serial_controls is None:
            text = self.tr("Board: N/A")
        elif telemetry.serial_controls:
            text = self.tr("Board: takes serial commands, does not report this motor")
        else:
            text = self.tr("Board: keeps the command, channels are in control")
        self._auxiliary.show_report(text)

    def _report_text(self, motor: int) -> str:
        """What the board says of a motor: its current, and what it has latched of late."""
        currents = self._device.telemetry.motor_currents
        if currents is None:
            return self.tr("Board: N/A")
        if self._device.is_joint:
            return self.tr("Board: no current sensing in joint mode")
        parts = [f"{currents[motor - 1]:.2f} A"]
        parts += [entry.name.lower() for entry in self._device.errors.recent(motor)]
        return self.tr("Board: {0}").format(", ".join(parts))

    def showEvent(self, event: QShowEvent) -> None:
        super().showEvent(event)
        self._on_telemetry_updated()
