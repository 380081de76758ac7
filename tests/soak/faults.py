"""Fault matrix in real time, in random order, with real ports."""

import random
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator
from pathlib import Path
from xml.etree import ElementTree

from tests.fault_matrix.cases import CASES, name_of

ROOT = Path(__file__).parents[2]

TEST = "tests/soak/test_real_faults.py::test_real_fault"

ROUND = 5
"""Cases for each process: starting it takes as long as a case."""

CASE_TIMEOUT = 120.0
"""Seconds after which a case hangs; pytest ends it before."""


def run(seconds: float, seed: int) -> list[str]:
    """Run cases until the time is over. Return the failures and their reasons."""
    end = time.monotonic() + seconds
    found: list[str] = []
    tried = 0
    for cases in _rounds(seed):
        if time.monotonic() >= end:
            break
        for name, seconds_taken, why in _run_round(cases):
            tried += 1
            print(f"{'short' if why else 'ok':<6}{name:<36}{seconds_taken:6.1f} s", flush=True)
            if why:
                found.append(f"{name}: {why}")
    print(f"{tried} cases tried, {len(found)} fell short")
    return found


def _rounds(seed: int) -> Iterator[list[str]]:
    order = random.Random(seed)
    names = [name_of(*case) for case in CASES]
    while True:
        order.shuffle(names)
        yield from (names[first : first + ROUND] for first in range(0, len(names), ROUND))


def _run_round(names: list[str]) -> Iterator[tuple[str, float, str]]:
    """Run cases in one process. Yield name, seconds and failure of each case."""
    with tempfile.TemporaryDirectory(prefix="trex-soak") as folder:
        report = Path(folder) / "report.xml"
        command = [sys.executable, "-m", "pytest", "-q", "-p", "no:randomly", "--tb=short"]
        command += [f"--junitxml={report}", *(f"{TEST}[{name}]" for name in names)]
        try:
            done = subprocess.run(
                command,
                cwd=ROOT,
                capture_output=True,
                text=True,
                errors="replace",
                check=False,
                timeout=len(names) * CASE_TIMEOUT,
            )
            outcome = f"status {done.returncode}"
        except subprocess.TimeoutExpired:
            outcome = "hangs"
        found = _read(report)
    for name in names:
        yield (name, *found.get(name, (0.0, f"the process ended without a result ({outcome})")))


def _read(report: Path) -> dict[str, tuple[float, str]]:
    """Return seconds and failure of each case in a pytest report."""
    try:
        cases = ElementTree.parse(report).getroot().iter("testcase")
    except (OSError, ElementTree.ParseError):
        return {}
    found: dict[str, tuple[float, str]] = {}
    for case in cases:
        name = case.get("name", "").partition("[")[2].removesuffix("]")
        failures = [case.find("failure"), case.find("error")]
        texts = [failure.get("message", "") for failure in failures if failure is not None]
        _, before = found.get(name, (0.0, ""))
        why = before or " ".join(" ".join(texts).split())[:300]
        found[name] = (float(case.get("time", "0")), why)
    return found
