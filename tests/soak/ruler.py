"""Distinguishes a hanging window from a busy computer."""

import subprocess
import sys
import threading

_STEP = 0.02  # seconds

_SCRIPT = f"""
import time
before = time.monotonic()
while True:
    time.sleep({_STEP})
    now = time.monotonic()
    if now - before > {1.2 * _STEP}:
        print(before + {_STEP}, now, flush=True)
    before = now
"""


class Ruler:
    """Process that only records when it was late, on the clock of all processes."""

    def __init__(self) -> None:
        self._gaps: list[tuple[float, float]] = []
        self._process = subprocess.Popen(
            [sys.executable, "-c", _SCRIPT], stdout=subprocess.PIPE, text=True
        )
        self._thread = threading.Thread(target=self._read)
        self._thread.start()

    def starved(self, begin: float, end: float) -> float:
        """Return the seconds by which it was late between two moments."""
        return sum(max(0.0, min(end, late) - max(begin, due)) for due, late in list(self._gaps))

    def end(self) -> None:
        self._process.kill()
        self._process.wait()
        self._thread.join()

    def _read(self) -> None:
        assert self._process.stdout is not None
        with self._process.stdout as lines:
            for line in lines:
                due, late = map(float, line.split())
                self._gaps.append((due, late))
