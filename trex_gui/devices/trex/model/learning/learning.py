"""Learning channels step by step: motors stopped, hands off, all ends, review, test."""

from collections.abc import Sequence
from enum import Enum, auto

from PySide6.QtCore import QObject, Signal, Slot

from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.model.learning.channels import LearnedChannel, LearnedChannels
from trex_gui.devices.trex.model.learning.measured_inputs import Counts, MeasuredInputs
from trex_gui.devices.trex.model.learning.pending_values import (
    PendingLearnedValues,
    edit_what_is_chosen,
    has_edit,
    other_edits,
)
from trex_gui.devices.trex.model.learning.preconditions import (
    CalibrationPreconditions,
    StandstillCheck,
)
from trex_gui.devices.trex.model.learning.stick_tests import StickTests
from trex_gui.devices.trex.protocol.calibration import Calibration
from trex_gui.devices.trex.protocol.flags import CHANNELS, InputSource
from trex_gui.ui.plotting.history import Floats


class LearningStep(Enum):
    """The step of the wizard; in `DOUBT` the user has to confirm that the motors are stopped."""

    ENDED = auto()
    STOPPING = auto()
    DOUBT = auto()
    NEUTRAL = auto()
    TRAVEL = auto()
    REVIEW = auto()
    TEST = auto()
    FAILED = auto()


_MOVING = {LearningStep.NEUTRAL, LearningStep.TRAVEL, LearningStep.TEST}
"""Steps in which sticks are moved, or have to rest."""

_MEASURING = _MOVING | {LearningStep.REVIEW}


class Learning(QObject):
    """Learns channels of a board in serial mode; there the sticks move no motor.

    Nothing is written, and no edit is made before `take`.

    Signals:
        changed: `step`, `sampling`, `stalled` or a choice.
        measured: new samples are in.
        taken: what was learned is edits now, and waits for its review.
        stored: what was taken last is in the board; a test is due, but for `motors_armed`.
    """

    changed = Signal()
    measured = Signal()
    taken = Signal()
    stored = Signal()

    def __init__(self, device: Device, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._device = device
        self._step = LearningStep.ENDED
        self._after_stopping = LearningStep.NEUTRAL
        self._trouble = ""
        self._numbers: tuple[int, ...] = ()
        self._channels = LearnedChannels()
        self._tests: StickTests | None = None
        self._news = self._next_news = ""
        self._taken = PendingLearnedValues(device, self)
        self._guard = CalibrationPreconditions(device, self)
        self._standing = StandstillCheck(device, self)
        self._inputs = MeasuredInputs(device.telemetry, self)

        self._guard.broken.connect(self._on_broken)
        self._standing.stood.connect(self._on_stood)
        self._standing.doubted.connect(self._on_doubted)
        self._standing.failed.connect(self._on_stop_failed)
        self._inputs.arrived.connect(self._on_arrived)
        self._inputs.stalled_changed.connect(self._on_stalled_changed)
        self._taken.stored.connect(self._on_stored)

    # --- What is known ------------------------------------------------------------------

    @property
    def step(self) -> LearningStep:
        """How far it is."""
        return self._step

    @property
    def is_test(self) -> bool:
        """Whether the sticks are only tested."""
        return self._after_stopping is LearningStep.TEST

    @property
    def trouble(self) -> str:
        """Why it failed, or what is doubtful, in sentences."""
        return self._trouble

    @property
    def news(self) -> str:
        """What led to the test, as a sentence; empty if the user started it."""
        return self._news

    def has_edit(self, number: int) -> bool:
        """Whether an edit of a channel waits for Apply, which taking its values replaces."""
        return has_edit(self._device, number)

    @property
    def other_edits(self) -> int:
        """How many edits wait for Apply beside those of the channels that are to be taken."""
        return other_edits(self._device, [channel.number for channel in self._chosen])

    @property
    def _chosen(self) -> list[LearnedChannel]:
        return [channel for channel in self.channels if channel.can_be_taken]

    @property
    def sampling(self) -> bool:
        """Whether the rest is sampled right now."""
        return self._channels.sampling

    @property
    def stalled(self) -> bool:
        """Whether measurements should come, and do not."""
        return self._inputs.stalled

    @property
    def seconds_left(self) -> float:
        """How much longer the rest is sampled."""
        return self._channels.seconds_left

    @property
    def channels(self) -> tuple[LearnedChannel, ...]:
        return self._channels.all

    @property
    def tests(self) -> StickTests | None:
        """What is tested; `None` in other steps."""
        return self._tests

    @property
    def source(self) -> InputSource:
        return self._guard.source

    @property
    def samples_a_second(self) -> float:
        """How many measurements come in while the ends are looked for; 0 before it is known."""
        return self._channels.samples_a_second

    @property
    def baud(self) -> int:
        """How fast the line is."""
        settings = self._device.settings
        return 0 if settings is None else settings.line.baud

    def trace(self, number: int) -> tuple[Floats, Floats, float]:
        """Return the input of the last minute: times, counts, and what time it is."""
        telemetry = self._device.telemetry
        column = CHANNELS.index(number)
        return telemetry.inputs.times, telemetry.inputs.values(column), telemetry.latest

    @property
    def can_go_on(self) -> bool:
        """Whether `next` does something now."""
        match self._step:
            case LearningStep.DOUBT:
                return True
            case LearningStep.NEUTRAL if self.sampling or self.stalled:
                return False
            case LearningStep.NEUTRAL:
                return not self.has_sampled or any(c.is_at_rest for c in self.channels)
            case LearningStep.TRAVEL:
                return True
        return False

    @property
    def has_sampled(self) -> bool:
        """Whether a sampling of the rest has ended."""
        return self._channels.has_sampled

    @property
    def can_take(self) -> bool:
        """Whether there is something to take, and nothing that is wanted is wrong."""
        wanted = [c for c in self.channels if c.choice is not None and c.choice.included]
        return (
            self._step is LearningStep.REVIEW
            and bool(wanted)
            and all(channel.can_be_taken for channel in wanted)
            and not self._device.applying
        )

    @property
    def motors_armed(self) -> bool:
        """Whether the motors are driven: to begin would stop them."""
        return self._device.motors.armed or self._device.may_move

    def why_not(self) -> str:
        """Say why learning cannot begin now; empty when it can."""
        return self._guard.why_not()

    # --- User actions -------------------------------------------------------------------

    def begin(self, channels: Sequence[int] = CHANNELS) -> None:
        """Learn these channels at once; the motors are stopped first."""
        self._news = self._next_news = ""
        self._start(channels, LearningStep.NEUTRAL)

    def begin_test(self, channels: Sequence[int] = CHANNELS) -> None:
        """Test what is stored for these channels; the motors are stopped first."""
        self._news, self._next_news = self._next_news, ""
        self._start(channels, LearningStep.TEST)

    def next(self) -> None:
        """Continue with what the user has done or confirmed.

        That is: the motors are stopped; hands are off; channels without a rest are left out; all
        ends were held.
        """
        if not self.can_go_on:
            return
        if self._step is LearningStep.DOUBT:
            self._on_stood()
        elif self._step is LearningStep.TRAVEL:
            self._channels.propose()
            self._go(LearningStep.REVIEW)
        elif self.has_sampled:
            self._begin_travel()
        else:
            self._begin_sampling()

    def back(self) -> None:
        """Go one step back; ends that were reached stay, a rest is sampled anew."""
        if self._step is LearningStep.REVIEW:
            self._go(LearningStep.TRAVEL)
        elif self._step is LearningStep.TRAVEL:
            self._wait_at_rest()

    def again(self) -> None:
        """Do this step, or after a failure all of them, once more."""
        match self._step:
            case LearningStep.NEUTRAL if not self.sampling:
                self._begin_sampling()
            case LearningStep.TRAVEL:
                self._begin_travel()
            case LearningStep.REVIEW:
                self._wait_at_rest()
            case LearningStep.TEST:
                self._begin_tests()
            case LearningStep.FAILED | LearningStep.DOUBT:
                self._start(self._numbers, self._after_stopping)

    def choose(
        self,
        number: int,
        calibration: Calibration | None = None,
        *,
        reversed_: bool | None = None,
        included: bool | None = None,
    ) -> None:
        """Choose otherwise for a channel; what is not given stays."""
        self._channels[number].choose(calibration, reversed_=reversed_, included=included)
        self.changed.emit()

    def take(self) -> None:
        """Make edits of what is chosen; one step to undo.

        Where all of it is stored already, nothing waits, and `stored` says so at once.
        """
        if not self.can_take:
            return
        chosen = self._chosen
        edit_what_is_chosen(self._device, chosen, self.tr("Learn channels"))
        numbers = tuple(channel.number for channel in chosen)
        is_new = any(self.has_edit(number) for number in numbers)
        self._go(LearningStep.ENDED)
        if is_new:
            self._taken.wait_for(chosen)
            self.taken.emit()
        else:
            self._report_stored(numbers, self.tr("These values are stored already."))

    def cancel(self) -> None:
        """End it, whatever the step; the board and the edits are as they were."""
        if self._step is not LearningStep.ENDED:
            self._go(LearningStep.ENDED)

    # --- Steps --------------------------------------------------------------------------

    def _start(self, channels: Sequence[int], after_stopping: LearningStep) -> None:
        self._standing.give_up()
        self._numbers = tuple(channels)
        self._channels = LearnedChannels()
        self._tests = None
        self._taken.forget()
        self._after_stopping = after_stopping
        if trouble := self.why_not():
            self._fail(trouble)
            return
        self._guard.begin()
        self._go(LearningStep.STOPPING)
        self._standing.stop()

    @Slot()
    def _on_stood(self) -> None:
        if self._after_stopping is LearningStep.TEST:
            self._begin_tests()
        else:
            self._wait_at_rest()

    @Slot(str)
    def _on_doubted(self, what: str) -> None:
        self._trouble = self.tr(
            "The board accepted the stop, but {0}. Check the motors: if one turns, something else "
            "drives it, such as another controller on this line; cut its power. Continue only if "
            "they are not turning."
        ).format(what)
        self._go(LearningStep.DOUBT)

    @Slot(str)
    def _on_stop_failed(self, why: str) -> None:
        text = self.tr("Cannot continue: the motors could not be confirmed as stopped. {0}")
        self._fail(text.format(why))

    @Slot(str)
    def _on_broken(self, why: str) -> None:
        if self.is_test:
            self._fail(why + self.tr(" The test has ended; it changes nothing in the board."))
        else:
            self._fail(why + self.tr(" Nothing was changed."))

    def _wait_at_rest(self) -> None:
        self._channels = LearnedChannels.of(self._device, self._numbers, self.source)
        self._go(LearningStep.NEUTRAL)

    def _begin_sampling(self) -> None:
        self._channels.begin_sampling()
        self.changed.emit()

    def _begin_travel(self) -> None:
        self._channels.begin_travel()
        self._go(LearningStep.TRAVEL)

    def _begin_tests(self) -> None:
        self._tests = StickTests(self._device, self._numbers)
        self._go(LearningStep.TEST)

    def _go(self, step: LearningStep) -> None:
        self._step = step
        self._channels.follow(step is LearningStep.TRAVEL)
        if step in _MEASURING:
            self._inputs.begin()
        else:
            self._inputs.end()
        if step in {LearningStep.ENDED, LearningStep.FAILED}:
            self._guard.end()
            self._standing.give_up()
        self.changed.emit()
        self._guard.watch_motors(step in _MOVING)

    def _fail(self, text: str) -> None:
        self._trouble = text
        self._go(LearningStep.FAILED)

    # --- What comes in ------------------------------------------------------------------

    @Slot(object)
    def _on_arrived(self, measured: Sequence[tuple[float, Counts]]) -> None:
        if self._step is LearningStep.TEST and self._tests is not None:
            for moment, counts in measured:
                self._tests.feed(moment, counts)
        elif self._channels.feed(measured):
            if all(channel.is_at_rest for channel in self.channels):
                self._begin_travel()
            else:
                self.changed.emit()
        self.measured.emit()

    @Slot()
    def _on_stalled_changed(self) -> None:
        if self.stalled and self.sampling:  # a gap is no rest
            self._begin_sampling()
        else:
            self.changed.emit()

    @Slot(object)
    def _on_stored(self, numbers: tuple[int, ...]) -> None:
        if self._step is LearningStep.ENDED:
            self._report_stored(numbers, self.tr("What was learned is stored."))

    def _report_stored(self, numbers: tuple[int, ...], news: str) -> None:
        self._numbers, self._next_news = numbers, news
        self.stored.emit()

    @property
    def numbers(self) -> tuple[int, ...]:
        """The channels that were learned or tested last."""
        return self._numbers
