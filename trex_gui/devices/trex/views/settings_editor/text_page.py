"""Page with the text of a settings file."""

import re
from bisect import bisect_right
from collections.abc import Iterable, Mapping, Sequence
from itertools import takewhile

from PySide6.QtCore import QRect, Qt, Signal, Slot
from PySide6.QtGui import QPainter, QPaintEvent, QResizeEvent, QTextCursor, QTextFormat
from PySide6.QtWidgets import QPlainTextEdit, QTextEdit, QWidget

from trex_gui.core.files import SettingsError, Severity
from trex_gui.core.translation import tr
from trex_gui.devices.trex.model.settings.document import SettingsDocument
from trex_gui.devices.trex.settings.reader import BYTE_ORDER_MARK, repair_values
from trex_gui.devices.trex.settings.yaml_subset import LINE_END
from trex_gui.devices.trex.views.findings_list import FindingsList
from trex_gui.ui.theme.icons import icon
from trex_gui.ui.theme.theme import fixed_font, follow_theme, theme
from trex_gui.ui.widgets.builders import button, column, label, named, row, splitter
from trex_gui.ui.widgets.painted import Painter
from trex_gui.ui.widgets.scroll_box import ScrollBox

_MARGIN = 6  # pixels
# Line ends in Qt. YAML defines other line ends.
EDITOR_BREAK = re.compile("\r\n|[\n\r\u2029\ufdd0\ufdd1]")


def with_line_ends(lines: Sequence[str], old_text: str) -> str:
    """Join the lines of an editor. Changed lines get the first line end of `old_text`."""
    old_ends, old, new = EDITOR_BREAK.findall(old_text), EDITOR_BREAK.split(old_text), list(lines)
    if new == old:
        return old_text
    same_first, same_last = _common_length(new, old), _common_length(new[::-1], old[::-1])
    shift = len(old) - len(new)
    new_ends = [old_ends[0] if old_ends else "\n"] * (len(new) - 1)
    for index in range(len(new_ends)):
        old_index = index if index < same_first else index + shift
        is_unchanged = index < same_first or index >= len(new) - same_last
        if is_unchanged and old_index < len(old_ends):
            new_ends[index] = old_ends[old_index]
    return "".join([*(line + end for line, end in zip(new, new_ends, strict=False)), *new[-1:]])


def _common_length(first: list[str], second: list[str]) -> int:
    """Return the number of equal lines at the start."""
    pairs = zip(first, second, strict=False)
    return sum(1 for _ in takewhile(lambda pair: pair[0] == pair[1], pairs))


class TextPage(QWidget):
    checked = Signal()  # the text was checked again
    repaired = Signal(object)  # tuple with a text for each repair, perhaps empty

    def __init__(self, document: SettingsDocument, parent: QWidget) -> None:
        super().__init__(parent)
        self.setObjectName("textPage")
        self._document = document
        self._shown: str | None = None

        self._notice = label(self, "textNotice", wrap=True)
        text, tip = tr("Chec&k again"), tr("Read the text again and list its errors")
        self._check = button(self, "checkAgainButton", text, icon="reload", tip=tip)
        tip = tr(
            "Convert values with units to wire values, and replace numbers that are out of "
            "range with the nearest valid number. The file changes only when you save it"
        )
        text = tr("&Repair values")
        self._repair = button(self, "repairTextButton", text, icon="edited", tip=tip)
        title = tr("Text of the settings file")
        self.editor = named(NumberedText(self), "settingsText", accessible=title)
        self._findings = FindingsList("text", self.editor, self, is_wide=True)
        self._findings_area = ScrollBox(self._findings, self)

        at_top = Qt.AlignmentFlag.AlignTop
        top = row((self._notice, 1), (self._check, 0, at_top), (self._repair, 0, at_top))
        parts = (self.editor, 3), (self._findings_area, 2)
        areas = splitter(self, "", Qt.Orientation.Vertical, *parts)
        column(top, (areas, 1), into=self, margins=16)

        self._check.clicked.connect(self._check_again)
        self._repair.clicked.connect(self._on_repair_clicked)
        self.editor.textChanged.connect(self._on_typed)
        self._findings.line_requested.connect(self.show_line)
        document.changed.connect(self._on_changed)
        self._on_changed()

    def show_line(self, line: int) -> None:
        """Show a line. `line` is a line number in YAML, as in findings."""
        self.editor.show_line(self._editor_lines([line])[line])
        self.editor.setFocus()

    def _editor_lines(self, lines: Iterable[int]) -> dict[int, int]:
        """Return the line number in the editor for each line number in YAML."""
        text = self._document.text
        starts = [0, *(match.end() for match in LINE_END.finditer(text))]
        breaks = [match.end() for match in EDITOR_BREAK.finditer(text)]
        offsets = {line: starts[max(0, min(line, len(starts)) - 1)] for line in lines}
        return {line: bisect_right(breaks, offset) + 1 for line, offset in offsets.items()}

    @Slot()
    def _check_again(self) -> None:
        self._document.check()
        self.checked.emit()

    @Slot()
    def _on_repair_clicked(self) -> None:
        document = self._document
        try:
            text, repairs = repair_values(document.text.encode("utf-8"), document.name)
        except SettingsError:
            repairs = ()  # the YAML is invalid, and the findings show the lines
        if repairs:
            cursor = QTextCursor(self.editor.document())  # undoable, unlike `setPlainText`
            cursor.select(QTextCursor.SelectionType.Document)
            cursor.insertText(text.removeprefix(BYTE_ORDER_MARK))
            self._shown = text  # the editor would change some line ends of this text
            document.set_text(text)
        self._check_again()
        self.repaired.emit(repairs)

    @Slot()
    def _on_typed(self) -> None:
        if self.editor.isReadOnly():
            return
        before = self._document.text
        body = before.removeprefix(BYTE_ORDER_MARK)
        mark = before.removesuffix(body)
        self._shown = mark + with_line_ends(self.editor.lines, body)
        self._document.set_text(self._shown)

    @Slot()
    def _on_changed(self) -> None:
        document = self._document
        self.editor.setReadOnly(document.readable)
        for widget in (self._check, self._repair):
            widget.setVisible(not document.readable)
        self._findings_area.setVisible(bool(document.findings))
        if document.text != self._shown:
            self._shown = document.text
            position = self.editor.verticalScrollBar().value()
            self.editor.setPlainText(document.text.removeprefix(BYTE_ORDER_MARK))
            self.editor.verticalScrollBar().setValue(position)
        signs: dict[int, str] = {}
        for finding in document.findings:
            if finding.line is not None and signs.get(finding.line) != Severity.ERROR:
                signs[finding.line] = finding.severity.value
        editor_lines = self._editor_lines(signs)
        self.editor.mark({editor_lines[line]: sign for line, sign in signs.items()})
        self._findings.show_findings(document.findings, with_lines=True)
        self._notice.setText(self._notice_text())

    def _notice_text(self) -> str:
        document = self._document
        if not document.readable:
            return tr(
                "This file cannot be used. Correct the text here, then check it again. The "
                "other pages become available once the text has no errors."
            )
        if document.problem:
            return tr(
                "This is the text as it was opened, without your changes: {0}. Save offers to "
                "rewrite the file from the settings."
            ).format(document.problem)
        return tr(
            "“Save” writes this text. Comments and the order of the lines do not change. To "
            "change values, use the other pages."
        )


class NumberedText(QPlainTextEdit):
    def __init__(self, parent: QWidget) -> None:
        super().__init__(parent)
        self._marked: dict[int, str] = {}
        self.setLineWrapMode(QPlainTextEdit.LineWrapMode.NoWrap)
        self.setTabChangesFocus(True)
        self._numbers = _Numbers(self)

        self.blockCountChanged.connect(self._fit)
        self.updateRequest.connect(self._on_update_request)
        follow_theme(self, "font", self._update_font)

    def _update_font(self) -> None:
        self.setFont(fixed_font())
        self._fit()
        self._numbers.update()

    @property
    def lines(self) -> list[str]:
        """Lines of the text. Unlike `toPlainText`, this property keeps no-break spaces."""
        return self.document().toRawText().split("\u2029")

    def mark(self, lines: Mapping[int, str]) -> None:
        self._marked = dict(lines)
        self._numbers.update()

    def show_line(self, line: int) -> None:
        block = self.document().findBlockByNumber(line - 1)
        if not block.isValid():
            return
        cursor = QTextCursor(block)
        self.setTextCursor(cursor)
        self.centerCursor()
        highlight = QTextEdit.ExtraSelection()
        highlight.cursor = cursor
        highlight.format.setBackground(self.palette().alternateBase())
        highlight.format.setProperty(QTextFormat.Property.FullWidthSelection, True)
        self.setExtraSelections([highlight])

    def paint_numbers(self, painter: QPainter, visible: QRect) -> None:
        painter.fillRect(visible, theme().color("window"))
        height = self.fontMetrics().height()
        block = self.firstVisibleBlock()
        area = self.blockBoundingGeometry(block).translated(self.contentOffset())
        while block.isValid() and area.top() <= visible.bottom():
            number = block.blockNumber() + 1
            is_marked = number in self._marked
            font = self.font()
            font.setBold(is_marked)
            painter.setFont(font)
            painter.setPen(theme().color("window_text" if is_marked else "muted"))
            box = QRect(0, round(area.top()), self._numbers.width() - _MARGIN, height)
            painter.drawText(box, Qt.AlignmentFlag.AlignRight, str(number))
            if is_marked:
                sign = self._marked[number]
                box = QRect(_MARGIN, round(area.top()), height, height)
                icon(sign, "danger" if sign == "error" else "warning").paint(painter, box)
            top = area.bottom()
            block = block.next()
            area = self.blockBoundingRect(block).translated(0, top)

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        self._fit()

    @Slot()
    def _fit(self) -> None:
        digits, metrics = max(3, len(str(self.blockCount()))), self.fontMetrics()
        width = digits * metrics.horizontalAdvance("9") + metrics.height() + 3 * _MARGIN
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
    def __init__(self, text: NumberedText) -> None:
        super().__init__(text)
        self._text = text
        self.setAccessibleName(tr("Line numbers"))

    def paintEvent(self, event: QPaintEvent) -> None:
        self._text.paint_numbers(Painter(self, smooth=False), event.rect())
