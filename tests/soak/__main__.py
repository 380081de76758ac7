"""Test the program in real time for a given time, and print the failures.

    python3 packaging/bootstrap.py soak --minutes 30 [--seed 1] [--part faults]

Each part gets the seed and a share of the time, prints its attempts and returns its failures. The
same seed repeats the same attempts in the same order.
"""

import argparse
import random
import sys
import time
from collections.abc import Callable, Mapping, Sequence

from tests.fuzz import targets
from tests.soak import deaths, drives, faults, groups, messages, networks
from tests.support import kill_saves

Part = Callable[[float, int], Sequence[object]]
"""Gets seconds and a seed. Returns the failures."""

PARTS: dict[str, Part] = {
    "fuzz": targets.run,
    "kill_saves": kill_saves.run,
    "faults": faults.run,
    "drives": drives.run,
    "deaths": deaths.run,
    "groups": groups.run,
    "messages": messages.run,
    "networks": networks.run,
}


def run_parts(parts: Mapping[str, Part], seconds: float, seed: int) -> list[str]:
    """Run all parts, each for its share of the time. Return the failures."""
    end = time.monotonic() + seconds
    failures: list[str] = []
    for number, (name, run) in enumerate(parts.items()):
        share = (end - time.monotonic()) / (len(parts) - number)
        print(f"\n--- {name} for {share:.0f} s, seed {seed}", flush=True)
        failed = run(max(share, 0.0), seed)
        print(f"{name}: {len(failed)} failed", flush=True)
        failures += [f"{name}: {failure}" for failure in failed]
    return failures


def main(arguments: Sequence[str] | None = None) -> int:
    parser = argparse.ArgumentParser(prog="soak", description=__doc__)
    parser.add_argument("--minutes", type=float, default=10.0)
    parser.add_argument("--seed", type=int, help="seed, random by default")
    parser.add_argument("--part", choices=sorted(PARTS), action="append", help="run only this part")
    options = parser.parse_args(arguments)
    seed = random.SystemRandom().randrange(10**6) if options.seed is None else options.seed
    selected = {name: run for name, run in PARTS.items() if name in (options.part or PARTS)}
    failures = run_parts(selected, options.minutes * 60, seed)
    print(f"\n{len(failures)} failed, seed {seed}")
    for failure in failures:
        print(f"  {failure}")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
