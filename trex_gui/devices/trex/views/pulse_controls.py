"""Buttons that turn a motor in weak pulses while they are held."""

from collections.abc import Mapping
from functools import partial
from types import MappingProxyType

from PySide6.QtCore import Signal, Slot
from PySide6.QtWidgets import QWidget

from trex_gui.core.translation import tr
from trex_gui.devices.trex.board.drive_status import drive_statuses
from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.model.drive_status import drive_inputs, fault_text
from trex_gui.devices.trex.model.setup.pulses import MotorPulses
from trex_gui.devices.trex.views.motor_controls import ArmButton
from trex_gui.ui.theme.theme import set_look
from trex_gui.ui.widgets import builders as ui
from trex_gui.ui.widgets.behaviour import HoldButton, only_when_visible
from trex_gui.ui.widgets.labels import Note


class PulseControls(QWidget):
    """Check box, arm button, and a hold button for each motor.

    `below` maps motor numbers to the widgets below the hold buttons. The owner starts the pulses
    when `hold_started` is emitted.
    """

    hold_started = Signal(int)  # motor number

    def __init__(
        self,
        name: str,
        device: Device,
        pulses: MotorPulses,
        parent: QWidget,
        below: Mapping[int, QWidget] = MappingProxyType({}),
    ) -> None:
        super().__init__(parent)
        self._device, self._pulses = device, pulses
        text = tr("The wheels are &off the ground")
        self._wheels = ui.check_box(self, f"{name}WheelsFree", text, on_click=pulses.confirm_wheels)
        # Keeps the arm button disabled even if the button enables itself.
        self._arm_frame = QWidget(self)
        arm_button = ArmButton(device, f"{name}RunButton", self._arm_frame)
        arm_button.setAutoDefault(False)
        self._arm_frame.setEnabled(False)
        ui.row(arm_button, into=self._arm_frame, margins=0)
        self._note = ui.named(Note(2, self), f"{name}PulseNote")
        self._hold_buttons = {
            motor: self._create_hold_button(f"{name}Hold{motor}", motor) for motor in (1, 2)
        }
        motor_widgets: list[QWidget] = []
        for motor, hold in self._hold_buttons.items():
            motor_widgets += [hold, below[motor]] if motor in below else [hold]
        for widget in motor_widgets:  # determines the Tab order
            widget.setParent(self)
        items = self._wheels, self._arm_frame, self._note
        ui.column(*items, *motor_widgets, into=self, margins=0, spacing=6)
        for changed in (pulses.changed, device.telemetry.text_due):
            changed.connect(self.refresh)

    def _create_hold_button(self, name: str, motor: int) -> HoldButton:
        hold = HoldButton(tr("Hold to turn motor {0}").format(motor))
        tip = tr("Short, weak pulses while you hold the button with the mouse or the space bar")
        ui.named(hold, name, tip=tip)
        hold.setMinimumHeight(2 * self.fontMetrics().height() + 4)
        set_look(hold, f"motor{motor}")
        ui.set_bold(hold)
        hold.hold_started.connect(partial(self.hold_started.emit, motor))
        hold.hold_ended.connect(self._pulses.release)
        return hold

    @Slot()
    @only_when_visible
    def refresh(self) -> None:
        pulses, blocker = self._pulses, self._pulses.blocker
        can_confirm = self._device.is_connected and not pulses.mode_problem
        self._wheels.setEnabled(can_confirm)
        self._wheels.setChecked(pulses.wheels_are_free)
        may_arm = can_confirm and pulses.wheels_are_free
        self._arm_frame.setEnabled(may_arm or self._device.motors.armed)
        for motor, hold in self._hold_buttons.items():
            hold.setEnabled(pulses.motor in {0, motor} and not blocker)
        text = blocker or tr(
            "Armed. The motor turns in short, weak pulses while you hold the button."
        )
        if pulses.motor:
            text = tr("Motor {0} is driven in pulses. Release the button to stop the motor.")
            text = text.format(pulses.motor)
        if not blocker:
            text = fault_text(drive_statuses(drive_inputs(self._device))) or text
        self._note.show_note(text, alarming=self._device.motors.armed)
