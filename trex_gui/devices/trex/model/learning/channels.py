"""The channels that are learned together, each from its samples to a choice of values."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace

from trex_gui.devices.trex.calibration.neutral import (
    SAMPLING_SECONDS,
    Neutral,
    measure_neutral,
    no_signal,
)
from trex_gui.devices.trex.calibration.problems import Problem, ProblemKind, has_fatal
from trex_gui.devices.trex.calibration.proposal import Proposal, propose
from trex_gui.devices.trex.calibration.samples import Sample
from trex_gui.devices.trex.calibration.travel import TASKS, Task, Travel, TravelWatch
from trex_gui.devices.trex.model.calibration.channel_curve import ChannelCurve
from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.model.learning.checks import Check
from trex_gui.devices.trex.model.learning.measured_inputs import Counts
from trex_gui.devices.trex.protocol.calibration import Calibration, CalibrationKey
from trex_gui.devices.trex.protocol.flags import CHANNELS, InputSource, channels_in
from trex_gui.devices.trex.protocol.parameters import ParameterKey

_SILENT_AFTER = 0.5
"""Seconds without a valid sample until a channel is said to have no signal."""


@dataclass(frozen=True, slots=True)
class Choice:
    """The user's choice for a channel: the proposal, until they change it."""

    calibration: Calibration
    reversed_: bool
    included: bool = True


class LearnedChannel:
    """Collects what is measured of one channel; each step begins afresh.

    Attributes:
        curve_before: what the channel makes of its input with what the board stores; `None`
            where that is not known.
        parabolic, ignored: what the channel will be, with the edits that wait.
    """

    def __init__(
        self,
        number: int,
        source: InputSource,
        curve_before: ChannelCurve | None,
        *,
        reversed_now: bool,
        parabolic: bool = False,
        ignored: bool = False,
    ) -> None:
        self.number = number
        self.source = source
        self.curve_before = curve_before
        self.reversed_now = reversed_now
        self._parabolic = parabolic
        self._ignored = ignored
        self.raw: int | None = None
        self.neutral: Neutral | None = None
        self.travel: Travel | None = None
        self.proposal: Proposal | None = None
        self.choice: Choice | None = None
        self._samples: list[Sample] = []
        self._watch: TravelWatch | None = None
        self._heard_at: float | None = None
        self._now = 0.0

    def feed(self, sample: Sample) -> None:
        """Take a sample that belongs to no step."""
        self.raw = sample.count
        self._now = sample.time
        if sample.count is not None or self._heard_at is None:
            self._heard_at = sample.time

    # --- At rest ------------------------------------------------------------------------

    def begin_sampling(self) -> None:
        """Sample the rest afresh."""
        self._samples = []
        self.neutral = None

    def sample(self, sample: Sample) -> None:
        """Take a sample of the rest."""
        self.feed(sample)
        self._samples.append(sample)

    def measure(self) -> None:
        """Judge what was sampled so far."""
        self.neutral = measure_neutral(self._samples, self.source)

    @property
    def is_at_rest(self) -> bool:
        """Whether a rest was measured and nothing is wrong with it."""
        return self.neutral is not None and not has_fatal(self.neutral.problems)

    # --- Travel -------------------------------------------------------------------------

    def begin_travel(self) -> None:
        """Follow the ends afresh, where a rest is known."""
        self._watch = None
        self.travel = None
        if self.neutral is not None and self.is_at_rest:
            self._watch = TravelWatch(self.neutral, TASKS[self.number])
            self.travel = self._watch.travel

    def follow(self, sample: Sample) -> None:
        """Take a sample of a channel that moves."""
        self.feed(sample)
        if self._watch is not None:
            self._watch.feed(sample)

    def look(self) -> None:
        """See how far it went so far."""
        if self._watch is not None:
            self.travel = self._watch.travel

    # --- The result ---------------------------------------------------------------------

    def propose(self) -> None:
        """Make values of what was measured."""
        self.proposal = self.choice = None
        if self.neutral is None or self.travel is None:
            return
        self.proposal = propose(
            self.number, self.neutral, self.travel, reversed_now=self.reversed_now
        )
        if self.proposal.calibration is not None:
            self.choice = Choice(self.proposal.calibration, self.proposal.reversed_)

    def choose(
        self,
        calibration: Calibration | None = None,
        *,
        reversed_: bool | None = None,
        included: bool | None = None,
    ) -> None:
        """Change the choice; what is not given stays."""
        if self.choice is None:
            return
        if calibration is not None:
            self.choice = replace(self.choice, calibration=calibration)
        if reversed_ is not None:
            self.choice = replace(self.choice, reversed_=reversed_)
        if included is not None:
            self.choice = replace(self.choice, included=included)

    @property
    def can_be_taken(self) -> bool:
        """Whether the board would take what is chosen, and it is wanted."""
        choice = self.choice
        return choice is not None and choice.included and choice.calibration.problem() is None

    @property
    def stored(self) -> Calibration | None:
        """What the board stores; `None` when it is not known."""
        return None if self.curve_before is None else self.curve_before.calibration

    @property
    def new_rest(self) -> int | None:
        """Where it came to rest, if that is not where it was sampled; a neutral to take."""
        if self.travel is None or self.choice is None or self.travel.task is Task.SWITCH:
            return None
        rest, wanted = self.travel.rest, self.choice.calibration
        if abs(rest - wanted.neutral) <= wanted.deadband or rest == self.travel.neutral:
            return None
        return rest

    @property
    def remarks(self) -> tuple[str, ...]:
        """What is good to know of what is chosen."""
        check = self._check
        return () if check is None else check.remarks

    @property
    def _check(self) -> Check | None:
        if self.curve_after is None or self.neutral is None or self.travel is None:
            return None
        return Check(self.number, self.curve_after, self.neutral, self.travel)

    @property
    def curve_after(self) -> ChannelCurve | None:
        """What it makes of it with what is chosen; `None` where the board would not take that."""
        if self.choice is None or self.choice.calibration.problem() is not None:
            return None
        wanted, reversed_ = self.choice.calibration, self.choice.reversed_
        return ChannelCurve(wanted, reversed_, self._parabolic, self._ignored)

    @property
    def is_silent(self) -> bool:
        """Whether there was no valid sample for a while."""
        return (
            self.raw is None
            and self._heard_at is not None
            and self._now - self._heard_at > _SILENT_AFTER
        )

    @property
    def rest_problems(self) -> tuple[Problem, ...]:
        """What is wrong with the rest, or with a signal that is not sampled yet."""
        if self.neutral is not None:
            return self.neutral.problems
        return (no_signal(self.source),) if self.is_silent else ()

    @property
    def result_problems(self) -> tuple[Problem, ...]:
        """What is wrong with the measurement, or with the user's choice."""
        if self.proposal is None:
            return self.rest_problems
        if self.choice is None:
            return self.proposal.problems
        check = self._check
        if check is not None:
            return self.proposal.problems + check.problems
        refused = self.choice.calibration.problem()
        return (*self.proposal.problems, Problem(ProblemKind.REFUSED, "CHOSEN", (refused,)))


class LearnedChannels:
    """Shares the samples out, and says when all of them have rested for long enough.

    Attributes:
        sampling: whether the rest is sampled right now.
    """

    def __init__(self, channels: Sequence[LearnedChannel] = ()) -> None:
        self.sampling = False
        self.all = tuple(channels)
        self._travelling = False

    @classmethod
    def of(cls, device: Device, numbers: Sequence[int], source: InputSource) -> "LearnedChannels":
        """Begin with these channels as the board stores them; edits that wait do not count."""
        return cls([_channel(device, number, source) for number in numbers])

    def __iter__(self) -> Iterator[LearnedChannel]:
        return iter(self.all)

    def __getitem__(self, number: int) -> LearnedChannel:
        return next(channel for channel in self.all if channel.number == number)

    def begin_sampling(self) -> None:
        """Sample the rest of every channel afresh."""
        for channel in self.all:
            channel.begin_sampling()
        self.sampling = True

    def begin_travel(self) -> None:
        """Look for the ends of every channel afresh."""
        for channel in self.all:
            channel.begin_travel()

    def follow(self, travelling: bool) -> None:
        """Set whether samples to come are travel; sampling of the rest is over."""
        self._travelling = travelling
        self.sampling = False

    def propose(self) -> None:
        """Make values of what was measured."""
        for channel in self.all:
            channel.propose()

    def feed(self, measured: Sequence[tuple[float, Counts]]) -> bool:
        """Take measurements of all inputs; return whether that has ended the sampling."""
        for moment, counts in measured:
            for channel in self.all:
                sample = Sample(moment, counts[CHANNELS.index(channel.number)])
                if self.sampling:
                    channel.sample(sample)
                elif self._travelling:
                    channel.follow(sample)
                else:
                    channel.feed(sample)
        for channel in self.all:
            if self.sampling:
                channel.measure()
            elif self._travelling:
                channel.look()
        if self.sampling and self.seconds_left == 0:
            self.sampling = False
            return True
        return False

    @property
    def seconds_left(self) -> float:
        """How much longer the rest has to be sampled."""
        return max(
            (
                SAMPLING_SECONDS if channel.neutral is None else channel.neutral.seconds_left
                for channel in self.all
            ),
            default=SAMPLING_SECONDS,
        )

    @property
    def has_sampled(self) -> bool:
        """Whether a sampling of the rest has ended."""
        return not self.sampling and any(channel.neutral is not None for channel in self.all)

    @property
    def samples_a_second(self) -> float:
        """How many measurements come in while the ends are looked for; 0 before it is known."""
        intervals = [c.travel.interval for c in self.all if c.travel is not None]
        longest = max(intervals, default=0.0)
        return 1 / longest if longest else 0.0


def _channel(device: Device, number: int, source: InputSource) -> LearnedChannel:
    parameters = device.parameters
    stored = device.calibrations.stored(CalibrationKey.of(source, number))

    def has(mask: int | None) -> bool:
        return number in channels_in(mask or 0)

    is_reversed = has(parameters.stored_of(ParameterKey.REVERSED_CHANNELS))
    before = None
    if stored is not None:
        before = ChannelCurve(
            stored,
            is_reversed,
            has(parameters.stored_of(ParameterKey.PARABOLIC_CHANNELS)),
            has(parameters.stored_of(ParameterKey.IGNORED_CHANNELS)),
        )
    return LearnedChannel(
        number,
        source,
        before,
        reversed_now=is_reversed,
        parabolic=has(parameters.value_of(ParameterKey.PARABOLIC_CHANNELS)),
        ignored=has(parameters.value_of(ParameterKey.IGNORED_CHANNELS)),
    )
