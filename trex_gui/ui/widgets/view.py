"""Base class of the *Diagnostics* pages, with search and copy."""

from collections.abc import Iterable, Sequence

from PySide6.QtCore import Signal, Slot
from PySide6.QtGui import QGuiApplication, QShowEvent
from PySide6.QtWidgets import QWidget

from trex_gui.core.translation import tr
from trex_gui.ui.notifier import Notifier


def copy_lines(lines: Iterable[str], notifier: Notifier) -> None:
    lines = list(lines)
    QGuiApplication.clipboard().setText("".join(f"{line}\n" for line in lines))
    notifier.info.emit(tr("%n line(s) copied.", "", len(lines)))


class View(QWidget):
    summarized = Signal(str)  # one-line summary of the content, emitted at each refresh

    searched = ""  # search text, stripped and case-folded

    @Slot(str)
    def search(self, text: str) -> None:
        self.searched = text.strip().casefold()
        self.refresh()

    def matches(self, text: str) -> bool:
        return self.searched in text.casefold()

    def refresh(self) -> None:
        """Show the current content if the page is visible."""
        raise NotImplementedError

    def lines(self) -> Sequence[str]:
        raise NotImplementedError

    def showEvent(self, event: QShowEvent) -> None:
        super().showEvent(event)
        self.refresh()
