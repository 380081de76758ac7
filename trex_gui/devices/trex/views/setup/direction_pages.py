"""Set-up steps for the stick directions and the motor wiring."""

from functools import partial

from PySide6.QtCore import Qt, Slot
from PySide6.QtGui import QShowEvent
from PySide6.QtWidgets import QPushButton

from trex_gui.core.translation import tr
from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.model.learning.learning import Learning
from trex_gui.devices.trex.model.setup.pulses import STRONGER
from trex_gui.devices.trex.model.setup.robot_setup import RobotSetup
from trex_gui.devices.trex.model.setup.wiring import Driver, Movement, Rewiring, Side, Wiring
from trex_gui.devices.trex.protocol.flags import CHANNELS, InputSource
from trex_gui.devices.trex.views.learning.live_pages import InputStrip
from trex_gui.devices.trex.views.motor_controls import TimeoutNotice
from trex_gui.devices.trex.views.pulse_controls import PulseControls
from trex_gui.devices.trex.views.robot_view import MOVEMENTS, RobotView
from trex_gui.devices.trex.views.steps import Page
from trex_gui.ui.theme.theme import set_look, set_text_color
from trex_gui.ui.widgets import builders as ui
from trex_gui.ui.widgets.behaviour import only_when_visible
from trex_gui.ui.widgets.labels import Muted, Note


class SticksPage(Page):
    def __init__(self, device: Device, setup: RobotSetup, learning: Learning) -> None:
        super().__init__("setupSticksPage", tr("The board learns your sticks"))
        self._device = device
        self._setup = setup
        self._learning = learning
        self._unclear: tuple[int, ...] = ()
        side = self.side
        text = tr(
            "Learning takes about two minutes, and the motors stay off. The next step "
            "needs the stick directions."
        )
        button = partial(ui.button, side, default=False)
        self._learn = button("setupLearnButton", tr("&Learn channels…"), icon="calibrate")
        self._learn.clicked.connect(lambda: learning.start(CHANNELS))
        self._blocker = ui.named(Note(1, side), "setupLearnBlocker")
        pushed = ui.label(
            side,
            text=tr("Already learned? Hold the sticks as a button says, then click the button:"),
            wrap=True,
        )
        self._forward = button("setupForwardButton")
        self._forward.clicked.connect(lambda: self._record((2,) if self._has_one_stick else (1, 2)))
        text_right = tr("The stick is fully &right now")
        self._right = button("setupRightButton", text_right, on_click=lambda: self._record((1,)))
        self._wiring = Muted(tr("Each channel is connected to an output of your receiver."), self)
        self._strips = {channel: InputStrip("setup", channel, self) for channel in (1, 2)}
        self._notes: dict[int, Note] = {}
        channels = ui.column(spacing=8)
        for channel, strip in self._strips.items():
            note = self._notes[channel] = ui.named(Note(2, self), f"setupStick{channel}Note")
            channels.addWidget(strip, 1)
            channels.addWidget(note)
        ui.column((channels, 1), self._wiring, into=self, margins=0)
        items = self._learn, Muted(text, side), self._blocker, pushed, self._forward, self._right
        ui.column(*items, into=side, margins=0)
        device.telemetry.frame_due.connect(self._show_inputs)

    @property
    def _has_one_stick(self) -> bool:
        return self._setup.driver is Driver.ONE_STICK

    def _record(self, channels: tuple[int, ...]) -> None:
        self._unclear = self._setup.record_pushed(channels)
        self.refresh()

    def refresh(self) -> None:
        blocker = self._learning.preconditions.blocker
        self._learn.setEnabled(not blocker)
        self._blocker.show_note(blocker, alarming=True)
        self._right.setVisible(self._has_one_stick)
        one_stick = tr("The stick is fully &forward now")
        two_sticks = tr("Both sticks are fully &forward now")
        self._forward.setText(one_stick if self._has_one_stick else two_sticks)
        can_push = self._device.is_connected and not self._device.writer.is_rejected
        for button in (self._forward, self._right):
            button.setEnabled(can_push)
        self._wiring.setVisible(self._device.calibrations.source is InputSource.RC)
        for channel, note in self._notes.items():
            is_unclear = channel in self._unclear and channel not in self._setup.rises
            text = self._stick_text(channel, is_unclear=is_unclear)
            note.show_note(text, alarming=is_unclear)
        self._show_inputs()

    @Slot()
    @only_when_visible
    def _show_inputs(self) -> None:
        telemetry, calibrations = self._device.telemetry, self._device.calibrations
        for channel, strip in self._strips.items():
            if telemetry.raw is None:
                strip.show_unknown()
                continue
            marks, raw = calibrations.stored(channel), telemetry.raw_of(channel)
            strip.show_input(telemetry.latest, calibrations.source, marks, raw)

    def _stick_text(self, channel: int, *, is_unclear: bool) -> str:
        names = {1: tr("Channel 1 (motor 1)"), 2: tr("Channel 2 (motor 2)")}
        if self._has_one_stick:
            names = {1: tr("Channel 1 (turns)"), 2: tr("Channel 2 (drives)")}
        texts = {
            None: tr("{0}: the direction is not known yet."),
            True: tr("{0}: the value rises."),
            False: tr("{0}: the value falls."),
        }
        text = texts[self._setup.rises.get(channel)]
        if is_unclear:
            text = tr("{0}: the stick is still near its centre. Push the stick all the way.")
            if self._device.telemetry.raw_of(channel) is None:
                text = tr("{0}: no signal arrives.")
            if self._device.calibrations.source is InputSource.RC:
                text = f"{text} {tr('Is the transmitter on?')}"
        return text.format(names[channel])


class WiringPage(Page):
    def __init__(self, device: Device, setup: RobotSetup) -> None:
        super().__init__("setupWiringPage", tr("Hold a button, then click what moved"))
        self._device = device
        self._setup = setup
        self._motor = 1  # motor of the next answer
        side = self.side
        self._question = ui.label(self, "setupQuestion", bold=True)
        self._robot = RobotView(self, with_buttons=True)
        self._robot.wheel_clicked.connect(self._record)
        button = partial(ui.button, self, default=False)
        self._nothing = button("setupNothingMoved", tr("Nothing &moved"), checkable=True)
        self._nothing.clicked.connect(lambda: self._record(Movement.NOTHING))
        middle = Qt.AlignmentFlag.AlignHCenter
        text = tr("Wir&es swapped – test again")
        tip = tr("Clear both answers and test the motors again")
        self._again = button("setupAgainButton", text, icon="reload", tip=tip)
        below = ui.row(1, self._nothing, self._again, 1)
        items = (self._question, 0, middle), (self._robot, 1), below
        ui.column(*items, into=self, margins=0)

        self._answers = {motor: self._create_answer(motor) for motor in (1, 2)}
        self._controls = PulseControls("setup", device, setup.pulses, side, self._answers)
        self._controls.hold_started.connect(self._on_hold_started)
        self._result = ui.named(Note(2, side), "setupWiringNote")
        notice = TimeoutNotice(device, side)
        ui.column(self._controls, self._result, notice, into=side, margins=0, spacing=6)

        self._again.clicked.connect(setup.clear_movements)
        self._again.clicked.connect(partial(self._prompt, 1))
        for changed in (setup.changed, setup.pulses.changed, device.telemetry.text_due):
            changed.connect(self.refresh)

    def _create_answer(self, motor: int) -> QPushButton:
        name, tip = f"setupAnswer{motor}", tr("Click what this motor moved")
        answer = ui.button(self.side, name, tip=tip, default=False)
        set_look(answer, "link")
        answer.clicked.connect(partial(self._prompt, motor))
        return answer

    def _prompt(self, motor: int) -> None:
        self._motor = motor
        self.refresh()

    @Slot(int)
    def _on_hold_started(self, motor: int) -> None:
        self._motor = motor
        stronger = self._setup.movements.get(motor) is Movement.NOTHING
        self._setup.pulses.start(motor, stronger=stronger)

    @Slot(object)
    def _record(self, movement: Movement) -> None:
        motor = self._motor
        if 3 - motor not in self._setup.movements and movement is not Movement.NOTHING:
            self._motor = 3 - motor
        self._setup.record_movement(motor, movement)

    def _show_answers(self) -> None:
        movements = self._setup.movements
        self._question.setText(tr("What did motor {0} move?").format(self._motor))
        set_text_color(self._question, f"motor{self._motor}")
        colors = dict.fromkeys(Side, "outline")
        for motor, answer in self._answers.items():
            movement, sign = movements.get(motor), ""
            text = tr(MOVEMENTS[movement]) if movement else tr("not tried yet")
            if movement and movement.side:
                colors[movement.side], sign = f"motor{motor}", "✓ "
            answer.setText(f"{sign}{tr('Motor &{0}').format(motor)}: {text}")
        for side, color in colors.items():
            self._robot.show_wheel(side, 0, color)
        movement = movements.get(self._motor)
        self._robot.select(movement)
        self._nothing.setChecked(movement is Movement.NOTHING)

    def showEvent(self, event: QShowEvent) -> None:
        super().showEvent(event)
        self.refresh()

    @Slot()
    @only_when_visible
    def refresh(self) -> None:
        self._controls.refresh()
        self._show_answers()
        wiring = self._setup.wiring
        rewiring = wiring.rewiring(self._setup.driver) if wiring else None
        self._again.setVisible(bool(rewiring))
        self._result.show_note(self._result_text(wiring, rewiring), alarming=bool(rewiring))

    def _result_text(self, wiring: Wiring | None, rewiring: Rewiring | None) -> str:
        setup = self._setup
        if Movement.NOTHING in setup.movements.values():
            if self._device.motors.ceiling < STRONGER:
                return tr(
                    "Nothing turned: the pulses stay below the speed ceiling of the Motors "
                    "page. Raise the ceiling, or check the battery and the wires of this "
                    "motor."
                )
            return tr(
                "Nothing turned: the next pulses are stronger (30 %). If that does not help, check "
                "the battery and the wires of this motor."
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
            return tr(
                "No wires have to be swapped, but the directions of the sticks are not known yet: "
                "go back to Sticks. Your answers are kept."
            )
        if setup.edits:
            return tr("Settings correct this; no wires have to be swapped.")
        return tr("Nothing has to change: the wheels follow the sticks.")


def rewiring_text(driver: Driver, rewiring: Rewiring) -> str:
    texts = [tr("Switch the motors' power off.")]
    swap = tr("Swap the wire pairs of motors 1 and 2. Keep the order within each pair.")
    if rewiring.exchange_motors:
        texts.append(swap)
    left = tr("Swap the two wires of the left motor.")
    right = tr("Swap the two wires of the right motor.")
    texts += [left if side is Side.LEFT else right for side in sorted(rewiring.reverse)]
    program = tr("No setting can make this change for serial commands, but your own program can.")
    board = tr("No setting of the board can make this change.")
    return " ".join([*texts, program if driver is Driver.COMPUTER else board])
