"""Measurements of simulated sticks, without a board."""

from collections.abc import Sequence
from random import Random

from tests.support.transmitter import HOLD, RATE, Stick
from trex_gui.devices.trex.calibration.channel_curve import ChannelCurve
from trex_gui.devices.trex.calibration.neutral import ChannelSample, Neutral, measure_neutral
from trex_gui.devices.trex.calibration.proposal import Proposal, propose
from trex_gui.devices.trex.calibration.travel import TASKS, Travel
from trex_gui.devices.trex.model.learning.channels import Check
from trex_gui.devices.trex.protocol.calibration import Calibration
from trex_gui.devices.trex.protocol.flags import InputSource

THROTTLE = Stick(rest=1100, low=1100, high=1900)
HIGH_THROTTLE = Stick(rest=1900, low=1100, high=1900)


def neutral_of_counts(
    counts: Sequence[int], source: InputSource = InputSource.RC, rate: float = RATE
) -> Neutral:
    """Measure an input at rest with these counts, `rate` per second."""
    samples = [ChannelSample(index / rate, count) for index, count in enumerate(counts)]
    neutral = measure_neutral(samples, source)
    assert neutral is not None
    return neutral


def neutral_of(stick: Stick, seed: int = 1) -> Neutral:
    """Measure a stick that rests for 1.6 s."""
    neutral = measure_neutral(stick.samples(((1.6, 0.0),), Random(seed)), stick.source)
    assert neutral is not None
    assert neutral.seconds_left == 0
    return neutral


def travel_of(
    stick: Stick,
    neutral: Neutral,
    channel: int = 1,
    moves: tuple[tuple[float, float], ...] = HOLD,
    seed: int = 2,
    rate: float = RATE,
) -> Travel:
    travel = Travel(neutral, TASKS[channel])
    for sample in stick.samples(moves, Random(seed), 10.0, rate):
        travel.feed(sample)
    return travel


def learn(
    stick: Stick,
    channel: int = 1,
    moves: tuple[tuple[float, float], ...] = HOLD,
    *,
    seed: int = 1,
    reversed_now: bool = False,
) -> Proposal:
    neutral = neutral_of(stick, seed)
    travel = travel_of(stick, neutral, channel, moves, seed + 1)
    return propose(neutral, travel, reversed_now=reversed_now)


def check(
    stick: Stick,
    channel: int,
    calibration: Calibration | None = None,
    *,
    reversed_: bool | None = None,
) -> Check:
    """Check a calibration. The default is the proposed calibration."""
    neutral = neutral_of(stick)
    travel = travel_of(stick, neutral, channel)
    proposal = propose(neutral, travel, reversed_now=False)
    assert proposal.calibration is not None
    reversed_ = proposal.reversed_ if reversed_ is None else reversed_
    curve = ChannelCurve(calibration or proposal.calibration, reversed_)
    return Check(channel, curve, neutral, travel)
