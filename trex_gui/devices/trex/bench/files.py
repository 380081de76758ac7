"""Bench tests as text files for spreadsheets.

Facts about the test come first, one `# name: value` per line. A table follows:

```
time_s,setpoint,current_a
0.0000,40,
0.0113,40,5.85
```

Each row is a setpoint (without a current) or a reading. Rows are sorted by time. Times are in
seconds since the first setpoint. Speeds are -127 to 127.
"""

import csv
import io
import math
from collections.abc import Callable, Iterable
from datetime import datetime
from itertools import takewhile
from operator import itemgetter
from pathlib import Path
from typing import TypeVar

from trex_gui.core.errors import StudioError
from trex_gui.core.files import load
from trex_gui.core.translation import tr
from trex_gui.devices.trex.bench.run import End, Profile, Run, Shape

_MAX_FILE_SIZE = 10_000_000  # bytes; two minutes of readings take less than half a megabyte
_TITLE = "# TReX Studio bench test"
_COLUMNS = ["time_s", "setpoint", "current_a"]
_SETTING_PREFIX = "stored "

ValueT = TypeVar("ValueT")


class BenchFileError(StudioError):
    """The file is not a bench test. The text gives the reason and, if known, the line."""


def load_run(path: Path) -> Run:
    """Load a test from a file.

    Raises:
        SettingsError: the file cannot be read.
        BenchFileError: the file is damaged.
    """
    data = load(path, tr("bench tests"), _MAX_FILE_SIZE)
    try:
        return from_csv(data.decode("utf-8"))
    except UnicodeDecodeError as error:
        raise BenchFileError(tr("it is not a text file")) from error


def to_csv(run: Run) -> str:
    """Return a test as text. Times are rounded to 0.1 ms, currents to 0.1 mA."""
    lines = [_TITLE, *(f"# {name}: {value}" for name, value in _facts(run))]
    out = io.StringIO("\n".join(lines) + "\n")
    out.seek(0, io.SEEK_END)
    table = csv.writer(out, lineterminator="\n")
    table.writerow(_COLUMNS)
    rows = [(time, f"{speed}", "") for time, speed in run.setpoints]
    rows += [(time, f"{run.setpoint_at(time)}", f"{amps:.4f}") for time, amps in run.currents]
    for time, speed, amps in sorted(rows, key=itemgetter(0)):
        table.writerow([f"{time:.4f}", speed, amps])
    return out.getvalue()


def _facts(run: Run) -> Iterable[tuple[str, str]]:
    profile = run.profile
    yield "started", run.started.isoformat(timespec="seconds")
    yield "motor", str(run.motor)
    yield "shape", profile.shape.value
    yield "speed", str(profile.speed)
    yield "duration_s", f"{profile.duration:g}"
    yield "period_s", f"{profile.period:g}"
    yield "sent", "accelerate" if run.accelerate else "set"
    yield "abort_current_a", f"{run.abort_current:g}"
    yield "ampere_per_count", f"{run.ampere:g}"
    yield "end", run.end.value
    yield "ended_s", f"{run.ended:.4f}"
    if run.reason:
        yield "reason", " ".join(run.reason.split())
    for name, text in run.settings:
        yield _SETTING_PREFIX + name, text


def from_csv(text: str) -> Run:
    """Return the test that `to_csv` wrote. Raise BenchFileError for any other text."""
    lines = text.removeprefix("\ufeff").splitlines()
    if not lines or lines[0].strip() != _TITLE:
        raise BenchFileError(tr("line 1: a bench test begins with {0!r}").format(_TITLE))
    header = list(takewhile(lambda line: line.startswith("#"), lines[1:]))
    facts: dict[str, str] = {}
    for number, line in enumerate(header, 2):
        name, colon, value = line.removeprefix("#").partition(":")
        if not colon:
            raise BenchFileError(tr("line {0}: expected a name and a value").format(number))
        facts[name.strip()] = value.strip()
    setpoints, currents = _table(lines, 1 + len(header))
    try:
        profile = Profile(
            shape=_fact(facts, "shape", Shape),
            speed=_fact(facts, "speed", int),
            duration=_fact(facts, "duration_s", _number),
            period=_fact(facts, "period_s", _number),
        )
    except ValueError as error:
        raise BenchFileError(str(error)) from error
    motor = _fact(facts, "motor", int)
    if motor not in {1, 2}:
        raise BenchFileError(tr("motor: expected 1 or 2, not {0}").format(motor))
    return Run(
        motor=motor,
        profile=profile,
        accelerate=_fact(facts, "sent", str) == "accelerate",
        abort_current=_fact(facts, "abort_current_a", _number),
        ampere=_fact(facts, "ampere_per_count", _number),
        started=_fact(facts, "started", datetime.fromisoformat),
        end=_fact(facts, "end", End),
        reason=facts.get("reason", ""),
        ended=_fact(facts, "ended_s", _number),
        setpoints=setpoints,
        currents=currents,
        settings=tuple(
            (name.removeprefix(_SETTING_PREFIX), value)
            for name, value in facts.items()
            if name.startswith(_SETTING_PREFIX)
        ),
    )


def _fact(facts: dict[str, str], name: str, read: Callable[[str], ValueT]) -> ValueT:
    if name not in facts:
        raise BenchFileError(tr("the line “# {0}: …” is missing").format(name))
    try:
        return read(facts[name])
    except ValueError as error:
        raise BenchFileError(tr("{0}: invalid value “{1}”").format(name, facts[name])) from error


def _number(text: str) -> float:
    value = float(text)
    if not math.isfinite(value):
        raise ValueError(text)
    return value


def _table(
    lines: list[str], first: int
) -> tuple[tuple[tuple[float, int], ...], tuple[tuple[float, float], ...]]:
    try:
        rows = list(csv.reader(lines[first:]))
    except csv.Error as error:
        raise BenchFileError(tr("line {0} or below: {1}").format(first + 1, error)) from error
    if not rows or rows[0] != _COLUMNS:
        text = tr("line {0}: expected the columns {1}")
        raise BenchFileError(text.format(first + 1, ", ".join(_COLUMNS)))
    setpoints: list[tuple[float, int]] = []
    currents: list[tuple[float, float]] = []
    for number, row in enumerate(rows[1:], first + 2):
        try:
            time, speed, amps = row
            if amps:
                currents.append((_number(time), _number(amps)))
            else:
                setpoints.append((_number(time), int(speed)))
        except ValueError as error:
            text = tr("line {0}: invalid row “{1}”")
            raise BenchFileError(text.format(number, ",".join(row))) from error
    return tuple(setpoints), tuple(currents)
