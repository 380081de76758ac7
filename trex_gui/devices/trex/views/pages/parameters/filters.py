"""Which rows of the parameter table are shown, and the fields above it that choose them."""

from typing import cast

from PySide6.QtCore import (
    QModelIndex,
    QObject,
    QPersistentModelIndex,
    QSignalBlocker,
    QSortFilterProxyModel,
    Slot,
)
from PySide6.QtGui import QKeySequence, QShortcut
from PySide6.QtWidgets import QLineEdit, QWidget

from trex_gui.devices.trex.model.parameters.parameters import ParameterModel, Role
from trex_gui.devices.trex.model.parameters.text import ParameterColumn
from trex_gui.devices.trex.protocol.parameters import ParameterSpec
from trex_gui.ui.preferences import Preferences
from trex_gui.ui.widgets.builders import check_box, combo_box, label, named, row

_BOTH_MOTORS = "parameters/both_motors"


class ParameterFilter(QSortFilterProxyModel):
    """The rows that match every filter; a group without rows has no heading."""

    def __init__(self, parameters: ParameterModel, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self.parameters = parameters
        self._words: tuple[str, ...] = ()
        self._group = ""
        self._modified_only = False
        self._not_default_only = False
        self.setRecursiveFilteringEnabled(True)
        self.setSourceModel(parameters)

    @property
    def shown(self) -> int:
        return sum(self.rowCount(self.index(row, 0)) for row in range(self.rowCount()))

    @property
    def is_narrowed(self) -> bool:
        return bool(self._words or self._group or self._modified_only or self._not_default_only)

    def index_of(self, key: str, column: ParameterColumn = ParameterColumn.VALUE) -> QModelIndex:
        """Return the cell of a parameter, invalid when it is not shown."""
        return self.mapFromSource(self.parameters.index_of(key, column))

    def narrow(
        self,
        *,
        words: str = "",
        group: str = "",
        modified_only: bool = False,
        not_default_only: bool = False,
    ) -> None:
        """Show rows with all words in name, key or description, in any case; empty: all rows."""
        self._words = tuple(words.casefold().split())
        self._group = group
        self._modified_only = modified_only
        self._not_default_only = not_default_only
        self.invalidate()

    def filterAcceptsRow(
        self, source_row: int, source_parent: QModelIndex | QPersistentModelIndex
    ) -> bool:
        index = self.sourceModel().index(source_row, ParameterColumn.VALUE, source_parent)
        spec = cast("ParameterSpec | None", index.data(Role.SPEC))
        if spec is None:
            return False  # a heading is shown for the rows below it
        if self._group and spec.group != self._group:
            return False
        if self._modified_only and not index.data(Role.DIRTY):
            return False
        if self._not_default_only and index.data(Role.RESET) is None:
            return False
        searched = f"{spec.name} {spec.key} {spec.description}".casefold()
        return all(word in searched for word in self._words)


class ParameterFilters(QWidget):
    """The fields of the filter, and a check box to edit both motors as one."""

    def __init__(self, rows: ParameterFilter, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._rows = rows
        self._store = Preferences()

        self._words = named(
            QLineEdit(self), "parameterSearch", accessible=self.tr("Search parameters")
        )
        self._words.setPlaceholderText(self.tr("Search names and descriptions (Ctrl+F)"))
        self._words.setClearButtonEnabled(True)
        self._group = combo_box(
            self, "parameterGroup", self.tr("Group of parameters"), on_change=self._on_changed
        )
        self._modified = check_box(
            self,
            "modifiedOnly",
            self.tr("Modified only"),
            tip=self.tr("Show only what you have changed"),
            on_toggle=self._on_changed,
        )
        self._not_default = check_box(
            self,
            "notDefaultOnly",
            self.tr("Not default only"),
            tip=self.tr("Show only values that differ from their default"),
            on_toggle=self._on_changed,
        )
        both = check_box(
            self,
            "bothMotors",
            self.tr("Both motors as one"),
            tip=self.tr("Make each change to one motor to the other, too, in one step"),
            on_toggle=self._on_both_toggled,
        )
        self._count = label(self, "parameterCount")

        layout = row(
            (self._words, 1),
            self._count,
            self._group,
            self._modified,
            self._not_default,
            into=self,
            margins=0,
        )
        layout.addSpacing(layout.spacing())
        layout.addWidget(both)

        QShortcut(QKeySequence.StandardKey.Find, self, self._on_find)
        self._words.textChanged.connect(self._on_changed)
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
        text = self.tr("None of {1} matches") if shown == 0 else self.tr("{0} of {1}")
        self._count.setText(text.format(shown, total))

    @Slot()
    def _on_find(self) -> None:
        self._words.setFocus()
        self._words.selectAll()

    @Slot()
    def _on_reset(self) -> None:
        """Offer the groups that have parameters."""
        wanted = self._group.currentData()
        with QSignalBlocker(self._group):
            self._group.clear()
            self._group.addItem(self.tr("All groups"), "")
            for group, title in self._rows.parameters.groups.items():
                self._group.addItem(title, group)
            self._group.setCurrentIndex(max(0, self._group.findData(wanted)))
        self.setEnabled(self._rows.parameters.count > 0)
        if wanted and self._group.currentData() != wanted:
            self._on_changed()

    @Slot()
    def _on_changed(self) -> None:
        self._rows.narrow(
            words=self._words.text(),
            group=self._group.currentData() or "",
            modified_only=self._modified.isChecked(),
            not_default_only=self._not_default.isChecked(),
        )

    @Slot(bool)
    def _on_both_toggled(self, both: bool) -> None:
        self._rows.parameters.both_motors = both
        self._store.set(_BOTH_MOTORS, both)
