"""Fuzzing without measurement of coverage.

Inputs are bytes. `corpus/<target>` has inputs that once failed, which are always tried first.
Random mutations of valid inputs follow, which depend only on the seed.
"""

import contextlib
import gc
import logging
import re
import signal
import sys
import tempfile
import threading
import time
import traceback
import tracemalloc
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from functools import cache
from itertools import count
from pathlib import Path
from random import Random
from types import TracebackType

CORPUS = Path(__file__).parent / "corpus"
MAX_INPUT = 64 * 1024  # bytes of a random input
MAX_CASE_S = 20.0  # processor time, although most inputs take a few milliseconds
GROWTH_FIRST = 20  # inputs before the first check of the memory
GROWTH_EVERY = 500  # inputs between two checks

_NUMBER = re.compile(rb"-?[0-9]+")
_NUMBERS = (
    *(b"0", b"-1", b"1", b"7", b"127", b"128", b"255", b"256", b"65535", b"2147483648", b"1e9"),
    *(b"-9223372036854775809", b"18446744073709551616", b"9" * 400, b"9" * 5000, b"1e400"),
    *(b"nan", b"-inf", b"0.1", b"0x7f", b"1_0", "٣".encode(), "²".encode(), b""),
)


InputFactory = Callable[[Random], bytes]


@dataclass(frozen=True)
class Target:
    """Part of the program that reads external input."""

    name: str
    create: InputFactory  # depends on the random numbers only
    # Passes an input to the program. Gets an empty folder for files. Raises undocumented errors.
    check: Callable[[bytes, Path], object]
    examples: int = 50  # number of random inputs in the gate
    growth: int = 2000  # bytes of memory that may remain in use after an input

    def corpus(self) -> list[Path]:
        return sorted((CORPUS / self.name).glob("*"))

    def random_input(self, seed: int, number: int) -> bytes:
        return self.create(Random(f"{seed} {self.name} {number}"))


@dataclass(frozen=True)
class Finding:
    """Input with an undocumented result. `origin`: seed and number, or file, of the input."""

    target: Target
    data: bytes
    origin: str
    error: str

    def __str__(self) -> str:
        excerpt = f"{self.data[:400]!r}{' …' if len(self.data) > 400 else ''}"
        return f"{self.target.name}, {self.origin}:\n{excerpt}\n{self.error}"

    def save(self) -> Path:
        """Store the input in the corpus under the name of its error."""
        last = self.error.rstrip().rpartition("\n")[2]
        kind = re.split(r"\W", last.partition(":")[0].rpartition(".")[2])[0] or "error"
        folder = CORPUS / self.target.name
        folder.mkdir(parents=True, exist_ok=True)
        path = next(
            path for number in count(1) if not (path := folder / f"{kind}-{number}").exists()
        )
        path.write_bytes(self.data)
        return path


def attempt(target: Target, data: bytes, origin: str) -> Finding | None:
    """Try an input. An internal error that the program catches is also a finding."""
    errors: list[str] = []
    recorder = _ErrorRecorder(errors)
    hook, sys.excepthook = sys.excepthook, recorder.record
    logging.getLogger().addHandler(recorder)
    try:
        with _watchdog(), tempfile.TemporaryDirectory(prefix="fuzz-") as folder:
            target.check(data, Path(folder).resolve())
    except (Exception, CaseTimeout):  # noqa: BLE001 - any error is a finding
        errors.append(traceback.format_exc())
    finally:
        sys.excepthook = hook
        logging.getLogger().removeHandler(recorder)
    return Finding(target, data, origin, errors[-1]) if errors else None


class _ErrorRecorder(logging.Handler):
    """Records unexpected errors of threads, slots and sessions."""

    def __init__(self, errors: list[str]) -> None:
        super().__init__(logging.ERROR)
        self._errors = errors

    def emit(self, record: logging.LogRecord) -> None:
        if record.exc_info is not None:
            self._errors.append(logging.Formatter().format(record))

    def record(
        self, kind: type[BaseException], error: BaseException, trace: TracebackType | None
    ) -> None:
        self._errors.append("".join(traceback.format_exception(kind, error, trace)))


class CaseTimeout(BaseException):
    """An input exceeded `MAX_CASE_S`. No `except Exception` catches this error."""


@contextlib.contextmanager
def _watchdog() -> Iterator[None]:
    """Raise `CaseTimeout` on systems with a timer for processor time."""
    if (
        not hasattr(signal, "setitimer")
        or threading.current_thread() is not threading.main_thread()
    ):
        yield
        return

    def expire(*_: object) -> None:
        raise CaseTimeout

    before = signal.signal(signal.SIGPROF, expire)
    signal.setitimer(signal.ITIMER_PROF, MAX_CASE_S)
    try:
        yield
    finally:
        signal.setitimer(signal.ITIMER_PROF, 0)
        signal.signal(signal.SIGPROF, before)


def run(
    seconds: float,
    seed: int,
    targets: Sequence[Target],
    report: Callable[[Finding | str], object] = print,
    clock: Callable[[], float] = time.monotonic,
) -> list[Finding]:
    """Try the corpus, then random inputs for some seconds. Report and return the findings.

    All targets get an equal share of the time. The inputs of each target are numbered from 0.
    """
    findings: list[Finding] = []

    def add(finding: Finding | None) -> None:
        if finding is not None:
            findings.append(finding)
            report(finding)

    for target in targets:
        for path in target.corpus():
            add(attempt(target, path.read_bytes(), path.name))
    used = dict.fromkeys(targets, 0.0)
    tried = dict.fromkeys(targets, 0)
    end = clock() + seconds
    while (start := clock()) < end:
        target = min(targets, key=used.__getitem__)
        number = tried[target]
        origin = f"seed {seed}, number {number}"
        add(attempt(target, target.random_input(seed, number), origin))
        tried[target] += 1
        if (tried[target] - GROWTH_FIRST) % GROWTH_EVERY == 0 and (
            (grown := growth(target, seed, number)) > target.growth
        ):
            error = f"Growth: {grown} bytes for each input"
            add(Finding(target, b"", origin, error))
        used[target] += clock() - start
    counts = ", ".join(f"{target.name} {count}" for target, count in tried.items())
    report(f"Tried {sum(tried.values())} inputs: {counts}.")
    return findings


def growth(target: Target, seed: int, number: int, inputs: int = 10) -> int:
    """Return the bytes by which memory grows per input, after the caches are full."""
    tracemalloc.start()
    try:
        sizes = []
        for _ in range(3):
            for offset in range(inputs):
                attempt(target, target.random_input(seed, number + offset), "")
            gc.collect()
            sizes.append(tracemalloc.get_traced_memory()[0])
    finally:
        tracemalloc.stop()
    return (sizes[2] - sizes[1]) // inputs


# --- Mutations --------------------------------------------------------------------------


def mutations(samples: Callable[[], Sequence[bytes]], words: Sequence[bytes] = ()) -> InputFactory:
    """Return a function that mutates valid inputs. `words`: meaningful pieces to insert."""
    valid = cache(samples)

    def create(random: Random) -> bytes:
        if random.random() < 0.05:
            return random.randbytes(random.randrange(300))
        data = random.choice(valid())
        for _ in range(random.choice((1, 1, 1, 2, 2, 3, 5, 8))):
            data = _mutated_once(random, data, valid(), words)[:MAX_INPUT]
        return data

    return create


def _mutated_once(
    random: Random, data: bytes, samples: Sequence[bytes], words: Sequence[bytes]
) -> bytes:
    if b"\n" in data and random.random() < 0.4:
        return b"\n".join(_with_changed_line(random, data.split(b"\n"), samples, words))
    start = random.randrange(len(data) + 1)
    end = min(len(data), start + random.choice((1, 1, 2, 4, 8, 40, 400)))
    before, piece, after = data[:start], data[start:end], data[end:]
    match random.randrange(9):
        case 0:
            piece = bytes(byte ^ 1 << random.randrange(8) for byte in piece[:1]) + piece[1:]
        case 1:
            piece = random.randbytes(len(piece))
        case 2:
            piece = b""
        case 3:
            piece = random.randbytes(random.choice((1, 1, 2, 4, 8))) + piece
        case 4:
            piece *= random.choice((2, 2, 3, 10, 1000))
        case 5:
            piece = _excerpt(random, random.choice(samples))
        case 6 if numbers := list(_NUMBER.finditer(data[:4000])):
            number = random.choice(numbers)
            before, piece, after = (
                data[: number.start()],
                random.choice(_NUMBERS),
                data[number.end() :],
            )
        case 7 if random.random() < 0.2:
            after = b""
        case _ if words:
            piece = random.choice(words) + random.choice((piece, b""))
    return before + piece + after


def _with_changed_line(
    random: Random, lines: list[bytes], samples: Sequence[bytes], words: Sequence[bytes]
) -> list[bytes]:
    line, other = random.randrange(len(lines)), random.randrange(len(lines))
    match random.randrange(5):
        case 0:
            return [*lines[:line], *lines[line + 1 :]]
        case 1:
            lines[line], lines[other] = lines[other], lines[line]
        case 2:
            lines.insert(line, lines[other])
        case 3:
            lines.insert(line, random.choice(random.choice(samples).split(b"\n")))
        case _ if words:
            lines[line] = random.choice(words)
    return lines


def _excerpt(random: Random, data: bytes) -> bytes:
    return data[random.randrange(len(data) + 1) :][:400]
