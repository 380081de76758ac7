"""The text of a settings file: as Save writes it, or to be corrected."""

import re
from bisect import bisect_right
from collections.abc import Iterable, Sequence
from itertools import takewhile

from PySide6.QtCore import Qt, Signal, Slot
from PySide6.QtWidgets import QSplitter, QWidget

from trex_gui.core.files import Severity
from trex_gui.devices.trex.model.settings.document import SettingsDocument
from trex_gui.devices.trex.settings.yaml_subset import LINE_END
from trex_gui.devices.trex.views.settings_editor.findings_panel import FindingsPanel
from trex_gui.devices.trex.views.settings_editor.numbered_text import NumberedText
from trex_gui.ui.widgets.builders import button, column, label, row

_MARK = "\ufeff"

EDITOR_BREAK = re.compile("\r\n|[\n\r\u2029\ufdd0\ufdd1]")
"""What Qt's editor shows as the end of a line; YAML has two more characters for it."""


def with_line_ends(lines: Sequence[str], before: str) -> str:
    """Join the lines of an editor to text with the line ends of the text before.

    Lines unchanged at the beginning and the end keep theirs; the others get that of the first.
    """
    ends, old, typed = EDITOR_BREAK.findall(before), EDITOR_BREAK.split(before), list(lines)
    if typed == old:
        return before
    head, tail = _common_start(typed, old), _common_start(typed[::-1], old[::-1])
    shift = len(old) - len(typed)
    result = [ends[0] if ends else "\n"] * (len(typed) - 1)
    for number in range(len(result)):
        place = number if number < head else number + shift
        if (number < head or number >= len(typed) - tail) and place < len(ends):
            result[number] = ends[place]
    return "".join([*(a + b for a, b in zip(typed, result, strict=False)), *typed[-1:]])


def _common_start(one: list[str], other: list[str]) -> int:
    pairs = zip(one, other, strict=False)
    return sum(1 for _ in takewhile(lambda pair: pair[0] == pair[1], pairs))


class TextPage(QWidget):
    """Follows the document; while that cannot be read, its text can be edited here.

    Signals:
        checked: the text was read again.
    """

    checked = Signal()

    def __init__(self, document: SettingsDocument, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("textPage")
        self._document = document
        self._shown: str | None = None

        self._notice = label(self, "textNotice", wrap=True)
        self._check = button(
            self,
            "checkAgainButton",
            self.tr("Chec&k again"),
            icon="reload",
            tip=self.tr("Read the text again and list its errors"),
        )
        self._text = NumberedText(self)
        self._text.setObjectName("settingsText")
        self._text.setAccessibleName(self.tr("Text of the settings file"))
        self._findings = FindingsPanel(self)
        self._findings.setObjectName("textFindings")

        top = row((self._notice, 1), (self._check, 0, Qt.AlignmentFlag.AlignTop))
        both = QSplitter(Qt.Orientation.Vertical, self)
        both.addWidget(self._text)
        both.addWidget(self._findings)
        both.setStretchFactor(0, 3)
        both.setStretchFactor(1, 2)
        both.setChildrenCollapsible(False)
        column(top, (both, 1), into=self)

        self._text.textChanged.connect(self._on_typed)
        self._check.clicked.connect(self.check)
        self._findings.line_chosen.connect(self.show_line)
        document.changed.connect(self._on_changed)
        self._on_changed()

    def show_line(self, line: int) -> None:
        """Go to a line as findings count them."""
        self._text.show_line(self._editor_lines([line])[line])
        self._text.setFocus()

    def _editor_lines(self, lines: Iterable[int]) -> dict[int, int]:
        """Return the numbers that the editor gives to lines of YAML."""
        text = self._document.text
        starts = [0, *(found.end() for found in LINE_END.finditer(text))]
        breaks = [found.end() for found in EDITOR_BREAK.finditer(text)]
        places = {line: starts[max(0, min(line, len(starts)) - 1)] for line in lines}
        return {line: bisect_right(breaks, place) + 1 for line, place in places.items()}

    @property
    def editor(self) -> NumberedText:
        """The text itself, for the window's Undo and Redo."""
        return self._text

    @Slot()
    def check(self) -> None:
        """Read the text again."""
        self._document.check()
        self.checked.emit()

    @Slot()
    def _on_typed(self) -> None:
        if self._text.isReadOnly():
            return
        before = self._document.text
        body = before.removeprefix(_MARK)
        mark = before[: len(before) - len(body)]
        self._shown = mark + with_line_ends(self._text.lines, body)
        self._document.set_text(self._shown)

    @Slot()
    def _on_changed(self) -> None:
        document = self._document
        self._text.setReadOnly(document.readable)
        self._check.setVisible(not document.readable)
        self._findings.setVisible(not document.readable)
        if document.text != self._shown:
            self._shown = document.text
            place = self._text.verticalScrollBar().value()
            self._text.setPlainText(document.text.removeprefix(_MARK))
            self._text.verticalScrollBar().setValue(place)
        signs: dict[int, str] = {}
        for found in document.findings:
            if found.line is not None and signs.get(found.line) != Severity.ERROR:
                signs[found.line] = found.severity.value
        places = self._editor_lines(signs)
        self._text.mark({places[line]: sign for line, sign in signs.items()})
        if not document.readable:
            self._findings.show_findings(document.findings)
        self._notice.setText(self._words())

    def _words(self) -> str:
        document = self._document
        if not document.readable:
            return self.tr(
                "This file cannot be used. Correct the text here, then check it again; "
                "the other pages open once it has no errors."
            )
        if document.trouble:
            return self.tr(
                "Shown is the text as it was opened, without your changes: {0}. Save offers to "
                "write the settings as a fresh text."
            ).format(document.trouble)
        return self.tr(
            "What Save writes. Comments and the order of the lines stay as they are; values are "
            "changed on the other pages."
        )
