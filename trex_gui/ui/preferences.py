"""Typed access to the program's preferences."""

import contextlib
import logging
import re
import stat
import sys
import time
from collections.abc import Callable
from functools import cache
from pathlib import Path
from typing import TypeVar

from PySide6.QtCore import QByteArray, QCoreApplication, QSettings

T = TypeVar("T")

log = logging.getLogger(__name__)

_MAX_FILE_SIZE = 4 * 1024 * 1024  # bytes; a typical file has 3000 bytes
_ABANDONED_S = 600.0  # minimum age of an abandoned lock or temporary file


class Preferences:
    """Values by key. An invalid value is logged and counts as missing.

    A user may edit the file, so a value may have any type or size. A pipe is never opened,
    since that would block. If the file cannot be used, values last only until the program ends.
    """

    def __init__(self) -> None:
        self._store = _open()

    def flag(self, key: str, *, default: bool) -> bool:
        return self._read(key, default, _flag)

    def integer(self, key: str, default: int, lowest: int, highest: int) -> int:
        return self._read(key, default, lambda value: _in_range(int(_text(value)), lowest, highest))

    def real(self, key: str, default: float, lowest: float, highest: float) -> float:
        return self._read(
            key, default, lambda value: _in_range(float(_text(value)), lowest, highest)
        )

    def text(self, key: str, default: str = "") -> str:
        return self._read(key, default, _text)

    def path(self, key: str, default: str | Path) -> Path:
        return Path(self._read(key, str(default), _path))

    def data(self, key: str) -> QByteArray:
        return self._read(key, QByteArray(), _data)

    def set(self, key: str, value: bool | float | str | QByteArray) -> None:
        self._store.setValue(key, value)

    def _read(self, key: str, default: T, convert: Callable[[object], T]) -> T:
        value = self._store.value(key)
        if value is None:
            return default
        try:
            return convert(value)
        except (ValueError, OverflowError) as error:
            log.warning("the preference %s is ignored: %s", key, str(error)[:200])
            return default


def _open() -> QSettings:
    file_format = QSettings.defaultFormat()
    if file_format is QSettings.Format.NativeFormat and sys.platform in {"win32", "darwin"}:
        return QSettings()  # the system stores the preferences
    # `QSettings` opens its file before it returns the file name. Opening a missing file is safe.
    unused = QSettings(file_format, QSettings.Scope.UserScope, "TReX Studio, no such file")
    unused_path = Path(unused.fileName())
    folder, suffix = unused_path.parent, unused_path.suffix
    organization = QCoreApplication.organizationName()
    path = folder / organization / f"{QCoreApplication.applicationName()}{suffix}"
    lock = path.with_name(f"{path.name}.lock")
    for file in (path, folder / f"{organization}{suffix}", lock):
        if problem := _problem(file):
            _report(file, problem)
            # No file can exist below a file, so these preferences are never saved.
            return QSettings(str(file / "unused"), QSettings.Format.IniFormat)
    remove_stale_files(path)
    return QSettings()


@cache
def _report(path: Path, problem: str) -> None:
    log.warning("the preferences are not used: %s %s", path, problem)


@cache
def remove_stale_files(path: Path) -> None:
    """Remove locks and temporary files that killed programs left beside `path`."""
    stale = re.compile(re.escape(path.name) + r"\.(lock(\.rmlock)+|[A-Za-z]{6})")
    with contextlib.suppress(OSError):
        for file in path.parent.iterdir():
            if stale.fullmatch(file.name) and file.lstat().st_mtime < time.time() - _ABANDONED_S:
                file.unlink()


def _problem(path: Path) -> str:
    """Return the reason why a file must not be opened, or an empty string."""
    try:
        status = path.stat()
    except OSError:
        return ""  # the file is missing, or Qt cannot open it either
    if not (stat.S_ISREG(status.st_mode) or stat.S_ISDIR(status.st_mode)):
        return "is not an ordinary file"
    return "is too large" if status.st_size > _MAX_FILE_SIZE else ""


def _flag(value: object) -> bool:
    if isinstance(value, bool):
        return value
    if value in ("true", "false"):
        return value == "true"
    raise ValueError(f"{value!r} is neither true nor false")


def _text(value: object) -> str:
    if isinstance(value, str):
        return value
    if isinstance(value, int | float) and not isinstance(value, bool):
        return str(value)
    raise ValueError(f"{value!r} is not text")


def _path(value: object) -> str:
    if "\0" in (text := _text(value)):
        raise ValueError(f"{value!r} is not a path")
    return text


def _data(value: object) -> QByteArray:
    if isinstance(value, QByteArray):
        return value
    raise ValueError(f"{value!r} is not binary data")


NumberT = TypeVar("NumberT", int, float)


def _in_range(number: NumberT, lowest: NumberT, highest: NumberT) -> NumberT:
    if lowest <= number <= highest:
        return number
    raise ValueError(f"{number} is not between {lowest} and {highest}")
