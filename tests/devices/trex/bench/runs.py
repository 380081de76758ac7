"""Results of bench tests."""

from collections.abc import Sequence
from datetime import UTC, datetime

from trex_gui.devices.trex.bench.run import End, Profile, Run


def run_of(
    currents: Sequence[tuple[float, float]],
    profile: Profile | None = None,
    *,
    ended: float = 2.0,
    end: End = End.COMPLETE,
    reason: str = "",
    motor: int = 1,
) -> Run:
    """Return the result of a bench test with these readings (s, A)."""
    profile = profile or Profile(duration=2.0)
    return Run(
        motor=motor,
        profile=profile,
        accelerate=True,
        abort_current=10.0,
        ampere=0.15,
        started=datetime(2026, 11, 21, 12, 30, tzinfo=UTC),
        end=end,
        reason=reason,
        ended=ended,
        setpoints=((0.0, profile.speed),),
        currents=tuple(currents),
        settings=(("Motor 1 Acceleration", "20 per 100 ms"),),
    )
