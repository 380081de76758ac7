"""Workspace of a device, and the menus of the window."""

from collections.abc import Callable, Collection, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from enum import Enum, auto
from functools import partial
from pathlib import Path

from PySide6.QtCore import QSignalBlocker, Signal, Slot
from PySide6.QtGui import QAction, QKeySequence
from PySide6.QtWidgets import QDockWidget, QMainWindow, QMenu, QStackedWidget, QTabWidget, QWidget

from trex_gui.core.translation import tr
from trex_gui.ui.frame.places import Place, Places, title_with_count
from trex_gui.ui.help.messages import MessageHelp
from trex_gui.ui.help.search import Findable, Kind
from trex_gui.ui.log import Log
from trex_gui.ui.notifier import Notifier
from trex_gui.ui.plotting.page import PlotPage
from trex_gui.ui.theme.icons import set_icon
from trex_gui.ui.theme.theme import follow_theme
from trex_gui.ui.widgets import builders as ui
from trex_gui.ui.widgets.labels import PAGE_MARGINS
from trex_gui.ui.widgets.messages import message_height
from trex_gui.ui.widgets.scroll_box import ScrollBox

SEPARATOR = ""


@dataclass(frozen=True, slots=True)
class Entry:
    """Menu entry. `shortcut` is a portable key sequence."""

    key: str
    text: str
    slot: Callable[[], object]
    shortcut: str | QKeySequence.StandardKey = ""
    icon: str = ""
    checkable: bool = False


Entries = Sequence[Entry | str]  # actions and separators of one menu


class Menu(Enum):
    """Menus that the window and the workspaces share, in the order of the menu bar."""

    FILE = auto()
    EDIT = auto()
    DEVICE = auto()
    WINDOW = auto()
    HELP = auto()


Menus = Mapping[Menu | str, Entries]  # menu (or title of an extra menu) → entries of a workspace


@dataclass(frozen=True, slots=True)
class FileKind:
    suffixes: Collection[str]  # in lower case
    name: str  # with an article: "a settings file of a TReX"
    open: Callable[[Path], object]  # opens a file in the visible workspace
    # Opens a file named on the command line, unless its device is connecting. `None`: use `open`.
    open_offline: Callable[[Path], object] | None = None


@dataclass(frozen=True, slots=True)
class PageInfo:
    key: str  # the action of the page has the key `{workspace}_{key}`
    title: str  # with the mnemonic of the menu entry
    create: Callable[[QWidget], QWidget]  # creates the page in a parent widget
    icon: str = "info"
    place: Place | None = None  # place shared with adjacent pages


class Workspace(QWidget):
    """Pages, bottom bar and menu entries of a device."""

    actions_changed = Signal()  # the result of `enabled_actions` has changed
    page_changed = Signal(str)  # key of the visible page

    bar: QWidget  # bottom bar with the stop button

    def __init__(self, key: str, notifier: Notifier, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.notifier = notifier
        self.key = key
        self.log = Log(self)  # events, and the messages shown while this workspace is visible
        self.stop_text = tr("&Stop motors")  # text of the menu entry for Esc
        # Object names of pages, docks and dialogs → help topics.
        self.help_topics: Mapping[str, str] = {}
        self.message_help = MessageHelp({})
        # Files that the user can drop on this workspace or name on the command line.
        self.file_kinds: Sequence[FileKind] = ()
        # Keys of file kinds → functions that open a recent file.
        self.openers: Mapping[str, Callable[[Path], object]] = {}
        self.docks: Sequence[QDockWidget] = ()  # docks that the workspace shows and hides
        # Keys of menu entries that move motors. A search hit only opens the menu.
        self.motion_keys: Collection[str] = ()
        self.pages = Places(self)
        self._actions: Mapping[str, QAction] = {}  # key → action; set with the menus
        self._infos: tuple[PageInfo, ...] = ()
        self._tabs: list[tuple[QTabWidget, int]] = []  # tab widget and tab index of each page
        self._missing: set[int] = set()  # indices of pages that have not been created

    def add_pages(self, infos: Sequence[PageInfo]) -> None:
        """Add pages. Each page is created when it is first shown, or in `create_pages`.

        Pages that share a place become its tabs.
        """
        self._infos = tuple(infos)
        self._missing = set(range(len(infos)))
        icons = []
        for info in infos:
            tabs = self.pages if info.place is None else info.place.tabs
            if info.place is None or not tabs.count():
                icons.append(info.icon)
            if info.place is not None and not tabs.count():
                self.pages.addTab(info.place, info.place.title)
            tabs.addTab(QWidget(self), info.title.replace("&", ""))
            self._tabs.append((tabs, tabs.count() - 1))
        self.pages.bar.icons = icons
        for tabs in {tabs: None for tabs, _ in self._tabs}:
            tabs.currentChanged.connect(self._on_current_changed)
        self._create_page(self.current)

    @property
    def current(self) -> int:
        """Index of the visible page."""
        place = self.pages.currentWidget()
        visible = {self.pages, place.tabs if isinstance(place, Place) else None}
        current = (
            number
            for number, (tabs, index) in enumerate(self._tabs)
            if tabs in visible and tabs.currentIndex() == index
        )
        return next(current, 0)

    @property
    def page_count(self) -> int:
        return len(self._infos)

    def page_at(self, number: int) -> QWidget | None:
        """Return a page in its scroll area, or its placeholder."""
        tabs, index = self._tabs[number]
        return tabs.widget(index)

    @Slot()
    def _on_current_changed(self) -> None:
        self._create_page(self.current)
        self.page_changed.emit(self._infos[self.current].key)

    def create_pages(self) -> None:
        for number in sorted(self._missing):
            self._create_page(number)

    def _create_page(self, number: int) -> None:
        if number not in self._missing:
            return
        self._missing.remove(number)
        tabs, index = self._tabs[number]
        current, placeholder = tabs.currentIndex(), tabs.widget(index)
        parent = tabs.findChild(QStackedWidget) or self  # the parent that `insertTab` sets
        box = ScrollBox(self._infos[number].create, parent)
        page = box.content
        follow_theme(page, "messages", partial(_reserve_space, page))
        with QSignalBlocker(tabs):  # the current page does not change
            tabs.insertTab(index, box, tabs.tabText(index))
            tabs.removeTab(index + 1)
            tabs.setCurrentIndex(current)
        # By default, Tab visits the page last, since the page and its plots are created last.
        order = partial(ui.tab_order, tabs.tabBar(), box)
        order()
        if isinstance(page, PlotPage):
            page.plot_added.connect(order)
        if placeholder is not None:
            placeholder.deleteLater()

    def show_page(self, key: str) -> None:
        self.show_page_at(self._number_of(key))

    def show_saved(self, saved: str) -> None:
        """Show the page with the key `saved`. If there is none, show the first page."""
        keys = [info.key for info in self._infos]
        self.show_page(saved if saved in keys else keys[0])

    def show_page_at(self, number: int) -> None:
        tabs, index = self._tabs[number]
        tabs.setCurrentIndex(index)
        if (place := self._infos[number].place) is not None:
            self.pages.setCurrentWidget(place)

    def set_page_count(self, key: str, count: int) -> None:
        """Show a count on the tab of a page and on its place. A count of 0 is hidden."""
        number = self._number_of(key)
        (tabs, index), info = self._tabs[number], self._infos[number]
        if info.place is not None:
            title = info.title.replace("&", "")
            tabs.setTabText(index, title_with_count(title, count))
            index = self.pages.indexOf(info.place)
        self.pages.bar.set_count(index, count)

    def _number_of(self, key: str) -> int:
        return [info.key for info in self._infos].index(key)

    def page_entries(self) -> Entries:
        return [
            Entry(
                f"{self.key}_{info.key}",
                info.title,
                partial(self.show_page, info.key),
                f"Ctrl+{number}",
            )
            for number, info in enumerate(self._infos, start=1)
        ]

    def findables(self) -> Iterable[Findable]:
        """Return the search entries of the device, except its menus and messages."""
        return ()

    def report_parts(self) -> dict[str, Callable[[], str]]:
        """Return the functions that create the files of a support report.

        The functions may be called in any thread.
        """
        lines = "".join(f"{entry.line}\n" for entry in self.log.entries)
        return {"log.txt": lambda: lines}

    def menus(self) -> Menus:
        return {Menu.WINDOW: self.page_entries()}

    def set_actions(self, actions: Mapping[str, QAction]) -> None:
        self._actions = actions

    def trigger(self, key: str) -> None:
        """Trigger a menu entry if it is enabled."""
        self._actions[key].trigger()

    @property
    def device_name(self) -> str:
        """Name of the connected device for the window title, or empty."""
        return ""

    @property
    def has_edits(self) -> bool:
        """True if some edits are saved neither in the device nor in a file."""
        return False

    def enabled_actions(self) -> Mapping[str, bool]:
        """Return the enabled state of each action. Missing actions are enabled."""
        return {}

    def may_close(self, leave: Callable[[], object]) -> bool:
        """Return True if nothing would be lost. Otherwise ask the user.

        `leave`: called later if the user agrees to close the workspace.
        """
        del leave
        return True

    def prepare_to_close(self) -> None:
        """Close dialogs and windows and save their state."""

    def finish(self) -> None:
        """End work that outlasts the connection, such as writing to a slow disk."""

    def shut_down(self) -> bool:
        return True

    def set_up_crc(self) -> None:
        """Open a review of the settings that make the device detect corrupted bytes."""

    def edit_line_settings(self) -> None:
        """Open the line settings."""


def _reserve_space(page: QWidget) -> None:
    page.setContentsMargins(0, 0, 0, message_height(page) - PAGE_MARGINS[3])


def entries_of(menus: Menus) -> list[Entry]:
    return [entry for menu in menus.values() for entry in menu if isinstance(entry, Entry)]


def fill_menu_bar(
    window: QMainWindow, menus: Iterable[tuple[str, Entries]], prefix: str = ""
) -> dict[str, QAction]:
    """Add menus to a window. Return the actions by key.

    Object names look like `openAction`, or `editorOpenAction` with the prefix `editor`. Qt hides
    repeated separators and separators at the ends of a menu.
    """
    actions: dict[str, QAction] = {}
    for title, entries in menus:
        menu = window.menuBar().addMenu(title)
        menu.setToolTipsVisible(True)
        menu.aboutToShow.connect(partial(_add_icons, actions, entries))
        for entry in entries:
            if isinstance(entry, str):
                menu.addSeparator()
                continue
            key = entry.key
            name = f"{prefix}{key[0].upper()}{key[1:]}" if prefix else key
            actions[key] = ui.action(
                window,
                f"{name}Action",
                entry.text,
                shortcut=entry.shortcut,
                checkable=entry.checkable,
                on_trigger=entry.slot,
            )
            menu.addAction(actions[key])
    return actions


def _add_icons(actions: Mapping[str, QAction], entries: Entries) -> None:
    """Add the icons of a menu when it opens.

    Creating all icons together with the window would take a tenth of the window's creation time.
    """
    for entry in entries:
        if isinstance(entry, Entry) and entry.icon:
            set_icon(actions[entry.key], entry.icon)


def menu_findables(
    window: QMainWindow, pages: Collection[str], motion_keys: Collection[str]
) -> Iterator[Findable]:
    """Yield search entries for the menus. An entry whose key is in `pages` has the kind "page".

    A hit triggers its menu entry. If the entry is disabled or its key is in `motion_keys`, the
    hit opens the menu at the entry.
    """
    bar = window.menuBar()

    def show(menu: QMenu, action: QAction, key: str) -> None:
        if action.isEnabled() and key not in motion_keys:
            action.trigger()
        else:
            bar.setActiveAction(menu.menuAction())
            menu.setActiveAction(action)

    for menu in [menu for title in bar.actions() if isinstance(menu := title.menu(), QMenu)]:
        for action in menu.actions():
            key, keys = action.objectName().removesuffix("Action"), action.shortcut()
            if key and action.isVisible():
                title, place = (name.replace("&", "") for name in (action.text(), menu.title()))
                kind: Kind = "page" if key in pages else "action"
                text = keys.toString(QKeySequence.SequenceFormat.NativeText)
                yield Findable(kind, key, title, place, text, partial(show, menu, action, key))
