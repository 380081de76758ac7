"""Menus and shortcuts: one table for the frame, one for each workspace, one `QAction` an entry."""

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from enum import Enum, auto

from PySide6.QtCore import QCoreApplication, Qt
from PySide6.QtGui import QAction, QActionGroup, QKeySequence
from PySide6.QtWidgets import QMainWindow

from trex_gui.ui.theme.icons import set_icon

SEPARATOR = ""


@dataclass(frozen=True, slots=True)
class ActionInfo:
    """One entry of a menu; `key` names it in code, `shortcut` is a portable key sequence."""

    key: str
    text: str
    shortcut: str | QKeySequence.StandardKey = ""
    icon: str = ""
    checkable: bool = False


Entries = Sequence[ActionInfo | str]
"""Actions and separators of one menu."""


class Menu(Enum):
    """Menus that the frame and the workspaces share, in their order."""

    FILE = auto()
    EDIT = auto()
    DEVICE = auto()
    WINDOW = auto()
    HELP = auto()


Menus = Mapping[Menu | str, Entries]
"""Entries of a workspace by shared menu, or by the title of one of its own."""


def tr(text: str) -> str:
    """Translate a text of this table."""
    return QCoreApplication.translate("actions", text)


@dataclass(frozen=True, slots=True)
class _FrameMenu:
    """A shared menu: its title, and the frame's entries above and below the workspaces'."""

    title: str
    above: Entries = ()
    below: Entries = ()


def _frame_menus() -> Mapping[Menu, _FrameMenu]:
    return {
        Menu.FILE: _FrameMenu(
            tr("&File"),
            below=(SEPARATOR, ActionInfo("quit", tr("E&xit"), QKeySequence.StandardKey.Quit)),
        ),
        Menu.EDIT: _FrameMenu(tr("&Edit")),
        Menu.DEVICE: _FrameMenu(
            tr("&Device"),
            above=(
                ActionInfo("connect", tr("&Connect"), "Ctrl+K", "connect"),
                ActionInfo("disconnect", tr("&Disconnect"), "Ctrl+D", "disconnect"),
                ActionInfo("line", tr("&Line settings…"), "", "settings"),
                ActionInfo("find", tr("&Find a board…"), "Ctrl+Shift+F", "find"),
                SEPARATOR,
                ActionInfo("stop", tr("&Stop motors"), "Esc", "stop"),
            ),
        ),
        Menu.WINDOW: _FrameMenu(
            tr("&Window"),
            below=(
                SEPARATOR,
                ActionInfo("system", tr("Colours of the s&ystem"), checkable=True),
                ActionInfo("light", tr("L&ight colours"), checkable=True),
                ActionInfo("dark", tr("Dar&k colours"), checkable=True),
            ),
        ),
        Menu.HELP: _FrameMenu(
            tr("&Help"),
            above=(
                ActionInfo("guide", tr("Online &documentation…"), "F1", "help"),
                ActionInfo("about", tr("&About…"), "", "info"),
            ),
        ),
    }


def frame_actions() -> Iterator[ActionInfo]:
    """Yield the frame's own actions."""
    for menu in _frame_menus().values():
        yield from (one for one in (*menu.above, *menu.below) if isinstance(one, ActionInfo))


def _menu_bar(workspaces: Sequence[Menus]) -> Iterator[tuple[str, Entries]]:
    """Yield titles and entries; menus that only one workspace has come before `WINDOW`."""
    for key, menu in _frame_menus().items():
        if key is Menu.WINDOW:
            for menus in workspaces:
                yield from ((own, menus[own]) for own in menus if isinstance(own, str))
        middle = [entry for menus in workspaces for entry in (SEPARATOR, *menus.get(key, ()))]
        yield menu.title, (*menu.above, *middle, *menu.below)


def build_menus(
    window: QMainWindow, slots: Mapping[str, Callable[[], object]], workspaces: Sequence[Menus]
) -> dict[str, QAction]:
    """Fill the main window's menu bar; return the actions by key."""
    actions = fill_menu_bar(window, _menu_bar(workspaces), slots)
    # Whatever window is in front; the others have their own keys.
    actions["stop"].setShortcutContext(Qt.ShortcutContext.ApplicationShortcut)
    schemes = QActionGroup(window)
    for key in ("system", "light", "dark"):
        schemes.addAction(actions[key])
    return actions


def fill_menu_bar(
    window: QMainWindow,
    menus: Iterable[tuple[str, Entries]],
    slots: Mapping[str, Callable[[], object]],
    prefix: str = "",
) -> dict[str, QAction]:
    """Add menus by title to a window; return the actions by key.

    Object names are `openAction`, or `editorOpenAction` with a prefix. Qt shows no separator at
    an end of a menu or behind another one.
    """
    actions: dict[str, QAction] = {}
    for title, entries in menus:
        menu = window.menuBar().addMenu(title)
        menu.setToolTipsVisible(True)
        for entry in entries:
            if isinstance(entry, str):
                menu.addSeparator()
                continue
            key = entry.key
            action = QAction(entry.text, window)
            name = f"{prefix}{key[0].upper()}{key[1:]}" if prefix else key
            action.setObjectName(f"{name}Action")
            action.setShortcut(QKeySequence(entry.shortcut))
            action.setCheckable(entry.checkable)
            if entry.icon:
                set_icon(action, entry.icon)
            action.triggered.connect(_without_state(slots[key]))
            menu.addAction(action)
            actions[key] = action
    return actions


def _without_state(slot: Callable[[], object]) -> Callable[[bool], None]:
    def triggered(_checked: bool) -> None:
        slot()

    return triggered
