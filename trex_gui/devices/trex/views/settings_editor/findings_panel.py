"""The findings about a settings file, each with its line."""

import re
from collections.abc import Iterable, Iterator

from PySide6.QtCore import Signal, Slot
from PySide6.QtWidgets import QWidget

from trex_gui.core.files import Finding, Severity
from trex_gui.core.translation import tr
from trex_gui.devices.trex.settings.rules import LintFinding
from trex_gui.devices.trex.settings.yaml_subset import LINE_END
from trex_gui.devices.trex.views.text_table import TextTable
from trex_gui.ui.theme.icons import icon
from trex_gui.ui.theme.theme import theme
from trex_gui.ui.widgets.builders import button, column, label, row

_COLOURS = {"error": "danger", "warning": "warning", "info": "info"}


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
        self._lines: list[int | None] = []  # of the rows

        self._summary = label(self, "findingsSummary", wrap=True)
        self._table = TextTable("findingsTable", tr("Findings"), (20, 7, 34), self)
        text = tr("Acce&pt the proposal")
        self._accept = button(self, "acceptFindingButton", text, on_click=self._on_accept_clicked)
        self._table.setHorizontalHeaderLabels(
            [tr("Kind"), tr("Line", "of a text"), tr("Setting"), tr("Message")]
        )
        column(self._summary, (self._table, 1), row(1, self._accept), into=self, margins=0)

        self._table.cellActivated.connect(self._on_activated)
        self._table.cellDoubleClicked.connect(self._on_activated)
        self._table.currentCellChanged.connect(self._update_accept)
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
        warnings, suggestions = len(self._findings) - errors, len(self._lint_findings)
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
        self._lines, rows = [], []
        for sign, kind, line, key, message in self._rows():
            texts = (kind, str(line or ""), key, f"{message[:1].upper()}{message[1:]}")
            rows.append((icon(sign, _COLOURS[sign]), texts))
            self._lines.append(line)
        self._table.show_rows(rows)
        proposals = [n for n, found in enumerate(self._lint_findings) if found.change]
        if current < 0 and proposals:
            current = len(self._findings) + proposals[0]
        self._table.setCurrentCell(min(current, self.count - 1), 0)
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
        if (finding := self._current_finding()) is not None:
            self.accepted.emit(finding)

    @Slot(int)
    def _on_activated(self, row: int) -> None:
        if (line := self._lines[row]) is not None:
            self.line_chosen.emit(line)
