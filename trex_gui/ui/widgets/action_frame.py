"""The row at the bottom of a window."""

from PySide6.QtWidgets import QFrame, QWidget

from trex_gui.ui.theme.theme import set_look
from trex_gui.ui.widgets.builders import Item, row


class ActionFrame(QFrame):
    """Holds the stop button of a window, at its left."""

    def __init__(self, parent: QWidget) -> None:
        super().__init__(parent)
        set_look(self, "actions")

    def fill(self, *parts: Item) -> None:
        """Lay the parts out as in the main window; dialogs use the margins of Qt."""
        row(*parts, into=self, margins=(12, 6, 12, 6))
