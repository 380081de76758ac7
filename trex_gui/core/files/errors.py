"""Errors and warnings about text files, by line."""

from collections.abc import Iterable
from dataclasses import dataclass
from enum import StrEnum

from trex_gui.core.errors import StudioError


class Severity(StrEnum):
    """Whether a file with this finding can be used."""

    ERROR = "error"
    WARNING = "warning"


@dataclass(frozen=True, slots=True)
class Finding:
    """One error or warning about a settings file.

    Attributes:
        line: counted from 1; `None` when it concerns the file as a whole.
        key: the setting concerned, as the file spells it.
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
    """A settings file cannot be used, read or written.

    Attributes:
        name: the file, as shown to the user.
        findings: everything found, in the order of the lines; at least one is an error.
    """

    def __init__(self, name: str, findings: Iterable[Finding]) -> None:
        self.name = name
        self.findings = tuple(findings)
        super().__init__(name, self.findings)

    def __str__(self) -> str:
        between = " " if len(self.findings) == 1 else "\n"
        return f"{self.name}:{between}" + "\n".join(map(str, self.findings))
