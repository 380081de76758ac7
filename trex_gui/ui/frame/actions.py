"""Menus and shortcuts: one table, one `QAction` each, wherever it stands."""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass

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


def tr(text: str) -> str:
    """Translate a text of this table."""
    return QCoreApplication.translate("actions", text)


def menus() -> Mapping[str, tuple[ActionInfo | str, ...]]:
    """The whole menu bar, in the words that users of the maker's programs know."""
    return {
        tr("&File"): (
            ActionInfo("new", tr("&New settings file…"), QKeySequence.StandardKey.New, "new"),
            ActionInfo("open", tr("&Open settings file…"), "Ctrl+O", "open"),
            ActionInfo("save", tr("&Save settings file…"), "Ctrl+S", "save"),
            ActionInfo("print", tr("Prin&t settings…"), "", "print"),
            ActionInfo("export", tr("&Export as code…"), "", "console"),
            SEPARATOR,
            ActionInfo("history", tr("&History…"), "Ctrl+H", "history"),
            SEPARATOR,
            ActionInfo("record", tr("&Record…"), "Ctrl+Shift+R", "record"),
            ActionInfo("open_recording", tr("Open recor&ding…"), "Ctrl+Shift+O", "plot"),
            SEPARATOR,
            ActionInfo("quit", tr("E&xit"), QKeySequence.StandardKey.Quit),
        ),
        tr("&Edit"): (
            ActionInfo("undo", tr("&Undo"), QKeySequence.StandardKey.Undo, "undo"),
            ActionInfo("redo", tr("&Redo"), QKeySequence.StandardKey.Redo, "redo"),
            SEPARATOR,
            ActionInfo("discard", tr("&Discard all edits"), "", "clear"),
        ),
        tr("&Device"): (
            ActionInfo("connect", tr("&Connect"), "Ctrl+K", "connect"),
            ActionInfo("disconnect", tr("&Disconnect"), "Ctrl+D", "disconnect"),
            ActionInfo("line", tr("&Line settings…"), "", "settings"),
            ActionInfo("find", tr("&Find a board…"), "Ctrl+Shift+F", "find"),
            SEPARATOR,
            ActionInfo("stop", tr("&Stop motor"), "Esc", "stop"),
            ActionInfo("run", tr("&Run motor"), "Ctrl+R", "run"),
            SEPARATOR,
            ActionInfo("reload", tr("Re&load settings from device"), "Ctrl+L", "reload"),
            ActionInfo("apply", tr("&Apply settings…"), "Ctrl+P", "apply"),
            ActionInfo("power", tr("Make stored settings acti&ve…"), "", "power"),
            SEPARATOR,
            ActionInfo("learn", tr("Lear&n channels…"), "", "calibrate"),
            ActionInfo("test_sticks", tr("&Test the sticks…")),
            ActionInfo("bench", tr("&Bench test…"), "Ctrl+B", "plot"),
            SEPARATOR,
            ActionInfo("defaults", tr("Restore &factory defaults…")),
            ActionInfo("serial_defaults", tr("Restore serial de&faults…")),
        ),
        tr("&Window"): (
            ActionInfo("page0", tr("S&tatus"), "Ctrl+1"),
            ActionInfo("page1", tr("&Channels"), "Ctrl+2"),
            ActionInfo("page2", tr("Cali&bration"), "Ctrl+3"),
            ActionInfo("page3", tr("&Motors"), "Ctrl+4"),
            ActionInfo("page4", tr("C&urrents"), "Ctrl+5"),
            ActionInfo("page5", tr("&Parameters"), "Ctrl+6"),
            ActionInfo("page6", tr("T&ranscript"), "Ctrl+7"),
            SEPARATOR,
            ActionInfo("demo", tr("&Demo TReX panel"), checkable=True),
            SEPARATOR,
            ActionInfo("system", tr("Colours of the s&ystem"), checkable=True),
            ActionInfo("light", tr("L&ight colours"), checkable=True),
            ActionInfo("dark", tr("Dar&k colours"), checkable=True),
        ),
        tr("&Help"): (
            ActionInfo("guide", tr("Online &documentation…"), "F1", "help"),
            ActionInfo("about", tr("&About…"), "", "info"),
        ),
    }


def build_menus(
    window: QMainWindow,
    slots: Mapping[str, Callable[[], object]],
    more: Sequence[Mapping[str, Sequence[ActionInfo | str]]] = (),
) -> dict[str, QAction]:
    """Fill the window's menu bar; return the actions by key.

    Every action of the table needs a slot: a missing one is a `KeyError` at start. The menus of
    `more` stand before that of the window.
    """
    actions: dict[str, QAction] = {}
    table: dict[str, Sequence[ActionInfo | str]] = {}
    for title, ours in menus().items():
        if title == tr("&Window"):
            for others in more:
                table |= others
        table[title] = ours
    for title, entries in table.items():
        menu = window.menuBar().addMenu(title)
        menu.setToolTipsVisible(True)
        for entry in entries:
            if isinstance(entry, str):
                menu.addSeparator()
                continue
            action = QAction(entry.text, window)
            action.setObjectName(f"{entry.key}Action")
            action.setShortcut(QKeySequence(entry.shortcut))
            if entry.key == "stop":  # whatever window is in front; the others have their own keys
                action.setShortcutContext(Qt.ShortcutContext.ApplicationShortcut)
            action.setCheckable(entry.checkable)
            if entry.icon:
                set_icon(action, entry.icon)
            action.triggered.connect(_without_state(slots[entry.key]))
            menu.addAction(action)
            actions[entry.key] = action
    schemes = QActionGroup(window)
    for key in ("system", "light", "dark"):
        schemes.addAction(actions[key])
    return actions


def _without_state(slot: Callable[[], object]) -> Callable[[bool], None]:
    def triggered(_checked: bool) -> None:
        slot()

    return triggered
