"""The languages that settings are exported to."""

from enum import Enum


class Language(Enum):
    """A language; the value is its word in command lines."""

    ARDUINO = "arduino"
    PYTHON = "python"
    C = "c"

    @property
    def title(self) -> str:
        """What people call a program in it."""
        titles = {"arduino": "Arduino sketch", "python": "Python program", "c": "C program"}
        return titles[self.value]

    @property
    def suffix(self) -> str:
        """How its files end."""
        return {"arduino": ".ino", "python": ".py", "c": ".c"}[self.value]

    @property
    def comment(self) -> str:
        """What begins a comment behind a line of code, in the style of the language."""
        return "  #" if self is Language.PYTHON else " //"
