"""User files, read with a size limit and written atomically.

Only ordinary files are accepted. Errors in text files are reported as findings with line numbers.
"""

import codecs
import contextlib
import errno
import os
import re
import shutil
import stat
import time
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from enum import StrEnum
from functools import cache
from pathlib import Path
from typing import BinaryIO

import platformdirs

from trex_gui.core.errors import StudioError
from trex_gui.core.translation import tr


def data_folder() -> Path:
    """Return the folder `$TREX_STUDIO_DATA`. Default: the program's folder for user data."""
    override = os.environ.get("TREX_STUDIO_DATA")
    return Path(override or platformdirs.user_data_dir("TReX Studio", appauthor=False)).absolute()


def file_exists(path: Path) -> bool:
    """Return whether a file exists. False for a name that is too long for the system."""
    with contextlib.suppress(OSError):
        return path.exists()
    return False


def log_folder() -> Path:
    return data_folder() / "log"


class Severity(StrEnum):
    """Severity of a finding. A file with only warnings is usable."""

    ERROR = "error"
    WARNING = "warning"


@dataclass(frozen=True, slots=True)
class Finding:
    line: int | None  # from 1; `None`: the file as a whole
    key: str | None  # spelt as in the file
    message: str  # includes the expected and the actual value
    severity: Severity = Severity.ERROR
    code: str = ""  # kind of the finding, for programs; empty for file system errors

    def __str__(self) -> str:
        parts = [
            "" if self.line is None else tr("line {0}").format(self.line),
            tr("warning") if self.severity is Severity.WARNING else "",
            self.key or "",
            self.message,
        ]
        return ": ".join(part for part in parts if part)


class SettingsError(StudioError):
    """Settings file that is invalid, unreadable or not writable. `findings`: sorted by line."""

    def __init__(self, name: str, findings: Iterable[Finding]) -> None:
        self.name = name
        self.findings = tuple(findings)
        super().__init__(name, self.findings)

    @classmethod
    def of(cls, name: object, message: str, line: int | None = None) -> "SettingsError":
        return cls(str(name), [Finding(line, None, message)])

    def __str__(self) -> str:
        separator = " " if len(self.findings) == 1 else "\n"
        return f"{self.name}:{separator}" + "\n".join(map(str, self.findings))


def reason_of(error: StudioError) -> str:
    """Return the reason for a file error, without the file name and the final period."""
    text = "; ".join(map(str, error.findings)) if isinstance(error, SettingsError) else str(error)
    return text.rstrip(". ")


class NotOrdinaryFileError(OSError):
    """Error for a folder, pipe, socket or device. Reading such a file may block forever."""

    def __init__(self, path: Path, mode: int) -> None:
        reason = tr("it is not an ordinary file")
        if stat.S_ISDIR(mode):
            reason = tr("it is a folder, not a file")
        super().__init__(errno.EINVAL, reason, str(path))
        self.reason = reason


def check_ordinary(path: Path) -> None:
    """Raise OSError unless `path` is an ordinary file or a link to one."""
    _check_mode(path, path.stat().st_mode)


def open_ordinary(path: Path) -> BinaryIO:
    """Open an ordinary file for reading. Raises OSError. Never blocks."""
    check_ordinary(path)  # before opening, which changes the control lines of a serial port
    extra_flags = getattr(os, "O_NONBLOCK", 0) | getattr(os, "O_NOCTTY", 0)
    file = open(  # noqa: SIM115 - the caller closes it
        path, "rb", opener=lambda name, flags: os.open(name, flags | extra_flags)
    )
    try:
        _check_mode(path, os.fstat(file.fileno()).st_mode)  # the file may have been replaced
    except BaseException:
        file.close()
        raise
    return file


def _check_mode(path: Path, mode: int) -> None:
    if not stat.S_ISREG(mode):
        raise NotOrdinaryFileError(path, mode)


_DRAFT = re.compile(r"\..*\.[0-9a-f]{8}\.trexdraft(-wal)?", re.DOTALL)  # -wal: log of SQLite

_ABANDONED_S = 600.0  # seconds; an older draft was left by a killed program


@cache
def remove_abandoned(folder: Path) -> None:
    """Remove the drafts that killed programs have left in a folder. Runs only once per folder."""
    oldest = time.time() - _ABANDONED_S
    with contextlib.suppress(OSError), os.scandir(folder) as entries:
        for entry in entries:
            if _DRAFT.fullmatch(entry.name):
                with contextlib.suppress(OSError):
                    if entry.stat(follow_symlinks=False).st_mtime < oldest:
                        Path(entry).unlink()


@contextlib.contextmanager
def atomic_file(path: Path, *, overwrite: bool = True) -> Iterator[BinaryIO]:
    """Open a file that replaces `path` once it is complete.

    The new file is synced to disk first. After an exception the old file is unchanged and the new
    file is removed. If the program is killed, either the old or the new file exists, and a hidden
    draft may remain. The first write to the folder in a later run removes such drafts. Links and
    permissions are preserved. The caller may close the file.

    Raises:
        NotOrdinaryFileError: `path` is a folder, a pipe or a device.
        FileExistsError: `overwrite` is false and `path` exists.
    """
    target = Path(os.path.realpath(path))
    if overwrite:
        with contextlib.suppress(FileNotFoundError):
            check_ordinary(target)
    remove_abandoned(target.parent)
    start = target.name[:25]  # up to 100 bytes; file systems allow 143 to 255
    draft = target.with_name(f".{start}.{os.urandom(4).hex()}.trexdraft")
    try:
        mode = 0o600 if target.exists() else 0o666  # private until the target's mode is copied
        with open(draft, "xb", opener=lambda name, flags: os.open(name, flags, mode)) as file:
            yield file
        with draft.open("rb+") as written:
            os.fsync(written.fileno())
        if overwrite:
            with contextlib.suppress(FileNotFoundError):
                shutil.copymode(target, draft)
            draft.replace(target)
        else:
            _rename_new(draft, target)
    finally:
        with contextlib.suppress(OSError):
            draft.unlink()
    _sync_folder(target.parent)


def _rename_new(draft: Path, target: Path) -> None:
    """Rename a file atomically. Raises FileExistsError if `target` exists."""
    if os.name == "nt":
        draft.rename(target)  # never replaces a file on Windows
        return
    try:
        target.hardlink_to(draft)
    except FileExistsError:
        raise
    except OSError:  # a file system without hard links
        target.open("xb").close()
        try:
            draft.replace(target)
        except BaseException:
            target.unlink()
            raise


def _sync_folder(folder: Path) -> None:
    """Sync a folder, so that new file names survive a power failure."""
    with contextlib.suppress(OSError):
        handle = os.open(folder, os.O_RDONLY)
        try:
            os.fsync(handle)
        finally:
            os.close(handle)


LARGEST_FILE = 256 * 1024  # bytes; a complete settings file has about 3000 bytes


def load(path: Path, content: str = "settings", largest: int = LARGEST_FILE) -> bytes:
    """Return the bytes of a text file. `content`: plural noun for error messages."""
    with explained(path, tr("it cannot be read")), open_ordinary(path) as file:
        data = file.read(largest + 1)
    check_size(data, str(path), content, largest)
    return data


def check_size(
    data: bytes, name: str, content: str = "settings", largest: int = LARGEST_FILE
) -> None:
    if len(data) > largest:
        limit = largest // 1024
        raise SettingsError.of(
            name, tr("is larger than {0} KiB; {1} are never that large").format(limit, content)
        )


def decode(data: bytes, name: str) -> str:
    """Decode UTF-8 text and remove its byte order mark. Raises SettingsError."""
    check_size(data, name)
    message, position = tr("this is a binary file; settings are text"), data.find(b"\0")
    has_mark = data.startswith((codecs.BOM_UTF16_LE, codecs.BOM_UTF16_BE))
    halves = data[:200:2], data[1:200:2]
    if has_mark or (len(data) > 3 and any(half and not half.strip(b"\0") for half in halves)):
        message = tr("this is UTF-16 text, as PowerShell writes with >; save the file as UTF-8")
    elif position < 0:
        try:
            return data.decode("utf-8").removeprefix("\ufeff")
        except UnicodeDecodeError as error:
            message, position = tr("this is not UTF-8 text"), error.start
    raise SettingsError.of(name, message, data.count(b"\n", 0, position) + 1)


def save(path: Path, content: str | bytes) -> None:
    """Write a file, text as UTF-8. After a SettingsError the old file is unchanged."""
    with explained(path, tr("it cannot be written")):
        target = Path(os.path.realpath(path))
        if target.is_file() and not os.access(target, os.W_OK):
            raise SettingsError.of(path, tr("it cannot be written: permission denied"))
        if not target.parent.is_dir():
            raise SettingsError.of(path, tr("there is no folder {0}").format(target.parent))
        data = content.encode("utf-8") if isinstance(content, str) else content
        with atomic_file(target) as file:
            file.write(data)


def save_over(path: Path, content: str | bytes, expected: bytes | None) -> bool:
    """Write a file if it still contains `expected`. Return whether it was written.

    If `expected` is `None`, any content is overwritten. A missing file is created. After a
    SettingsError the file is unchanged.
    """
    if expected is not None:
        # After an OSError here, `save` creates the file or reports the reason.
        with contextlib.suppress(OSError), open_ordinary(path) as file:
            if file.read(len(expected) + 1) != expected:
                return False
    save(path, content)
    return True


def save_new(path: Path, text: str) -> bool:
    """Write a new file. Return False if the file already exists. Raises SettingsError."""
    with explained(path, tr("it cannot be written")):
        try:
            with atomic_file(path, overwrite=False) as file:
                file.write(text.encode("utf-8"))
        except FileExistsError:
            return False
    return True


@contextlib.contextmanager
def explained(path: Path, failure: str) -> Iterator[None]:
    """Convert system errors to `SettingsError`. `failure`: clause that precedes the reason."""
    try:
        yield
    except FileNotFoundError:
        raise SettingsError.of(path, tr("there is no such file")) from None
    except NotOrdinaryFileError as error:
        raise SettingsError.of(path, error.reason) from None
    except PermissionError:
        raise SettingsError.of(path, f"{failure}: {tr('permission denied')}") from None
    except OSError as error:
        raise SettingsError.of(path, f"{failure}: {error.strerror or error}") from None
    except ValueError as error:  # NUL in a name, or invalid Unicode
        raise SettingsError.of(path, f"{failure}: {error}") from None
