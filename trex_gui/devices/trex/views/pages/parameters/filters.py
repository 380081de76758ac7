"""Which rows of the parameter table are shown, and the fields above it that choose them."""

from itertools import takewhile

from PySide6.QtCore import (
    QModelIndex,
    QObject,
    QPersistentModelIndex,
    QSignalBlocker,
    QSortFilterProxyModel,
    Signal,
    Slot,
)
from PySide6.QtWidgets import QComboBox, QWidget

from trex_gui.core.translation import tr
from trex_gui.devices.trex.model.parameters.parameters import ParameterModel, Role
from trex_gui.ui.preferences import Preferences
from trex_gui.ui.widgets.builders import check_box, combo_box, label, row, search_field

_BOTH_MOTORS = "parameters/both_motors"


class ParameterFilter(QSortFilterProxyModel):
    """The rows that match every filter; a task without rows has no heading."""

    def __init__(self, parameters: ParameterModel, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self.parameters = parameters
        self._words: tuple[str, ...] = ()
        self._task = ""
        self._modified_only = self._not_default_only = False
        self.setSourceModel(parameters)

    @property
    def shown(self) -> int:
        """The number of settings, headings left out."""
        return sum(bool(self.keys_at(row)) for row in range(self.rowCount()))

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

    def narrow(
        self,
        *,
        words: str = "",
        task: str = "",
        modified_only: bool = False,
        not_default_only: bool = False,
    ) -> None:
        """Show rows with all words in name, key or description, in any case; empty: all rows."""
        self._words = tuple(words.casefold().split())
        self._task = task
        self._modified_only = modified_only
        self._not_default_only = not_default_only
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
        model = self.parameters
        values = [model.index_of(key) for key in model.keys_at(row)]
        members = [each for key in model.keys_at(row) for each in model.text.together(key)]
        specs = [model.values.specs[key] for key in members]
        if self._task and specs[0].task != self._task:
            return False
        if self._modified_only and not any(value.data(Role.DIRTY) for value in values):
            return False
        if self._not_default_only and all(value.data(Role.RESET) is None for value in values):
            return False
        texts = [each for spec in specs for each in (spec.name, spec.key, spec.description)]
        searched = " ".join((*texts, *map(model.text.title, model.keys_at(row)))).casefold()
        return all(word in searched for word in self._words)


class ParameterFilters(QWidget):
    """The fields of the filter, and a check box to edit both motors as one."""

    entered = Signal()  # Enter in the field of the search

    def __init__(self, rows: ParameterFilter, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._rows = rows
        self._store = Preferences()

        hint = tr("Search names and descriptions (Ctrl+F)")
        self._words = search_field(self, "parameterSearch", tr("Search parameters"), hint)
        title = tr("Group of parameters")
        self._group = combo_box(self, "parameterGroup", title, tip=title)
        adjust = QComboBox.SizeAdjustPolicy.AdjustToMinimumContentsLengthWithIcon
        self._group.setSizeAdjustPolicy(adjust)
        self._group.setMinimumContentsLength(12)  # leaves room for the words
        tip = tr("Show only what you have changed")
        self._modified = check_box(self, "modifiedOnly", tr("&Modified only"), tip=tip)
        tip = tr("Show only values that differ from their default")
        self._not_default = check_box(self, "notDefaultOnly", tr("Not default onl&y"), tip=tip)
        tip = tr("Make each change to one motor to the other, too, in one step")
        both = check_box(self, "bothMotors", tr("&Both motors as one"), tip=tip)
        self._count = label(self, "parameterCount")

        first = (self._words, 1), self._count, self._group, self._modified, self._not_default
        layout = row(*first, into=self, margins=0)
        layout.addSpacing(layout.spacing())
        layout.addWidget(both)

        self._words.textChanged.connect(self._on_changed)
        self._group.currentIndexChanged.connect(self._on_changed)
        for restriction in (self._modified, self._not_default):
            restriction.toggled.connect(self._on_changed)
        both.toggled.connect(self._on_both_toggled)
        self._words.returnPressed.connect(self.entered)
        rows.modelReset.connect(self._on_reset)
        both.setChecked(self._store.flag(_BOTH_MOTORS, default=False))
        self._on_reset()

    def clear(self) -> None:
        self._words.clear()
        self._group.setCurrentIndex(0)
        self._modified.setChecked(False)
        self._not_default.setChecked(False)

    def show_count(self) -> None:
        """Show how many rows match, unless all do."""
        shown, total = self._rows.shown, self._rows.parameters.count
        self._count.setVisible(shown < total)
        text = tr("None of {1} matches") if shown == 0 else tr("{0} of {1}")
        self._count.setText(text.format(shown, total))

    @Slot()
    def _on_reset(self) -> None:
        """Offer the tasks that have parameters."""
        wanted = self._group.currentData()
        with QSignalBlocker(self._group):
            self._group.clear()
            self._group.addItem(tr("All groups"), "")
            for task, title in self._rows.parameters.tasks.items():
                self._group.addItem(title, task)
            self._group.setCurrentIndex(max(0, self._group.findData(wanted)))
        self.setEnabled(self._rows.parameters.count > 0)
        if wanted and self._group.currentData() != wanted:
            self._on_changed()

    @Slot()
    def _on_changed(self) -> None:
        self._rows.narrow(
            words=self._words.text(),
            task=self._group.currentData() or "",
            modified_only=self._modified.isChecked(),
            not_default_only=self._not_default.isChecked(),
        )

    @Slot(bool)
    def _on_both_toggled(self, both: bool) -> None:
        self._rows.parameters.both_motors = both
        self._store.set(_BOTH_MOTORS, both)
