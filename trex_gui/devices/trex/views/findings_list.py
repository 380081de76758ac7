"""List of findings about settings."""

from collections.abc import Callable, Iterable
from dataclasses import replace
from functools import partial

from PySide6.QtCore import Qt, Signal, Slot
from PySide6.QtWidgets import QPushButton, QWidget

from trex_gui.core.files import Finding, Severity
from trex_gui.core.translation import tr
from trex_gui.devices.trex.model.linter import SettingsLinter
from trex_gui.devices.trex.settings.rules import LintFinding
from trex_gui.ui.theme.theme import set_look
from trex_gui.ui.widgets.builders import button, column, label, named, no_mnemonic, row, tab_order
from trex_gui.ui.widgets.labels import Sign

Remark = LintFinding | Finding | str  # linter finding, file finding or plain sentence

_MAX_ROWS = 60  # number of findings in the list; the rest are only counted
_SIGNS = {Severity.ERROR: ("error", "danger"), Severity.WARNING: ("warning", "warning")}


class FindingsList(QWidget):
    """Findings with buttons for their proposals. An empty list is hidden."""

    accepted = Signal(object)  # `LintFinding` whose change becomes an edit
    line_requested = Signal(int)  # line number, from 1

    def __init__(
        self, prefix: str, after: QWidget, parent: QWidget, *, is_wide: bool = False
    ) -> None:
        """Create the list. `prefix` is the prefix of its object names.

        The Tab key moves the focus from `after` to the list. If `is_wide` is true, the buttons
        show whole proposals.
        """
        super().__init__(parent)
        self._after = after
        self._is_wide = is_wide
        self._prefix = prefix
        named(self, f"{prefix}Findings", accessible=tr("Findings about the settings"))
        self._findings: tuple[Remark, ...] = ()
        self._with_lines = False
        self._can_accept = True
        self._rows: list[QWidget] = []
        self._layout = column(1, into=self, margins=0)
        self.hide()

    def follow(
        self, linter: SettingsLinter, is_relevant: Callable[[LintFinding], bool] = bool
    ) -> None:
        """Show the relevant findings of a linter."""
        self._linter, self._is_relevant = linter, is_relevant
        linter.changed.connect(self.refresh)
        self.accepted.connect(linter.accept)
        self.refresh()

    @Slot()
    def refresh(self) -> None:
        findings = self._linter.findings
        self.show_findings([finding for finding in findings if self._is_relevant(finding)])

    def show_findings(self, findings: Iterable[Remark], *, with_lines: bool = False) -> None:
        """Show findings. `with_lines` adds buttons that show the lines in the file."""
        shown = tuple(findings)
        if shown != self._findings:
            self._findings, self._with_lines = shown, with_lines
            self._fill()

    def set_can_accept(self, can_accept: bool) -> None:
        if can_accept != self._can_accept:
            self._can_accept = can_accept
            self._fill()

    def _fill(self) -> None:
        for item in self._rows:
            self._layout.removeWidget(item)
            item.setParent(None)
            item.deleteLater()  # the current signal may come from one of its buttons
        shown, more = self._findings[:_MAX_ROWS], len(self._findings) - _MAX_ROWS
        if more > 0:
            shown += (tr("and %n more", "", more),)
        self._rows = [self._create_row(*numbered) for numbered in enumerate(shown)]
        for number, item in enumerate(self._rows):
            self._layout.insertWidget(number, item)
        self.setVisible(bool(self._rows))
        tab_order(self._after, self)

    def _create_row(self, number: int, finding: Remark) -> QWidget:
        item, create_button = QWidget(self), partial(button, default=False)
        text, sign, line_number, actions = str(finding), ("info", "info"), None, list[QPushButton]()
        if isinstance(finding, LintFinding):
            text = finding.message if self._is_wide else finding.text
            sign = _SIGNS[Severity.WARNING]
            accept = create_button(
                item,
                f"{self._prefix}Accept{number}",
                no_mnemonic(finding.proposal) if self._is_wide else tr("Accept"),
                accessible=finding.proposal,
                on_click=partial(self.accepted.emit, finding),
            )
            accept.setVisible(bool(finding.change))
            accept.setEnabled(self._can_accept)
            actions.append(accept)
        elif isinstance(finding, Finding):
            sign, line_number = _SIGNS[finding.severity], finding.line
            text = str(replace(finding, severity=Severity.ERROR))  # the sign shows the severity
        if line_number is not None and self._with_lines:
            show_line = partial(self.line_requested.emit, line_number)
            title = tr("Show line {0}").format(line_number)
            name = f"{self._prefix}Line{number}"
            actions.append(create_button(item, name, title, on_click=show_line))
        text = f"{text[:1].upper()}{text[1:]}"
        message = label(item, f"{self._prefix}Finding{number}", text, wrap=True, expand=True)
        mark = Sign(item)
        mark.show_sign(*sign)
        for action in actions:
            if self._is_wide:
                set_look(action, "link")
        below = row(*actions, 1) if self._is_wide else row(1, *actions)
        right = column(message, *([below] if actions else []), margins=0, spacing=0)
        row((mark, 0, Qt.AlignmentFlag.AlignTop), (right, 1), into=item, margins=0)
        return item
