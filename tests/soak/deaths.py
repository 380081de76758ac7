"""Kill a program and its guardian while motors are turning.

The next start must stop the motors and report the stop. Each case is a cause of death and a
program: the window with one of three kinds of lines, `trexcmd motor`, or a user of the library.
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
LIMIT = 30.0  # seconds until an event, even on a busy computer
MAX_STOP_S = 1.0
"""Seconds from the connection of the next start to the stop of the board."""

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


CAUSES: dict[str, Callable[[int, int], None]] = {
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

CASES = list(product(CAUSES, PROGRAMS))


def _command(program: str, url: str, *, drive: bool) -> list[str]:
    if program.startswith("window"):
        return [sys.executable, "-m", "tests.support.driven_window", url, "default"]
    if program.startswith("trexcmd"):
        words = ["motor", "1", "50"] if drive else ["status"]
        return [sys.executable, "-m", "trex_gui.cli", *words, "--port", url]
    return [sys.executable, "-c", LIBRARY, url, *(["drive"] if drive else [])]


def turns(board: SimulatorProcess) -> bool:
    return any(motor["direction"] != "brake" for motor in board.show()["motors"])


def wait(condition: Callable[[], object], problem: str) -> float:
    """Wait until a condition holds. Return the seconds. After `LIMIT`, raise a problem."""
    start = time.monotonic()
    while not condition():
        if time.monotonic() > start + LIMIT:
            raise TimeoutError(problem)
        time.sleep(0.002)
    return time.monotonic() - start


def _is_connected(process: int, url: str) -> bool:
    """Return whether a process has the port open."""
    files = {str(Path(url).resolve())}
    if "://" in url:
        port = f":{int(url.rpartition(':')[2]):04X} 01"
        lines = Path("/proc/net/tcp").read_text().splitlines()
        files = {f"socket:[{line.split()[9]}]" for line in lines if port in line}
    with suppress(OSError):
        links = Path(f"/proc/{process}/fd").iterdir()
        return bool(files & {str(link.readlink()) for link in links})
    return False


def _children(process: int) -> list[int]:
    """Return all descendants of a process, each after its parent."""
    children: list[int] = []
    for task in Path(f"/proc/{process}/task").glob("*/children"):
        for child in map(int, task.read_text().split()):
            children += [child, *_children(child)]
    return children


def die(cause: str, program: str) -> str:
    """Run a case. Return the result, which starts with `failed` after a failure."""
    kind = program.split()[1]
    options = [] if kind == "pty" else [f"--{kind}", "127.0.0.1:0"]
    board = SimulatorProcess(*options)
    with tempfile.TemporaryDirectory(prefix="trex-deaths") as folder:
        try:
            return _die(cause, program, board, Path(folder))
        except (OSError, subprocess.TimeoutExpired) as error:
            return f"failed: {error}"
        finally:
            for number in _STARTED:
                for process in (*_children(number), number):
                    _kill(process)
            _STARTED.clear()
            board.end()


_STARTED: list[int] = []


def _die(cause: str, program: str, board: SimulatorProcess, folder: Path) -> str:
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
            process.stdin.write("drive\n" if len(_STARTED) == 1 else "stop_rearming\n")
            process.stdin.flush()
        return process

    prefix = ["unshare", "-p", "-f", "--kill-child"] if cause.startswith("namespace") else []
    first = start(*prefix, *_command(program, board.url, drive=True))
    wait(lambda: turns(board), "the motors never turned")
    time.sleep(0.2)
    guardians = [
        number
        for number in _children(first.pid)
        if b"guardian" in Path(f"/proc/{number}/cmdline").read_bytes()
    ]
    CAUSES[cause](first.pid, guardians[-1])
    first.wait()  # without its standard error, which a suspended guardian has open
    time.sleep(0.5)
    was_turning = turns(board)
    second = start(*_command(program, board.url, drive=False))
    connected = wait(lambda: _is_connected(second.pid, board.url) or not turns(board), "not open")
    duration = wait(lambda: not turns(board), "the motors never stopped")
    log = folder / "guardian.log"
    wait(lambda: log.exists() and " confirmed:" in log.read_text(), "the stop was never confirmed")
    if program.startswith("window"):
        time.sleep(1.0)
        second.terminate()
    output = second.communicate(timeout=LIMIT)[1] + log.read_text()
    output += "".join(path.read_text() for path in folder.glob("log/*.log"))
    files = [path.name for path in folder.glob("driven/*")]
    is_reported = not was_turning or "Motors may still be turning" in output
    if files or duration > MAX_STOP_S or not is_reported:
        return f"failed: {duration:.2f} s, remaining files {files}, output {output!r}"
    result = f"stopped {duration:.2f} s after" if was_turning else "stopped by the guardian before"
    return f"{result} the connection ({connected:.1f} s)"


def run(seconds: float, seed: int) -> list[str]:
    """Run cases until the time is over. Return the failed cases and their results."""
    end = time.monotonic() + seconds
    cases, failures = list(CASES), []
    random.Random(seed).shuffle(cases)
    tried = 0
    for cause, program in cases:
        if time.monotonic() >= end:
            break
        result = die(cause, program)
        tried += 1
        print(f"{program:<15} {cause:<32} {result}", flush=True)
        if result.startswith("failed"):
            failures.append(f"{program}, {cause}: {result}")
    print(f"{tried} of {len(cases)} cases tried, {len(failures)} failed")
    return failures
