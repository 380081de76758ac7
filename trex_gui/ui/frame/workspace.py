"""Workspace: what the frame shows and needs to know of one kind of device."""

from collections.abc import Callable, Collection, Mapping, Sequence
from dataclasses import dataclass
from functools import partial
from pathlib import Path

from PySide6.QtCore import Signal
from PySide6.QtGui import QAction
from PySide6.QtWidgets import QDockWidget, QTabWidget, QWidget

from trex_gui.ui.frame.actions import ActionInfo, Menu, Menus
from trex_gui.ui.notifier import Notifier
from trex_gui.ui.widgets.scroll_box import ScrollBox


@dataclass(frozen=True, slots=True)
class FileKind:
    """Files of one kind that belong to a workspace.

    Attributes:
        suffixes: how their names end, in lower case.
        name: with its article: "a settings file of a TReX".
        open: opens one, in the workspace that is shown.
        open_offline: opens one that was named at the start while no device is being connected;
            `None`: `open` does.
    """

    suffixes: Collection[str]
    name: str
    open: Callable[[Path], object]
    open_offline: Callable[[Path], object] | None = None


@dataclass(frozen=True, slots=True)
class PageInfo:
    """One page of a workspace: its tab, and its entry in the Window menu with Ctrl and its number.

    Attributes:
        key: names it in code and in the key of its action, `WORKSPACE_KEY`.
        title: of its tab, with the mnemonic of its menu entry.
    """

    key: str
    title: str
    page: QWidget
    icon: str = ""


class Workspace(QWidget):
    """The pages of a device, the bar below them, and its menu entries.

    The defaults are for a device that needs no more.

    Signals:
        actions_changed: `enabled_actions`.
    """

    actions_changed = Signal()

    def __init__(self, key: str, notifier: Notifier, parent: QWidget | None = None) -> None:
        """Show the kind of device with this key."""
        super().__init__(parent)
        self.notifier = notifier
        self.key = key
        self.pages = QTabWidget(self)
        self.pages.setDocumentMode(True)
        self._infos: tuple[PageInfo, ...] = ()

    @property
    def stop_text(self) -> str:
        """Menu entry of Esc."""
        return self.tr("&Stop motors")

    @property
    def help_title(self) -> str:
        """Menu entry of F1."""
        return self.tr("Online &documentation…")

    @property
    def help_url(self) -> str:
        """URL of the documentation; empty: `help_text` is shown."""
        return ""

    @property
    def help_text(self) -> str:
        """Help as rich text."""
        return ""

    @property
    def file_kinds(self) -> Sequence[FileKind]:
        """The files that are opened here, dropped or named at the start."""
        return ()

    @property
    def docks(self) -> Sequence[QDockWidget]:
        """Docks at the right of the window; the workspace shows and hides them."""
        return ()

    def add_pages(self, infos: Sequence[PageInfo]) -> None:
        """Add a tab for each page; the tab is found by the object name of the page."""
        self._infos = tuple(infos)
        for info in infos:
            self.pages.addTab(ScrollBox(info.page, self), info.title.replace("&", ""))

    def show_page(self, key: str) -> None:
        """Turn to a page."""
        keys = [info.key for info in self._infos]
        self.pages.setCurrentIndex(keys.index(key))

    def page_actions(self) -> tuple[ActionInfo, ...]:
        """Return the menu entries that show the pages."""
        return tuple(
            ActionInfo(f"{self.key}_{info.key}", info.title, f"Ctrl+{number}", info.icon)
            for number, info in enumerate(self._infos, start=1)
        )

    def page_slots(self) -> Mapping[str, Callable[[], object]]:
        """Return what the entries of `page_actions` do."""
        return {f"{self.key}_{info.key}": partial(self.show_page, info.key) for info in self._infos}

    def menus(self) -> Menus:
        """Return the entries of its own by menu, or by title of an additional menu."""
        return {Menu.WINDOW: self.page_actions()}

    def slots(self) -> Mapping[str, Callable[[], object]]:
        """Return what each of its actions does, by key."""
        return self.page_slots()

    def take_actions(self, actions: Mapping[str, QAction]) -> None:
        """Take the actions of its slots by key, once the menus are built."""

    def enabled_actions(self) -> Mapping[str, bool]:
        """Return which of its actions can be done now; missing ones can."""
        return {}

    def may_close(self, leave: Callable[[], object]) -> bool:
        """Return whether nothing would be lost; else ask, and call `leave` on consent."""
        del leave
        return True

    def prepare_to_close(self) -> None:
        """Close dialogs and windows and save their state."""

    def finish(self) -> None:
        """End what goes on after the line is closed: a disk may be slow."""

    def shut_down(self) -> bool:
        """End every thread, at the end of the program; return whether all ended in time."""
        return True

    def edit_line_settings(self) -> None:
        """Let the user edit how this computer talks to the device."""
