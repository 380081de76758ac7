"""What can be wrong with a recording, said with its file and the place in it."""

from pathlib import Path
from typing import BinaryIO

from trex_gui.core.errors import StudioError


class RecordingError(StudioError):
    """A recording cannot be read or written.

    Attributes:
        name: the file, as the person knows it.
        place: where in it, such as `byte 40960` or `line 17`; empty for the file as a whole.
        message: what is wrong, as a sentence.
    """

    def __init__(self, name: str, message: str, place: str = "") -> None:
        self.name = name
        self.place = place
        self.message = message
        super().__init__(name, message, place)

    def __str__(self) -> str:
        where = f"{self.name}, {self.place}" if self.place else self.name
        return f"{where}: {self.message}"


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
