"""The channels that are learned at once: they rest together, and move together."""

from collections.abc import Iterator, Sequence

from trex_gui.devices.trex.calibration.neutral import SAMPLING_SECONDS
from trex_gui.devices.trex.calibration.samples import Sample
from trex_gui.devices.trex.model.calibration.channel_curve import ChannelCurve
from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.model.learning.channel import LearnedChannel
from trex_gui.devices.trex.model.learning.measured_inputs import Counts
from trex_gui.devices.trex.protocol.calibration import CalibrationKey
from trex_gui.devices.trex.protocol.flags import CHANNELS, InputSource, channels_in
from trex_gui.devices.trex.protocol.parameter_keys import ParameterKey


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
        """Say whether the samples to come tell where the ends are; sampling is over."""
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
