"""Groups, and below each one row a parameter, as Qt wants to have them."""

from collections.abc import Callable, Sequence
from enum import IntEnum
from typing import Any

from PySide6.QtCore import QAbstractItemModel, QModelIndex, QObject, QPersistentModelIndex, Qt

from trex_gui.devices.trex.model.parameters.draft import Draft
from trex_gui.devices.trex.model.parameters.text import ParameterText, pwm_partner
from trex_gui.devices.trex.protocol.parameters import ParameterSpec, other_motor_key

Index = QModelIndex | QPersistentModelIndex

GROUPS = ("motors", "channels", "serial", "system")


class ParameterColumn(IntEnum):
    """The columns, left to right."""

    NAME = 0
    VALUE = 1
    WIRE = 2
    RESET = 3
    DEFAULT = 4
    RANGE = 5
    SOURCE = 6
    EFFECT = 7


class Role(IntEnum):
    """Data of a cell besides its text; headings of groups know of GROUP only.

    TWIN and STORED_TEXT are sentences, RESET is what going back to the default would do, and
    `None` where nothing differs.
    """

    SPEC = Qt.ItemDataRole.UserRole
    WIRE = Qt.ItemDataRole.UserRole + 1
    DIRTY = Qt.ItemDataRole.UserRole + 2
    WAITING = Qt.ItemDataRole.UserRole + 3
    PROBLEM = Qt.ItemDataRole.UserRole + 4
    GROUP = Qt.ItemDataRole.UserRole + 5
    RESET = Qt.ItemDataRole.UserRole + 6
    OTHER_MOTOR = Qt.ItemDataRole.UserRole + 7
    STORED_TEXT = Qt.ItemDataRole.UserRole + 8


_COLUMNS = len(ParameterColumn)
_DESCRIBED = {
    Qt.ItemDataRole.DisplayRole,
    Qt.ItemDataRole.EditRole,
    Qt.ItemDataRole.ToolTipRole,
    Qt.ItemDataRole.AccessibleTextRole,
    Qt.ItemDataRole.TextAlignmentRole,
    *Role,
}


class ParameterTree(QAbstractItemModel):
    """Shows a draft, and announces what is another now; what changes it is `ParameterModel`'s.

    Attributes:
        text: what the cells say.
    """

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._groups: tuple[tuple[str, tuple[ParameterSpec, ...]], ...] = ()
        self._places: dict[str, tuple[int, int]] = {}
        self._draft = Draft()
        self._problems: dict[str, str] = {}
        self.text = ParameterText(self._draft, self._problems, self)
        self._editable = False
        self._headers = (
            self.tr("Parameter"),
            self.tr("Value"),
            self.tr("Wire"),
            "",
            self.tr("Default"),
            self.tr("Range"),
            self.tr("Source"),
            self.tr("Takes effect"),
        )
        self._titles = {
            "motors": self.tr("Motors"),
            "channels": self.tr("Channels"),
            "serial": self.tr("Serial"),
            "system": self.tr("System"),
        }

    # --- What there is ------------------------------------------------------------------

    @property
    def groups(self) -> tuple[str, ...]:
        """The groups that there are, in their order."""
        return tuple(group for group, _ in self._groups)

    def title_of(self, group: str) -> str:
        """Return the name of a group for the user."""
        return self._titles[group]

    @property
    def count(self) -> int:
        """How many parameters there are."""
        return len(self._places)

    def knows(self, key: str) -> bool:
        """Whether a parameter can be given a value: it was read, or need not be."""
        return key in self._places and self._draft.takes(key)

    def _arrange(self, specs: Sequence[ParameterSpec]) -> None:
        """Put parameters into their groups; a group that the board lacks has no heading."""
        groups = ((group, tuple(s for s in specs if s.group == group)) for group in GROUPS)
        self._groups = tuple((group, members) for group, members in groups if members)
        self._places = {
            spec.key: (number, row)
            for number, (_, members) in enumerate(self._groups)
            for row, spec in enumerate(members)
        }
        self.text.specs = {spec.key: spec for spec in specs if spec.key in self._places}

    # --- Qt -----------------------------------------------------------------------------

    def index_of(self, key: str, column: ParameterColumn = ParameterColumn.VALUE) -> QModelIndex:
        """Return the cell of a parameter, invalid when there is none."""
        place = self._places.get(key)
        return QModelIndex() if place is None else self._cell(*place, column)

    def index_of_group(self, group: str) -> QModelIndex:
        """Return the heading of a group, invalid when there is none."""
        found = group in self.groups
        return self.index(self.groups.index(group), 0) if found else QModelIndex()

    def _cell(self, group: int, row: int, column: int) -> QModelIndex:
        return self.createIndex(row, column, group + 1)  # a heading has 0

    def _spec_at(self, index: Index) -> ParameterSpec | None:
        """Return the parameter of a cell; `None`: it is a heading, or none at all."""
        group = index.internalId() if index.isValid() else 0
        return self._groups[group - 1][1][index.row()] if group else None

    def index(self, row: int, column: int, parent: Index | None = None) -> QModelIndex:
        if parent is None or not parent.isValid():
            group, rows = -1, len(self._groups)
        else:
            group, rows = parent.row(), self.rowCount(parent)
        if not (0 <= row < rows and 0 <= column < _COLUMNS):
            return QModelIndex()
        return self.createIndex(row, column, group + 1)

    def parent(self, index: Index | None = None) -> Any:
        if index is None:
            return super().parent()
        group = index.internalId() if index.isValid() else 0
        return self.createIndex(group - 1, 0, 0) if group else QModelIndex()

    def rowCount(self, parent: Index | None = None) -> int:
        if parent is None or not parent.isValid():
            return len(self._groups)
        if parent.internalId() or parent.column() > 0:
            return 0
        return len(self._groups[parent.row()][1])

    def columnCount(self, _parent: Index | None = None) -> int:
        return _COLUMNS

    def headerData(
        self,
        section: int,
        orientation: Qt.Orientation,
        role: int = Qt.ItemDataRole.DisplayRole,
    ) -> Any:
        if orientation is not Qt.Orientation.Horizontal or section >= len(ParameterColumn):
            return None
        match role:
            case Qt.ItemDataRole.DisplayRole:
                return self._headers[section]
            case Qt.ItemDataRole.TextAlignmentRole if section == ParameterColumn.WIRE:
                return int(Qt.AlignmentFlag.AlignCenter)
            case Qt.ItemDataRole.AccessibleTextRole if section == ParameterColumn.RESET:
                return self.tr("Back to default")
        return None

    def flags(self, index: Index) -> Qt.ItemFlag:
        if not index.isValid():
            return Qt.ItemFlag.NoItemFlags
        spec = self._spec_at(index)
        flags = Qt.ItemFlag.ItemIsSelectable
        if spec is not None:
            flags |= Qt.ItemFlag.ItemNeverHasChildren
        if self._editable:
            flags |= Qt.ItemFlag.ItemIsEnabled
            if (
                spec is not None
                and index.column() == ParameterColumn.VALUE
                and self.knows(spec.key)
            ):
                flags |= Qt.ItemFlag.ItemIsEditable
        return flags

    def data(self, index: Index, role: int = Qt.ItemDataRole.DisplayRole) -> Any:
        if role not in _DESCRIBED or not index.isValid():
            return None  # early: views query many roles that do not exist
        spec = self._spec_at(index)
        if spec is None:
            return self._heading_data(index.row(), index.column(), role)
        column = ParameterColumn(index.column())
        match role:
            case Qt.ItemDataRole.DisplayRole:
                return self._cell_text(spec, column)
            case Qt.ItemDataRole.ToolTipRole:
                return self._tool_tip(spec, column)
            case Qt.ItemDataRole.EditRole:
                return self._draft.value(spec.key)
            case Qt.ItemDataRole.AccessibleTextRole if column is ParameterColumn.RESET:
                return self._reset_text(spec)
            case Qt.ItemDataRole.TextAlignmentRole if column is ParameterColumn.WIRE:
                return int(Qt.AlignmentFlag.AlignCenter)
        return self._fact(spec, role)

    def _fact(self, spec: ParameterSpec, role: int) -> Any:
        """Return the data of a row for its roles."""
        match role:
            case Role.SPEC:
                return spec
            case Role.WIRE:
                return self._draft.value(spec.key)
            case Role.DIRTY:
                return self._draft.is_modified(spec.key)
            case Role.WAITING:
                return self._draft.active.get(spec.key)
            case Role.PROBLEM:
                return self._problems.get(spec.key)
            case Role.RESET:
                return self._reset_text(spec)
            case Role.OTHER_MOTOR:
                return self.text.other_motor(spec)
            case Role.STORED_TEXT:
                return self.text.stored(spec) if self._draft.is_modified(spec.key) else None
        return None

    def _reset_text(self, spec: ParameterSpec) -> str | None:
        differs = self._draft.value(spec.key) not in {None, spec.default}
        return self.text.reset_text(spec) if differs else None

    def _heading_data(self, row: int, column: int, role: int) -> Any:
        group, members = self._groups[row]
        if role == Role.GROUP:
            return group
        if role != Qt.ItemDataRole.DisplayRole or column > 0:
            return None
        title, modified = self._titles[group], self._count_modified(members)
        if modified:
            return self.tr("{0} ({1}, {2} modified)").format(title, len(members), modified)
        return self.tr("{0} ({1})").format(title, len(members))

    def _count_modified(self, specs: Sequence[ParameterSpec]) -> int:
        return sum(self._draft.is_modified(spec.key) for spec in specs)

    def _cell_text(self, spec: ParameterSpec, column: ParameterColumn) -> str:
        match column:
            case ParameterColumn.NAME:
                return spec.name
            case ParameterColumn.VALUE:
                return self.text.value(spec)
            case ParameterColumn.WIRE:
                wire = self._draft.value(spec.key)
                return "" if wire is None else str(wire)
            case ParameterColumn.RESET:
                return ""
            case ParameterColumn.DEFAULT:
                return spec.text(spec.default)
            case ParameterColumn.RANGE:
                return self.text.range(spec)
            case ParameterColumn.SOURCE:
                return self.text.source(spec)
            case ParameterColumn.EFFECT:
                return self.text.effect(spec)

    def _tool_tip(self, spec: ParameterSpec, column: ParameterColumn) -> str | None:
        if column is ParameterColumn.RESET:
            return self._reset_text(spec)
        tips: dict[ParameterColumn, Callable[[ParameterSpec], str]] = {
            ParameterColumn.NAME: self.text.tip_of_name,
            ParameterColumn.DEFAULT: self.text.tip_of_default,
            ParameterColumn.RANGE: self.text.tip_of_range,
            ParameterColumn.SOURCE: self.text.tip_of_source,
            ParameterColumn.EFFECT: self.text.tip_of_effect,
        }
        return tips.get(column, self.text.tip_of_value)(spec)

    # --- News ---------------------------------------------------------------------------

    def _announce(self, key: str) -> None:
        """Announce a row, the rows whose text refers to it, and its group's heading."""
        other_motor = other_motor_key(key)
        for each in (key, other_motor, pwm_partner(key), pwm_partner(other_motor or "")):
            if each in self._places:
                group, row = self._places[each]
                last = self._cell(group, row, len(ParameterColumn) - 1)
                self.dataChanged.emit(self._cell(group, row, 0), last)
        heading = self.index(self._places[key][0], 0)
        self.dataChanged.emit(heading, heading)

    def _announce_all(self) -> None:
        for number, (_, members) in enumerate(self._groups):
            first, last = (0, 0), (len(members) - 1, len(ParameterColumn) - 1)
            self.dataChanged.emit(self._cell(number, *first), self._cell(number, *last))
        if self._groups:
            last_heading = self.index(len(self._groups) - 1, len(ParameterColumn) - 1)
            self.dataChanged.emit(self.index(0, 0), last_heading)
