"""Two boards in one group, in virtual time, with random stops and losses."""

import time

from tests.devices.trex.session.group_harness import run_sequences, stop_delays

_BATCH = 500  # stops and sequences
_MAX_SENT, _MAX_CONFIRMED = 0.020, 0.060  # seconds until a stop is sent, and until confirmed


def run(seconds: float, seed: int) -> list[str]:
    end, failures, count = time.monotonic() + seconds, list[str](), 0
    worst = 0.0, 0.0
    while time.monotonic() < end:
        sent, confirmed = stop_delays(_BATCH, seed + count)
        worst = max(worst[0], *sent), max(worst[1], *confirmed)
        failures += run_sequences(_BATCH, seed + count)
        count += _BATCH
    milliseconds = [1000 * value for value in worst]
    print(f"{count} stops and sequences: worst {milliseconds[0]:.1f}, {milliseconds[1]:.1f} ms")
    if worst[0] > _MAX_SENT or worst[1] > _MAX_CONFIRMED:
        failures.append(
            f"a stop took {milliseconds[0]:.1f} ms, its confirmation {milliseconds[1]:.1f}"
        )
    return failures
