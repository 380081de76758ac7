"""The files that were opened or saved last, of every kind of device."""

from dataclasses import dataclass
from pathlib import Path

from PySide6.QtCore import QObject, Signal

from trex_gui.ui.preferences import Preferences

_KEY = "files/recent"
_MOST = 8


@dataclass(frozen=True, slots=True)
class RecentFile:
    device: str  # key of the kind of device
    kind: str  # key of what opens it, in `Workspace.openers`
    path: Path

    @property
    def title(self) -> str:
        return f"{self.path.name}  ({self.path.parent.name})"


class RecentFiles(QObject):
    """A list that is remembered; the newest is first."""

    changed = Signal()

    @property
    def entries(self) -> tuple[RecentFile, ...]:
        lines = (line.split(" ", 2) for line in Preferences().text(_KEY).splitlines())
        found = [RecentFile(line[0], line[1], Path(line[2])) for line in lines if len(line) == 3]
        return tuple(found[:_MOST])

    def note(self, device: str, kind: str, path: Path) -> None:
        """Put a file first."""
        noted = RecentFile(device, kind, path.absolute())
        if not {"\n", "\0"} & set(str(noted.path)):
            self._keep(noted, *(one for one in self.entries if one.path != noted.path))

    def remove(self, gone: RecentFile) -> None:
        self._keep(*(one for one in self.entries if one != gone))

    def clear(self) -> None:
        self._keep()

    def _keep(self, *entries: RecentFile) -> None:
        lines = [f"{one.device} {one.kind} {one.path}" for one in entries[:_MOST]]
        Preferences().set(_KEY, "\n".join(lines))
        self.changed.emit()
