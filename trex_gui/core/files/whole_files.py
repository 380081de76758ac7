"""Files on disk: opened with a reason where that fails, written whole or not at all."""

import contextlib
import secrets
from collections.abc import Iterator
from pathlib import Path
from typing import BinaryIO

from trex_gui.core.recording.errors import RecordingError


def opened(path: Path) -> BinaryIO:
    """Open a recording for reading.

    Raises:
        RecordingError: it cannot be opened.
    """
    try:
        return path.open("rb")
    except (OSError, ValueError) as error:
        reason = getattr(error, "strerror", None) or error
        raise RecordingError(str(path), f"It cannot be opened: {reason}.") from error


@contextlib.contextmanager
def whole_file(path: Path) -> Iterator[BinaryIO]:
    """Open a file that takes its name only when all of it was written.

    Until then it lies beside its place under another name, and whatever had the name stays; where
    the writing ends with an exception nothing is left of it. What is no ordinary file, such as a
    pipe, is written to as it is.

    Raises:
        OSError: it cannot be written.
    """
    target = path.resolve()
    if target.exists() and not target.is_file():
        with target.open("wb") as file:
            yield file
        return
    draft = target.with_name(f".{target.name[:100]}.{secrets.token_hex(4)}.part")
    try:
        with draft.open("xb") as file:
            yield file
        draft.replace(target)
    finally:
        with contextlib.suppress(OSError):
            draft.unlink(missing_ok=True)
