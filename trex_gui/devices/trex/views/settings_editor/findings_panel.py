"""The findings about a settings file, each with its line."""

import re
from collections.abc import Iterable, Iterator

from PySide6.QtCore import Qt, Signal, Slot
from PySide6.QtWidgets import QHeaderView, QTableWidget, QTableWidgetItem, QWidget

from trex_gui.core.files import Finding, Severity
from trex_gui.core.translation import tr
from trex_gui.devices.trex.settings.rules import LintFinding
from trex_gui.devices.trex.settings.yaml_subset import LINE_END
from trex_gui.ui.runtime import new_timer
from trex_gui.ui.theme.icons import icon
from trex_gui.ui.theme.theme import theme
from trex_gui.ui.widgets.builders import button, column, flat_table, label, plain, row

_LINE = Qt.ItemDataRole.UserRole
_COLOURS = {"error": "danger", "warning": "warning", "info": "info"}
_WIDEST = {0: 20, 1: 7, 2: 34}  # characters, by column


def line_of_key(text: str, key: str) -> int | None:
    """Return the line of a setting in a file, counted from 1."""
    found = re.search(rf"^\W*{re.escape(key)}\W*:", text, re.MULTILINE)
    return None if found is None else len(LINE_END.findall(text, 0, found.start())) + 1


class FindingsPanel(QWidget):
    """A table of the findings of reader and linter."""

    line_chosen = Signal(int)  # a line, from 1, was double-clicked
    accepted = Signal(object)  # a `LintFinding`; its change is to be made

    def __init__(self, parent: QWidget | None = None, *, with_lines: bool = True) -> None:
        """Create the panel; `with_lines`: a double click shows the line."""
        super().__init__(parent)
        self.setObjectName("findingsPanel")
        self._with_lines = with_lines
        self._findings: tuple[Finding, ...] = ()
        self._lint_findings: tuple[LintFinding, ...] = ()
        self._text = ""

        self._summary = label(self, "findingsSummary", wrap=True)
        self._table = flat_table(QTableWidget(0, 4, self), "findingsTable", tr("Findings"))
        self._accept = button(
            self,
            "acceptFindingButton",
            tr("Acce&pt the proposal"),
            on_click=self._on_accept_clicked,
        )
        self._table.setHorizontalHeaderLabels(
            [tr("Kind"), tr("Line", "of a text"), tr("Setting"), tr("Message")]
        )
        header = self._table.horizontalHeader()
        header.setStretchLastSection(True)
        header.setSectionResizeMode(QHeaderView.ResizeMode.Interactive)
        self._fitting = new_timer(self, 0, self._table.resizeRowsToContents, single_shot=True)

        column(self._summary, (self._table, 1), row(1, self._accept), into=self, margins=0)

        self._table.itemActivated.connect(self._on_activated)
        self._table.itemDoubleClicked.connect(self._on_activated)
        self._table.currentCellChanged.connect(self._update_accept)
        # Later: row heights are only known when all columns have their widths.
        header.sectionResized.connect(self._fitting.start)
        theme().changed.connect(self._fill)
        self._fill()

    @property
    def count(self) -> int:
        return len(self._findings) + len(self._lint_findings)

    def show_findings(
        self,
        findings: Iterable[Finding],
        lint_findings: Iterable[LintFinding] = (),
        *,
        text: str = "",
    ) -> None:
        """List the findings of the reader, and those of the linter about the settings in `text`."""
        before = self._shown()
        self._findings = tuple(findings)
        self._lint_findings = tuple(lint_findings)
        self._text = text
        self._summary.setText(self._count_text())
        if before != self._shown():
            self._fill()

    def _shown(self) -> tuple[object, ...]:
        return self._findings, self._lint_findings, self._text if self._lint_findings else ""

    def _count_text(self) -> str:
        if not self.count:
            return tr("No errors, warnings or suggestions.")
        errors = sum(found.severity is Severity.ERROR for found in self._findings)
        warnings = len(self._findings) - errors
        suggestions = len(self._lint_findings)
        counts = {
            tr("%n error(s)", "", errors): errors,
            tr("%n warning(s)", "", warnings): warnings,
            tr("%n suggestion(s)", "", suggestions): suggestions,
        }
        sentences = [f"{', '.join(text for text, count in counts.items() if count)}."]
        if self._with_lines:
            sentences.append(tr("Double-click a finding to show its line."))
        if errors:
            sentences.append(tr("A file with errors cannot be used."))
        return " ".join(sentences)

    @Slot()
    def _fill(self) -> None:
        current = self._table.currentRow()
        self._table.clearContents()
        self._table.setRowCount(self.count)
        for number, (sign, kind, line, key, message) in enumerate(self._rows()):
            sentence = f"{message[:1].upper()}{message[1:]}"
            for section, text in enumerate((kind, str(line or ""), key, sentence)):
                item = QTableWidgetItem(text)
                item.setData(_LINE, line)
                item.setToolTip(plain(text))
                if section == 0:
                    item.setIcon(icon(sign, _COLOURS[sign]))
                self._table.setItem(number, section, item)
        proposals = [n for n, found in enumerate(self._lint_findings) if found.change]
        if current < 0 and proposals:
            current = len(self._findings) + proposals[0]
        self._table.setCurrentCell(min(current, self.count - 1), 0)
        character = self.fontMetrics().averageCharWidth()
        for section, widest in _WIDEST.items():  # the message wraps in the rest
            self._table.resizeColumnToContents(section)
            width = min(self._table.columnWidth(section) + 2 * character, widest * character)
            title = self._table.horizontalHeader().sectionSizeHint(section)
            self._table.setColumnWidth(section, max(width, title))
        self._fitting.start()
        self._update_accept()

    def _rows(self) -> Iterator[tuple[str, str, int | None, str, str]]:
        """Yield sign, kind, line, key and message."""
        kinds = {Severity.ERROR: tr("Error"), Severity.WARNING: tr("Warning")}
        for found in self._findings:
            kind = kinds[found.severity]
            yield found.severity.value, kind, found.line, found.key or "", found.message
        for finding in self._lint_findings:
            lines = (line_of_key(self._text, key) for key in finding.keys)
            line = next((line for line in lines if line is not None), None)
            message = finding.message
            if finding.change:
                message += " " + tr("Proposal: {0}.").format(finding.proposal.rstrip("."))
            yield "info", tr("Suggestion"), line, ", ".join(finding.keys), message

    def _current_finding(self) -> LintFinding | None:
        row = self._table.currentRow() - len(self._findings)
        return self._lint_findings[row] if 0 <= row < len(self._lint_findings) else None

    @Slot()
    def _update_accept(self) -> None:
        finding = self._current_finding()
        self._accept.setVisible(any(found.change for found in self._lint_findings))
        self._accept.setEnabled(finding is not None and bool(finding.change))

    @Slot()
    def _on_accept_clicked(self) -> None:
        finding = self._current_finding()
        if finding is not None:
            self.accepted.emit(finding)

    @Slot(QTableWidgetItem)
    def _on_activated(self, item: QTableWidgetItem) -> None:
        line = item.data(_LINE)
        if isinstance(line, int):
            self.line_chosen.emit(line)
