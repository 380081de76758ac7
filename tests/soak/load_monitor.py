"""Monitor that distinguishes a hanging window from a busy computer."""

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


class LoadMonitor:
    """Process that wakes up at regular intervals and reports each late wake-up."""

    def __init__(self) -> None:
        self._gaps: list[tuple[float, float]] = []
        self._process = subprocess.Popen(
            [sys.executable, "-c", _SCRIPT], stdout=subprocess.PIPE, text=True
        )
        self._thread = threading.Thread(target=self._read)
        self._thread.start()

    def pauses(self, begin: float, end: float) -> float:
        """Return the seconds between two times in which the process was late."""
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
