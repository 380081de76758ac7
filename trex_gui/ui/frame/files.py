"""Opening of dropped files, recent files and files from the command line."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import partial
from pathlib import Path

from PySide6.QtCore import QObject, Qt, Signal, Slot
from PySide6.QtWidgets import QMenu, QWidget

from trex_gui.core.translation import tr
from trex_gui.ui.devices.device_manager import DeviceManager
from trex_gui.ui.files import in_background
from trex_gui.ui.frame.workspace import FileKind, Workspace
from trex_gui.ui.notifier import Notifier
from trex_gui.ui.preferences import Preferences
from trex_gui.ui.widgets import builders as ui
from trex_gui.ui.widgets.file_drop import FileDrop

_KEY = "files/recent"
_MAX_RECENT = 8


@dataclass(frozen=True, slots=True)
class RecentFile:
    device: str  # key of the kind of device
    kind: str  # key in `Workspace.openers`
    path: Path

    @property
    def title(self) -> str:
        return f"{self.path.name}  ({self.path.parent.name})"


class RecentFiles(QObject):
    """Saved list of recent files, newest first."""

    changed = Signal()

    @property
    def entries(self) -> tuple[RecentFile, ...]:
        lines = (line.split(" ", 2) for line in Preferences().text(_KEY).splitlines())
        files = [RecentFile(line[0], line[1], Path(line[2])) for line in lines if len(line) == 3]
        return tuple(files[:_MAX_RECENT])

    def add(self, device: str, kind: str, path: Path) -> None:
        added = RecentFile(device, kind, path.absolute())
        if not {"\n", "\0"} & set(str(added.path)):
            self._save(added, *(file for file in self.entries if file.path != added.path))

    def remove(self, removed: RecentFile) -> None:
        self._save(*(file for file in self.entries if file != removed))

    def _save(self, *files: RecentFile) -> None:
        lines = [f"{file.device} {file.kind} {file.path}" for file in files[:_MAX_RECENT]]
        Preferences().set(_KEY, "\n".join(lines))
        self.changed.emit()


class FileOpener(QObject):
    """Opens files in their workspaces. Adds all workspaces if none of them can open a file."""

    def __init__(
        self,
        device_manager: DeviceManager,
        notifier: Notifier,
        workspaces: Callable[[], Sequence[Workspace]],
        add_all_workspaces: Callable[[], object],
        window: QWidget,
    ) -> None:
        super().__init__(window)
        self._manager = device_manager
        self._notifier = notifier
        self._workspaces = workspaces
        self._add_all_workspaces = add_all_workspaces
        self._window = window
        self.recent = RecentFiles(self)
        self.recent_menu = QMenu(tr("Recent &files"), window)
        self.recent_menu.setToolTipsVisible(True)
        self.recent.changed.connect(self._fill_menu)
        self._fill_menu()
        # Queued, because a question must not block the program from which the user drags a file.
        drop = FileDrop(window)
        drop.dropped.connect(self._on_dropped, Qt.ConnectionType.QueuedConnection)

    @Slot(object)
    def _on_dropped(self, paths: Sequence[Path]) -> None:
        self._window.activateWindow()
        if len(paths) == 1:
            self.open_file(paths[0])
        else:
            text = tr("None of the {0} dropped files was opened. Drop one file at a time.")
            self._notifier.error.emit(text.format(len(paths)))

    def open_file(self, path: Path) -> None:
        """Open a file in its workspace, unless another device is connected."""
        if not any(path.suffix.lower() in kind.suffixes for _, kind in self._kinds):
            self._add_all_workspaces()
        kinds = self._kinds
        for key, kind in kinds:
            if path.suffix.lower() in kind.suffixes:
                self._open_in(key, partial(kind.open, path), path.name, kind.name)
                return
        names = "; ".join(f"{kind.name} ({', '.join(sorted(kind.suffixes))})" for _, kind in kinds)
        text = tr("{0} was not opened: its type is not supported. Supported: {1}.")
        self._notifier.error.emit(text.format(path.name, names))

    @property
    def _kinds(self) -> list[tuple[str, FileKind]]:
        return [(item.key, kind) for item in self._workspaces() for kind in item.file_kinds]

    def _open_in(self, key: str, then: Callable[[], object], name: str, kind: str) -> None:
        if not self._manager.switch_to(key, then):
            text = tr(
                "{0} is {1}. It was not opened, because this window is connected to {2}: "
                "disconnect, then open it again."
            )
            device = self._manager.current.plugin.name
            self._notifier.error.emit(text.format(name, kind, device))

    def open_recent(self, file: RecentFile) -> None:
        """Open a recent file. If the file no longer exists, remove it from the list."""

        def on_checked(is_missing: bool) -> None:
            if not is_missing:
                self._open_again(file)
                return
            self.recent.remove(file)
            text = tr("{0} no longer exists and was removed from the recent files.")
            self._notifier.error.emit(text.format(file.path))

        in_background(self, partial(_is_missing, file.path), on_checked, lambda _: None)

    def _open_again(self, file: RecentFile) -> None:
        if all(file.device != workspace.key for workspace in self._workspaces()):
            self._add_all_workspaces()
        for workspace in self._workspaces():
            if workspace.key == file.device and file.kind in workspace.openers:
                device = self._manager.controller(workspace.key).plugin.name
                self._open_in(
                    workspace.key,
                    partial(workspace.openers[file.kind], file.path),
                    file.path.name,
                    tr("a file of the {0}").format(device),
                )

    @Slot()
    def _fill_menu(self) -> None:
        menu, files = self.recent_menu, self.recent.entries
        menu.clear()
        for number, file in enumerate(files, start=1):
            text, then = f"&{number} {ui.no_mnemonic(file.title)}", partial(self.open_recent, file)
            action = ui.action(menu, "", text, on_trigger=then)
            action.setToolTip(ui.plain(str(file.path)))
            menu.addAction(action)
        menu.setEnabled(bool(files))


def _is_missing(path: Path) -> bool:
    try:
        return not path.is_file()
    except OSError:  # opening the file reports the reason
        return False
