"""Table of read-only text."""

from collections.abc import Sequence

from PySide6.QtGui import QIcon, QResizeEvent
from PySide6.QtWidgets import QHeaderView, QTableWidget, QTableWidgetItem, QWidget

from trex_gui.ui.runtime import new_timer
from trex_gui.ui.widgets.builders import flat_table, plain


class TextTable(QTableWidget):
    """Each row begins with a sign; the text of the last column wraps in the rest of the width."""

    def __init__(self, name: str, accessible: str, widest: Sequence[int], parent: QWidget) -> None:
        """`widest`: characters of the columns before the last one."""
        super().__init__(0, len(widest) + 1, parent)
        flat_table(self, name, accessible)
        self._widest = widest
        header = self.horizontalHeader()
        header.setStretchLastSection(True)
        header.setSectionResizeMode(QHeaderView.ResizeMode.Interactive)
        # Later: row heights are only known when all columns have their widths.
        self._fitting = new_timer(self, 0, self.resizeRowsToContents, single_shot=True)
        header.sectionResized.connect(self._fitting.start)

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        self._fitting.start()

    def show_rows(self, rows: Sequence[tuple[QIcon, Sequence[str]]]) -> None:
        """Replace all rows; the place to which the user scrolled stays."""
        self.clearContents()
        self.setRowCount(len(rows))
        for number, (sign, texts) in enumerate(rows):
            for section, text in enumerate(texts):
                item = QTableWidgetItem(text)
                item.setToolTip(plain(text))
                if section == 0:
                    item.setIcon(sign)
                self.setItem(number, section, item)
        character = self.fontMetrics().averageCharWidth()
        for section, widest in enumerate(self._widest):
            self.resizeColumnToContents(section)
            width = min(self.columnWidth(section) + 2 * character, widest * character)
            title = self.horizontalHeader().sectionSizeHint(section)
            self.setColumnWidth(section, max(width, title))
        self._fitting.start()
