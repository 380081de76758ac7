"""The findings about a settings file, each with its line."""

import re
from collections.abc import Iterable, Iterator
from dataclasses import dataclass

from PySide6.QtCore import Qt, Signal, Slot
from PySide6.QtWidgets import (
    QAbstractItemView,
    QHeaderView,
    QTableWidget,
    QTableWidgetItem,
    QWidget,
)

from trex_gui.core.files import Finding, Severity
from trex_gui.devices.trex.settings.rules import LintFinding
from trex_gui.devices.trex.settings.yaml_subset import LINE_END
from trex_gui.ui.runtime import runtime
from trex_gui.ui.theme.icons import icon
from trex_gui.ui.theme.theme import theme
from trex_gui.ui.widgets.builders import button, column, label, row

_LINE = Qt.ItemDataRole.UserRole
_COLOURS = {"error": "danger", "warning": "warning", "info": "info"}


@dataclass(frozen=True, slots=True)
class _Row:
    """The content of one row."""

    sign: str
    kind: str
    line: int | None
    key: str
    message: str


def line_of_key(text: str, key: str) -> int | None:
    """Return the line of a setting in a file, counted from 1."""
    found = re.search(rf"^\W*{re.escape(key)}\W*:", text, re.MULTILINE)
    return None if found is None else len(LINE_END.findall(text, 0, found.start())) + 1


class FindingsPanel(QWidget):
    """A table of the findings of reader and linter; a double click requests the line.

    Signals:
        line_chosen: the number of a line, from 1, to show.
        accepted: a `LintFinding`; its change is to be made.
    """

    line_chosen = Signal(int)
    accepted = Signal(object)

    def __init__(self, parent: QWidget | None = None, *, with_lines: bool = True) -> None:
        """List findings; `with_lines`: a double click shows the line."""
        super().__init__(parent)
        self.setObjectName("findingsPanel")
        self._with_lines = with_lines
        self._findings: tuple[Finding, ...] = ()
        self._lint_findings: tuple[LintFinding, ...] = ()
        self._text = ""

        self._summary = label(self, "findingsSummary", wrap=True)
        self._accept = button(self, "acceptFindingButton", self.tr("Accept the proposal"))
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

        below = row(1, self._accept)
        column(self._summary, (self._table, 1), below, into=self, margins=0)

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
        return len(self._findings) + len(self._lint_findings)

    def show_findings(
        self,
        findings: Iterable[Finding],
        lint_findings: Iterable[LintFinding] = (),
        *,
        text: str = "",
        summary: str = "",
    ) -> None:
        """List the findings of the reader, and those of the linter about the settings in `text`.

        A `summary` replaces the counts.
        """
        before = self._shown()
        self._findings = tuple(findings)
        self._lint_findings = tuple(lint_findings)
        self._text = text
        self._summary.setText(summary or self._count_text())
        if before != self._shown():
            self._fill()

    def _shown(self) -> tuple[object, ...]:
        return self._findings, self._lint_findings, self._text if self._lint_findings else ""

    def _count_text(self) -> str:
        if not self.count:
            return self.tr("No errors, warnings or suggestions.")
        errors = sum(found.severity is Severity.ERROR for found in self._findings)
        warnings = len(self._findings) - errors
        parts = [
            one if count == 1 else many.format(count)
            for count, one, many in (
                (errors, self.tr("1 error"), self.tr("{0} errors")),
                (warnings, self.tr("1 warning"), self.tr("{0} warnings")),
                (len(self._lint_findings), self.tr("1 suggestion"), self.tr("{0} suggestions")),
            )
            if count
        ]
        words = self.tr("{0}.").format(", ".join(parts))
        if self._with_lines:
            words += " " + self.tr("A double click shows the line.")
        if errors:
            words += " " + self.tr("A file with errors cannot be used.")
        return words

    @Slot()
    def _fill(self) -> None:
        current = self._table.currentRow()
        self._table.clearContents()
        self._table.setRowCount(self.count)
        for number, found in enumerate(self._rows()):
            line = "" if found.line is None else str(found.line)
            message = f"{found.message[:1].upper()}{found.message[1:]}"
            for section, text in enumerate((found.kind, line, found.key, message)):
                item = QTableWidgetItem(text)
                item.setData(_LINE, found.line)
                item.setToolTip(text)
                if section == 0:
                    item.setIcon(icon(found.sign, _COLOURS[found.sign]))
                self._table.setItem(number, section, item)
        proposals = [n for n, found in enumerate(self._lint_findings) if found.change]
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
        for finding in self._lint_findings:
            lines = (line_of_key(self._text, key) for key in finding.keys)
            line = next((line for line in lines if line is not None), None)
            message = finding.message
            if finding.change:
                message += " " + self.tr("Proposal: {0}.").format(finding.proposal.rstrip("."))
            yield _Row("info", self.tr("Suggestion"), line, ", ".join(finding.keys), message)

    def _fit(self) -> None:
        """Wrap the messages in the width that the other columns leave."""
        header = self._table.horizontalHeader()
        header.setSectionResizeMode(QHeaderView.ResizeMode.Interactive)
        character = self.fontMetrics().averageCharWidth()
        for section, widest in ((0, 14), (1, 7), (2, 34)):
            self._table.resizeColumnToContents(section)
            size = header.sectionSize(section) + 2 * character
            header.resizeSection(section, min(size, widest * character))
        self._fitting.start()

    def _current_finding(self) -> LintFinding | None:
        row = self._table.currentRow() - len(self._findings)
        return self._lint_findings[row] if 0 <= row < len(self._lint_findings) else None

    @Slot()
    def _on_current_changed(self) -> None:
        finding = self._current_finding()
        self._accept.setVisible(any(found.change for found in self._lint_findings))
        self._accept.setEnabled(finding is not None and bool(finding.change))

    @Slot()
    def _on_accept(self) -> None:
        finding = self._current_finding()
        if finding is not None:
            self.accepted.emit(finding)

    @Slot(QTableWidgetItem)
    def _on_activated(self, item: QTableWidgetItem) -> None:
        line = item.data(_LINE)
        if isinstance(line, int):
            self.line_chosen.emit(line)
