"""The step that finds out which motor is which."""

from functools import partial

from PySide6.QtCore import Slot
from PySide6.QtGui import QShowEvent
from PySide6.QtWidgets import QButtonGroup, QWidget

from trex_gui.core.translation import tr
from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.model.drive_status import recent_fault_text
from trex_gui.devices.trex.model.setup.pulses import STRONGER
from trex_gui.devices.trex.model.setup.robot_setup import RobotSetup
from trex_gui.devices.trex.model.setup.wiring import Driver, Movement, Rewiring, Side, Wiring
from trex_gui.devices.trex.views.motor_controls import RunButton, TimeoutNotice
from trex_gui.ui.theme.theme import tint
from trex_gui.ui.widgets import builders as ui
from trex_gui.ui.widgets.behaviour import HoldButton, keep_room, only_when_visible
from trex_gui.ui.widgets.labels import Note


class _MotorBox(ui.GroupBox):
    """A button to hold for one motor, and what it moved."""

    def __init__(self, setup: RobotSetup, motor: int, parent: QWidget) -> None:
        super().__init__(tr("Motor {0}").format(motor), parent)
        self._setup = setup
        self._motor = motor
        tip = tr("Short, weak pulses while you hold it with the mouse or the space bar")
        hold = HoldButton(tr("Hold to pulse motor {0}").format(motor), self)
        self._hold = ui.named(hold, f"setupHold{motor}", tip=tip)
        self._hold.setMinimumHeight(2 * self.fontMetrics().height() + 4)
        ui.set_bold(self._hold)
        tint(self._hold, "run")
        question = ui.label(self, text=tr("What turned, and which way?"))
        texts = {
            Movement.LEFT_FORWARD: tr("Left wheel, forward"),
            Movement.RIGHT_FORWARD: tr("Right wheel, forward"),
            Movement.LEFT_BACKWARD: tr("Left wheel, backward"),
            Movement.RIGHT_BACKWARD: tr("Right wheel, backward"),
            Movement.NOTHING: tr("Nothing"),
        }
        self._answers = {}
        self._group = QButtonGroup(self)
        for movement, text in texts.items():
            name = f"setupMotor{motor}{movement.name.title().replace('_', '')}"
            answer = ui.radio_button(self, name, text)
            answer.setAccessibleName(f"{self.title()}: {text}")
            answer.clicked.connect(partial(setup.note_movement, motor, movement))
            self._group.addButton(answer)
            self._answers[movement] = answer
        ui.column(self._hold, question, *self._answers.values(), into=self, spacing=4)

        self._hold.hold_started.connect(self._on_hold_started)
        self._hold.hold_ended.connect(setup.pulses.release)

    @Slot()
    def _on_hold_started(self) -> None:
        stronger = self._setup.movements.get(self._motor) is Movement.NOTHING
        self._setup.pulses.start(self._motor, stronger=stronger)

    def show_state(self, *, can_hold: bool) -> None:
        pulses = self._setup.pulses
        self._hold.setEnabled(pulses.motor in {0, self._motor} and can_hold)
        seen = self._setup.movements.get(self._motor)
        self._group.setExclusive(False)
        for movement, answer in self._answers.items():
            answer.setChecked(movement is seen)
        self._group.setExclusive(True)


class WiringPage(QWidget):
    """Nothing on it moves while motors are armed: texts have their room, buttons are disabled."""

    def __init__(self, device: Device, setup: RobotSetup, parent: QWidget) -> None:
        super().__init__(parent)
        self.setObjectName("setupWiringPage")
        self._device = device
        self._setup = setup
        self._free = ui.check_box(
            self,
            "setupWheelsFree",
            tr("The wheels are &off the ground, and nothing can get caught in them"),
            on_click=setup.pulses.confirm_wheels,
        )
        self._run_place = QWidget(self)  # disables the button, which enables itself
        run = RunButton(device, "setupRunButton", self._run_place)
        run.setAutoDefault(False)
        self._run_place.setEnabled(False)
        ui.row(run, into=self._run_place, margins=0)
        self._note = ui.named(Note(2, self), "setupPulseNote")
        self._boxes = [_MotorBox(setup, motor, self) for motor in (1, 2)]
        self._result = ui.named(Note(4, self), "setupWiringNote")
        self._again = ui.button(
            self,
            "setupAgainButton",
            tr("Wir&es swapped – test again"),
            icon="reload",
            default=False,
            tip=tr("Forget both answers and find out again which motor is which"),
            on_click=setup.forget_movements,
        )
        keep_room(self._again)
        top = ui.row((self._free, 1), self._run_place)
        boxes = ui.row(*((box, 1) for box in self._boxes))
        result = ui.row((self._result, 1), self._again, spacing=10)
        notice = TimeoutNotice(device, self)
        ui.column(top, self._note, boxes, result, 1, notice, into=self, margins=0)

        for changed in (setup.changed, setup.pulses.changed, device.telemetry.text_due):
            changed.connect(self.refresh)

    def showEvent(self, event: QShowEvent) -> None:
        super().showEvent(event)
        self.refresh()

    @Slot()
    @only_when_visible
    def refresh(self) -> None:
        pulses, blocker = self._setup.pulses, self._setup.pulses.blocker
        can_confirm = self._device.is_connected and not pulses.cannot_drive
        self._free.setEnabled(can_confirm)
        self._free.setChecked(pulses.wheels_are_free)
        self._run_place.setEnabled(can_confirm and pulses.wheels_are_free)
        for box in self._boxes:
            box.show_state(can_hold=not blocker)
        text = blocker or tr(
            "Armed. Hold a button: its motor is driven forward in short, weak pulses; the other "
            "one stays at rest. Then say below what turned."
        )
        if pulses.motor:
            text = tr("Motor {0} is driven in pulses. Release the button to stop it.")
            text = text.format(pulses.motor)
        if not blocker:
            text = recent_fault_text(self._device) or text
        self._note.show_note(text, alarming=self._device.motors.armed)
        wiring = self._setup.wiring
        rewiring = wiring.rewiring(self._setup.driver) if wiring else None
        self._again.setVisible(bool(rewiring))
        self._result.show_note(self._result_text(wiring, rewiring), alarming=bool(rewiring))

    def _result_text(self, wiring: Wiring | None, rewiring: Rewiring | None) -> str:
        setup = self._setup
        if Movement.NOTHING in setup.movements.values():
            if self._device.motors.ceiling < STRONGER:
                return tr(
                    "Nothing turned: the pulses stay below the speed ceiling of the Motors page. "
                    "Raise it, or check the battery and the wires of this motor."
                )
            return tr(
                "Nothing turned: the next pulses are stronger (30 % instead of 20 %). If that does "
                "not help, check the battery and the wires of this motor."
            )
        if wiring is None or rewiring is None:
            if len(setup.movements) == 2:
                return tr("Two motors cannot drive the same wheel: try both buttons again.")
            return ""
        if rewiring:
            return rewiring_text(setup.driver, rewiring)
        if not setup.driver.uses_sticks:
            return tr("Motor 1 drives the left wheel, motor 2 the right one, both forward.")
        if not setup.knows_sticks:
            text = tr(
                "No wires have to be swapped. Settings make the wheels follow the sticks, but "
                "those settings depend on the directions of the sticks, which are not known yet: "
                "go back to Sticks. Your answers are kept."
            )
            swapped = tr("Motor 1 drives the right wheel, motor 2 the left one.")
            return f"{swapped} {text}" if wiring.swapped else text
        if setup.edits:
            return tr("Settings correct this; no wires have to be swapped.")
        return tr("Nothing has to change: the wheels follow the sticks.")


def rewiring_text(driver: Driver, rewiring: Rewiring) -> str:
    """Return what to do with the wires, in sentences."""
    texts = [tr("Switch the motors' power off.")]
    swap = tr("Swap the pair of wires of motor 1 with that of motor 2 (keep their order).")
    if rewiring.exchange_motors:
        texts.append(swap)
    left = tr("Swap the two wires of the left motor.")
    right = tr("Swap the two wires of the right motor.")
    sides = sorted(rewiring.reverse, key=lambda side: side.value)
    texts += [left if side is Side.LEFT else right for side in sides]
    program = tr("No setting does this for serial commands; your own program can do it instead.")
    board = tr("No setting of the board does this.")
    return " ".join([*texts, program if driver is Driver.COMPUTER else board])
