"""Findings of the settings check, and a question about values beyond inferred limits."""

from collections.abc import Callable, Iterable, Sequence
from functools import partial

from PySide6.QtCore import Qt, Signal, Slot
from PySide6.QtWidgets import QWidget

from trex_gui.core.translation import tr
from trex_gui.devices.trex.model.linter import SettingsLinter
from trex_gui.devices.trex.settings.rules import LintFinding
from trex_gui.ui.notifier import Answer
from trex_gui.ui.widgets.builders import button, column, label, row, tab_order
from trex_gui.ui.widgets.labels import Sign
from trex_gui.ui.widgets.messages import InlinePrompt


class FindingsList(QWidget):
    """Every finding, with a button for its proposal; hidden without any."""

    accepted = Signal(object)  # a `LintFinding`; its change is to become an edit

    def __init__(
        self, where: str, after: QWidget, parent: QWidget | None = None, *, is_wide: bool = False
    ) -> None:
        """Create the list; `where` begins the object names: `parameter`, `review`.

        Tab comes to it from `after`. `is_wide`: there is room for the buttons beside the texts.
        """
        super().__init__(parent)
        self._after = after
        self._is_wide = is_wide
        self._where = where
        self.setObjectName(f"{where}Findings")
        self.setAccessibleName(tr("Findings about the settings"))
        self._findings: tuple[LintFinding, ...] = ()
        self._can_accept = True
        self._lines: list[QWidget] = []
        self._layout = column(into=self, margins=0)
        self.hide()

    def follow(
        self, linter: SettingsLinter, concerns: Callable[[LintFinding], bool] = bool
    ) -> None:
        """Show the findings that concern the user here."""
        self._linter, self._concerns = linter, concerns
        linter.changed.connect(self._on_linter_changed)
        self.accepted.connect(linter.accept)
        self._on_linter_changed()

    @Slot()
    def _on_linter_changed(self) -> None:
        self.show_findings(filter(self._concerns, self._linter.findings))

    @property
    def count(self) -> int:
        return len(self._findings)

    def show_findings(self, findings: Iterable[LintFinding]) -> None:
        shown = tuple(findings)
        if shown != self._findings:
            self._findings = shown
            self._fill()

    def set_can_accept(self, can_accept: bool) -> None:
        if can_accept != self._can_accept:
            self._can_accept = can_accept
            self._fill()

    def _fill(self) -> None:
        for line in self._lines:
            self._layout.removeWidget(line)
            line.setParent(None)
            line.deleteLater()  # later: this may handle a click on one of its buttons
        self._lines = [self._line(*numbered) for numbered in enumerate(self._findings)]
        for line in self._lines:
            self._layout.addWidget(line)
        self.setVisible(bool(self._lines))
        tab_order(self._after, self)

    def _line(self, number: int, finding: LintFinding) -> QWidget:
        line = QWidget(self)
        sign = Sign(line)
        sign.show_sign("warning")
        text = label(line, f"{self._where}Finding{number}", finding.text, wrap=True, expand=True)
        accept = button(
            line,
            f"{self._where}Accept{number}",
            tr("Accept"),
            accessible=finding.proposal,
            tip=tr("Add this change to the edits; nothing is written until you click Apply"),
            default=False,
            on_click=partial(self.accepted.emit, finding),
        )
        accept.setVisible(bool(finding.change))
        accept.setEnabled(self._can_accept)
        if self._is_wide:
            row(sign, (text, 1), accept, into=line, margins=0)
        else:
            below = (accept, 0, Qt.AlignmentFlag.AlignRight)
            column(row(sign, (text, 1)), below, into=line, margins=0)
        return line


class LimitsPrompt(InlinePrompt):
    def ask_before(self, write: Callable[[], object], doubts: Callable[[], Sequence[str]]) -> None:
        """Call `write`, after a question if there are doubts; `doubts` names the values."""
        named = doubts()
        if not named:
            write()
            return
        text = tr(
            "{0}: beyond a limit that no document confirms (inferred). The board decides: it may "
            "reject the value, or store another one."
        )
        answer = Answer("writeAnyway", tr("Write an&yway"), write)
        self.ask(text.format(", ".join(named)), answer, still=lambda: doubts() == named)
