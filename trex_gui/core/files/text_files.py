"""Settings files on disk: read whole or not at all, written whole or not at all."""

import contextlib
import os
import secrets
import shutil
from collections.abc import Iterator
from pathlib import Path

from trex_gui.core.files.errors import Finding, SettingsError
from trex_gui.devices.trex.settings.plain_yaml import LARGEST_FILE


def load(path: Path) -> bytes:
    """Return what a settings file holds.

    Raises:
        SettingsError: it is missing, forbidden, no ordinary file or too large to be one.
    """
    with _sentences(path, "read"):
        if not path.is_file():
            path.stat()  # says what is missing or forbidden
            raise _refusal(path, _kind_of(path))
        with path.open("rb") as file:
            # A little more than allowed, for a file may grow between two looks at it.
            data = file.read(LARGEST_FILE + 1)
    if len(data) > LARGEST_FILE:
        limit = LARGEST_FILE // 1024
        raise _refusal(path, f"is larger than {limit} KiB; settings are not that long")
    return data


def save(path: Path, text: str) -> None:
    """Write a settings file; whatever happens, the old one or the new one is there, whole.

    Raises:
        SettingsError: it cannot be written; says why.
    """
    with _sentences(path, "written"):
        target = path.resolve()
        if target.exists() and not target.is_file():
            raise _refusal(path, _kind_of(target))
        if target.exists() and not os.access(target, os.W_OK):
            raise _refusal(path, "it may not be written; its permissions forbid it")
        if not target.parent.is_dir():
            raise _refusal(path, f"there is no folder {target.parent}")
        with _drafted(target, text) as draft:
            with contextlib.suppress(FileNotFoundError):
                shutil.copymode(target, draft)
            draft.replace(target)
        _sync_folder(target.parent)


def save_new(path: Path, text: str) -> bool:
    """Write a settings file under a name that is free, whole or not at all.

    Of several programs that want the same name at once, one gets it.

    Returns:
        Whether the name was free; else nothing was written.

    Raises:
        SettingsError: it cannot be written; says why.
    """
    with _sentences(path, "written"):
        try:
            with _drafted(path, text) as draft:
                _take_free_name(draft, path)
        except FileExistsError:
            return False
        _sync_folder(path.parent)
    return True


@contextlib.contextmanager
def _drafted(target: Path, text: str) -> Iterator[Path]:
    """Write a text beside its place and down to the disk; take the draft away if it stays."""
    draft = target.with_name(f".{target.name[:100]}.{secrets.token_hex(4)}.tmp")
    try:
        with draft.open("xb") as file:
            file.write(text.encode("utf-8"))
            file.flush()
            os.fsync(file.fileno())
        yield draft
    finally:
        with contextlib.suppress(OSError):
            draft.unlink()


def _take_free_name(draft: Path, target: Path) -> None:
    """Give a draft its name in one step; a `FileExistsError` when it is taken."""
    if os.name == "nt":
        draft.rename(target)  # refuses there what it replaces elsewhere
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
    """Make the new name of a file last through a power failure, where a system can."""
    with contextlib.suppress(OSError):
        handle = os.open(folder, os.O_RDONLY)
        try:
            os.fsync(handle)
        finally:
            os.close(handle)


@contextlib.contextmanager
def _sentences(path: Path, what: str) -> Iterator[None]:
    """Say what the system refuses as a person would."""
    try:
        yield
    except FileNotFoundError:
        raise _refusal(path, "there is no such file") from None
    except PermissionError:
        raise _refusal(path, f"it may not be {what}; its permissions forbid it") from None
    except OSError as error:
        raise _refusal(path, f"it cannot be {what}: {error.strerror or error}") from None
    except ValueError as error:  # a name with a NUL in it; text that is no Unicode
        raise _refusal(path, f"it cannot be {what}: {error}") from None


def _kind_of(path: Path) -> str:
    return "is a folder, not a file" if path.is_dir() else "is no ordinary file"


def _refusal(path: Path, message: str) -> SettingsError:
    return SettingsError(str(path), [Finding(None, None, message)])
