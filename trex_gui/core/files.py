"""Text files that users edit: findings by line, size limit on reading, atomic writing."""

import contextlib
import errno
import os
import secrets
import shutil
import stat
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from enum import StrEnum
from pathlib import Path
from typing import BinaryIO

from trex_gui.core.errors import StudioError


class Severity(StrEnum):
    """Whether a file with this finding can be used."""

    ERROR = "error"
    WARNING = "warning"


@dataclass(frozen=True, slots=True)
class Finding:
    """An error or warning about a settings file; `key` is spelt as in the file.

    Attributes:
        line: counted from 1; `None` for the file as a whole.
        message: what was expected, and what was found instead.
        code: the kind of finding, for programs; empty for errors of the file system.
    """

    line: int | None
    key: str | None
    message: str
    severity: Severity = Severity.ERROR
    code: str = ""

    def __str__(self) -> str:
        parts = [
            "" if self.line is None else f"line {self.line}",
            "warning" if self.severity is Severity.WARNING else "",
            self.key or "",
            self.message,
        ]
        return ": ".join(part for part in parts if part)


class SettingsError(StudioError):
    """A settings file cannot be used, read or written; `findings` are in the order of lines."""

    def __init__(self, name: str, findings: Iterable[Finding]) -> None:
        self.name = name
        self.findings = tuple(findings)
        super().__init__(name, self.findings)

    @classmethod
    def of(cls, name: object, message: str, line: int | None = None) -> "SettingsError":
        return cls(str(name), [Finding(line, None, message)])

    def __str__(self) -> str:
        between = " " if len(self.findings) == 1 else "\n"
        return f"{self.name}:{between}" + "\n".join(map(str, self.findings))


def open_regular(path: Path) -> BinaryIO:
    """Open an ordinary file for reading: a pipe would block, a device may react to it.

    Raises:
        OSError: it cannot be opened, or is not an ordinary file.
    """
    _check_regular(path, path.stat())
    flags = os.O_RDONLY | getattr(os, "O_BINARY", 0) | getattr(os, "O_NONBLOCK", 0)
    file = os.fdopen(os.open(path, flags), "rb")
    try:
        _check_regular(path, os.fstat(file.fileno()))  # it may have been replaced meanwhile
    except OSError:
        file.close()
        raise
    return file


def _check_regular(path: Path, found: os.stat_result) -> None:
    if not stat.S_ISREG(found.st_mode):
        kind = "is a folder, not a file" if stat.S_ISDIR(found.st_mode) else "is no regular file"
        raise OSError(errno.EINVAL, f"it {kind}", str(path))


@contextlib.contextmanager
def atomic_file(path: Path, *, overwrite: bool = True) -> Iterator[BinaryIO]:
    """Open a file that replaces `path` once everything was written and synced to disk.

    After an exception the old file is still there and nothing is left of the new one. Links and
    permissions are kept. A pipe or a device is written to directly. The caller may close the file.

    Raises:
        FileExistsError: with `overwrite` off, the name is taken, also by another program just now.
    """
    target = path.resolve()
    if overwrite and target.exists() and not target.is_file():
        with target.open("wb") as file:
            yield file
        return
    draft = target.with_name(f".{target.name[:100]}.{secrets.token_hex(4)}.tmp")
    try:
        with draft.open("xb") as file:
            yield file
        with draft.open("rb+") as written:
            os.fsync(written.fileno())
        if overwrite:
            with contextlib.suppress(FileNotFoundError):
                shutil.copymode(target, draft)
            draft.replace(target)
        else:
            _take_free_name(draft, target)
    finally:
        with contextlib.suppress(OSError):
            draft.unlink()
    _sync_folder(target.parent)


def _take_free_name(draft: Path, target: Path) -> None:
    """Rename a file in one step; a `FileExistsError` when the name is taken."""
    if os.name == "nt":
        draft.rename(target)  # replaces a file on other systems only
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
    """Make a new file name survive a power failure, where the system can."""
    with contextlib.suppress(OSError):
        handle = os.open(folder, os.O_RDONLY)
        try:
            os.fsync(handle)
        finally:
            os.close(handle)


LARGEST_FILE = 256 * 1024  # bytes; a complete settings file has about 3000


def load(path: Path, content: str = "settings") -> bytes:
    """Return the bytes of a text file; `content` (plural) says what it holds, for messages."""
    with _sentences(path, "read"):
        if not path.is_file():
            path.stat()  # raises where the file is missing or forbidden
            raise SettingsError.of(path, _kind_of(path))
        with open_regular(path) as file:
            data = file.read(LARGEST_FILE + 1)
    check_size(data, str(path), content)
    return data


def check_size(data: bytes, name: str, content: str = "settings") -> None:
    if len(data) > LARGEST_FILE:
        limit = LARGEST_FILE // 1024
        raise SettingsError.of(name, f"is larger than {limit} KiB; {content} are not that long")


def decode(data: bytes, name: str) -> str:
    """Return the text without its byte order mark; SettingsError if it is binary or not UTF-8."""
    check_size(data, name)
    message, position = "this is a binary file; settings are text", data.find(b"\0")
    if position < 0:
        try:
            return data.decode("utf-8").removeprefix("\ufeff")
        except UnicodeDecodeError as error:
            message, position = "this is not UTF-8 text", error.start
    raise SettingsError.of(name, message, data.count(b"\n", 0, position) + 1)


def save(path: Path, text: str) -> None:
    """Write a text file; after a SettingsError the old one is still there, complete."""
    with _sentences(path, "written"):
        target = path.resolve()
        if target.exists() and not target.is_file():
            raise SettingsError.of(path, _kind_of(target))
        if target.exists() and not os.access(target, os.W_OK):
            raise SettingsError.of(path, "it cannot be written: permission denied")
        if not target.parent.is_dir():
            raise SettingsError.of(path, f"there is no folder {target.parent}")
        with atomic_file(target) as file:
            file.write(text.encode("utf-8"))


def save_new(path: Path, text: str) -> bool:
    with _sentences(path, "written"):
        try:
            with atomic_file(path, overwrite=False) as file:
                file.write(text.encode("utf-8"))
        except FileExistsError:
            return False
    return True


@contextlib.contextmanager
def _sentences(path: Path, verb: str) -> Iterator[None]:
    try:
        yield
    except FileNotFoundError:
        raise SettingsError.of(path, "there is no such file") from None
    except PermissionError:
        raise SettingsError.of(path, f"it cannot be {verb}: permission denied") from None
    except OSError as error:
        raise SettingsError.of(path, f"it cannot be {verb}: {error.strerror or error}") from None
    except ValueError as error:  # a name with a NUL in it; text that is not Unicode
        raise SettingsError.of(path, f"it cannot be {verb}: {error}") from None


def _kind_of(path: Path) -> str:
    return "is a folder, not a file" if path.is_dir() else "is not a regular file"
