"""Text files that users edit: size limit on reading, atomic writing, errors as sentences."""

import contextlib
import os
from collections.abc import Iterator
from pathlib import Path

from trex_gui.core.files.atomic import atomic_file
from trex_gui.core.files.errors import Finding, SettingsError

LARGEST_FILE = 256 * 1024
"""Bytes; a complete settings file has about 3000."""


def load(path: Path, content: str = "settings") -> bytes:
    """Return the bytes of a text file.

    Args:
        path: the file.
        content: what the file holds, in the plural; for messages.

    Raises:
        SettingsError: it is missing, forbidden, not a regular file, or larger than 256 KiB.
    """
    with _sentences(path, "read"):
        if not path.is_file():
            path.stat()  # raises where the file is missing or forbidden
            raise _error(path, _kind_of(path))
        with path.open("rb") as file:
            data = file.read(LARGEST_FILE + 1)
    check_size(data, str(path), content)
    return data


def check_size(data: bytes, name: str, content: str = "settings") -> None:
    """Raise a `SettingsError` for more than 256 KiB."""
    if len(data) > LARGEST_FILE:
        limit = LARGEST_FILE // 1024
        message = f"is larger than {limit} KiB; {content} are not that long"
        raise SettingsError(name, [Finding(None, None, message)])


def decode(data: bytes, name: str) -> str:
    """Return the text of a file without its byte order mark.

    Raises:
        SettingsError: it is too large, binary, or not UTF-8.
    """
    check_size(data, name)
    message, position = "this is a binary file; settings are text", data.find(b"\0")
    if position < 0:
        try:
            return data.decode("utf-8").removeprefix("\ufeff")
        except UnicodeDecodeError as error:
            message, position = "this is not UTF-8 text", error.start
    raise SettingsError(name, [Finding(data.count(b"\n", 0, position) + 1, None, message)])


def save(path: Path, text: str) -> None:
    """Write a text file; after an error the old one is still there, complete.

    Raises:
        SettingsError: it cannot be written.
    """
    with _sentences(path, "written"):
        target = path.resolve()
        if target.exists() and not target.is_file():
            raise _error(path, _kind_of(target))
        if target.exists() and not os.access(target, os.W_OK):
            raise _error(path, "it may not be written; its permissions forbid it")
        if not target.parent.is_dir():
            raise _error(path, f"there is no folder {target.parent}")
        with atomic_file(target) as file:
            file.write(text.encode("utf-8"))


def save_new(path: Path, text: str) -> bool:
    """Write a text file under a free name; return `False`, with nothing written, if it is taken.

    Raises:
        SettingsError: it cannot be written.
    """
    with _sentences(path, "written"):
        try:
            with atomic_file(path, overwrite=False) as file:
                file.write(text.encode("utf-8"))
        except FileExistsError:
            return False
    return True


@contextlib.contextmanager
def _sentences(path: Path, verb: str) -> Iterator[None]:
    """Turn errors of the operating system into a `SettingsError`."""
    try:
        yield
    except FileNotFoundError:
        raise _error(path, "there is no such file") from None
    except PermissionError:
        raise _error(path, f"it may not be {verb}; its permissions forbid it") from None
    except OSError as error:
        raise _error(path, f"it cannot be {verb}: {error.strerror or error}") from None
    except ValueError as error:  # a name with a NUL in it; text that is not Unicode
        raise _error(path, f"it cannot be {verb}: {error}") from None


def _kind_of(path: Path) -> str:
    return "is a folder, not a file" if path.is_dir() else "is not a regular file"


def _error(path: Path, message: str) -> SettingsError:
    return SettingsError(str(path), [Finding(None, None, message)])
