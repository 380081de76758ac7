"""The steps of the assistant that ask, explain or choose values."""

from collections.abc import Mapping
from enum import Enum
from functools import partial
from typing import TypeVar

from PySide6.QtCore import QSignalBlocker, Qt, Signal, Slot
from PySide6.QtWidgets import QAbstractButton, QButtonGroup, QLabel, QRadioButton, QWidget

from trex_gui.core.translation import tr
from trex_gui.devices.trex.driving.timeout_stop import TimeoutStop
from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.model.drive_texts import timeout_warning_on
from trex_gui.devices.trex.model.setup.presets import LIMITS, Preset
from trex_gui.devices.trex.model.setup.robot_setup import RobotSetup, SetupStep
from trex_gui.devices.trex.model.setup.wiring import Driver
from trex_gui.devices.trex.protocol.descriptions import CURRENT_ACCURACY
from trex_gui.devices.trex.protocol.device_table import device_table
from trex_gui.devices.trex.protocol.flags import InputSource
from trex_gui.devices.trex.protocol.parameters import MotorParameter, ParameterKey
from trex_gui.devices.trex.views.jumper_sketch import JumperPlaces, JumperSketch
from trex_gui.devices.trex.views.setup.direction_pages import rewiring_text
from trex_gui.ui.devices.connection import ConnectionState
from trex_gui.ui.widgets import builders as ui
from trex_gui.ui.widgets.labels import Muted, Note, Sign

ChoiceT = TypeVar("ChoiceT", bound=Enum | None)


class Choices(QWidget):
    """Radio buttons with an explanation below each."""

    chosen = Signal(object)

    def __init__(
        self, name: str, texts: Mapping[ChoiceT, tuple[str, str]], parent: QWidget
    ) -> None:
        super().__init__(parent)
        self.setObjectName(name)
        self._buttons: dict[object, QRadioButton] = {}
        group = QButtonGroup(self)
        column = ui.column(into=self, margins=0, spacing=2)
        for choice, (text, explanation) in texts.items():
            key = "Keep" if choice is None else choice.name.title().replace("_", "")
            button = ui.radio_button(self, f"{name}{key}", text)
            ui.set_bold(button)
            button.clicked.connect(partial(self.chosen.emit, choice))
            group.addButton(button)
            below = Muted(explanation, self)
            below.setContentsMargins(24, 0, 0, 8)
            column.addWidget(button)
            column.addWidget(below)
            self._buttons[choice] = button

    def show_choice(self, choice: object) -> None:
        self._buttons[choice].setChecked(True)


class _Check(QWidget):
    """A statement about the board with a sign."""

    def __init__(self, name: str, parent: QWidget) -> None:
        super().__init__(parent)
        self._sign = Sign(self)
        self._text = ui.named(Note(2, self), name)
        top = Qt.AlignmentFlag.AlignTop
        ui.row((self._sign, 0, top), (self._text, 1), into=self, margins=0)

    def show_result(self, good: bool | None, text: str) -> None:
        """`good`: `None` if it is not known."""
        signs = {True: ("ok", "good"), False: ("warning", "warning"), None: ("info", "info")}
        self._sign.show_sign(*signs[good])
        self._text.show_note(text, alarming=good is False)


class DriverPage(QWidget):
    def __init__(self, setup: RobotSetup, parent: QWidget) -> None:
        super().__init__(parent)
        self._setup = setup
        one_stick = tr(
            "A transmitter or a joystick: forward and back, left and right with one stick. "
            "The board mixes both."
        )
        two_sticks = tr("One stick for each side of the robot, as in a tank.")
        computer = tr(
            "A program, a microcontroller or this window sends commands over the serial line."
        )
        texts = {
            Driver.ONE_STICK: (tr("&One stick"), one_stick),
            Driver.TWO_STICKS: (tr("&Two sticks"), two_sticks),
            Driver.COMPUTER: (tr("&A computer"), computer),
        }
        question = ui.label(self, text=tr("Who drives your robot?"), bold=True)
        self._choices = Choices("setupDriver", texts, self)
        self._choices.chosen.connect(setup.choose_driver)
        text = tr(
            "Each step can be skipped. The assistant writes nothing by itself: what you "
            "choose becomes unapplied changes, which you review at the end."
        )
        items = question, self._choices, Muted(text, self), 1
        ui.column(*items, into=self, margins=0, spacing=10)

    def refresh(self) -> None:
        self._choices.show_choice(self._setup.driver)


class JumperPage(QWidget):
    """What has to be plugged where, and whether the board shows that it is."""

    def __init__(self, device: Device, setup: RobotSetup, parent: QWidget) -> None:
        super().__init__(parent)
        self._device = device
        self._setup = setup
        self._sketch = JumperSketch(self)
        self._text = ui.label(self, "setupJumperText", wrap=True)
        self._mode = _Check("setupModeCheck", self)
        self._mix = _Check("setupMixCheck", self)
        caption = Muted(tr("Schematic: the user's guide shows where your board has them."), self)
        caption.setMaximumWidth(2 * self._sketch.width())
        top = Qt.AlignmentFlag.AlignTop
        left = ui.column(self._sketch, caption, 1)
        right = ui.column((self._text, 0, top), self._mode, self._mix, 1, spacing=12)
        ui.row(left, (right, 1), into=self, margins=0, spacing=20)
        device.telemetry.text_due.connect(self.refresh)

    @Slot()
    def refresh(self) -> None:
        driver, source = self._setup.driver, self._device.calibrations.source
        is_mixed = driver is Driver.ONE_STICK
        mix = {
            Driver.ONE_STICK: tr(
                "Put the mix jumper on: channel 2 drives forward and back, channel 1 turns. It "
                "takes effect at once."
            ),
            Driver.TWO_STICKS: tr(
                "Remove the mix jumper: channel 1 drives motor 1, channel 2 drives motor 2. It "
                "takes effect at once."
            ),
            Driver.COMPUTER: tr(
                "The mix jumper does not matter: it has no effect on serial commands."
            ),
        }
        if driver is Driver.COMPUTER:
            self._sketch.show_boards(JumperPlaces(tr("Always"), "", None))
            mode = tr(
                "Remove the mode jumper and leave it off: the board then accepts settings and "
                "serial commands. It reads the jumper when it is switched on."
            )
        else:
            now = JumperPlaces(tr("Now: to set up"), "", is_mixed)
            position = "RC" if source is InputSource.RC else "Analog"
            self._sketch.show_boards(now, JumperPlaces(tr("Later: to drive"), position, is_mixed))
            mode = tr(
                "Remove the mode jumper to set up the board: it accepts settings only without it. "
                "To drive, put it on RC, or on analog for a joystick with potentiometers. The "
                "board reads it when it is switched on."
            )
        self._text.setText(f"{mode}\n\n{mix[driver]}")
        self._mode.show_result(*self._mode_result())
        self._mix.setVisible(driver.uses_sticks)
        self._mix.show_result(*self._mix_result(is_mixed))

    def _mode_result(self) -> tuple[bool | None, str]:
        state = self._device.state
        if self._device.link is ConnectionState.NOT_RESPONDING:
            return None, tr("The board does not respond: it may be switched off.")
        if state is None or not self._device.is_connected:
            return None, tr("No board is connected, so its jumpers cannot be checked.")
        if state.mode.is_serial:
            return True, tr("This board was started without the mode jumper (serial mode).")
        text = tr(
            "This board was started in {0} mode. Switch it off, remove the mode jumper and switch "
            "it on again. This statement then updates by itself."
        )
        return False, text.format(state.mode.source.word)

    def _mix_result(self, is_mixed: bool) -> tuple[bool | None, str]:
        seen = self._setup.is_mixed
        if seen is not is_mixed and self._device.writer.is_rejected:
            return None, tr(
                "The mix jumper can be checked in serial mode only: in this mode a stick that you "
                "push would drive the motors."
            )
        if seen is None:
            return None, tr(
                "It is not known yet whether the mix jumper is on: the board cannot be asked. Push "
                "a stick to one side, and the answer appears here."
            )
        if seen is is_mixed:
            on, off = tr("The mix jumper is on."), tr("The mix jumper is off.")
            return True, on if seen else off
        take = tr("The mix jumper is on: remove it, then push a stick again.")
        put = tr("The mix jumper is off: put it on, then push a stick again.")
        return False, take if seen else put


class LimitsPage(QWidget):
    def __init__(self, device: Device, setup: RobotSetup, parent: QWidget) -> None:
        super().__init__(parent)
        self._device = device
        self._setup = setup
        texts: dict[Preset | None, tuple[str, str]] = {
            None: (tr("Keep w&hat the board has"), tr("Neither ramps nor limits change.")),
            Preset.TANK: (tr("&Tank"), ""),
            Preset.ROVER: (tr("Ro&ver"), ""),
            Preset.AUTONOMOUS: (tr("&Autonomous robot"), ""),
        }
        self._choices = Choices("setupPreset", texts, self)
        self._explained = self._choices.findChildren(Muted)
        self._limit = ui.double_spin_box(
            self,
            "setupCurrentLimit",
            tr("Current limit of each motor"),
            0.0,
            1.0,
            decimals=2,
            suffix=" A",
            on_change=self._on_limit_changed,
        )
        self._limit.setSpecialValueText(tr("off", "limit"))
        self._hint = ui.named(Note(3, self), "setupLimitHint")
        self._choices.chosen.connect(setup.choose_preset)
        question = ui.label(self, text=tr("How should the motors start and stop?"), bold=True)
        title = ui.label(self, text=tr("Current &limit of each motor"), buddy=self._limit)
        items = question, self._choices, ui.row(title, self._limit, 1), self._hint, 1
        ui.column(*items, into=self, margins=0, spacing=8)

    def refresh(self) -> None:
        device, setup = self._device, self._setup
        parameters = device.parameters
        self._choices.show_choice(setup.preset)
        self.setEnabled(bool(parameters.model_key))
        if not parameters.model_key:
            return
        for preset, explained in zip(Preset, self._explained[1:], strict=True):
            explained.setText(self._text_of(preset))
        spec = parameters.values.specs[LIMITS[0]]
        stored = parameters.values.value_of(LIMITS[0]) or 0
        wire = stored if setup.current_limit is None else setup.current_limit
        with QSignalBlocker(self._limit):
            self._limit.setDecimals(spec.decimals)
            self._limit.setRange(0, spec.maximum * spec.scale)
            self._limit.setSingleStep(spec.scale)
            self._limit.setValue(wire * spec.scale)
        self._limit.setEnabled(not device.board.is_joint)
        self._hint.show_note(self._hint_text())

    def _hint_text(self) -> str:
        preset = self._setup.preset
        if self._device.board.is_joint:
            return tr("In joint mode the board measures no current, so it cannot limit it.")
        text = tr(
            "Set the current that your motors can draw continuously; the values above are only "
            "examples. Speeds that are set at once, without a ramp, bypass the limit for a moment."
        )
        text = f"{text} {tr(CURRENT_ACCURACY)}"
        if preset is not None and preset.product != self._device.parameters.model_key:
            other = tr(
                "This example was made for a {0}, which measures current in other units. Your "
                "board keeps its current limit."
            )
            text = f"{other.format(device_table().model(preset.product).name)} {text}"
        return text

    def _text_of(self, preset: Preset) -> str:
        """Return the ramps of a preset, as the table of parameters shows them."""
        parameters = self._device.parameters
        values = preset.values(parameters.model_key)
        keys = [p.of(1) for p in (MotorParameter.ACCELERATION, MotorParameter.BRAKE_DURATION)]
        ramp, brake = (parameters.values.specs[key].text(values[key]) for key in keys)
        text = tr("Acceleration: {0}; brake before a reversal: {1}.").format(ramp, brake)
        limit = values.get(LIMITS[0])
        if limit is None:
            return text
        amps = parameters.values.specs[LIMITS[0]].text(limit)
        return f"{text} {tr('Example of a current limit: {0}.').format(amps)}"

    @Slot(float)
    def _on_limit_changed(self, amps: float) -> None:
        scale = self._device.parameters.values.specs[LIMITS[0]].scale
        self._setup.choose_current_limit(round(amps / scale))


class TimeoutPage(QWidget):
    def __init__(self, device: Device, setup: RobotSetup, parent: QWidget) -> None:
        super().__init__(parent)
        self._device = device
        self._setup = setup
        why = tr(
            "If the cable falls out or the computer fails, only the board itself can notice and "
            "stop the motors. Without a serial timeout they keep running at their last speed."
        )
        text = ui.label(self, text=why, wrap=True)
        self._seconds = ui.double_spin_box(
            self,
            "setupTimeout",
            tr("Serial timeout in seconds"),
            0.1,
            12.7,
            decimals=1,
            step=0.1,
            suffix=tr(" s"),
            on_change=lambda seconds: setup.choose_timeout(round(10 * seconds)),
        )
        self._now = ui.named(Muted(parent=self), "setupTimeoutNow")
        self._short = ui.named(Note(2, self), "setupTimeoutShort")
        title = ui.label(self, text=tr("&Stop the motors after a silence of"), buddy=self._seconds)
        hint = tr(
            "Have the computer send something at least twice in that time; a status query will do. "
            "0.5 s is a good value for most robots. UART-Error Shutdown is switched on with it, as "
            "the timeout may need it (twin)."
        )
        seconds = ui.row(title, self._seconds, 1)
        items = text, seconds, Muted(hint, self), self._now, self._short, 1
        ui.column(*items, into=self, margins=0, spacing=12)

    def refresh(self) -> None:
        seconds, settings = self._setup.timeout / 10, self._device.settings
        with QSignalBlocker(self._seconds):
            self._seconds.setValue(seconds)
        stop = TimeoutStop.EXPECTED if seconds else TimeoutStop.OFF
        warning = settings and timeout_warning_on(settings, seconds, stop, is_guarded=True)
        self._short.show_note(warning.text if warning else "", alarming=True)
        parameters, key = self._device.parameters, ParameterKey.SERIAL_TIMEOUT
        wire = parameters.values.stored.get(key)
        text = tr("The board stores: {0}.")
        self._now.setText(
            "" if wire is None else text.format(parameters.values.specs[key].text(wire))
        )


class SummaryPage(QWidget):
    """What is left to do: in other steps, by Apply, and by hand."""

    apply_requested = Signal()

    def __init__(
        self, device: Device, setup: RobotSetup, titles: Mapping[SetupStep, str], parent: QWidget
    ) -> None:
        super().__init__(parent)
        self._device = device
        self._setup = setup
        self._open_title = ui.label(self, text=tr("Still open:"), bold=True)
        self._open: dict[SetupStep, tuple[QAbstractButton, QLabel]] = {}
        steps = ui.grid(margins=0, spacing=(12, 6), stretch=[(1, 1)])
        link = partial(ui.button, self, default=False, tip=tr("Go to this step"))
        for row, step in enumerate(titles):
            if step not in {SetupStep.DRIVER, SetupStep.REVIEW}:
                name, go_to = f"setupGoTo{step.name.title()}Button", partial(setup.go_to, step)
                go = link(name, titles[step], on_click=go_to)
                reason = ui.label(self, f"setupOpen{step.name.title()}", wrap=True)
                steps.addWidget(go, row, 0)
                steps.addWidget(reason, row, 1)
                self._open[step] = go, reason
        self._pending = ui.named(Note(1, self), "setupPending")
        title = tr("Review and &apply…")
        self._apply = ui.button(self, "setupApplyButton", title, icon="apply", default=False)
        self._apply.clicked.connect(self.apply_requested)
        self._tasks = ui.label(self, "setupTasks", wrap=True)
        pending = ui.row((self._pending, 1), self._apply)
        by_hand = ui.label(self, text=tr("Then, by hand:"), bold=True)
        items = self._open_title, steps, pending, by_hand, self._tasks, 1
        ui.column(*items, into=self, margins=0, spacing=12)

    def focus_apply(self) -> None:
        if self._apply.isEnabled():
            self._apply.setFocus()

    def refresh(self) -> None:
        device, pending = self._device, self._device.draft.pending
        text = tr("%n change(s) not applied yet.", "", pending)
        if not device.is_connected:
            text = tr("No board is connected.")
        elif not pending:
            text = tr("All changes are stored.")
        self._pending.show_note(text)
        self._apply.setEnabled(device.writer.can_apply and pending > 0)
        still_open = self._setup.open_steps
        self._open_title.setVisible(bool(still_open))
        for step, (go, reason) in self._open.items():
            if step in still_open:
                reason.setText(self._reason(step))
            for widget in (go, reason):
                widget.setVisible(step in still_open)
        tasks = enumerate(self._task_texts(), 1)
        self._tasks.setText("\n\n".join(f"{number}. {task}" for number, task in tasks))

    def _reason(self, step: SetupStep) -> str:
        """Return why a step is not done, for the user."""
        setup = self._setup
        wiring = setup.wiring
        if step is SetupStep.JUMPERS:
            return tr("The jumpers are not as they have to be, or were not checked.")
        if step is SetupStep.STICKS:
            return tr("The directions of the sticks are not known.")
        if step is not SetupStep.MOTORS:
            return tr("Skipped, or its changes were undone.")
        if wiring is None:
            return tr("It is not known which motor drives which wheel.")
        if rewiring := wiring.rewiring(setup.driver):
            text = rewiring_text(setup.driver, rewiring)
            return tr("{0} Then test the motors again.").format(text)
        if setup.driver.uses_sticks and not setup.knows_sticks:
            return tr("The settings for the motors wait for the directions of the sticks.")
        return tr("The changes for the motors were not taken over: open the step and click Next.")

    def _task_texts(self) -> list[str]:
        driver, source = self._setup.driver, self._device.calibrations.source
        drive = tr("Drive first with the wheels off the ground: forward, back, left, right.")
        if not driver.uses_sticks:
            text = tr(
                "Leave the mode jumper off. The first commands can come from the Motors page "
                "of this window."
            )
            return [text, drive]
        on, off = tr("put the mix jumper on"), tr("leave the mix jumper off")
        mix = on if driver is Driver.ONE_STICK else off
        start = tr("Switch the board off, put the mode jumper on {0}, {1}.")
        rc = tr("Switch on the transmitter, then the board.")
        on_again = rc if source is InputSource.RC else tr("Switch the board on.")
        safe = tr("The motors stay off until the sticks are released (safe-start).")
        return [f"{start.format(source.word, mix)} {on_again} {safe}", drive]
