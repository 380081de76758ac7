"""Menus and tool bar of the window for one settings file."""

from collections.abc import Callable, Mapping

from PySide6.QtCore import QCoreApplication, Qt
from PySide6.QtGui import QAction, QKeySequence
from PySide6.QtWidgets import QMainWindow, QToolBar

from trex_gui.ui.frame.workspace import SEPARATOR, ActionInfo
from trex_gui.ui.theme.icons import set_icon

_ON_THE_BAR = ("new", "open", "save", SEPARATOR, "undo", "redo", SEPARATOR, "send", "print")


def tr(text: str) -> str:
    """Translate a text of this table."""
    return QCoreApplication.translate("editor_actions", text)


def menus() -> Mapping[str, tuple[ActionInfo | str, ...]]:
    """The whole menu bar."""
    keys = QKeySequence.StandardKey
    return {
        tr("&File"): (
            ActionInfo("new", tr("&New…"), keys.New, "new"),
            ActionInfo("open", tr("&Open…"), keys.Open, "open"),
            SEPARATOR,
            ActionInfo("save", tr("&Save"), keys.Save, "save"),
            ActionInfo("saveAs", tr("Save &as…"), "Ctrl+Shift+S"),
            SEPARATOR,
            ActionInfo("print", tr("&Print…"), keys.Print, "print"),
            ActionInfo("pdf", tr("Save as P&DF…")),
            SEPARATOR,
            ActionInfo("close", tr("&Close"), keys.Close),
        ),
        tr("&Edit"): (
            ActionInfo("undo", tr("&Undo"), keys.Undo, "undo"),
            ActionInfo("redo", tr("&Redo"), keys.Redo, "redo"),
        ),
        tr("&Compare"): (
            ActionInfo("compareFile", tr("With another &file…")),
            ActionInfo("compareBoard", tr("With the &board")),
            ActionInfo("compareFactory", tr("With &factory values")),
        ),
        tr("&Device"): (ActionInfo("send", tr("&Send to the board…"), "Ctrl+Return", "apply"),),
    }


def build_editor_menus(
    window: QMainWindow, slots: Mapping[str, Callable[[], object]]
) -> dict[str, QAction]:
    """Fill the window's menu bar and tool bar; return the actions by key."""
    actions: dict[str, QAction] = {}
    for title, entries in menus().items():
        menu = window.menuBar().addMenu(title)
        for entry in entries:
            if isinstance(entry, str):
                menu.addSeparator()
                continue
            action = QAction(entry.text, window)
            action.setObjectName(f"editor{entry.key[0].upper()}{entry.key[1:]}Action")
            action.setShortcut(QKeySequence(entry.shortcut))
            action.setIconText(entry.text.replace("&", "").rstrip("…"))  # the bar keeps its width
            if entry.icon:
                set_icon(action, entry.icon)
            action.triggered.connect(_without_state(slots[entry.key]))
            menu.addAction(action)
            actions[entry.key] = action
    bar = QToolBar(window)
    bar.setObjectName("editorToolBar")
    bar.setWindowTitle(tr("Tool bar"))
    bar.setMovable(False)
    bar.setToolButtonStyle(Qt.ToolButtonStyle.ToolButtonTextBesideIcon)
    for key in _ON_THE_BAR:
        if key == SEPARATOR:
            bar.addSeparator()
        else:
            bar.addAction(actions[key])
    window.addToolBar(bar)
    return actions


def _without_state(slot: Callable[[], object]) -> Callable[[bool], None]:
    def triggered(_checked: bool) -> None:
        slot()

    return triggered
