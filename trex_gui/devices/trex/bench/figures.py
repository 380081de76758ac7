"""The figures of a bench test, from its readings alone. Pure."""

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise

from trex_gui.devices.trex.bench.run import Run

LONGEST_GAP = 0.5
"""Seconds between two readings over which no charge is counted."""

BAND = 0.1
"""How far from the steady current, as a share of it, counts as settled by default."""

_TAIL = 0.3
"""The share of a constant setpoint, at its end, whose current counts as steady."""

_SHORTEST_PLATEAU = 0.4
"""Seconds of a constant setpoint below which no current is steady: ten readings in its tail."""

_NOISE_COUNTS = 2
"""Counts from which a reading is a current; one alone may be noise."""


@dataclass(frozen=True, slots=True)
class Figures:
    """The figures of a test; `None` where the readings are not sufficient.

    Attributes:
        peak: highest reading, A.
        peak_at: its time, s since the first setpoint.
        mean: A, from the first setpoint until the motor began to brake.
        charge: mAh, in the same time.
        steady: A at the end of the first constant setpoint.
        settled: s from the first setpoint until the current came within a share of `steady`, or
            two counts where that is more, and stayed there: an inrush passes the steady
            current on its way up.
        delay: s from the first setpoint to the first reading that is a current.
    """

    peak: float | None = None
    peak_at: float | None = None
    mean: float | None = None
    charge: float | None = None
    steady: float | None = None
    settled: float | None = None
    delay: float | None = None


def figures(run: Run, band: float = BAND) -> Figures:
    """Return the figures of a test; `band` is the share of `steady` (0 to 1) for `settled`."""
    command = next((time for time, speed in run.setpoints if speed), None)
    driven = [(time, amps) for time, amps in run.currents if 0 <= time <= run.ended]
    if command is None or not driven:
        return Figures()
    peak_at, peak = max(driven, key=lambda reading: (reading[1], -reading[0]))
    mean, charge = _flow(driven)
    after = [(time, amps) for time, amps in driven if time >= command]
    steady = _steady(run, driven)
    noise = _NOISE_COUNTS * run.ampere
    flowing = (time - command for time, amps in after if amps >= noise - 1e-9)
    within = max(band * steady, noise) if steady else 0.0

    return Figures(
        peak=peak,
        peak_at=peak_at,
        mean=mean,
        charge=charge,
        steady=steady,
        settled=_settled(run, after, steady, command, within) if steady else None,
        delay=next(flowing, None),
    )


def _flow(readings: Sequence[tuple[float, float]]) -> tuple[float | None, float]:
    """Return the mean in A and the charge in mAh; gaps count for neither."""
    seconds = coulombs = 0.0
    for (start, before), (end, after) in pairwise(readings):
        if end - start <= LONGEST_GAP:
            seconds += end - start
            coulombs += (before + after) / 2 * (end - start)
    return (coulombs / seconds if seconds else None), coulombs / 3.6


def _steady(run: Run, driven: Sequence[tuple[float, float]]) -> float | None:
    span = run.profile.plateau(run.ended)
    if span is None or span[1] - span[0] < _SHORTEST_PLATEAU:
        return None
    begin = span[1] - _TAIL * (span[1] - span[0])
    tail = [amps for time, amps in driven if begin <= time < span[1]]
    return sum(tail) / len(tail) if tail else None


def _settled(
    run: Run, after: Sequence[tuple[float, float]], steady: float, command: float, within: float
) -> float | None:
    """Return when the current came to stay; `None` where it did not."""
    span = run.profile.plateau(run.ended)
    if span is None:
        return None
    settled: float | None = None
    for time, amps in after:
        if time >= span[1]:
            break
        if abs(amps - steady) > within + 1e-9:
            settled = None
        elif settled is None:
            settled = time - command
    return settled
