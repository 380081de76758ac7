"""Which rows of the parameter table are shown: by words, by group, by what is worth a look."""

from typing import cast

from PySide6.QtCore import (
    QModelIndex,
    QObject,
    QPersistentModelIndex,
    QSortFilterProxyModel,
)

from trex_gui.devices.trex.model.parameters.parameters import ParameterColumn, ParameterModel, Role
from trex_gui.devices.trex.protocol.parameters import ParameterSpec


class ParameterFilter(QSortFilterProxyModel):
    """The rows that match every filter, under the headings of their groups.

    Without wishes, all of them in the order of the table; a group without rows has no heading.
    """

    def __init__(self, parameters: ParameterModel, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._parameters = parameters
        self._words: tuple[str, ...] = ()
        self._group = ""
        self._modified_only = False
        self._not_default_only = False
        self.setRecursiveFilteringEnabled(True)
        self.setSourceModel(parameters)

    @property
    def parameters(self) -> ParameterModel:
        """What is narrowed down."""
        return self._parameters

    @property
    def shown(self) -> int:
        """How many parameters are shown."""
        return sum(self.rowCount(self.index(row, 0)) for row in range(self.rowCount()))

    @property
    def is_narrowed(self) -> bool:
        """Whether any filter is active."""
        return bool(self._words or self._group or self._modified_only or self._not_default_only)

    def index_of(self, key: str, column: ParameterColumn = ParameterColumn.VALUE) -> QModelIndex:
        """Return the cell of a parameter, invalid when it is not shown."""
        return self.mapFromSource(self._parameters.index_of(key, column))

    def set_words(self, text: str) -> None:
        """Show rows with all these words in name, key or description, whatever their case."""
        self._words = tuple(text.casefold().split())
        self.invalidate()

    def set_group(self, group: str) -> None:
        """Show one group of the parameter table; empty for all."""
        self._group = group
        self.invalidate()

    def set_modified_only(self, only: bool) -> None:
        """Show only pending edits."""
        self._modified_only = only
        self.invalidate()

    def set_not_default_only(self, only: bool) -> None:
        """Show only values that differ from their default."""
        self._not_default_only = only
        self.invalidate()

    def filterAcceptsRow(
        self, source_row: int, source_parent: QModelIndex | QPersistentModelIndex
    ) -> bool:
        index = self.sourceModel().index(source_row, ParameterColumn.VALUE, source_parent)
        spec = cast("ParameterSpec | None", index.data(Role.SPEC))
        if spec is None:
            return False  # a heading is there for the rows below it
        if self._group and spec.group != self._group:
            return False
        if self._modified_only and not index.data(Role.DIRTY):
            return False
        if self._not_default_only and index.data(Role.WIRE) in {None, spec.default}:
            return False
        searched = f"{spec.name} {spec.key} {spec.description}".casefold()
        return all(word in searched for word in self._words)
