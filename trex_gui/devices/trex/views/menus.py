"""Menu entries of a TReX, in the terms of Pololu's own programs."""

from PySide6.QtCore import QCoreApplication
from PySide6.QtGui import QKeySequence

from trex_gui.ui.frame.actions import SEPARATOR, ActionInfo, Entries, Menu, Menus


def tr(text: str) -> str:
    """Translate a text of this table."""
    return QCoreApplication.translate("TrexMenus", text)


def menus(pages: Entries) -> Menus:
    """Return the entries by menu; `pages` are those that show a page."""
    return {
        Menu.FILE: (
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
        ),
        Menu.EDIT: (
            ActionInfo("undo", tr("&Undo"), QKeySequence.StandardKey.Undo, "undo"),
            ActionInfo("redo", tr("&Redo"), QKeySequence.StandardKey.Redo, "redo"),
            SEPARATOR,
            ActionInfo("discard", tr("&Discard all edits"), "", "clear"),
        ),
        Menu.DEVICE: (
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
        Menu.WINDOW: (
            *pages,
            SEPARATOR,
            ActionInfo("demo", tr("&Demo TReX panel"), checkable=True),
        ),
    }
