"""Wizard that learns channels, from stopping the motors to a test."""

from collections.abc import Sequence
from dataclasses import replace
from enum import Enum, auto
from typing import Any

from PySide6.QtCore import QObject, Signal, Slot

from trex_gui.core.texts import title_of
from trex_gui.core.translation import tr
from trex_gui.devices.trex.calibration.neutral import (
    SAMPLING_SECONDS,
    ChannelSample,
    measure_neutral,
)
from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.model.learning.channels import Counts, LearnedChannel, MeasuredInputs
from trex_gui.devices.trex.model.learning.pending_values import PendingLearnedValues
from trex_gui.devices.trex.model.learning.preconditions import (
    CalibrationPreconditions,
    StandstillCheck,
)
from trex_gui.devices.trex.model.learning.stick_tests import StickTests
from trex_gui.devices.trex.protocol.flags import CHANNELS


class LearningStep(Enum):
    """Step of the wizard. `DOUBT` asks whether the motors are stopped."""

    ENDED = auto()
    STOPPING = auto()
    DOUBT = auto()
    NEUTRAL = auto()
    TRAVEL = auto()
    REVIEW = auto()
    TEST = auto()
    FAILED = auto()


_MOVING = {LearningStep.NEUTRAL, LearningStep.TRAVEL, LearningStep.TEST}  # steps that use sticks

_MEASURING = _MOVING | {LearningStep.REVIEW}


class Learning(QObject):
    """Learns channels of a board in serial mode.

    The sticks move no motor. Only `use_values` edits settings. Nothing is written to the board.
    """

    started = Signal()  # `start` was called; `preconditions` may still prevent learning
    changed = Signal()  # the step, `sampling`, `inputs.stalled` or a choice
    measured = Signal()  # new samples have arrived
    edited = Signal()  # the learned values are pending edits
    stored = Signal()  # the board has stored the learned values

    def __init__(self, device: Device, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self.step = LearningStep.ENDED
        self.problem = ""  # reason for a failure or doubt, as text for the user
        self.test_message = ""  # shown before a test; empty if the user started the test
        self.numbers: tuple[int, ...] = ()  # channels of the last run
        self.channels: tuple[LearnedChannel, ...] = ()
        self.tests: StickTests | None = None  # `None` before the test step
        self.sampling = False  # rest positions are being sampled
        self.preconditions = CalibrationPreconditions(device, self)
        self.inputs = MeasuredInputs(device.telemetry, self)
        self.pending = PendingLearnedValues(device, self)
        self._device = device
        self._after_stopping = LearningStep.NEUTRAL
        self._next_test_message = ""
        self._standstill = StandstillCheck(device, self)

        self.preconditions.violated.connect(self._on_violated)
        self._standstill.confirmed.connect(self._on_standstill)
        self._standstill.doubted.connect(self._on_doubted)
        self._standstill.failed.connect(self._on_stop_failed)
        self.inputs.arrived.connect(self._on_arrived)
        self.inputs.stalled_changed.connect(self._on_stalled_changed)
        self.pending.stored.connect(self._on_stored)

    # --- State --------------------------------------------------------------------------

    @property
    def is_test(self) -> bool:
        return self._after_stopping is LearningStep.TEST

    @property
    def has_sampled(self) -> bool:
        return not self.sampling and any(channel.neutral is not None for channel in self.channels)

    @property
    def seconds_left(self) -> float:
        neutrals = [channel.neutral for channel in self.channels]
        return max(SAMPLING_SECONDS if n is None else n.seconds_left for n in neutrals)

    @property
    def can_go_on(self) -> bool:
        match self.step:
            case LearningStep.NEUTRAL if self.sampling or self.inputs.stalled:
                return False
            case LearningStep.NEUTRAL:
                return not self.has_sampled or any(c.is_at_rest for c in self.channels)
        return self.step in {LearningStep.DOUBT, LearningStep.TRAVEL}

    @property
    def included(self) -> list[LearnedChannel]:
        return [channel for channel in self.channels if channel.is_included]

    @property
    def can_use_values(self) -> bool:
        return (
            self.step is LearningStep.REVIEW
            and bool(self.included)
            and all(channel.can_be_used for channel in self.included)
            and not self._device.writer.running
        )

    @property
    def other_edits(self) -> int:
        return self.pending.other_edits([c.number for c in self.channels if c.can_be_used])

    @property
    def motors_armed(self) -> bool:
        """True if `start` would stop driven motors."""
        return self._device.motors.armed or self._device.may_move

    @property
    def baud(self) -> int:
        settings = self._device.settings
        return 0 if settings is None else settings.line.baud

    # --- User actions -------------------------------------------------------------------

    def start(self, channels: Sequence[int] = CHANNELS) -> None:
        """Stop the motors, then learn these channels together."""
        self.test_message = self._next_test_message = ""
        self.started.emit()
        self._start(channels, LearningStep.NEUTRAL)

    def start_test(self, channels: Sequence[int] = CHANNELS) -> None:
        """Stop the motors, then test stored values."""
        self.test_message, self._next_test_message = self._next_test_message, ""
        self._start(channels, LearningStep.TEST)

    def next(self) -> None:
        if not self.can_go_on:
            return
        if self.step is LearningStep.DOUBT:
            self._on_standstill()
        elif self.step is LearningStep.TRAVEL:
            for channel in self.channels:
                channel.propose()
            self._set_step(LearningStep.REVIEW)
        elif self.has_sampled:
            self._start_travel()
        else:
            self._start_sampling()

    def back(self) -> None:
        if self.step is LearningStep.REVIEW:
            self._set_step(LearningStep.TRAVEL)
        elif self.step is LearningStep.TRAVEL:
            self._wait_at_rest()

    def repeat(self) -> None:
        """Repeat this step. Measure again from the review. Start again after a doubt or failure."""
        match self.step:
            case LearningStep.NEUTRAL if not self.sampling:
                self._start_sampling()
            case LearningStep.TRAVEL:
                self._start_travel()
            case LearningStep.REVIEW:
                self._wait_at_rest()
            case LearningStep.TEST:
                self._start_tests()
            case LearningStep.FAILED | LearningStep.DOUBT:
                self._start(self.numbers, self._after_stopping)

    def set_choice(self, number: int, **changes: Any) -> None:
        channel = next(channel for channel in self.channels if channel.number == number)
        if channel.choice is not None:
            channel.choice = replace(channel.choice, **changes)
        self.changed.emit()

    def use_values(self) -> bool:
        """Put the chosen values into the draft. Return whether an edit is pending."""
        if not self.can_use_values:
            return False
        choices = {c.number: c.choice for c in self.channels if c.can_be_used and c.choice}
        is_pending = self.pending.edit(choices, title_of(tr("&Learn channels…")))
        self._set_step(LearningStep.ENDED)
        if is_pending:
            self.edited.emit()
        else:
            self._report_stored(tuple(choices), tr("These values are already stored."))
        return is_pending

    def cancel(self) -> None:
        if self.step is not LearningStep.ENDED:
            self._set_step(LearningStep.ENDED)

    # --- Steps --------------------------------------------------------------------------

    def _start(self, channels: Sequence[int], after_stopping: LearningStep) -> None:
        self._standstill.cancel()
        self.numbers = tuple(channels)
        self.channels = ()
        self.tests = None
        self.pending.clear()
        self._after_stopping = after_stopping
        if blocker := self.preconditions.blocker:
            self._fail(blocker)
            return
        self.preconditions.start()
        self._set_step(LearningStep.STOPPING)
        if self.step is LearningStep.STOPPING:  # a precondition may already be violated
            self._standstill.start()

    @Slot()
    def _on_standstill(self) -> None:
        if self.is_test:
            self._start_tests()
        else:
            self._wait_at_rest()

    @Slot(str)
    def _on_doubted(self, currents: str) -> None:
        self.problem = tr(
            "The board accepted the stop, but {0}. Check the motors. If a motor is turning, "
            "cut its power: something else is driving it, such as another controller on this "
            "line. Continue only if no motor is turning."
        ).format(currents)
        self._set_step(LearningStep.DOUBT)

    @Slot(str)
    def _on_stop_failed(self, reason: str) -> None:
        text = tr("Cannot continue: the stop of the motors is not confirmed. {0}")
        self._fail(text.format(reason))

    @Slot(str)
    def _on_violated(self, reason: str) -> None:
        if self.is_test:
            outcome = tr("The test has ended. Nothing in the board was changed.")
        else:
            outcome = tr("Nothing was changed.")
        self._fail(f"{reason} {outcome}")

    def _wait_at_rest(self) -> None:
        source = self.preconditions.source
        self.channels = tuple(LearnedChannel(self._device, n, source) for n in self.numbers)
        self._set_step(LearningStep.NEUTRAL)

    def _start_sampling(self) -> None:
        for channel in self.channels:
            channel.start_sampling()
        self.sampling = True
        self.changed.emit()

    def _start_travel(self) -> None:
        for channel in self.channels:
            channel.start_travel()
        self._set_step(LearningStep.TRAVEL)

    def _start_tests(self) -> None:
        self.tests = StickTests(self._device, self.numbers)
        self._set_step(LearningStep.TEST)

    def _set_step(self, step: LearningStep) -> None:
        self.step = step
        self.sampling = False
        is_measuring = step in _MEASURING
        self._device.connection.watch("learning", is_measuring)
        if is_measuring:
            self.inputs.start()
        else:
            self.inputs.end()
        if step in {LearningStep.ENDED, LearningStep.FAILED}:
            self.preconditions.end()
            self._standstill.cancel()
        self.changed.emit()
        self.preconditions.watch_motors(step in _MOVING)

    def _fail(self, text: str) -> None:
        self.problem = text
        self._set_step(LearningStep.FAILED)

    # --- Measurements and stored values -------------------------------------------------

    @Slot(object)
    def _on_arrived(self, measured: Sequence[tuple[float, Counts]]) -> None:
        if self.step is LearningStep.TEST and self.tests is not None:
            for moment, counts in measured:
                self.tests.feed(moment, counts)
        else:
            self._feed_channels(measured)
        self.measured.emit()

    def _feed_channels(self, measured: Sequence[tuple[float, Counts]]) -> None:
        for channel in self.channels:
            for moment, counts in measured:
                sample = ChannelSample(moment, counts[CHANNELS.index(channel.number)])
                channel.feed(sample)
                if self.sampling:
                    channel.samples.append(sample)
                elif self.step is LearningStep.TRAVEL and channel.travel is not None:
                    channel.travel.feed(sample)
            if self.sampling:
                channel.neutral = measure_neutral(channel.samples, channel.source)
        if self.sampling and self.seconds_left == 0:
            self.sampling = False
            if all(channel.is_at_rest for channel in self.channels):
                self._start_travel()
            else:
                self.changed.emit()

    @Slot()
    def _on_stalled_changed(self) -> None:
        if self.inputs.stalled and self.sampling:  # a gap may hide a movement
            self._start_sampling()
        else:
            self.changed.emit()

    @Slot(object)
    def _on_stored(self, numbers: tuple[int, ...]) -> None:
        if self.step is LearningStep.ENDED:
            self._report_stored(numbers, tr("The learned values are stored."))

    def _report_stored(self, numbers: tuple[int, ...], message: str) -> None:
        self.numbers, self._next_test_message = numbers, message
        self.stored.emit()
