"""Figures of a bench test, computed only from its readings."""

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise
from statistics import fmean

from trex_gui.devices.trex.bench.run import Run

LONGEST_GAP = 0.5  # seconds between two readings over which no charge is counted
BAND = 0.1  # default deviation that counts as settled, as a share of the steady current
_TAIL = 0.3  # final share of a constant setpoint, whose current counts as steady
_SHORTEST_PLATEAU = 0.4  # seconds of a constant setpoint, with ten readings in its tail
_NOISE_COUNTS = 2  # least reading that is a current; a single count may be noise


@dataclass(frozen=True, slots=True)
class Figures:
    """The figures of a test. `None` where the readings are not sufficient."""

    peak: float | None = None  # highest reading, A
    mean: float | None = None  # A, from the first setpoint until the motor began to brake
    charge: float | None = None  # mAh, over the same time as `mean`
    steady: float | None = None  # A at the end of the first constant setpoint
    # s from the first setpoint until the current stayed within a share of `steady`, at least two
    # counts. To come within it is not enough: an inrush passes the steady current on its way up.
    settled: float | None = None
    delay: float | None = None  # s from the first setpoint to the first reading that is a current


def figures(run: Run, band: float = BAND) -> Figures:
    """Return the figures of a test. `band` is the share of `steady` (0 to 1) for `settled`."""
    command = next((time for time, speed in run.setpoints if speed), None)
    driven = [(time, amps) for time, amps in run.currents if 0 <= time <= run.ended]
    if command is None or not driven:
        return Figures()
    mean, charge = _flow(driven)
    noise = _NOISE_COUNTS * run.ampere
    first, last = run.profile.plateau(run.ended) or (0.0, 0.0)
    tail = [amps for time, amps in driven if last - _TAIL * (last - first) <= time < last]
    steady = fmean(tail) if tail and last - first >= _SHORTEST_PLATEAU else None
    settled = None
    if steady:
        within = max(band * steady, noise) + 1e-9
        held = [(time, amps) for time, amps in driven if command <= time < last]
        left_at = max((time for time, amps in held if abs(amps - steady) > within), default=-1.0)
        settled = next((time - command for time, _ in held if time > left_at), None)
    flowing = (time - command for time, amps in driven if time >= command and amps >= noise - 1e-9)
    return Figures(
        peak=max(amps for _, amps in driven),
        mean=mean,
        charge=charge,
        steady=steady,
        settled=settled,
        delay=next(flowing, None),
    )


def _flow(readings: Sequence[tuple[float, float]]) -> tuple[float | None, float]:
    """Return the mean in A and the charge in mAh. Gaps are left out of both."""
    seconds = coulombs = 0.0
    for (start, before), (end, after) in pairwise(readings):
        if end - start <= LONGEST_GAP:
            seconds += end - start
            coulombs += (before + after) / 2 * (end - start)
    return (coulombs / seconds if seconds else None), coulombs / 3.6
