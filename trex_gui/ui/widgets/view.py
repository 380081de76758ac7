"""Base of the pages of *Diagnostics*, which the head of the place searches and copies."""

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
    summarized = Signal(str)  # one line about what is shown, whenever it is refreshed

    searched = ""  # text without blanks around it, in lower case

    @Slot(str)
    def search(self, text: str) -> None:
        self.searched = text.strip().casefold()
        self.refresh()

    def matches(self, text: str) -> bool:
        return self.searched in text.casefold()

    def refresh(self) -> None:
        """Show what there is now, if the page is visible."""
        raise NotImplementedError

    def lines(self) -> Sequence[str]:
        """Return what is shown, to be copied."""
        raise NotImplementedError

    def showEvent(self, event: QShowEvent) -> None:
        super().showEvent(event)
        self.refresh()
