"""The parameters of a draft: filters, table, findings and help; of a board or of a file."""

from functools import partial
from html import escape
from typing import cast

from PySide6.QtCore import QModelIndex, Qt, Signal, Slot
from PySide6.QtWidgets import (
    QFrame,
    QHBoxLayout,
    QLabel,
    QPushButton,
    QSizePolicy,
    QVBoxLayout,
    QWidget,
)

from trex_gui.devices.trex.model.linter import SettingsLinter
from trex_gui.devices.trex.model.parameters.filter import ParameterFilter
from trex_gui.devices.trex.model.parameters.parameters import ParameterColumn, Role
from trex_gui.devices.trex.model.parameters.text import ParameterText
from trex_gui.devices.trex.model.settings.draft import SettingsDraft
from trex_gui.devices.trex.protocol.parameters import ParameterSpec
from trex_gui.devices.trex.views.pages.parameters.filters import ParameterFilters
from trex_gui.devices.trex.views.pages.parameters.menu import ParameterMenu
from trex_gui.devices.trex.views.pages.parameters.view import ParameterView
from trex_gui.ui.theme.icons import icon
from trex_gui.ui.theme.theme import theme
from trex_gui.ui.widgets.builders import button, column, label
from trex_gui.ui.widgets.scroll_box import ScrollBox

_LEAST_ROWS = 5
"""So many stay in sight; on a low screen the texts below them scroll."""


class ParameterTable(QWidget):
    """Everything to look at parameters and edit them; knows of no board.

    Signals:
        rejected: why the input is not a value, for the user.
    """

    rejected = Signal(str)

    def __init__(
        self, draft: SettingsDraft, linter: SettingsLinter, parent: QWidget | None = None
    ) -> None:
        super().__init__(parent)
        self._model = draft.parameters
        self._rows = ParameterFilter(self._model, self)
        self._place = ""
        self._column = ParameterColumn.VALUE
        self._is_inside = False

        self._filters = ParameterFilters(self._rows, self)
        self._view = ParameterView(self._rows, self)
        self._view.setMinimumHeight(_LEAST_ROWS * (self.fontMetrics().height() + 8))
        self._nothing = _Nothing(self._view.viewport())
        below = QWidget(self)
        below.setObjectName("aboutParameters")
        self._findings = FindingsList(linter, below)
        self._help = ParameterHelp(self._model.text, below)
        box = ScrollBox(below, self)
        box.setSizePolicy(QSizePolicy.Policy.Preferred, QSizePolicy.Policy.Preferred)
        self._menu = ParameterMenu(self._model, self._view)

        column(self._findings, self._help, into=below, margins=0)
        column(self._filters, (self._view, 1), box, into=self, margins=0)

        self._view.reset_wanted.connect(self._model.reset)
        self._view.rejected.connect(self.rejected)
        self._model.rejected.connect(self.rejected)
        self._nothing.all_wanted.connect(self._filters.clear)
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

    # --- For the page -------------------------------------------------------------------

    def set_rows_enabled(self, enabled: bool) -> None:
        """Let rows be edited, or grey them; they can be searched all the same."""
        self._view.setEnabled(enabled)

    def show_parameter(self, key: str) -> None:
        """Go to a parameter, whatever was narrowed down or closed; without it, do nothing."""
        if self._model.index_of(key).isValid():
            self._filters.clear()
            self._go_to(self._rows.index_of(key))

    @property
    def current_key(self) -> str:
        """The parameter of the current row; empty on a heading."""
        spec = self._view.currentIndex().data(Role.SPEC)
        return spec.key if isinstance(spec, ParameterSpec) else ""

    # --- The current row ----------------------------------------------------------------

    @Slot(QModelIndex, QModelIndex)
    def _on_current_changed(self, current: QModelIndex, _previous: QModelIndex) -> None:
        if current.isValid():
            self._is_inside = False
            self._place = self.current_key or str(current.data(Role.GROUP))
            if self.current_key:
                self._column = ParameterColumn(current.column())
            self._view.scrollTo(current)
            # Which row it is, above all.
            self._view.scrollTo(current.siblingAtColumn(ParameterColumn.NAME))
        self._show_help()

    @Slot()
    def _on_rows_changed(self) -> None:
        """Keep the user's current row while it is shown; else select the first."""
        self._nothing.setVisible(self._model.count > 0 and self._rows.rowCount() == 0)
        is_lost = self._is_inside or not self._view.currentIndex().isValid()
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
        self._is_inside = bool(wanted)
        self._place = wanted or self._place

    def _go_to(self, place: QModelIndex) -> None:
        if place.parent().isValid() and not self._view.isExpanded(place.parent()):
            self._view.expand(place.parent())
        self._view.setCurrentIndex(place)

    @Slot()
    def _show_help(self) -> None:
        self._help.show_help_of(self._view.currentIndex())


class _Nothing(QWidget):
    """Stands where the rows would be while none matches.

    Signals:
        all_wanted: every row is to be shown again.
    """

    all_wanted = Signal()

    def __init__(self, viewport: QWidget) -> None:
        super().__init__(viewport)
        self.setObjectName("noParameterMatches")
        words = QLabel(self.tr("No parameter matches."), self)
        words.setAlignment(Qt.AlignmentFlag.AlignCenter)
        show_all = button(self, "showAllParameters", self.tr("Show all parameters"))

        column(words, (show_all, 0, Qt.AlignmentFlag.AlignCenter), into=self)
        around = QVBoxLayout(viewport)
        around.addWidget(self, 0, Qt.AlignmentFlag.AlignCenter)

        show_all.clicked.connect(self.all_wanted)


_LINES = 6


class ParameterHelp(QLabel):
    """Keeps the room of a few lines, so that nothing jumps above it."""

    def __init__(self, text: ParameterText, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._text = text
        self.setObjectName("parameterHelp")
        self.setWordWrap(True)
        self.setTextFormat(Qt.TextFormat.RichText)
        self.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
        self.setAlignment(Qt.AlignmentFlag.AlignTop | Qt.AlignmentFlag.AlignLeft)
        self.setSizePolicy(QSizePolicy.Policy.Preferred, QSizePolicy.Policy.Minimum)
        self.setFrameShape(QFrame.Shape.StyledPanel)
        self.setMargin(8)
        self.setMinimumHeight(_LINES * self.fontMetrics().lineSpacing() + 2 * self.margin())
        self._show_lines([])

    def show_help_of(self, index: QModelIndex) -> None:
        """Explain the parameter of a row, or what a heading is good for."""
        spec = cast("ParameterSpec | None", index.data(Role.SPEC))
        if spec is not None:
            self._show_lines(self._lines(spec, index))
        elif index.data(Role.GROUP) is not None:
            hint = self.tr("Enter, or a click on the arrow, closes or opens the group.")
            self._show_lines([f"<b>{escape(str(index.data()))}</b>", hint])
        else:
            self._show_lines([])

    def _show_lines(self, lines: list[str]) -> None:
        self.setText("<br>".join(lines))
        self.setAccessibleName("" if lines else self.tr("No parameter is selected"))

    def _lines(self, spec: ParameterSpec, index: QModelIndex) -> list[str]:
        lines = [
            f"<b>{escape(spec.name)}</b> ({spec.number:#04x}, <code>{spec.key}</code>)",
            escape(spec.description),
            escape(f"{self._text.limits(spec)} {self._text.origin(spec)}"),
        ]
        if spec.needs_power_cycle:
            lines.append(self.tr("Takes effect when the board is switched off and on."))
        notes = [
            index.data(Role.STORED_TEXT),
            index.data(Role.OTHER_MOTOR),
            index.data(Role.PROBLEM),
        ]
        waiting = index.data(Role.WAITING)
        if waiting is not None:
            notes.append(self.tr("Still active: {0}.").format(spec.text(waiting)))
        if stand_out := " ".join(escape(text) for text in notes if text):
            lines.append(f"<b>{stand_out}</b>")
        return lines


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
        text = label(row, f"advice{index}", finding.message, tip=finding.message, wrap=True)
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
