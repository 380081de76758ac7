"""Set-up steps with choices, values and instructions."""

from collections.abc import Mapping
from functools import partial

from PySide6.QtCore import QSignalBlocker, Qt, Slot
from PySide6.QtWidgets import QAbstractButton, QLabel

from trex_gui.core.translation import tr
from trex_gui.devices.trex.driving.timeout_stop import TimeoutStop
from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.model.drive_texts import timeout_warning_on
from trex_gui.devices.trex.model.learning.preconditions import mode_blocker
from trex_gui.devices.trex.model.setup.robot_setup import LIMITS, Preset, RobotSetup, SetupStep
from trex_gui.devices.trex.model.setup.wiring import Driver
from trex_gui.devices.trex.protocol.descriptions import CURRENT_ACCURACY
from trex_gui.devices.trex.protocol.device_table import device_table
from trex_gui.devices.trex.protocol.flags import InputSource
from trex_gui.devices.trex.protocol.parameters import FULL_SPEED_S, MotorParameter
from trex_gui.devices.trex.settings.comparison import compare
from trex_gui.devices.trex.views.board.jumpers import JumperPicture
from trex_gui.devices.trex.views.setup.direction_pages import rewiring_text
from trex_gui.devices.trex.views.setup.pictures import Choices, paint_driver, paint_ramp
from trex_gui.devices.trex.views.steps import Page
from trex_gui.ui.devices.connection import ConnectionState
from trex_gui.ui.widgets import builders as ui
from trex_gui.ui.widgets.labels import Muted, Note


class DriverPage(Page):
    def __init__(self, setup: RobotSetup) -> None:
        super().__init__("setupDriverPage", tr("Who drives your robot?"))
        self._setup = setup
        texts = {
            Driver.ONE_STICK: tr("&One stick"),
            Driver.TWO_STICKS: tr("&Two sticks"),
            Driver.COMPUTER: tr("&A computer"),
        }
        captions = {
            Driver.ONE_STICK: tr("One stick drives and turns. The board mixes both."),
            Driver.TWO_STICKS: tr("One stick for each side of the robot, as in a tank."),
            Driver.COMPUTER: tr("Commands come over the serial line."),
        }
        self._choices = Choices("setupDriver", texts, self, columns=3)
        for driver, caption in captions.items():
            self._choices.show_picture(driver, partial(paint_driver, driver), caption)
        self._choices.chosen.connect(setup.select_driver)
        text = tr(
            "You can skip any step. Nothing is written until you apply the changes at the end."
        )
        ui.column((self._choices, 1), Muted(text, self), into=self, margins=0, spacing=16)

    def refresh(self) -> None:
        self._choices.show_choice(self._setup.driver)


class JumperPage(Page):
    def __init__(self, device: Device, setup: RobotSetup) -> None:
        super().__init__("setupJumpersPage", tr("Move the jumpers as drawn"))
        self._device = device
        self._setup = setup
        self._picture = JumperPicture(self)
        self._mode = ui.named(Note(3, self.side), "setupModeCheck")
        self._mix = ui.named(Note(3, self.side), "setupMixCheck")
        text = tr("Schematic drawing: see the user's guide for the positions on your board.")
        middle = Qt.AlignmentFlag.AlignCenter
        ui.column((self._picture, 1, middle), Muted(text, self), into=self, margins=0)
        ui.column(self._mode, self._mix, into=self.side, margins=0)
        device.telemetry.text_due.connect(self.refresh)

    @Slot()
    def refresh(self) -> None:
        driver = self._setup.driver
        is_mixed = driver is Driver.ONE_STICK if driver.uses_sticks else None
        checks = {"mode": self._mode_result()}
        if is_mixed is not None:
            checks["mix"] = self._mix_result(is_mixed)
        for key, note in (("mode", self._mode), ("mix", self._mix)):
            good, text = checks.get(key, (None, ""))
            note.show_note(f"✓ {text}" if good else text, alarming=good is False)
        to_move = [key for key, (good, _) in checks.items() if good is False]
        self._picture.show_jumpers(is_mixed, to_move=to_move)

    def _mode_result(self) -> tuple[bool | None, str]:
        """Return the result of the check, `None` if unknown, and a text for the user."""
        state = self._device.state
        if self._device.link is ConnectionState.NOT_RESPONDING:
            return None, tr("The board does not respond: it may be switched off.")
        if state is None or not self._device.is_connected:
            return None, tr("No board is connected, so its jumpers cannot be checked.")
        if state.mode.is_serial:
            return True, tr("This board was started without the mode jumper (serial mode).")
        return False, mode_blocker(self._device)

    def _mix_result(self, is_mixed: bool) -> tuple[bool | None, str]:
        is_on = self._device.mix_jumper.is_on
        if is_on is not is_mixed and self._device.writer.is_rejected:
            return None, tr(
                "The mix jumper can be checked only in serial mode. In the present mode, a "
                "stick would drive the motors."
            )
        if is_on is None:
            return None, tr(
                "The board does not report the state of the mix jumper. Push a stick to one "
                "side to detect it."
            )
        if is_on is is_mixed:
            return True, tr("The mix jumper is on.") if is_on else tr("The mix jumper is off.")
        remove = tr("The mix jumper is on: remove it, then push a stick.")
        put_on = tr("The mix jumper is off: put it on, then push a stick.")
        return False, remove if is_on else put_on


class LimitsPage(Page):
    def __init__(self, device: Device, setup: RobotSetup) -> None:
        super().__init__("setupLimitsPage", tr("How should the motors start and stop?"))
        self._device = device
        self._setup = setup
        texts: dict[Preset | None, str] = {
            None: tr("As &it is"),
            Preset.TANK: tr("&Tank"),
            Preset.ROVER: tr("Ro&ver"),
            Preset.AUTONOMOUS: tr("&Autonomous robot"),
        }
        self._choices = Choices("setupPreset", texts, self, columns=2)
        spin = partial(ui.double_spin_box, self.side, "setupCurrentLimit", "", 0.0, 1.0)
        self._limit = spin(decimals=2, suffix=" A", on_change=self._on_limit_changed)
        self._limit.setSpecialValueText(tr("off", "limit"))
        self._hint = ui.named(Note(6, self.side), "setupLimitHint")
        self._choices.chosen.connect(setup.select_preset)
        title = ui.label(self.side, text=tr("Current &limit of each motor"), buddy=self._limit)
        ui.column(self._choices, into=self, margins=0)
        ui.column(title, self._limit, self._hint, into=self.side, margins=0)

    def refresh(self) -> None:
        device, setup = self._device, self._setup
        parameters = device.parameters
        self._choices.show_choice(setup.preset)
        for widget in (self._choices, self.side):
            widget.setEnabled(bool(parameters.model_key))
        if not parameters.model_key:
            return
        for preset in (None, *Preset):
            self._show_ramps(preset)
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

    def _show_ramps(self, preset: Preset | None) -> None:
        """Show the ramps and values of a preset, or of the board if `preset` is `None`."""
        parameters = self._device.parameters
        values = parameters.values
        wire = values.stored if preset is None else preset.values(parameters.model_key)
        keys = [p.of(1) for p in (MotorParameter.ACCELERATION, MotorParameter.BRAKE_DURATION)]
        ramp, brake = (wire.get(key) for key in keys)
        if ramp is None or brake is None:
            return
        texts = [values.specs[key].text(wire[key]) for key in (*keys, LIMITS[0]) if key in wire]
        seconds = FULL_SPEED_S / ramp if ramp else 0.0
        paint = partial(paint_ramp, seconds, brake * values.specs[keys[1]].scale / 1000)
        self._choices.show_picture(preset, paint, ", ".join(texts))

    def _hint_text(self) -> str:
        preset = self._setup.preset
        if self._device.board.is_joint:
            return tr("In joint mode the board does not measure the current and cannot limit it.")
        text = tr(
            "Set the current that your motors can draw continuously; the presets are "
            "examples. Without a ramp, the current exceeds the limit for a moment."
        )
        text = f"{text} {tr(CURRENT_ACCURACY)}"
        if preset is not None and preset.product != self._device.parameters.model_key:
            foreign = tr(
                "This example was made for a {0}, which measures current in other units. Your "
                "board keeps its current limit."
            )
            text = f"{foreign.format(device_table().model(preset.product).name)} {text}"
        return text

    @Slot(float)
    def _on_limit_changed(self, amps: float) -> None:
        scale = self._device.parameters.values.specs[LIMITS[0]].scale
        self._setup.select_current_limit(round(amps / scale))


class TimeoutPage(Page):
    def __init__(self, device: Device, setup: RobotSetup) -> None:
        super().__init__("setupTimeoutPage", tr("If the cable falls out, the board stops"))
        self._device = device
        self._setup = setup
        spin = partial(ui.double_spin_box, self, "setupTimeout", "", 0.1, 12.7, suffix=tr(" s"))
        self._seconds = spin(decimals=1, step=0.1, on_change=self._on_seconds_changed)
        self._short = ui.named(Note(2, self), "setupTimeoutShort")
        title = ui.label(self, text=tr("&Stop the motors after a silence of"), buddy=self._seconds)
        hint = tr(
            "The computer must send something at least twice within this time. UART-Error "
            "Shutdown is also switched on, because the timeout may need it (twin)."
        )
        seconds = self._seconds, 0, Qt.AlignmentFlag.AlignLeft
        ui.column(title, seconds, Muted(hint, self), self._short, 1, into=self, margins=0)

    @Slot(float)
    def _on_seconds_changed(self, seconds: float) -> None:
        self._setup.select_timeout(round(10 * seconds))

    def refresh(self) -> None:
        seconds, settings = self._setup.timeout / 10, self._device.settings
        with QSignalBlocker(self._seconds):
            self._seconds.setValue(seconds)
        stop = TimeoutStop.EXPECTED if seconds else TimeoutStop.OFF
        warning = settings and timeout_warning_on(settings, seconds, stop, is_guarded=True)
        self._short.show_note(warning.text if warning else "", alarming=True)


class SummaryPage(Page):
    def __init__(self, device: Device, setup: RobotSetup, titles: Mapping[SetupStep, str]) -> None:
        super().__init__("setupReviewPage", tr("What is left to do"))
        self._device = device
        self._setup = setup
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
        self._pending = ui.label(self, "setupPending", size="heading")
        self._changes = Muted(parent=self)
        by_hand = ui.label(self.side, text=tr("Then, by hand:"), size="heading")
        self._tasks = ui.label(self.side, "setupTasks", wrap=True)
        self._picture = JumperPicture(self.side)
        middle = Qt.AlignmentFlag.AlignCenter
        ui.column(steps, self._pending, self._changes, 1, into=self, margins=0, spacing=12)
        items = by_hand, self._tasks, (self._picture, 1, middle)
        ui.column(*items, into=self.side, margins=0, spacing=12)

    def refresh(self) -> None:
        device, pending = self._device, self._device.draft.pending
        text = tr("There are unapplied changes.")
        if not device.is_connected:
            text = tr("No board is connected.")
        elif not pending:
            text = tr("Nothing to write.")
        self._pending.setText(text)
        stored, shown = device.draft.stored, device.draft.shown
        changes = compare(stored, shown).differing if stored and shown else ()
        rows = (f"{row.name}: {row.text_before} → {row.text_after}" for row in changes)
        self._changes.setText("\n".join(rows))
        for step, (go, reason) in self._open.items():
            is_open = step in self._setup.open_steps
            if is_open:
                reason.setText(self._reason(step))
            for widget in (go, reason):
                widget.setVisible(is_open)
        driver = self._setup.driver
        mode = device.calibrations.source.word if driver.uses_sticks else ""
        is_mixed = driver is Driver.ONE_STICK if driver.uses_sticks else None
        self._picture.show_jumpers(is_mixed, mode=mode)
        tasks = enumerate(self._task_texts(), 1)
        self._tasks.setText("\n\n".join(f"{number}. {task}" for number, task in tasks))

    def _reason(self, step: SetupStep) -> str:
        setup = self._setup
        wiring = setup.wiring
        if step is SetupStep.JUMPERS:
            return tr("The positions are wrong or have not been checked.")
        if step is SetupStep.STICKS:
            return tr("The directions of the sticks are not known.")
        if step is not SetupStep.MOTORS:
            return tr("This step was skipped, or its changes were undone.")
        if wiring is None:
            return tr("It is not known which motor drives which wheel.")
        if rewiring := wiring.rewiring(setup.driver):
            text = rewiring_text(setup.driver, rewiring)
            return tr("{0} Then test the motors again.").format(text)
        if setup.driver.uses_sticks and not setup.knows_sticks:
            return tr("The motor settings depend on the directions of the sticks.")
        return tr("The changes of this step were not added. Open the step and click Next.")

    def _task_texts(self) -> list[str]:
        driver, source = self._setup.driver, self._device.calibrations.source
        drive = tr(
            "For the first drive, keep the wheels off the ground: forward, back, left, right."
        )
        if not driver.uses_sticks:
            text = tr(
                "Leave the mode jumper off. You can send the first commands from the Motors "
                "page of this window."
            )
            return [text, drive]
        on, off = tr("put the mix jumper on"), tr("leave the mix jumper off")
        mix = on if driver is Driver.ONE_STICK else off
        start = tr("Switch the board off, set the mode jumper to {0}, and {1}.")
        rc = tr("Switch on the transmitter, then the board.")
        on_again = rc if source is InputSource.RC else tr("Switch the board on.")
        safe = tr("The motors stay off until the sticks are released (safe-start).")
        return [f"{start.format(source.word, mix)} {on_again} {safe}", drive]
