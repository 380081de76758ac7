"""The parameters of a draft: filters, table, findings and help; of a board or of a file."""

from functools import partial
from html import escape

from PySide6.QtCore import QModelIndex, Qt, Slot
from PySide6.QtWidgets import QFrame, QLabel, QSizePolicy, QVBoxLayout, QWidget

from trex_gui.devices.trex.model.linter import SettingsLinter
from trex_gui.devices.trex.model.parameters.parameters import ParameterModel, Role
from trex_gui.devices.trex.model.parameters.text import ParameterColumn, value_text
from trex_gui.devices.trex.model.settings.draft import SettingsDraft
from trex_gui.devices.trex.protocol.parameters import ParameterSpec
from trex_gui.devices.trex.settings.rules import LintFinding
from trex_gui.devices.trex.views.pages.parameters.filters import ParameterFilter, ParameterFilters
from trex_gui.devices.trex.views.pages.parameters.view import ParameterView
from trex_gui.ui.theme.theme import theme
from trex_gui.ui.widgets.builders import button, column, label, row
from trex_gui.ui.widgets.labels import Sign
from trex_gui.ui.widgets.scroll_box import ScrollBox

_LEAST_ROWS = 5
"""Rows that stay visible; on a low screen the texts below them scroll."""


class ParameterTable(QWidget):
    """The parameters of a board or of a file; has no access to a board."""

    def __init__(
        self, draft: SettingsDraft, linter: SettingsLinter, parent: QWidget | None = None
    ) -> None:
        super().__init__(parent)
        self._model = draft.parameters
        self._rows = ParameterFilter(self._model, self)
        self._place = ""  # key or group of the row that the user has selected
        self._column = ParameterColumn.VALUE
        self._is_elsewhere = False

        self._filters = ParameterFilters(self._rows, self)
        self._view = ParameterView(self._rows, self)
        self._view.setMinimumHeight(_LEAST_ROWS * (self.fontMetrics().height() + 8))
        self._no_match = self._no_match_note()
        below = QWidget(self)
        below.setObjectName("aboutParameters")
        self._help = ParameterHelp(self._model, below)
        box = ScrollBox(below, self)
        box.setSizePolicy(QSizePolicy.Policy.Preferred, QSizePolicy.Policy.Preferred)

        column(FindingsList(linter, below), self._help, into=below, margins=0)
        column(self._filters, (self._view, 1), box, into=self, margins=0)

        self._view.selectionModel().currentChanged.connect(self._on_current_changed)
        self._model.dataChanged.connect(self._show_help)
        for changed in (
            self._rows.modelReset,
            self._rows.layoutChanged,
            self._rows.rowsInserted,
            self._rows.rowsRemoved,
        ):
            changed.connect(self._on_rows_changed)
        theme().changed.connect(self._view.viewport().update)
        self._on_rows_changed()

    def _no_match_note(self) -> QWidget:
        viewport = self._view.viewport()
        note = QWidget(viewport)
        note.setObjectName("noParameterMatches")
        text = label(note, text=self.tr("No parameter matches."))
        show_all = button(
            note, "showAllParameters", self.tr("Show all parameters"), on_click=self._filters.clear
        )
        centre = Qt.AlignmentFlag.AlignCenter
        column((text, 0, centre), (show_all, 0, centre), into=note)
        QVBoxLayout(viewport).addWidget(note, 0, centre)
        return note

    def set_rows_enabled(self, enabled: bool) -> None:
        """Enable edits; disabled rows can still be searched."""
        self._view.setEnabled(enabled)

    def show_parameter(self, key: str) -> None:
        """Select a parameter, which may be filtered out or in a closed group."""
        if self._model.index_of(key).isValid():
            self._filters.clear()
            self._go_to(self._rows.index_of(key))

    @Slot(QModelIndex, QModelIndex)
    def _on_current_changed(self, current: QModelIndex, _previous: QModelIndex) -> None:
        if current.isValid():
            self._is_elsewhere = False
            self._place = self._view.current_key or str(current.data(Role.GROUP))
            if self._view.current_key:
                self._column = ParameterColumn(current.column())
            self._view.scrollTo(current)
            # The name is more important than the column.
            self._view.scrollTo(current.siblingAtColumn(ParameterColumn.NAME))
        self._show_help()

    @Slot()
    def _on_rows_changed(self) -> None:
        """Keep the user's row selected while it is shown; else select the first."""
        self._view.arrange()
        self._filters.show_count()
        self._no_match.setVisible(self._model.count > 0 and self._rows.rowCount() == 0)
        is_lost = self._is_elsewhere or not self._view.currentIndex().isValid()
        if is_lost and self._rows.rowCount() > 0:
            place = self._rows.index_of(self._place, self._column)
            if not place.isValid():
                place = self._rows.mapFromSource(self._model.index_of_group(self._place))
            if place.isValid():
                self._go_to(place)
            elif not self._view.currentIndex().isValid():
                self._go_to_first()
        self._show_help()

    def _go_to_first(self) -> None:
        """Select the first row, but remember the user's row."""
        wanted = self._place
        heading = self._rows.index(0, 0)
        first = self._rows.index(0, ParameterColumn.VALUE, heading)
        self._view.setCurrentIndex(first if self._view.isExpanded(heading) else heading)
        self._view.scrollToTop()
        self._is_elsewhere = bool(wanted)
        self._place = wanted or self._place

    def _go_to(self, place: QModelIndex) -> None:
        if place.parent().isValid() and not self._view.isExpanded(place.parent()):
            self._view.expand(place.parent())
        self._view.setCurrentIndex(place)

    @Slot()
    def _show_help(self) -> None:
        self._help.show_help_of(self._view.currentIndex())


_LINES = 6


class ParameterHelp(QLabel):
    """Explains the current row; keeps the room of a few lines, so that nothing above it jumps."""

    def __init__(self, model: ParameterModel, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._model = model
        self.setObjectName("parameterHelp")
        self.setWordWrap(True)
        self.setTextFormat(Qt.TextFormat.RichText)
        self.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
        self.setAlignment(Qt.AlignmentFlag.AlignTop | Qt.AlignmentFlag.AlignLeft)
        self.setSizePolicy(QSizePolicy.Policy.Preferred, QSizePolicy.Policy.Minimum)
        self.setFrameShape(QFrame.Shape.StyledPanel)
        self.setMargin(8)
        self.setMinimumHeight(_LINES * self.fontMetrics().lineSpacing() + 2 * self.margin())

    def show_help_of(self, index: QModelIndex) -> None:
        spec, lines = index.data(Role.SPEC), []
        if isinstance(spec, ParameterSpec):
            lines = self._lines(spec, index)
        elif index.data(Role.GROUP) is not None:
            hint = self.tr("Enter, or a click on the arrow, closes or opens the group.")
            lines = [f"<b>{escape(str(index.data()))}</b>", hint]
        self.setText("<br>".join(lines))
        self.setAccessibleName("" if lines else self.tr("No parameter is selected"))

    def _lines(self, spec: ParameterSpec, index: QModelIndex) -> list[str]:
        text = self._model.text
        lines = [
            f"<b>{escape(spec.name)}</b> ({spec.number:#04x}, <code>{spec.key}</code>)",
            escape(spec.description),
            escape(f"{text.limits(spec)} {text.origin(spec)}"),
        ]
        if spec.needs_power_cycle:
            lines.append(self.tr("Takes effect when the board is switched off and on."))
        notes = [text.stored(spec), text.other_motor(spec), index.data(Role.PROBLEM)]
        active = index.data(Role.WAITING)
        if active is not None:
            notes.append(self.tr("Still active: {0}.").format(value_text(spec, active)))
        if note := " ".join(escape(note) for note in notes if note):
            lines.append(f"<b>{note}</b>")
        return lines


_SHOWN = 3


class FindingsList(QWidget):
    """The first findings, one below the other; hidden without any."""

    def __init__(self, linter: SettingsLinter, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("parameterFindings")
        self.setAccessibleName(self.tr("Findings about the settings"))
        self._linter = linter
        self._lines: list[QWidget] = []
        self._layout = column(into=self, margins=0)

        linter.changed.connect(self._on_changed)
        self._on_changed()

    @Slot()
    def _on_changed(self) -> None:
        for line in self._lines:
            self._layout.removeWidget(line)
            line.setParent(None)
            line.deleteLater()  # later: this may handle a click on one of its buttons
        findings = self._linter.findings
        self._lines = [self._line(*numbered) for numbered in enumerate(findings[:_SHOWN])]
        if len(findings) > _SHOWN:
            more = self.tr("… and {0} more").format(len(findings) - _SHOWN)
            self._lines.append(label(self, text=more))
        for line in self._lines:
            self._layout.addWidget(line)
        self.setVisible(bool(self._lines))

    def _line(self, number: int, finding: LintFinding) -> QWidget:
        line = QWidget(self)
        sign = Sign(line)
        sign.show_sign("warning")
        message = finding.message
        text = label(
            line, f"parameterFinding{number}", message, tip=message, wrap=True, expand=True
        )
        text.setMinimumHeight(2 * text.fontMetrics().lineSpacing() + 4)
        layout = row(sign, (text, 1), into=line, margins=0)
        if finding.change:
            accept = button(
                line,
                f"acceptFinding{number}",
                finding.proposal,
                tip=self.tr(
                    "Add this change to the edits; nothing is written until you click Apply"
                ),
                on_click=partial(self._linter.accept, finding),
            )
            layout.addWidget(accept)
        return line
