"""Curves of channels, compared with the board at every raw count."""

from itertools import product

import pytest

from tests.support.matrix import sampled
from trex_gui.devices.trex.calibration.channel_curve import ChannelCurve
from trex_gui.devices.trex.protocol.calibration import HIGHEST_CODED, Calibration
from trex_gui.devices.trex.simulator.channel_control import ChannelSetup

CALIBRATIONS = (
    Calibration(2500, 3750, 5000, 75),
    Calibration(2400, 3700, 5100, 0),
    Calibration(0, 512, 1023, 20),
    Calibration(3000, 3000, 4500, 10),  # no travel below neutral
    Calibration(2000, 3000, 3000, 400),
    Calibration(3000, 3010, 3020, 200),  # the deadband covers the whole travel
    Calibration(0, 8000, HIGHEST_CODED, 1),
)
OPTIONS = (  # reversed, parabolic, ignored
    (False, False, False),
    (True, False, False),
    (False, True, False),
    (True, True, False),
    (True, True, True),
)


@pytest.mark.parametrize(
    ("calibration", "options"), sampled(product(CALIBRATIONS, OPTIONS), every=4), ids=str
)
def test_curve_matches_the_board_at_every_raw_count(
    calibration: Calibration, options: tuple[bool, bool, bool]
) -> None:
    reversed_, parabolic, ignored = options
    curve = ChannelCurve(calibration, reversed_, parabolic, ignored)
    setup = ChannelSetup(
        (calibration,) * 5,
        ignored=0x1F * ignored,
        reversed_=0x1F * reversed_,
        parabolic=0x1F * parabolic,
    )
    outputs = [curve.output(raw) for raw in range(HIGHEST_CODED + 1)]
    for raw in range(0, HIGHEST_CODED + 1, 5):
        # The five channels have equal settings and remap five counts at once.
        counts = [min(raw + step, HIGHEST_CODED) for step in range(5)]
        assert setup.remapped(counts) == tuple(outputs[count] for count in counts)
    assert curve.output(None) == 0


@pytest.mark.parametrize("calibration", CALIBRATIONS, ids=str)
def test_drawn_curve_reproduces_every_output(calibration: Calibration) -> None:
    curve = ChannelCurve(calibration, parabolic=True)
    low, high = 0, 6250
    outputs = [curve.output(raw) for raw in range(low, high + 1)]
    counts, values = curve.corners(low, high)
    assert (counts[0], counts[-1]) == (low, high)
    drawn: list[int] = []
    for first, last, value in zip(counts, counts[1:], values, strict=False):
        drawn += [value] * (last - first)
    assert drawn == list(outputs[:-1])


@pytest.mark.parametrize(
    ("channel", "reversed_", "ignored"),
    sampled(product((4, 5), (False, True), (False, True)), every=3),
)
def test_switch_threshold_matches_the_board(channel: int, reversed_: bool, ignored: bool) -> None:
    for calibration in CALIBRATIONS:
        curve = ChannelCurve(calibration, reversed_, ignored=ignored)
        setup = ChannelSetup((calibration,) * 5, 0x1F * ignored, 0x1F * reversed_)
        for raw in (None, *range(HIGHEST_CODED + 1)):
            assert curve.is_switched(channel, raw) == setup.is_switched(channel, raw)


def test_only_channels_4_and_5_have_a_threshold() -> None:
    curve = ChannelCurve(CALIBRATIONS[0])
    assert [curve.threshold(channel) for channel in (1, 2, 3, 4, 5)] == [None] * 3 + [3125] * 2
