"""Sequences and gaits, with the steps of the current item."""

from collections.abc import Sequence as Many
from dataclasses import replace
from enum import IntEnum
from typing import Any

from PySide6.QtCore import (
    QAbstractItemModel,
    QLocale,
    QModelIndex,
    QPersistentModelIndex,
    QSignalBlocker,
    Qt,
    Signal,
    Slot,
)
from PySide6.QtGui import QPaintEvent
from PySide6.QtWidgets import (
    QAbstractItemView,
    QHeaderView,
    QSpinBox,
    QStyledItemDelegate,
    QStyleOptionViewItem,
    QTableWidget,
    QTableWidgetItem,
    QToolButton,
    QWidget,
)

from trex_gui.core.translation import tr
from trex_gui.devices.aracna.model.library import ItemKey, ItemKind, Library
from trex_gui.devices.aracna.poses.gaits import GAITS
from trex_gui.devices.aracna.poses.project import (
    DEFAULT_MS,
    LONGEST_MS,
    SHORTEST_MS,
    Sequence,
    SequenceStep,
    is_usable_in_step,
)
from trex_gui.devices.aracna.views.poses.name_list import (
    NameList,
    action_button,
    row_action,
    small_button,
)
from trex_gui.ui.notifier import Notifier
from trex_gui.ui.theme.theme import follow_theme, set_look
from trex_gui.ui.widgets import builders as ui
from trex_gui.ui.widgets.behaviour import commit_typed, paint_placeholder

_Index = QModelIndex | QPersistentModelIndex
_LINES = 3  # minimum height of the step table, in rows


class StepColumn(IntEnum):
    NUMBER = 0
    POSE = 1
    TIME = 2
    NOTE = 3


class MotionBox(ui.Card):
    steps_changed = Signal()  # the current item or its steps have changed

    def __init__(self, library: Library, notifier: Notifier, parent: QWidget | None = None) -> None:
        super().__init__(tr("Sequences and gaits"), parent)
        self.setObjectName("aracnaMotionBox")
        set_look(self, "compact")
        self._library = library
        self._next_pose = ""
        self._list = ui.named(
            NameList(library, ItemKind.SEQUENCE, notifier, "", self),
            "aracnaMotions",
            accessible=tr("Sequences and gaits"),
        )
        new = small_button(
            self, "aracnaNewSequence", tr("New sequence"), text=tr("&New"), icon="new"
        )
        buttons = self._list.buttons(self)
        self.table = StepTable(library, self)
        self._add = small_button(self, "aracnaAddStep", text=tr("Add s&tep"), icon="new")
        ui.column(
            (self._list, 2),
            ui.row(new, *buttons, 1),
            (self.table, 3),
            ui.row(self._add, *self.table.buttons(self), 1),
            into=self,
            spacing=4,
        )

        new.clicked.connect(lambda: self._list.select_and_edit(library.add_sequence()))
        self._add.clicked.connect(self._on_add_clicked)
        self._list.current_changed.connect(lambda: self.table.show_item(self._list.current))
        self.table.selectionModel().currentChanged.connect(self._update_buttons)
        self.table.steps_changed.connect(self._update_buttons)
        self.table.steps_changed.connect(self.steps_changed)
        self._list.select(ItemKey(GAITS[0].name, built_in=True))  # so that Play is enabled
        self._update_buttons()

    @property
    def current(self) -> ItemKey | None:
        return self._list.current

    @property
    def playable(self) -> Sequence | None:
        return self._library.playable(self._list.current)

    def set_step_pose(self, name: str) -> None:
        """Set the pose of new steps."""
        self._next_pose = name
        self._update_buttons()

    @Slot()
    def _update_buttons(self) -> None:
        pose = self._pose_for_step()
        self._add.setEnabled(self.table.editable and bool(pose) and is_usable_in_step(pose))
        self._add.setToolTip(ui.plain(self._add_tool_tip(pose)))
        self.table.update_actions()

    def _add_tool_tip(self, pose: str) -> str:
        if not self.table.editable:
            return tr("Select a sequence; built-in gaits cannot be changed")
        if not pose:
            return tr("There are no poses")
        if not is_usable_in_step(pose):
            text = tr(
                "A step cannot use “{0}”: remove commas and vertical bars from the pose's name"
            )
            return text.format(pose)
        return tr("Add a step with the pose “{0}” after the current step").format(pose)

    def _pose_for_step(self) -> str:
        names = self._library.project.pose_names
        return self._next_pose if self._next_pose in names else next(iter(names), "")

    @Slot()
    def _on_add_clicked(self) -> None:
        commit_typed()
        row, steps = self.table.currentRow(), self.table.steps
        after = row if row >= 0 else len(steps) - 1
        time = steps[after].milliseconds if steps else DEFAULT_MS
        self.table.add(after + 1, SequenceStep(self._pose_for_step(), time))
        self.table.select(after + 1)


class _Delegate(QStyledItemDelegate):
    def __init__(self, library: Library, parent: QWidget) -> None:
        super().__init__(parent)
        self._library = library

    def createEditor(self, parent: QWidget, option: QStyleOptionViewItem, index: _Index) -> QWidget:
        del option
        if index.column() == StepColumn.POSE:
            combo = ui.combo_box(
                parent,
                "aracnaStepPose",
                tr("Pose of step {0}").format(index.row() + 1),
                items=[
                    name for name in self._library.project.pose_names if is_usable_in_step(name)
                ],
                on_activate=self._on_activated,
            )
            if combo.findText(str(index.data())) < 0:  # an undefined pose
                combo.insertItem(0, str(index.data()))
            return combo
        return ui.spin_box(
            parent,
            "aracnaStepTime",
            tr("Milliseconds of step {0}").format(index.row() + 1),
            SHORTEST_MS,
            LONGEST_MS,
            step=100,
            suffix=tr(" ms"),
        )

    def displayText(self, value: Any, locale: QLocale | QLocale.Language) -> str:
        return _time_text(value) if isinstance(value, int) else super().displayText(value, locale)

    def setModelData(self, editor: QWidget, model: QAbstractItemModel, index: _Index) -> None:
        if isinstance(editor, QSpinBox):
            editor.interpretText()
        super().setModelData(editor, model, index)

    @Slot()
    def _on_activated(self) -> None:
        editor = self.sender()
        if isinstance(editor, QWidget):
            self.commitData.emit(editor)


class StepTable(QTableWidget):
    steps_changed = Signal()  # the item or its steps have changed

    def __init__(self, library: Library, parent: QWidget | None = None) -> None:
        super().__init__(0, len(StepColumn), parent)
        self._library = library
        self._key: ItemKey | None = None  # the library may no longer contain this item
        self.steps: tuple[SequenceStep, ...] = ()
        self._notes: dict[int, str] = {}
        self._running: int | None = None
        self.setHorizontalHeaderLabels((tr("Step"), tr("Pose"), tr("Time"), tr("Remarks")))
        ui.flat_table(self, "aracnaSteps", tr("Steps"))
        self.setItemDelegate(_Delegate(library, self))
        self.setEditTriggers(
            QAbstractItemView.EditTrigger.EditKeyPressed
            | QAbstractItemView.EditTrigger.DoubleClicked
            | QAbstractItemView.EditTrigger.SelectedClicked
            | QAbstractItemView.EditTrigger.AnyKeyPressed
        )
        header = self.horizontalHeader()
        header.setSectionResizeMode(QHeaderView.ResizeMode.ResizeToContents)
        header.setStretchLastSection(True)
        follow_theme(
            self,
            "note",
            lambda: header.setMinimumSectionSize(header.sectionSizeHint(StepColumn.NOTE)),
        )
        self.setMinimumHeight(_LINES * self.verticalHeader().defaultSectionSize())

        self.setContextMenuPolicy(Qt.ContextMenuPolicy.ActionsContextMenu)
        self._remove = row_action(self, tr("Delete"), "Del", self._on_remove, "clear")
        self._up = row_action(self, tr("Move up"), "Alt+Up", lambda: self._shift(-1))
        self._down = row_action(self, tr("Move down"), "Alt+Down", lambda: self._shift(1))
        self.itemChanged.connect(self._on_edited)
        library.changed.connect(self._on_library_changed)

    @property
    def editable(self) -> bool:
        key = self._key
        return key is not None and not key.built_in and self._library.playable(key) is not None

    def show_item(self, key: ItemKey | None) -> None:
        if key != self._key:
            self._key = key
            self._running = None
            self.setCurrentCell(-1, -1)
            self._on_library_changed()

    def show_notes(self, notes: dict[int, str]) -> None:
        if notes != self._notes:
            self._notes = notes
            self._fill()

    def show_running(self, step: int | None) -> None:
        if step != self._running:
            self._running = step
            self._fill()

    def select(self, row: int) -> None:
        column = max(self.currentColumn(), int(StepColumn.POSE))
        self.setCurrentCell(min(row, self.rowCount() - 1), column)

    def add(self, row: int, step: SequenceStep) -> None:
        self._set_steps((*self.steps[:row], step, *self.steps[row:]))

    def buttons(self, parent: QWidget) -> list[QToolButton]:
        return [
            action_button(parent, "aracnaRemoveStep", self._remove),
            action_button(parent, "aracnaStepUp", self._up, Qt.ArrowType.UpArrow),
            action_button(parent, "aracnaStepDown", self._down, Qt.ArrowType.DownArrow),
        ]

    def update_actions(self) -> None:
        row, last = self.currentRow(), self.rowCount() - 1
        self._remove.setEnabled(self.editable and row >= 0)
        self._up.setEnabled(self.editable and row > 0)
        self._down.setEnabled(self.editable and 0 <= row < last)

    def _shift(self, offset: int) -> None:
        row, steps = self.currentRow(), list(self.steps)
        steps.insert(row + offset, steps.pop(row))
        self._set_steps(steps)
        self.select(row + offset)

    def _on_remove(self) -> None:
        row = self.currentRow()
        self._set_steps(self.steps[:row] + self.steps[row + 1 :])
        self.select(row)

    def _set_steps(self, steps: Many[SequenceStep]) -> None:
        if self.editable and self._key is not None:
            self._library.set_steps(self._key.name, steps)

    @Slot(QTableWidgetItem)
    def _on_edited(self, item: QTableWidgetItem) -> None:
        row, value = item.row(), item.data(Qt.ItemDataRole.EditRole)
        field = "pose_name" if item.column() == StepColumn.POSE else "milliseconds"
        step = replace(self.steps[row], **{field: value})
        self._set_steps((*self.steps[:row], step, *self.steps[row + 1 :]))

    @Slot()
    def _on_library_changed(self) -> None:
        sequence = self._library.playable(self._key)
        steps = sequence.steps if sequence is not None else ()
        if len(steps) != len(self.steps):
            self._notes = {}
        self.steps = steps
        self._fill()
        self.steps_changed.emit()

    def _fill(self) -> None:
        with QSignalBlocker(self):
            self.setRowCount(len(self.steps))
            for row, step in enumerate(self.steps):
                number = f"{'▶ ' if row == self._running else ''}{row + 1}"
                self._show_value(row, StepColumn.NUMBER, number)
                self._show_value(row, StepColumn.POSE, step.pose_name)
                self._show_value(row, StepColumn.TIME, step.milliseconds)
                self._show_value(row, StepColumn.NOTE, self._notes.get(row, ""))

    def _show_value(self, row: int, column: StepColumn, value: str | int) -> None:
        if (cell := self.item(row, column)) is None:
            cell = QTableWidgetItem()
            self.setItem(row, column, cell)
        flags = Qt.ItemFlag.ItemIsEnabled | Qt.ItemFlag.ItemIsSelectable
        if self.editable and column in {StepColumn.POSE, StepColumn.TIME}:
            flags |= Qt.ItemFlag.ItemIsEditable
        if flags != cell.flags():  # setting equal flags would reset an open editor
            cell.setFlags(flags)
        font = cell.font()
        font.setBold(row == self._running)
        cell.setFont(font)
        cell.setData(Qt.ItemDataRole.EditRole, value)
        if isinstance(value, int):
            cell.setData(Qt.ItemDataRole.AccessibleTextRole, _time_text(value))
        if column is StepColumn.NOTE:
            cell.setToolTip(ui.plain(str(value)))

    def paintEvent(self, event: QPaintEvent) -> None:
        super().paintEvent(event)
        if self.rowCount() == 0:
            text = tr("Select a sequence or a gait to see its steps.")
            if self.editable:
                text = tr("No steps yet. “Add step” adds a step with the current pose.")
            paint_placeholder(self, text)


def _time_text(milliseconds: int) -> str:
    return tr("{0} ms").format(milliseconds)
