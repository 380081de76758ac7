"""Menus of an Aracna; shortcuts are those of a TReX where they fit."""

from PySide6.QtCore import QCoreApplication
from PySide6.QtGui import QKeySequence

from trex_gui.ui.frame.workspace import SEPARATOR, ActionInfo, Entries, Menu, Menus


def tr(text: str) -> str:
    return QCoreApplication.translate("AracnaMenu", text)


def menus(pages: Entries) -> Menus:
    """Return the entries by menu; `pages` are those that show a page. Keys begin with `aracna_`."""
    undo, redo = QKeySequence.StandardKey.Undo, QKeySequence.StandardKey.Redo
    return {
        tr("&Aracna"): (
            ActionInfo("aracna_move", tr("&Move to the sliders' goals"), "Ctrl+M", "run"),
            ActionInfo("aracna_present", tr("Sliders to the &present position")),
            ActionInfo("aracna_centre", tr("Sliders to the &centre")),
            ActionInfo("aracna_stand", tr("Sliders to &stand")),
            SEPARATOR,
            ActionInfo("aracna_play", tr("Pla&y the current sequence or gait"), "Ctrl+R"),
            ActionInfo("aracna_end", tr("&End sequence after this step"), "Ctrl+E"),
            SEPARATOR,
            ActionInfo("aracna_record", tr("&Record…"), "Ctrl+Shift+R", "record"),
            ActionInfo("aracna_open_recording", tr("Ope&n recording…"), "Ctrl+Shift+O", "plot"),
            SEPARATOR,
            ActionInfo("aracna_limits", tr("Reset the joints' &limits")),
        ),
        tr("P&oses"): (
            ActionInfo("aracna_new", tr("&New pose file"), QKeySequence.StandardKey.New, "new"),
            ActionInfo("aracna_open", tr("&Open pose file…"), "Ctrl+O", "open"),
            ActionInfo("aracna_save", tr("&Save pose file"), "Ctrl+S", "save"),
            ActionInfo("aracna_save_as", tr("Save pose file &as…")),
            SEPARATOR,
            ActionInfo("aracna_undo", tr("&Undo"), undo, "undo"),
            ActionInfo("aracna_redo", tr("&Redo"), redo, "redo"),
            SEPARATOR,
            ActionInfo("aracna_capture", tr("&Capture the present position as a pose"), "Ctrl+P"),
        ),
        Menu.WINDOW: (
            *pages,
            SEPARATOR,
            ActionInfo("aracna_demo", tr("&Demo Aracna panel"), checkable=True),
        ),
    }
