"""Filter of the parameter table, and the controls that set it."""

from enum import IntEnum, auto
from itertools import takewhile
from typing import Any

from PySide6.QtCore import (
    QModelIndex,
    QObject,
    QPersistentModelIndex,
    QSortFilterProxyModel,
    Qt,
    Signal,
    Slot,
)
from PySide6.QtWidgets import QTabBar, QWidget

from trex_gui.core.translation import tr
from trex_gui.devices.trex.model.parameters.parameters import ParameterModel
from trex_gui.devices.trex.model.parameters.text import ParameterColumn
from trex_gui.ui.theme.theme import set_look, theme
from trex_gui.ui.widgets.builders import named, row, search_field


class Shown(IntEnum):
    """Parameters that are shown."""

    ALL = 0
    CHANGED = auto()
    NOT_DEFAULT = auto()
    FOUND = auto()


class ParameterFilter(QSortFilterProxyModel):
    """The rows that match every filter; a task without rows has no heading."""

    def __init__(self, parameters: ParameterModel, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self.parameters = parameters
        self._words: tuple[str, ...] = ()
        self._shown = Shown.ALL
        self.found: frozenset[str] = frozenset()  # keys that a finding of the linter is about
        self.setSourceModel(parameters)

    def headerData(
        self, section: int, orientation: Qt.Orientation, role: int = Qt.ItemDataRole.DisplayRole
    ) -> Any:
        colors = {ParameterColumn.MOTOR1: "motor1", ParameterColumn.MOTOR2: "motor2"}
        if role == Qt.ItemDataRole.ForegroundRole and section in colors:
            return theme().color(colors[ParameterColumn(section)])
        return super().headerData(section, orientation, role)

    def index_of(self, key: str) -> QModelIndex:
        """Return the value of a parameter, invalid when it is not shown."""
        return self.mapFromSource(self.parameters.index_of(key))

    def keys_at(self, row: int) -> tuple[str, ...]:
        """Return a key for each value of a row; none of a heading."""
        return self.parameters.keys_at(self.mapToSource(self.index(row, 0)).row())

    def best_match(self) -> QModelIndex:
        """Return the first value that has all words in its name, or else the first value."""
        keys = [keys[0] for row in range(self.rowCount()) if (keys := self.keys_at(row))]
        names = ((key, self.parameters.text.title(key).casefold()) for key in keys)
        named = (key for key, name in names if all(word in name for word in self._words))
        return self.index_of(next(named, keys[0]))

    def narrow(self, words: str = "", shown: Shown = Shown.ALL) -> None:
        """Show rows with all words in name, key or description, in any case; empty: all rows."""
        self._words = tuple(words.casefold().split())
        self._shown = shown
        self.invalidate()

    def set_found(self, keys: frozenset[str]) -> None:
        self.found = keys
        self.invalidate()

    def filterAcceptsRow(
        self, source_row: int, source_parent: QModelIndex | QPersistentModelIndex
    ) -> bool:
        del source_parent
        if self.parameters.keys_at(source_row):
            return self._accepts(source_row)
        below = range(source_row + 1, self.parameters.rowCount())
        members = takewhile(self.parameters.keys_at, below)
        return any(map(self._accepts, members))

    def _accepts(self, row: int) -> bool:
        model, values = self.parameters, self.parameters.values
        members = [each for key in model.keys_at(row) for each in model.text.together(key)]
        is_shown = {
            Shown.CHANGED: values.is_modified,
            Shown.NOT_DEFAULT: values.differs_from_default,
            Shown.FOUND: self.found.__contains__,
        }.get(self._shown)
        if is_shown is not None and not any(map(is_shown, members)):
            return False
        specs = [values.specs[key] for key in members]
        texts = [each for spec in specs for each in (spec.name, spec.key, spec.description)]
        searched = " ".join((*texts, *map(model.text.title, model.keys_at(row)))).casefold()
        return all(word in searched for word in self._words)


class ParameterFilters(QWidget):
    """Search, and the choice of what is shown."""

    entered = Signal()  # Enter in the field of the search

    def __init__(self, rows: ParameterFilter, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._rows = rows

        title = tr("Search parameters")
        self._words = search_field(self, "parameterSearch", title, title)
        self._choice = named(QTabBar(self), "parameterChoice", accessible=tr("Parameters"))
        set_look(self._choice, "switch")
        self._choice.setDrawBase(False)
        self._choice.setUsesScrollButtons(False)
        for _ in Shown:
            self._choice.addTab("")
        row((self._words, 1), self._choice, into=self, margins=0)

        self._words.textChanged.connect(self._on_changed)
        self._choice.currentChanged.connect(self._on_changed)
        self._words.returnPressed.connect(self.entered)
        for changed in (rows.parameters.modelReset, rows.parameters.pending_changed):
            changed.connect(self.show_counts)
        self.show_counts()

    def clear(self) -> None:
        self._words.clear()
        self._choice.setCurrentIndex(Shown.ALL)

    def show_counts(self) -> None:
        values = self._rows.parameters.values
        found = values.specs.keys() & self._rows.found
        texts = tr("All"), tr("Changed {0}"), tr("Not default {0}"), tr("Findings {0}")
        for shown, keys in enumerate(((), values.modified, values.not_default, found)):
            self._choice.setTabText(shown, texts[shown].format(len(keys)))
        self.setEnabled(self._rows.parameters.count > 0)

    @Slot()
    def _on_changed(self) -> None:
        self._rows.narrow(self._words.text(), Shown(self._choice.currentIndex()))
