"""Pose files on disk: read whole or not at all, written whole or not at all."""

from dataclasses import dataclass
from pathlib import Path

from trex_gui.core.files.errors import Finding, SettingsError, Severity
from trex_gui.core.files.text_files import load, save
from trex_gui.devices.aracna.poses.ppr import read_ppr, write_ppr
from trex_gui.devices.aracna.poses.project import Project

_LEGIBLE = "\n\t\r"


@dataclass(frozen=True, slots=True)
class PoseFile:
    """What a file held when it was read."""

    project: Project
    findings: tuple[Finding, ...]
    data: bytes


def read_file(path: Path) -> PoseFile:
    """Read a pose file.

    Raises:
        SettingsError: it cannot be read, is larger than any pose file, or no text.
    """
    data = load(path, "poses")
    found: list[Finding] = []
    try:
        text = data.decode("utf-8")
    except UnicodeDecodeError as error:
        line = data.count(b"\n", 0, error.start) + 1
        text = data.decode("latin-1")
        said = "this is not UTF-8 text; it is read as Western European, and Save writes UTF-8"
        found.append(Finding(line, None, said, Severity.WARNING))
    for number, line_text in enumerate(text.split("\n"), 1):
        if any(sign < " " and sign not in _LEGIBLE for sign in line_text):
            said = "this is a binary file; poses are text"
            raise SettingsError(str(path), [Finding(number, None, said)])
    project, findings = read_ppr(text)
    return PoseFile(project, (*found, *findings), data)


def write_file(path: Path, project: Project) -> bytes:
    """Write a pose file and return what it holds now; the old one or the new one is there, whole.

    Raises:
        SettingsError: it cannot be written; says why.
    """
    text = write_ppr(project)
    save(path, text)
    return text.encode("utf-8")
