"""What the next bench test is."""

from dataclasses import dataclass, field

from trex_gui.devices.trex.bench.profile import Profile


@dataclass(frozen=True, slots=True, kw_only=True)
class Plan:
    """What the next test is.

    Attributes:
        motor: 1 or 2.
        profile: what it is asked to do.
        accelerate: whether through the board's ramp, brake duration and limit, or at once.
        abort_current: A; one reading above it stops everything.
        abort_at_limit: whether the board's own current limit stops everything, too.
    """

    motor: int = 1
    profile: Profile = field(default_factory=Profile)
    accelerate: bool = True
    abort_current: float = 10.0
    abort_at_limit: bool = False
