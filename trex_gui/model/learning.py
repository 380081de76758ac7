"""Learning channels step by step: motors stopped, hands off, all ends, review, test."""

import math
import time
from collections.abc import Sequence
from enum import Enum, auto

from PySide6.QtCore import QObject, QTimer, Signal, Slot

from trex_gui.learning.neutral import SAMPLING_SECONDS
from trex_gui.learning.samples import Sample
from trex_gui.link.writing import Written
from trex_gui.model.device import Device, Link
from trex_gui.model.learned_channel import LearnedChannel
from trex_gui.model.stick_tests import StickTests
from trex_gui.protocol.calibration import Calibration
from trex_gui.protocol.errors import TrexError
from trex_gui.protocol.flags import CHANNELS, InputSource, channel_mask, channels_in

_STALLED_AFTER = 1.0
"""Seconds without a measurement until that is said."""

_TICK_MS = 200

_SAME_VALUE = 0.012
"""Seconds within which two samples are one: the board renews its inputs every 20 ms, but a line
that was held up reads them in a burst. One wild pulse, read thrice, must not look held."""


class Step(Enum):
    """How far it is."""

    ENDED = auto()
    STOPPING = auto()
    NEUTRAL = auto()
    TRAVEL = auto()
    REVIEW = auto()
    TEST = auto()
    FAILED = auto()


_MEASURING = {Step.NEUTRAL, Step.TRAVEL, Step.TEST}


class Learning(QObject):
    """Learns channels of a board in serial mode; there the sticks move no motor.

    Nothing is written, and no edit is made before `take`.

    Signals:
        changed: `step`, `sampling`, `stalled` or a choice.
        measured: new samples are in.
        taken: what was learned is edits now, and waits for its review.
        stored: what was taken last is in the board; a test is due.
    """

    changed = Signal()
    measured = Signal()
    taken = Signal()
    stored = Signal()

    def __init__(self, device: Device, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._device = device
        self._step = Step.ENDED
        self._after_stopping = Step.NEUTRAL
        self._run = 0
        self._trouble = ""
        self._sampling = False
        self._stalled = False
        self._numbers: tuple[int, ...] = ()
        self._channels: dict[int, LearnedChannel] = {}
        self._tests: StickTests | None = None
        self._source: InputSource | None = None
        self._waits_for: tuple[int, ...] = ()
        self._taken_until = -math.inf
        self._heard_at = 0.0
        self._timer = QTimer(self)
        self._timer.setInterval(_TICK_MS)

        self._timer.timeout.connect(self._on_tick)
        device.telemetry.updated.connect(self._on_updated)
        device.link_changed.connect(self._on_link_changed)
        device.state_changed.connect(self._on_state_changed)
        device.motors.changed.connect(self._on_motors_changed)
        device.applied.connect(self._on_applied)

    # --- What is known ------------------------------------------------------------------

    @property
    def step(self) -> Step:
        """How far it is."""
        return self._step

    @property
    def is_test(self) -> bool:
        """Whether the sticks are only tested."""
        return self._after_stopping is Step.TEST

    @property
    def trouble(self) -> str:
        """Why it failed, as a sentence."""
        return self._trouble

    @property
    def sampling(self) -> bool:
        """Whether the rest is sampled right now."""
        return self._sampling

    @property
    def stalled(self) -> bool:
        """Whether measurements should come, and do not."""
        return self._stalled

    @property
    def seconds_left(self) -> float:
        """How much longer the rest is sampled."""
        measured = [channel.neutral for channel in self.channels if channel.neutral is not None]
        seconds = min((neutral.seconds for neutral in measured), default=0.0)
        return max(0.0, SAMPLING_SECONDS - seconds)

    @property
    def channels(self) -> tuple[LearnedChannel, ...]:
        """The channels that are learned."""
        return tuple(self._channels.values())

    @property
    def tests(self) -> StickTests | None:
        """What is tested; `None` in other steps."""
        return self._tests

    @property
    def source(self) -> InputSource:
        """What the inputs are read as."""
        return self._source or self._device.calibrations.source

    @property
    def can_go_on(self) -> bool:
        """Whether `next` does something now."""
        match self._step:
            case Step.NEUTRAL if self._sampling or self._stalled:
                return False
            case Step.NEUTRAL:
                return not self.has_sampled or any(c.is_at_rest for c in self.channels)
            case Step.TRAVEL:
                return True
        return False

    @property
    def has_sampled(self) -> bool:
        """Whether a sampling of the rest has ended."""
        return not self._sampling and any(c.neutral is not None for c in self.channels)

    @property
    def can_take(self) -> bool:
        """Whether there is something to take, and nothing that is wanted is wrong."""
        wanted = [c for c in self.channels if c.choice is not None and c.choice.included]
        return (
            self._step is Step.REVIEW
            and bool(wanted)
            and all(channel.can_be_taken for channel in wanted)
            and not self._device.applying
        )

    def why_not(self) -> str:
        """Say why learning cannot begin now; empty when it can."""
        state = self._device.state
        if self._device.link is not Link.UP or state is None:
            return self.tr("Connect to a board first.")
        if not state.mode.is_serial:
            return self.tr(
                "The board is in {0} mode: the sticks drive the motors, and it takes no settings. "
                "Switch it off, take the mode jumper off, switch it on."
            ).format(state.mode.source.value)
        if self._device.applying:
            return self.tr("Settings are being written.")
        return ""

    # --- What a person does -------------------------------------------------------------

    def begin(self, channels: Sequence[int] = CHANNELS) -> None:
        """Learn these channels at once; the motors are stopped first."""
        self._start(channels, Step.NEUTRAL)

    def begin_test(self, channels: Sequence[int] = CHANNELS) -> None:
        """Test what is stored for these channels; the motors are stopped first."""
        self._start(channels, Step.TEST)

    def next(self) -> None:
        """Sample the rest; go on to the ends without the channels that have none; review."""
        if not self.can_go_on:
            return
        if self._step is Step.TRAVEL:
            for channel in self.channels:
                channel.propose()
            self._go(Step.REVIEW)
        elif self.has_sampled:
            self._begin_travel()
        else:
            self._begin_sampling()

    def back(self) -> None:
        """Go one step back; ends that were reached stay, a rest is sampled anew."""
        if self._step is Step.REVIEW:
            self._go(Step.TRAVEL)
        elif self._step is Step.TRAVEL:
            self._wait_at_rest()

    def again(self) -> None:
        """Do this step, or after a failure all of them, once more."""
        match self._step:
            case Step.NEUTRAL if not self._sampling:
                self._begin_sampling()
            case Step.TRAVEL:
                self._begin_travel()
            case Step.REVIEW:
                self._wait_at_rest()
            case Step.TEST:
                self._begin_tests()
            case Step.FAILED:
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
        channel = self._channels[number]
        channel.choose(calibration, reversed_=reversed_, included=included)
        self.changed.emit()

    def take(self) -> None:
        """Make edits of what is chosen; one step to undo."""
        if not self.can_take:
            return
        chosen = [channel for channel in self.channels if channel.can_be_taken]
        reversed_ = set(channels_in(self._mask("reversed_channels")))
        with self._device.draft.one_edit(self.tr("Learn channels")):
            for channel in chosen:
                if channel.choice is None:
                    continue
                self._device.calibrations.edit(channel.number, channel.choice.calibration)
                reversed_.discard(channel.number)
                if channel.choice.reversed_:
                    reversed_.add(channel.number)
            if self._device.parameters.knows("reversed_channels"):
                mask = channel_mask(reversed_)
                self._device.parameters.edit("reversed_channels", mask, alone=True)
        self._waits_for = tuple(channel.number for channel in chosen)
        self._go(Step.ENDED)
        self.taken.emit()

    def cancel(self) -> None:
        """End it, whatever the step; the board and the edits are as they were."""
        if self._step is not Step.ENDED:
            self._go(Step.ENDED)

    # --- Steps --------------------------------------------------------------------------

    def _start(self, channels: Sequence[int], after_stopping: Step) -> None:
        self._run += 1
        self._numbers = tuple(channels)
        self._channels = {}
        self._tests = None
        self._sampling = self._stalled = False
        self._waits_for = ()
        self._after_stopping = after_stopping
        if trouble := self.why_not():
            self._fail(trouble)
            return
        state, run = self._device.state, self._run
        self._source = None if state is None else state.source
        self._go(Step.STOPPING)
        self._device.stop_motors(lambda error: self._on_stopped(run, error))

    def _on_stopped(self, run: int, error: TrexError | None) -> None:
        if self._step is not Step.STOPPING or run != self._run:
            return
        if error is not None:
            self._fail(
                self.tr("It goes no further, since it is not sure that the motors stand. {0}"),
                str(error),
            )
            return
        if self._after_stopping is Step.TEST:
            self._begin_tests()
        else:
            self._wait_at_rest()

    def _wait_at_rest(self) -> None:
        reversed_ = channels_in(self._mask("reversed_channels"))
        self._sampling = False
        self._channels = {
            number: LearnedChannel(
                number,
                self.source,
                self._device.calibrations.shown(number),
                reversed_now=number in reversed_,
            )
            for number in self._numbers
        }
        self._go(Step.NEUTRAL)

    def _begin_sampling(self) -> None:
        for channel in self.channels:
            channel.begin_sampling()
        self._sampling = True
        self.changed.emit()

    def _begin_travel(self) -> None:
        for channel in self.channels:
            channel.begin_travel()
        self._go(Step.TRAVEL)

    def _begin_tests(self) -> None:
        self._tests = StickTests(self._device, self._numbers)
        self._go(Step.TEST)

    def _go(self, step: Step) -> None:
        self._step = step
        if step is not Step.NEUTRAL:
            self._sampling = False
        self._stalled = False
        if step in _MEASURING:
            times = self._device.telemetry.inputs.times
            self._taken_until = float(times[-1]) if len(times) else -math.inf
            self._heard_at = time.monotonic()
            self._timer.start()
        else:
            self._timer.stop()
        self.changed.emit()

    def _fail(self, text: str, *more: str) -> None:
        self._trouble = text.format(*more)
        self._go(Step.FAILED)

    def _mask(self, key: str) -> int:
        return self._device.parameters.value_of(key) or 0

    # --- What comes in ------------------------------------------------------------------

    @Slot()
    def _on_updated(self) -> None:
        if self._step not in _MEASURING:
            return
        inputs = self._device.telemetry.inputs
        first = int(inputs.times.searchsorted(self._taken_until, side="right"))
        times = inputs.times[first:].tolist()
        if not times:
            return
        for index, moment in enumerate(times, first):
            if moment - self._taken_until < _SAME_VALUE:
                continue
            self._taken_until = moment
            row = [inputs.values(column)[index] for column in range(len(CHANNELS))]
            counts = tuple(None if math.isnan(value) else int(value) for value in row)
            self._take_sample(moment, counts)
        self._heard_at = time.monotonic()
        self._judge()
        self.measured.emit()

    def _take_sample(self, moment: float, counts: tuple[int | None, ...]) -> None:
        if self._tests is not None and self._step is Step.TEST:
            self._tests.feed(moment, counts)
            return
        for channel in self.channels:
            sample = Sample(moment, counts[CHANNELS.index(channel.number)])
            if self._sampling:
                channel.sample(sample)
            elif self._step is Step.TRAVEL:
                channel.follow(sample)
            else:
                channel.feed(sample)

    def _judge(self) -> None:
        """See what the new samples have made of each channel."""
        if self._step is Step.TRAVEL:
            for channel in self.channels:
                channel.look()
        if not self._sampling:
            return
        for channel in self.channels:
            channel.measure()
        neutrals = [channel.neutral for channel in self.channels]
        if any(neutral is None or not neutral.is_complete for neutral in neutrals):
            return
        self._sampling = False
        if all(channel.is_at_rest for channel in self.channels):
            self._begin_travel()
        else:
            self.changed.emit()

    @Slot()
    def _on_tick(self) -> None:
        stalled = time.monotonic() - self._heard_at > _STALLED_AFTER
        if stalled != self._stalled:
            self._stalled = stalled
            if stalled and self._sampling:  # a gap is no rest
                self._begin_sampling()
            self.changed.emit()

    # --- What else happens to the board -------------------------------------------------

    @Slot()
    def _on_link_changed(self) -> None:
        if self._step in {Step.ENDED, Step.FAILED}:
            return
        link = self._device.link
        if link is Link.SILENT:
            self._fail(self.tr("The board has stopped answering. Nothing was changed."))
        elif link is not Link.UP:
            self._fail(self.tr("The line to the board is gone. Nothing was changed."))

    @Slot()
    def _on_state_changed(self) -> None:
        if self._step in {Step.ENDED, Step.FAILED}:
            return
        state = self._device.state
        if state is None:
            self._fail(self.tr("The line to the board is gone. Nothing was changed."))
        elif not state.mode.is_serial or state.source is not self._source:
            self._fail(
                self.tr("The board was started in another mode. Nothing was changed. {0}"),
                self.why_not(),
            )

    @Slot()
    def _on_motors_changed(self) -> None:
        if self._step in _MEASURING and self._device.motors.armed:
            self._fail(self.tr("The motors were armed, so this has ended. Nothing was changed."))

    @Slot(object)
    def _on_applied(self, results: tuple[Written, ...]) -> None:
        del results
        if not self._waits_for or self._step is not Step.ENDED:
            return
        waiting = {channel for channel, _ in self._device.calibrations.pending}
        if waiting.isdisjoint(self._waits_for):
            self._numbers, self._waits_for = self._waits_for, ()
            self.stored.emit()

    @property
    def numbers(self) -> tuple[int, ...]:
        """The channels that were learned or tested last."""
        return self._numbers
