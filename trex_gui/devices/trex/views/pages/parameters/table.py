"""The parameters of a draft: filters, table, findings and help; of a board or of a file."""

from html import escape

from PySide6.QtCore import QModelIndex, Qt, Slot
from PySide6.QtGui import QAction
from PySide6.QtWidgets import QSizePolicy, QToolButton, QVBoxLayout, QWidget

from trex_gui.core.translation import tr
from trex_gui.devices.trex.model.linter import SettingsLinter
from trex_gui.devices.trex.model.parameters.parameters import ParameterModel
from trex_gui.devices.trex.model.parameters.text import ParameterColumn
from trex_gui.devices.trex.model.settings.draft import SettingsDraft
from trex_gui.devices.trex.views.findings_list import FindingsList
from trex_gui.devices.trex.views.note_field import NoteField
from trex_gui.devices.trex.views.pages.parameters.filters import ParameterFilter, ParameterFilters
from trex_gui.devices.trex.views.pages.parameters.view import ParameterView
from trex_gui.ui.theme.theme import follow_theme, theme
from trex_gui.ui.units import units
from trex_gui.ui.widgets.builders import button, column, label, named, row
from trex_gui.ui.widgets.labels import LinkLabel
from trex_gui.ui.widgets.scroll_box import ScrollBox

_PANEL = 33  # least width of the texts beside the table, in average characters


class ParameterTable(QWidget):
    """The parameters of a board or of a file; has no access to a board."""

    def __init__(
        self, draft: SettingsDraft, linter: SettingsLinter, parent: QWidget | None = None
    ) -> None:
        super().__init__(parent)
        self._model = draft.parameters
        self._rows = ParameterFilter(self._model, self)
        self._place = ""  # key of the cell that the user has selected
        self._is_elsewhere = False

        self._filters = ParameterFilters(self._rows, self)
        self._view = ParameterView(self._rows, self)
        self._no_match = self._no_match_note()
        beside = named(QWidget(self), "aboutParameters")
        reset, pin, other = (_action_button(each, beside) for each in self._view.tools)
        self._help = ParameterHelp(self._model, beside)
        self._note = NoteField(draft.notes, "noteEdit", beside)
        note = label(beside, text=tr("N&ote on the value:"), buddy=self._note)
        self._findings = FindingsList("parameter", self._note, beside)
        tools = column(row(reset, pin, 1), row(other, 1), spacing=2)
        notes = column(note, self._note, spacing=2)
        column(tools, self._help, notes, self._findings, 1, into=beside, margins=0)
        panel = ScrollBox(beside, self)

        def fit_panel() -> None:
            panel.setMinimumWidth(_PANEL * self.fontMetrics().averageCharWidth())

        follow_theme(panel, "width", fit_panel)
        below = row((self._view, 5), (panel, 2))
        column(self._filters, (below, 1), into=self, margins=0)

        self._findings.follow(linter)
        self._view.selectionModel().currentChanged.connect(self._on_current_changed)
        self._view.clicked.connect(self._on_current_changed)
        self._filters.entered.connect(self._view.setFocus)
        self._model.dataChanged.connect(self._show_help)
        units().changed.connect(self._show_help)
        rows = self._rows
        for changed in (rows.modelReset, rows.layoutChanged, rows.rowsInserted, rows.rowsRemoved):
            changed.connect(self._on_rows_changed)
        self._on_rows_changed()

    def _no_match_note(self) -> QWidget:
        viewport, centre = self._view.viewport(), Qt.AlignmentFlag.AlignCenter
        note = named(QWidget(viewport), "noParameterMatches")
        text = label(note, text=tr("No parameter matches."))
        show_all = button(note, "showAllParameters", tr("&Show all parameters"))
        show_all.clicked.connect(self._filters.clear)
        column((text, 0, centre), (show_all, 0, centre), into=note)
        QVBoxLayout(viewport).addWidget(note, 0, centre)
        return note

    def set_rows_enabled(self, enabled: bool) -> None:
        """Enable edits; disabled rows can still be searched."""
        self._view.setEnabled(enabled)
        self._findings.set_can_accept(enabled)

    def show_parameter(self, key: str) -> None:
        """Select a parameter, which may be filtered out."""
        if self._model.index_of(key).isValid():
            self._filters.clear()
            self._view.setCurrentIndex(self._rows.index_of(key))

    @Slot(QModelIndex)
    def _on_current_changed(self, current: QModelIndex) -> None:
        if current.isValid():
            self._is_elsewhere = False
            self._place = self._view.current_key
            above = current.sibling(current.row() - 1, ParameterColumn.NAME)
            if not self._rows.keys_at(above.row()):
                self._view.scrollTo(above)  # no key reaches a heading
            if current.row() > 1:
                self._view.scrollTo(current)
        self._show_help()

    @Slot()
    def _on_rows_changed(self) -> None:
        """Keep the user's value selected while it is shown; else select the first."""
        self._view.arrange()
        self._filters.show_count()
        self._no_match.setVisible(self._model.count > 0 and self._rows.rowCount() == 0)
        is_lost = self._is_elsewhere or not self._view.currentIndex().isValid()
        if is_lost and self._rows.rowCount() > 0:
            place = self._rows.index_of(self._place)
            if place.isValid():
                self._view.setCurrentIndex(place)
            elif not self._view.currentIndex().isValid():
                wanted = self._place
                self._view.setCurrentIndex(self._rows.best_match())
                self._is_elsewhere = bool(wanted)
                self._place = wanted or self._place
        self._show_help()

    @Slot()
    def _show_help(self) -> None:
        key = self._view.current_key
        self._help.show_help_of(key)
        text = self._model.text
        self._note.show_note_on(*((text.together(key)[0], text.title(key)) if key else ("", "")))
        self._view.update_actions()


class ParameterHelp(LinkLabel):
    def __init__(self, model: ParameterModel, parent: QWidget | None = None) -> None:
        super().__init__("parameterHelp", parent)
        self._model = model
        by_mouse = Qt.TextInteractionFlag.TextSelectableByMouse
        self.setTextInteractionFlags(self.textInteractionFlags() | by_mouse)
        self.setOpenExternalLinks(True)
        self.setAlignment(Qt.AlignmentFlag.AlignTop | Qt.AlignmentFlag.AlignLeft)
        self.setSizePolicy(QSizePolicy.Policy.Preferred, QSizePolicy.Policy.Minimum)

    def show_help_of(self, key: str) -> None:
        def show() -> None:
            lines = self._lines(key) if key else []
            self.setText("".join(f"<p>{line}</p>" for line in lines))

        follow_theme(self, "link", show)
        self.setAccessibleName("" if key else tr("No parameter is selected"))

    def _lines(self, key: str) -> list[str]:
        text = self._model.text
        specs = [self._model.values.specs[each] for each in text.together(key)]
        names = "<br>".join(f"{spec.number:#04x}, <code>{spec.key}</code>" for spec in specs)
        address, title = map(escape, text.guide(key))
        notes = escape(" ".join(text.notes(key)))
        return [
            f"<b>{escape(text.title(key))}</b><br>{names}",
            *([f"<b>{notes}</b>"] if notes else []),
            escape(text.description(key)),
            "<br>".join(map(escape, text.about(key))),
            f'<a href="{address}" style="color:{theme().color("link").name()}">{title}</a>',
        ]


def _action_button(action: QAction, parent: QWidget) -> QToolButton:
    made = named(QToolButton(parent), f"{action.objectName()}Button")
    made.setDefaultAction(action)
    made.setToolButtonStyle(Qt.ToolButtonStyle.ToolButtonTextBesideIcon)
    return made
