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

TEST = "tests/soak/test_real_faults.py::test_real_fault_is_handled_safely"

ROUND = 5
"""Cases in a process, because its start takes as long as a case."""

CASE_TIMEOUT = 120.0
"""Seconds after which a case hangs. Usually pytest ends the case earlier."""


def run(seconds: float, seed: int) -> list[str]:
    """Run cases until the time is over. Return the failed cases and their messages."""
    end = time.monotonic() + seconds
    failures: list[str] = []
    tried = 0
    for cases in _rounds(seed):
        if time.monotonic() >= end:
            break
        for name, duration, failure in _run_round(cases):
            tried += 1
            print(f"{'failed' if failure else 'ok':<8}{name:<36}{duration:6.1f} s", flush=True)
            if failure:
                failures.append(f"{name}: {failure}")
    print(f"{tried} cases tried, {len(failures)} failed")
    return failures


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
            process = subprocess.run(
                command,
                cwd=ROOT,
                capture_output=True,
                text=True,
                errors="replace",
                check=False,
                timeout=len(names) * CASE_TIMEOUT,
            )
            outcome = f"status {process.returncode}"
        except subprocess.TimeoutExpired:
            outcome = "hangs"
        results = _read(report)
    for name in names:
        yield (name, *results.get(name, (0.0, f"the process ended without a result ({outcome})")))


def _read(report: Path) -> dict[str, tuple[float, str]]:
    """Return seconds and failure of each case in a pytest report."""
    try:
        cases = ElementTree.parse(report).getroot().iter("testcase")
    except (OSError, ElementTree.ParseError):
        return {}
    results: dict[str, tuple[float, str]] = {}
    for case in cases:
        name = case.get("name", "").partition("[")[2].removesuffix("]")
        failures = [case.find("failure"), case.find("error")]
        texts = [failure.get("message", "") for failure in failures if failure is not None]
        _, earlier = results.get(name, (0.0, ""))
        message = earlier or " ".join(" ".join(texts).split())[:300]
        results[name] = (float(case.get("time", "0")), message)
    return results
