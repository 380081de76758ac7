"""Kill a program and its guardian while motors are turning.

The next start must stop the motors and report that. Each case is a cause of death and a program:
the window over three kinds of lines, `trexcmd motor`, or the library, in separate processes.
"""

import os
import random
import signal
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable
from contextlib import suppress
from itertools import product
from pathlib import Path

from tests.support.simulator import SimulatorProcess

ROOT = Path(__file__).parents[2]
LIMIT = 30.0  # seconds; an idle computer takes a moment
AT_ONCE = 1.0
"""Seconds from the connection of the next start to a board that has stopped."""

LIBRARY = """
import sys
from trex_gui import Trex
with Trex(sys.argv[1]) as trex:
    if len(sys.argv) > 2:
        trex.drive(50, 50)
        trex.wait(60)
"""

PROGRAMS = ("window pty", "window tcp", "window rfc2217", "trexcmd pty", "library pty")


def _kill(number: int) -> None:
    with suppress(ProcessLookupError):
        os.kill(number, signal.SIGKILL)


def _guardian_first(seconds: float, number: signal.Signals) -> Callable[[int, int], None]:
    def die(program: int, guardian: int) -> None:
        os.kill(guardian, number)
        time.sleep(seconds)
        _kill(program)

    return die


def _program_first(program: int, guardian: int) -> None:
    _kill(program)
    _kill(guardian)


def _groups(program: int, guardian: int) -> None:
    os.killpg(program, signal.SIGKILL)
    os.killpg(guardian, signal.SIGKILL)


def _namespace(program: int, guardian: int) -> None:
    """Kill `unshare`, and with it all processes of its namespace."""
    del guardian
    _kill(program)


WAYS: dict[str, Callable[[int, int], None]] = {
    "guardian, then program": _guardian_first(0.0, signal.SIGKILL),
    "program, then guardian": _program_first,
    "guardian 0.1 s before": _guardian_first(0.1, signal.SIGKILL),
    "guardian 1 s before": _guardian_first(1.0, signal.SIGKILL),
    "guardian 5 s before": _guardian_first(5.0, signal.SIGKILL),
    "guardian suspended": _guardian_first(0.0, signal.SIGSTOP),
    "guardian suspended 0.2 s before": _guardian_first(0.2, signal.SIGSTOP),
    "guardian suspended 5 s before": _guardian_first(5.0, signal.SIGSTOP),
    "process groups": _groups,
    "namespace of processes": _namespace,
}

CASES = list(product(WAYS, PROGRAMS))


def _command(program: str, url: str, *, drive: bool) -> list[str]:
    if program.startswith("window"):
        return [sys.executable, "-m", "tests.support.driven_window", url, "usual"]
    if program.startswith("trexcmd"):
        words = ["motor", "1", "50"] if drive else ["status"]
        return [sys.executable, "-m", "trex_gui.cli", *words, "--port", url]
    return [sys.executable, "-c", LIBRARY, url, *(["drive"] if drive else [])]


def _turns(board: SimulatorProcess) -> bool:
    return any(motor["direction"] != "brake" for motor in board.show()["motors"])


def _wait(happened: Callable[[], object], what: str) -> float:
    begun = time.monotonic()
    while not happened():
        if time.monotonic() > begun + LIMIT:
            raise TimeoutError(what)
        time.sleep(0.005)
    return time.monotonic() - begun


def _is_connected(process: int, url: str) -> bool:
    """Return whether a process has the port open."""
    ends = {str(Path(url).resolve())}
    if "://" in url:
        port = f":{int(url.rpartition(':')[2]):04X} 01"
        lines = Path("/proc/net/tcp").read_text().splitlines()
        ends = {f"socket:[{line.split()[9]}]" for line in lines if port in line}
    with suppress(OSError):
        return bool(ends & {str(link.readlink()) for link in Path(f"/proc/{process}/fd").iterdir()})
    return False


def _children(process: int) -> list[int]:
    """Return the processes below a process, youngest last."""
    found: list[int] = []
    for task in Path(f"/proc/{process}/task").glob("*/children"):
        for child in map(int, task.read_text().split()):
            found += [child, *_children(child)]
    return found


def die(way: str, program: str) -> str:
    """Run a case. Return the result, which starts with `short` after a failure."""
    kind = program.split()[1]
    place = [] if kind == "pty" else [f"--{kind}", "127.0.0.1:0"]
    board = SimulatorProcess(*place)
    with tempfile.TemporaryDirectory(prefix="trex-deaths") as folder:
        try:
            return _die(way, program, board, Path(folder))
        except (TimeoutError, OSError) as error:
            return f"short: {error}"
        finally:
            for number in _STARTED:
                for each in (*_children(number), number):
                    _kill(each)
            _STARTED.clear()
            board.end()


_STARTED: list[int] = []


def _die(way: str, program: str, board: SimulatorProcess, folder: Path) -> str:
    environment = {
        **os.environ,
        "QT_QPA_PLATFORM": "offscreen",
        "XDG_CONFIG_HOME": str(folder),
        "TREX_STUDIO_DATA": str(folder),
    }

    def start(*command: str) -> "subprocess.Popen[str]":
        process = subprocess.Popen(
            command,
            cwd=ROOT,
            env=environment,
            stdin=subprocess.PIPE,
            stdout=subprocess.DEVNULL,
            stderr=subprocess.PIPE,
            text=True,
            start_new_session=True,
        )
        _STARTED.append(process.pid)
        if program.startswith("window"):
            assert process.stdin is not None
            process.stdin.write("drive\n" if len(_STARTED) == 1 else "only_watch\n")
            process.stdin.flush()
        return process

    below = ["unshare", "-p", "-f", "--kill-child"] if way.startswith("namespace") else []
    first = start(*below, *_command(program, board.url, drive=True))
    _wait(lambda: _turns(board), "it never drove")
    time.sleep(0.2)
    guardians = [
        number
        for number in _children(first.pid)
        if b"guardian" in Path(f"/proc/{number}/cmdline").read_bytes()
    ]
    WAYS[way](first.pid, guardians[-1])
    first.wait()  # no longer: a suspended guardian has its standard error
    time.sleep(0.5)
    ran_on = _turns(board)
    second = start(*_command(program, board.url, drive=False))
    connected = _wait(lambda: _is_connected(second.pid, board.url) or not _turns(board), "no line")
    took = _wait(lambda: not _turns(board), "it was never stopped")
    log = folder / "guardian.log"
    _wait(lambda: log.exists() and " confirmed:" in log.read_text(), "it was never confirmed")
    if program.startswith("window"):
        time.sleep(1.0)
        second.terminate()
    said = second.communicate(timeout=LIMIT)[1] + log.read_text()
    said += "".join(path.read_text() for path in folder.glob("log/*.log"))
    left = [path.name for path in folder.glob("driven/*")]
    if left or took > AT_ONCE or (ran_on and "Motors may still be turning" not in said):
        return f"short: {took:.2f} s, left {left}, said {said!r}"
    what = f"turned on, stopped {took:.2f} s after" if ran_on else "stopped by a guardian before"
    return f"{what} the connection ({connected:.1f} s)"


def run(seconds: float, seed: int) -> list[str]:
    """Run cases until the time is over. Return the failures and their reasons."""
    end = time.monotonic() + seconds
    cases, found = list(CASES), []
    random.Random(seed).shuffle(cases)
    tried = 0
    for way, program in cases:
        if time.monotonic() >= end:
            break
        seen = die(way, program)
        tried += 1
        print(f"{program:<15} {way:<32} {seen}", flush=True)
        if seen.startswith("short"):
            found.append(f"{program}, {way}: {seen}")
    print(f"{tried} of {len(cases)} cases tried, {len(found)} fell short")
    return found
