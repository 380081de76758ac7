"""The steps that find out which way the sticks go, and which motor is which."""

from functools import partial
from itertools import chain

from PySide6.QtCore import Signal, Slot
from PySide6.QtGui import QShowEvent
from PySide6.QtWidgets import QButtonGroup, QWidget

from trex_gui.core.translation import tr
from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.model.drive_status import recent_fault_text
from trex_gui.devices.trex.model.learning.learning import Learning
from trex_gui.devices.trex.model.setup.pulses import STRONGER
from trex_gui.devices.trex.model.setup.robot_setup import RobotSetup
from trex_gui.devices.trex.model.setup.wiring import Driver, Movement, Rewiring, Side, Wiring
from trex_gui.devices.trex.protocol.flags import InputSource
from trex_gui.devices.trex.views.bars import ChannelBar
from trex_gui.devices.trex.views.motor_controls import ArmButton, TimeoutNotice
from trex_gui.ui.theme.theme import set_look
from trex_gui.ui.widgets import builders as ui
from trex_gui.ui.widgets.behaviour import HoldButton, keep_room, only_when_visible
from trex_gui.ui.widgets.labels import Muted, Note


class SticksPage(QWidget):
    """Leads to learning; or, with learned channels, asks for the directions of the sticks."""

    learn_requested = Signal()

    def __init__(
        self, device: Device, setup: RobotSetup, learning: Learning, parent: QWidget
    ) -> None:
        super().__init__(parent)
        self._device = device
        self._setup = setup
        self._learning = learning
        self._unclear: tuple[int, ...] = ()
        text = tr(
            "The board has to know the middle and the ends of each stick. Learning measures them "
            "in about two minutes, in a separate window, and ends with a review. The motors stay "
            "off meanwhile. Learn before you go on: the next step, which motor is which, needs the "
            "directions of the sticks."
        )
        learn_text = ui.label(self, text=text, wrap=True)
        button = partial(ui.button, self, default=False)
        self._learn = button("setupLearnButton", tr("&Learn channels…"), icon="calibrate")
        self._blocker = ui.named(Note(1, self), "setupLearnBlocker")
        text = tr(
            "Already learned? Then show which way the sticks go: push, hold and click. In serial "
            "mode they move no motor."
        )
        pushed_text = ui.label(self, text=text, wrap=True)
        self._forward = button(
            "setupForwardButton", on_click=lambda: self._note((2,) if self._is_one else (1, 2))
        )
        text = tr("The stick is fully &right now")
        self._right = button("setupRightButton", text, on_click=lambda: self._note((1,)))
        self._wiring = Muted(parent=self)
        self._bars = {channel: self._make_bar(channel) for channel in (1, 2)}
        self._known = {
            channel: ui.named(Note(1, self), f"setupStick{channel}Note") for channel in self._bars
        }
        learn_row = ui.row(self._learn, (self._blocker, 1), 1)
        pushing = ui.row(self._forward, self._right, 1)
        above = learn_text, learn_row, pushed_text, pushing, self._wiring
        channels = chain.from_iterable(zip(self._known.values(), self._bars.values(), strict=True))
        ui.column(*above, *channels, 1, into=self, margins=0, spacing=10)

        self._learn.clicked.connect(self.learn_requested)
        device.telemetry.frame_due.connect(self._show_inputs)

    def _make_bar(self, channel: int) -> ChannelBar:
        accessible = tr("Raw input of channel {0}").format(channel)
        return ui.named(ChannelBar(self), f"setupChannel{channel}Bar", accessible=accessible)

    @property
    def _is_one(self) -> bool:
        return self._setup.driver is Driver.ONE_STICK

    def _note(self, channels: tuple[int, ...]) -> None:
        self._unclear = self._setup.note_pushed(channels)
        self.refresh()

    def refresh(self) -> None:
        blocker = self._learning.preconditions.blocker
        self._learn.setEnabled(not blocker)
        self._blocker.show_note(blocker, alarming=True)
        self._right.setVisible(self._is_one)
        one = tr("The stick is fully &forward now")
        two = tr("Both sticks are fully &forward now")
        self._forward.setText(one if self._is_one else two)
        can_push = self._device.is_connected and not self._device.writer.is_rejected
        for button in (self._forward, self._right):
            button.setEnabled(can_push)
        self._wiring.setText(self._wiring_text())
        device = self._device
        for channel, bar in self._bars.items():
            bar.set_connected(device.is_connected)
            bar.set_source(device.calibrations.source)
            bar.set_calibration(device.calibrations.stored(channel))
            is_unclear = channel in self._unclear and channel not in self._setup.rises
            self._known[channel].show_note(self._stick_text(channel), alarming=is_unclear)
        self._show_inputs()

    @Slot()
    @only_when_visible
    def _show_inputs(self) -> None:
        telemetry = self._device.telemetry
        if telemetry.raw is not None:
            for channel, bar in self._bars.items():
                bar.set_raw(telemetry.raw_of(channel))

    def _wiring_text(self) -> str:
        one = tr("Channel 1 is for left and right of the stick, channel 2 for forward and back.")
        text = one if self._is_one else tr("Channel 1 is for motor 1, channel 2 for motor 2.")
        if self._device.calibrations.source is InputSource.RC:
            text = f"{text} {tr('Each is connected to an output of your receiver.')}"
        return text

    def _stick_text(self, channel: int) -> str:
        """Return what is known of the direction of a stick, or why it could not be seen."""
        names = {1: tr("Channel 1 (motor 1)"), 2: tr("Channel 2 (motor 2)")}
        if self._is_one:
            names = {1: tr("Channel 1 (turns)"), 2: tr("Channel 2 (drives)")}
        texts = {
            None: tr("{0}: its direction is not known yet."),
            True: tr("{0}: the value rises."),
            False: tr("{0}: the value falls."),
        }
        if channel in self._unclear:
            texts[None] = tr("{0}: the stick is still near its middle. Push it all the way.")
            if self._device.telemetry.raw_of(channel) is None:
                texts[None] = tr("{0}: no signal arrives.")
        text = texts[self._setup.rises.get(channel)].format(names[channel])
        is_rc = self._device.calibrations.source is InputSource.RC
        if channel in self._unclear and channel not in self._setup.rises and is_rc:
            text = f"{text} {tr('Is the transmitter on?')}"
        return text


class _MotorBox(ui.Card):
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
        set_look(self._hold, "primary")
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
        text = tr("The wheels are &off the ground, and nothing can get caught in them")
        self._free = ui.check_box(self, "setupWheelsFree", text)
        self._run_place = QWidget(self)  # disables the button, which enables itself
        run = ArmButton(device, "setupRunButton", self._run_place)
        run.setAutoDefault(False)
        self._run_place.setEnabled(False)
        ui.row(run, into=self._run_place, margins=0)
        self._note = ui.named(Note(2, self), "setupPulseNote")
        self._boxes = [_MotorBox(setup, motor, self) for motor in (1, 2)]
        self._result = ui.named(Note(4, self), "setupWiringNote")
        text = tr("Wir&es swapped – test again")
        tip = tr("Forget both answers and find out again which motor is which")
        self._again = ui.button(
            self, "setupAgainButton", text, icon="reload", default=False, tip=tip
        )
        keep_room(self._again)
        top = ui.row((self._free, 1), self._run_place)
        boxes = ui.row(*((box, 1) for box in self._boxes))
        result = ui.row((self._result, 1), self._again, spacing=10)
        notice = TimeoutNotice(device, self)
        ui.column(top, self._note, boxes, result, 1, notice, into=self, margins=0)

        self._free.clicked.connect(setup.pulses.confirm_wheels)
        self._again.clicked.connect(setup.forget_movements)
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
        may_run = can_confirm and pulses.wheels_are_free
        self._run_place.setEnabled(may_run or self._device.motors.armed)
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
