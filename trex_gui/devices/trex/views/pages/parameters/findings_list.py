"""Findings about the settings, each with its change to accept."""

from functools import partial

from PySide6.QtCore import Slot
from PySide6.QtWidgets import QHBoxLayout, QLabel, QPushButton, QSizePolicy, QVBoxLayout, QWidget

from trex_gui.devices.trex.model.linter import SettingsLinter
from trex_gui.ui.theme.icons import icon
from trex_gui.ui.theme.theme import theme

_SHOWN = 3
_ICON = 16


class FindingsList(QWidget):
    """The first findings, one below the other; hidden without any."""

    def __init__(self, linter: SettingsLinter, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("adviceList")
        self.setAccessibleName(self.tr("Findings about the settings"))
        self._linter = linter
        self._rows: list[QWidget] = []

        self._layout = QVBoxLayout(self)
        self._layout.setContentsMargins(0, 0, 0, 0)

        linter.changed.connect(self._on_changed)
        theme().changed.connect(self._on_changed)
        self._on_changed()

    @Slot()
    def _on_changed(self) -> None:
        for row in self._rows:
            self._layout.removeWidget(row)
            row.setParent(None)
            row.deleteLater()  # later: the click that brought us here may be one of its own
        findings = self._linter.findings
        self._rows = [self._row(index) for index in range(min(_SHOWN, len(findings)))]
        if len(findings) > _SHOWN:
            more = QLabel(self.tr("… and {0} more").format(len(findings) - _SHOWN), self)
            self._rows.append(more)
        for row in self._rows:
            self._layout.addWidget(row)
        self.setVisible(bool(self._rows))

    def _row(self, index: int) -> QWidget:
        finding = self._linter.findings[index]
        row = QWidget(self)
        sign = QLabel(row)
        sign.setPixmap(icon("warning").pixmap(_ICON, _ICON))
        text = QLabel(finding.message, row)
        text.setObjectName(f"advice{index}")
        text.setToolTip(finding.message)
        text.setWordWrap(True)
        text.setMinimumHeight(2 * text.fontMetrics().lineSpacing() + 4)
        text.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Preferred)
        layout = QHBoxLayout(row)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.addWidget(sign)
        layout.addWidget(text, 1)
        if finding.change:
            accept = QPushButton(finding.proposal, row)
            accept.setObjectName(f"acceptAdvice{index}")
            accept.setToolTip(self.tr("Make this an edit; nothing is written before Apply"))
            accept.clicked.connect(partial(self._linter.accept, finding))
            layout.addWidget(accept)
        return row
