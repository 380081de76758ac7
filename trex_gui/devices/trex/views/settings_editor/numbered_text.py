"""Plain text with the numbers of its lines, and a sign beside those that have a finding."""

from collections.abc import Mapping

from PySide6.QtCore import QRect, QSize, Qt, Slot
from PySide6.QtGui import (
    QFontDatabase,
    QPainter,
    QPaintEvent,
    QResizeEvent,
    QTextCursor,
    QTextFormat,
)
from PySide6.QtWidgets import QPlainTextEdit, QTextEdit, QWidget

from trex_gui.ui.theme.icons import icon
from trex_gui.ui.theme.theme import theme

_MARGIN = 6


class NumberedText(QPlainTextEdit):
    """Shows lines counted from 1; `lines` gives them as they were typed, spaces and all."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._marked: dict[int, str] = {}
        self.setFont(QFontDatabase.systemFont(QFontDatabase.SystemFont.FixedFont))
        self.setLineWrapMode(QPlainTextEdit.LineWrapMode.NoWrap)
        self.setTabChangesFocus(True)
        self._numbers = _Numbers(self)

        self.blockCountChanged.connect(self._fit)
        self.updateRequest.connect(self._on_update_request)
        theme().changed.connect(self._numbers.update)
        self._fit()

    @property
    def lines(self) -> list[str]:
        """The lines; unlike `toPlainText`, a no-break space stays one."""
        return self.document().toRawText().split("\u2029")

    def mark(self, lines: Mapping[int, str]) -> None:
        """Put signs, such as `error`, beside lines, counted from 1."""
        self._marked = dict(lines)
        self._numbers.update()

    def show_line(self, line: int) -> None:
        """Go to a line, counted from 1, and let it stand out."""
        block = self.document().findBlockByNumber(line - 1)
        if not block.isValid():
            return
        cursor = QTextCursor(block)
        self.setTextCursor(cursor)
        self.centerCursor()
        stand_out = QTextEdit.ExtraSelection()
        stand_out.cursor = cursor
        stand_out.format.setBackground(self.palette().alternateBase())
        stand_out.format.setProperty(QTextFormat.Property.FullWidthSelection, True)
        self.setExtraSelections([stand_out])

    # --- The numbers --------------------------------------------------------------------

    def numbers_width(self) -> int:
        """Return the room that the numbers and signs need."""
        digits = max(3, len(str(self.blockCount())))
        metrics = self.fontMetrics()
        return digits * metrics.horizontalAdvance("9") + metrics.height() + 3 * _MARGIN

    def paint_numbers(self, painter: QPainter, visible: QRect) -> None:
        """Draw the numbers of the lines in sight, right-aligned, signs left of them."""
        painter.fillRect(visible, self.palette().window())
        height = self.fontMetrics().height()
        block = self.firstVisibleBlock()
        place = self.blockBoundingGeometry(block).translated(self.contentOffset())
        while block.isValid() and place.top() <= visible.bottom():
            number = block.blockNumber() + 1
            is_marked = number in self._marked
            font = self.font()
            font.setBold(is_marked)
            painter.setFont(font)
            painter.setPen(theme().color("window_text" if is_marked else "muted"))
            box = QRect(0, round(place.top()), self._numbers.width() - _MARGIN, height)
            painter.drawText(box, Qt.AlignmentFlag.AlignRight, str(number))
            if is_marked:
                sign = self._marked[number]
                colour = "danger" if sign == "error" else "warning"
                where = QRect(_MARGIN, round(place.top()), height, height)
                icon(sign, colour).paint(painter, where)
            top = place.bottom()
            block = block.next()
            place = self.blockBoundingRect(block).translated(0, top)

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        self._fit()

    @Slot()
    def _fit(self) -> None:
        width = self.numbers_width()
        self.setViewportMargins(width, 0, 0, 0)
        inside = self.contentsRect()
        self._numbers.setGeometry(inside.left(), inside.top(), width, inside.height())

    @Slot(QRect, int)
    def _on_update_request(self, area: QRect, moved: int) -> None:
        if moved:
            self._numbers.scroll(0, moved)
        else:
            self._numbers.update(0, area.y(), self._numbers.width(), area.height())


class _Numbers(QWidget):
    """The strip left of the text."""

    def __init__(self, text: NumberedText) -> None:
        super().__init__(text)
        self._text = text

    def sizeHint(self) -> QSize:
        return QSize(self._text.numbers_width(), 0)

    def paintEvent(self, event: QPaintEvent) -> None:
        self._text.paint_numbers(QPainter(self), event.rect())
