"""What is wrong with a settings file or odd about it, each with its line."""

import re
from collections.abc import Iterable, Iterator
from dataclasses import dataclass

from PySide6.QtCore import Qt, Signal, Slot
from PySide6.QtWidgets import (
    QAbstractItemView,
    QHBoxLayout,
    QHeaderView,
    QLabel,
    QPushButton,
    QTableWidget,
    QTableWidgetItem,
    QVBoxLayout,
    QWidget,
)

from trex_gui.core.files.errors import Finding, Severity
from trex_gui.devices.trex.settings.rules import LintFinding
from trex_gui.devices.trex.settings.yaml_subset import LINE_END
from trex_gui.ui.runtime import runtime
from trex_gui.ui.theme.icons import icon
from trex_gui.ui.theme.theme import theme

_LINE = Qt.ItemDataRole.UserRole
_COLOURS = {"error": "danger", "warning": "warning", "info": "info"}


@dataclass(frozen=True, slots=True)
class _Row:
    """What one row says."""

    sign: str
    kind: str
    line: int | None
    key: str
    message: str


def line_of_key(text: str, key: str) -> int | None:
    """Return the line of a settings file in which a setting stands, counted from 1."""
    found = re.search(rf"^\W*{re.escape(key)}\W*:", text, re.MULTILINE)
    return None if found is None else len(LINE_END.findall(text, 0, found.start())) + 1


class FindingsPanel(QWidget):
    """A table of findings and of advice; a double click asks for the line.

    Signals:
        line_chosen: the number of a line, from 1, that a person wants to see.
        accepted: an `LintFinding` whose change a person wants.
    """

    line_chosen = Signal(int)
    accepted = Signal(object)

    def __init__(self, parent: QWidget | None = None, *, with_lines: bool = True) -> None:
        """List findings; `with_lines` says that somebody shows the lines that are asked for."""
        super().__init__(parent)
        self.setObjectName("findingsPanel")
        self._with_lines = with_lines
        self._findings: tuple[Finding, ...] = ()
        self._advice: tuple[LintFinding, ...] = ()
        self._text = ""

        self._summary = QLabel(self)
        self._summary.setObjectName("findingsSummary")
        self._summary.setWordWrap(True)
        self._accept = QPushButton(self.tr("Accept the proposal"), self)
        self._accept.setObjectName("acceptFindingButton")
        self._table = QTableWidget(0, 4, self)
        self._table.setObjectName("findingsTable")
        self._table.setAccessibleName(self.tr("Findings"))
        self._table.setHorizontalHeaderLabels(
            [self.tr("Kind"), self.tr("Line"), self.tr("Setting"), self.tr("What was found")]
        )
        self._table.setSelectionBehavior(QAbstractItemView.SelectionBehavior.SelectRows)
        self._table.setSelectionMode(QAbstractItemView.SelectionMode.SingleSelection)
        self._table.setEditTriggers(QAbstractItemView.EditTrigger.NoEditTriggers)
        self._table.setAlternatingRowColors(True)
        self._table.setShowGrid(False)
        self._table.setTabKeyNavigation(False)
        self._table.verticalHeader().hide()
        header = self._table.horizontalHeader()
        header.setDefaultAlignment(Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignVCenter)
        header.setHighlightSections(False)
        header.setStretchLastSection(True)
        self._fitting = runtime().timer(self)
        self._fitting.setSingleShot(True)
        self._fitting.setInterval(0)

        below = QHBoxLayout()
        below.addStretch(1)
        below.addWidget(self._accept)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.addWidget(self._summary)
        layout.addWidget(self._table, 1)
        layout.addLayout(below)

        self._table.itemActivated.connect(self._on_activated)
        self._table.itemDoubleClicked.connect(self._on_activated)
        self._table.currentCellChanged.connect(self._on_current_changed)
        self._accept.clicked.connect(self._on_accept)
        # Later: while columns take their width, no row knows yet how high it has to be.
        header.sectionResized.connect(self._fitting.start)
        self._fitting.timeout.connect(self._table.resizeRowsToContents)
        theme().changed.connect(self._fill)
        self._fill()

    @property
    def count(self) -> int:
        """How many findings are listed."""
        return len(self._findings) + len(self._advice)

    def show_findings(
        self,
        findings: Iterable[Finding],
        advice: Iterable[LintFinding] = (),
        *,
        text: str = "",
        summary: str = "",
    ) -> None:
        """List what reading found, and what the rules say of settings that `text` gives.

        A `summary` stands in place of the counts.
        """
        before = self._findings, self._advice, self._text if self._advice else ""
        self._findings = tuple(findings)
        self._advice = tuple(advice)
        self._text = text
        self._summary.setText(summary or self._count_text())
        if before != (self._findings, self._advice, self._text if self._advice else ""):
            self._fill()

    def _count_text(self) -> str:
        if not self.count:
            return self.tr("Nothing is wrong with this file, and nothing is odd about it.")
        errors = sum(found.severity is Severity.ERROR for found in self._findings)
        warnings = len(self._findings) - errors
        parts = [
            one if count == 1 else many.format(count)
            for count, one, many in (
                (errors, self.tr("1 error"), self.tr("{0} errors")),
                (warnings, self.tr("1 warning"), self.tr("{0} warnings")),
                (len(self._advice), self.tr("1 piece of advice"), self.tr("{0} pieces of advice")),
            )
            if count
        ]
        words = self.tr("{0}.").format(", ".join(parts))
        if self._with_lines:
            words += " " + self.tr("A double click shows the line.")
        if errors:
            words += " " + self.tr("With errors a file gives no settings.")
        return words

    @Slot()
    def _fill(self) -> None:
        current = self._table.currentRow()
        self._table.clearContents()
        self._table.setRowCount(self.count)
        for number, row in enumerate(self._rows()):
            line = "" if row.line is None else str(row.line)
            message = f"{row.message[:1].upper()}{row.message[1:]}"
            for column, text in enumerate((row.kind, line, row.key, message)):
                item = QTableWidgetItem(text)
                item.setData(_LINE, row.line)
                item.setToolTip(text)
                if column == 0:
                    item.setIcon(icon(row.sign, _COLOURS[row.sign]))
                self._table.setItem(number, column, item)
        proposals = [n for n, found in enumerate(self._advice) if found.change]
        if current < 0 and proposals:
            current = len(self._findings) + proposals[0]
        self._table.setCurrentCell(min(current, self.count - 1), 0)
        self._fit()
        self._on_current_changed()

    def _rows(self) -> Iterator[_Row]:
        for found in self._findings:
            is_error = found.severity is Severity.ERROR
            kind = self.tr("Error") if is_error else self.tr("Warning")
            sign = "error" if is_error else "warning"
            yield _Row(sign, kind, found.line, found.key or "", found.message)
        for advice in self._advice:
            lines = (line_of_key(self._text, key) for key in advice.keys)
            line = next((line for line in lines if line is not None), None)
            message = advice.message
            if advice.change:
                message += " " + self.tr("Proposal: {0}.").format(advice.proposal.rstrip("."))
            yield _Row("info", self.tr("LintFinding"), line, ", ".join(advice.keys), message)

    def _fit(self) -> None:
        """Give the words the room that the rest leaves, in as many lines as they need."""
        header = self._table.horizontalHeader()
        header.setSectionResizeMode(QHeaderView.ResizeMode.Interactive)
        character = self.fontMetrics().averageCharWidth()
        for column, widest in ((0, 14), (1, 7), (2, 34)):
            self._table.resizeColumnToContents(column)
            size = header.sectionSize(column) + 2 * character
            header.resizeSection(column, min(size, widest * character))
        self._fitting.start()

    def _current_advice(self) -> LintFinding | None:
        row = self._table.currentRow() - len(self._findings)
        return self._advice[row] if 0 <= row < len(self._advice) else None

    @Slot()
    def _on_current_changed(self) -> None:
        advice = self._current_advice()
        self._accept.setVisible(any(found.change for found in self._advice))
        self._accept.setEnabled(advice is not None and bool(advice.change))

    @Slot()
    def _on_accept(self) -> None:
        advice = self._current_advice()
        if advice is not None:
            self.accepted.emit(advice)

    @Slot(QTableWidgetItem)
    def _on_activated(self, item: QTableWidgetItem) -> None:
        line = item.data(_LINE)
        if isinstance(line, int):
            self.line_chosen.emit(line)
