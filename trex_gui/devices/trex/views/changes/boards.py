"""Dialog that writes a settings file to several boards on a line."""

from dataclasses import replace

from PySide6.QtCore import QObject, QSignalBlocker, Qt, Slot
from PySide6.QtWidgets import QHeaderView, QTableWidget, QTableWidgetItem, QWidget

from trex_gui.core.texts import title_of
from trex_gui.core.translation import tr
from trex_gui.devices.trex.model.apply_to_boards import ApplyToBoards, BoardPlan, BoardStep
from trex_gui.devices.trex.model.boards import BoardList
from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.model.settings.document import SettingsDocument
from trex_gui.devices.trex.views.changes.dialog import Changes, ChangesDialog, Names, Rows, TickedOf
from trex_gui.ui.widgets import builders as ui

_LEFT_OUT = {BoardStep.FAILED, BoardStep.SKIPPED}
_CHECKED = Qt.CheckState.Checked
_VISIBLE_BOARDS = 6


class ApplyToBoardsDialog(QObject):
    """Preview the changes of a file for each board, and write the file to the checked boards.

    Closing the dialog ends the work after the current board. The main window then reports the
    outcome.
    """

    def __init__(self, boards: BoardList, device: Device, parent: QWidget) -> None:
        super().__init__(parent)
        self._boards = boards
        self._device = device
        self.work = ApplyToBoards(boards, device, self)
        self._name = self._problem = ""

        title = title_of(tr("&Write to boards"))
        self._table = table = ui.flat_table(QTableWidget(0, 3, parent), "boardsToWrite", title)
        table.setHorizontalHeaderLabels([tr("Board"), tr("Changes"), tr("Result")])
        header = table.horizontalHeader()
        for column in (0, 1):
            header.setSectionResizeMode(column, QHeaderView.ResizeMode.ResizeToContents)
        header.setStretchLastSection(True)
        table.setMaximumHeight(_VISIBLE_BOARDS * 2 * table.fontMetrics().height())
        self.dialog = ChangesDialog(
            device,
            parent,
            names=Names("applyToBoardsDialog", "boards", "writeBoardsButton", "closeBoardsButton"),
            describe=self._describe,
            on_action=self._on_write_clicked,
            refresh_on=(device.link_changed, device.motors.arming_changed),
            above=self._table,
        )
        text, cancel = tr("&End after this board"), self.work.cancel
        self._end = ui.button(self.dialog, "endBoardsButton", text, default=False, on_click=cancel)
        self.dialog.add_beside_buttons(self._end)

        self._table.itemChanged.connect(self.dialog.refresh)
        self._table.currentCellChanged.connect(self.dialog.refresh)
        self.work.changed.connect(self._fill)
        self.work.finished.connect(self._on_finished)
        self.dialog.rejected.connect(self.work.cancel)

    def open_file(self, document: SettingsDocument) -> None:
        """Read every board on the line, and show how the file would change each board."""
        if self.work.is_running:
            self.dialog.show_in_front()
            return
        self._name, self._problem = document.name, ""
        self._table.setRowCount(0)
        if document.settings is None:
            self._problem = tr("This file cannot be used: it has errors. Nothing was changed.")
        else:
            self.work.review(document.settings, [board.number for board in self._boards.boards])
        self._fill()
        self.dialog.reset_and_show()

    def _selected(self) -> list[int]:
        plans = enumerate(self.work.plans[: self._table.rowCount()])
        return [plan.number for row, plan in plans if self._item(row).checkState() is _CHECKED]

    @Slot()
    def _fill(self) -> None:
        names = {board.number: board.name for board in self._boards.boards}
        plans = self.work.plans
        with QSignalBlocker(self._table):
            self._table.setRowCount(len(plans))
            for row, plan in enumerate(plans):
                texts = (names.get(plan.number, str(plan.number)), *_texts(plan))
                for column, text in enumerate(texts):
                    self._item(row, column).setText(text)
                self._set_checkable(self._item(row), plan)
        self._table.resizeRowsToContents()
        self.dialog.refresh()

    def _item(self, row: int, column: int = 0) -> QTableWidgetItem:
        if (item := self._table.item(row, column)) is None:
            item = QTableWidgetItem()
            self._table.setItem(row, column, item)
        return item

    def _set_checkable(self, item: QTableWidgetItem, plan: BoardPlan) -> None:
        """Show a check box for a board with changes. It is initially checked."""
        checkable, role = Qt.ItemFlag.ItemIsUserCheckable, Qt.ItemDataRole.CheckStateRole
        if plan.step is not BoardStep.REVIEWED or not plan.to_write:
            item.setFlags(item.flags() & ~checkable)
            item.setData(role, None)  # no check box
        elif item.data(role) is None:
            item.setFlags(item.flags() | checkable)
            item.setData(role, _CHECKED)

    def _describe(self, _ticked_of: TickedOf) -> Changes:
        running, selected = self.work.is_running, self._selected()
        self._end.setEnabled(running)
        is_driven = self._device.motors.armed or self._device.may_move
        plans, row = self.work.plans, self._table.currentRow()
        if not 0 <= row < len(plans):
            row = next((i for i, plan in enumerate(plans) if plan.to_write), -1)
        plan = plans[row] if row >= 0 else None
        rows = None if plan is None else plan.changes
        text = tr("&Write to %n board(s)", "", len(selected))
        return Changes(
            tr("Apply {0} to several boards").format(self._name),
            caption=tr(
                "The settings are written to the checked boards one after another. A "
                "snapshot of each board is saved first. Each board keeps its device number "
                "and its serial settings. Writing ends at the first write error."
            ),
            rows=rows and replace(rows, rows=tuple(r for r in rows.rows if not r.is_missing)),
            sides=(tr("Board {0}").format(plan.number) if plan is not None else "", tr("File")),
            with_ticks=False,
            # The file is written unchanged, so proposals are omitted.
            remarks=[replace(finding, change={}) for finding in plan.findings] if plan else [],
            problem=self._problem,
            action=text if selected else tr("&Write to boards"),
            can_act=bool(selected) and not running and self._device.is_writable and not is_driven,
            close=tr("Close"),
        )

    def _on_write_clicked(self, _rows: Rows) -> None:
        self._problem = ""
        self.dialog.question.prompt_before(lambda: self.work.write(self._selected()), self._doubts)

    def _doubts(self) -> list[str]:
        if not self.dialog.action.isEnabled():
            return []
        selected = self._selected()
        plans = [plan for plan in self.work.plans if plan.number in selected]
        return list(dict.fromkeys(doubt for plan in plans for doubt in plan.doubts))

    @Slot()
    def _on_finished(self) -> None:
        steps = [plan.step for plan in self.work.plans]
        written = steps.count(BoardStep.WRITTEN)
        if written or BoardStep.FAILED in steps or self.work.was_stopped:
            self._report(steps, written)
        self._fill()
        if self.dialog.isVisible():
            self.dialog.fit()

    def _report(self, steps: list[BoardStep], written: int) -> None:
        left_out = [plan for plan in self.work.plans if plan.step in _LEFT_OUT]
        texts = []
        if self.work.was_stopped:
            texts.append(tr("Writing ended because Stop was pressed."))
        if written:
            texts.append(tr("Written to %n board(s).", "", written))
        if not self.dialog.isVisible() and self.work.is_writing:
            for plan in left_out:
                text = tr("Board {0}: {1}").format(plan.number, _texts(plan)[1])
                texts.append(text if text.endswith(".") else f"{text}.")
            notifier = self._device.notifier
            signal = notifier.error if BoardStep.FAILED in steps else notifier.info
            signal.emit(" ".join(texts))
        elif left_out:
            texts.append(tr("%n board(s) left out; see the Result column.", "", len(left_out)))
        self._problem = " ".join(texts)


def _texts(plan: BoardPlan) -> tuple[str, str]:
    changes = ""
    if plan.changes is not None:
        changes = tr("%n setting(s)", "", plan.to_write) if plan.to_write else tr("none")
    read = tr("Nothing to write.")
    if plan.to_write:
        read = tr("read, with warnings") if plan.findings else tr("read")
    state = {
        BoardStep.WAITING: tr("waiting"),
        BoardStep.READING: tr("being read …"),
        BoardStep.REVIEWED: read,
        BoardStep.WRITING: tr("being written …"),
        BoardStep.WRITTEN: tr("written and verified"),
        BoardStep.FAILED: plan.problem,
        BoardStep.SKIPPED: tr("not tried"),
    }[plan.step]
    return changes, state
