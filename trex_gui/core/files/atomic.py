"""Files that appear under their name completely written or not at all."""

import contextlib
import os
import secrets
import shutil
from collections.abc import Iterator
from pathlib import Path
from typing import BinaryIO


@contextlib.contextmanager
def atomic_file(path: Path, *, overwrite: bool = True) -> Iterator[BinaryIO]:
    """Open a file that replaces `path` once everything was written and synced to disk.

    After an exception the old file is still there and nothing is left of the new one. Links and
    permissions are kept. A pipe or a device is written to directly. The caller may close the file.

    Raises:
        FileExistsError: with `overwrite` off, the name is taken. Of several programs that want
            the same name at once, one gets it.
        OSError: the file cannot be written.
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
