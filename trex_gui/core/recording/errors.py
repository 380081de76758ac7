"""Errors of recordings and of the files beside them."""

from trex_gui.core.errors import StudioError


class RecordingError(StudioError):
    """A file cannot be read or written: its name as the user knows it, and the reason."""

    def __init__(self, name: str, message: str) -> None:
        self.name = name
        self.message = message
        super().__init__(name, message)

    def __str__(self) -> str:
        return f"{self.name}: {self.message}"
