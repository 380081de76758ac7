"""Calibrations from simulated sticks, without a board."""

from random import Random

from tests.support.transmitter import HOLD, Stick
from trex_gui.devices.trex.calibration.channel_curve import ChannelCurve
from trex_gui.devices.trex.calibration.neutral import Neutral, measure_neutral
from trex_gui.devices.trex.calibration.proposal import Proposal, propose
from trex_gui.devices.trex.calibration.travel import TASKS, Travel
from trex_gui.devices.trex.model.learning.channels import Check
from trex_gui.devices.trex.protocol.calibration import Calibration

REST = ((1.6, 0.0),)


def neutral_of(stick: Stick, seed: int = 1) -> Neutral:
    found = measure_neutral(stick.samples(REST, Random(seed)), stick.source)
    assert found is not None
    assert found.seconds_left == 0
    return found


def travel_of(
    stick: Stick,
    neutral: Neutral,
    channel: int = 1,
    moves: tuple[tuple[float, float], ...] = HOLD,
    seed: int = 2,
) -> Travel:
    travel = Travel(neutral, TASKS[channel])
    for sample in stick.samples(moves, Random(seed), start=10.0):
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
    stick: Stick, channel: int, wanted: Calibration | None = None, *, reversed_: bool | None = None
) -> Check:
    """Return the findings on a calibration, by default the proposed calibration."""
    neutral = neutral_of(stick)
    travel = travel_of(stick, neutral, channel)
    proposal = propose(neutral, travel, reversed_now=False)
    assert proposal.calibration is not None
    turned = proposal.reversed_ if reversed_ is None else reversed_
    curve = ChannelCurve(wanted or proposal.calibration, turned)
    return Check(channel, curve, neutral, travel)
