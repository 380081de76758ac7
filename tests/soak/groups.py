"""Two boards in one group, in virtual time, with random stops and losses."""

import time

from tests.devices.trex.session.group_harness import run_sequences, stop_delays

_AT_ONCE = 500
_LEFT, _CONFIRMED = 0.020, 0.060  # most seconds to the last byte of a stop, and to its confirmation


def run(seconds: float, seed: int) -> list[str]:
    end, found, count = time.monotonic() + seconds, list[str](), 0
    worst = 0.0, 0.0
    while time.monotonic() < end:
        left, confirmed = stop_delays(_AT_ONCE, seed + count)
        worst = max(worst[0], *left), max(worst[1], *confirmed)
        found += run_sequences(_AT_ONCE, seed + count)
        count += _AT_ONCE
    milliseconds = [1000 * one for one in worst]
    print(f"{count} stops and sequences: worst {milliseconds[0]:.1f}, {milliseconds[1]:.1f} ms")
    if worst[0] > _LEFT or worst[1] > _CONFIRMED:
        found.append(
            f"a stop took {milliseconds[0]:.1f} ms, its confirmation {milliseconds[1]:.1f}"
        )
    return found
