"""Dialog that writes one settings file to several boards on a line."""

from dataclasses import replace

from PySide6.QtCore import Qt, Slot
from PySide6.QtWidgets import QHeaderView, QTableWidget, QTableWidgetItem, QWidget

from trex_gui.core.translation import tr
from trex_gui.devices.trex.model.apply_to_boards import ApplyToBoards, BoardPlan, BoardStep
from trex_gui.devices.trex.model.boards import BoardList
from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.model.settings.document import SettingsDocument
from trex_gui.devices.trex.settings.comparison import Comparison
from trex_gui.devices.trex.views.boards import board_name
from trex_gui.devices.trex.views.comparison_view import ComparisonView
from trex_gui.devices.trex.views.findings_list import FindingsList, LimitsPrompt
from trex_gui.devices.trex.views.motor_controls import ActionBar
from trex_gui.ui.widgets import builders as ui
from trex_gui.ui.widgets.behaviour import ReusedDialog
from trex_gui.ui.widgets.labels import Note
from trex_gui.ui.widgets.messages import MessageRoom
from trex_gui.ui.widgets.placement import resize_with_font
from trex_gui.ui.widgets.scroll_box import ScrollBox

_LEFT_OUT = {BoardStep.FAILED, BoardStep.SKIPPED}
_CHECKED, _CLEARED = Qt.CheckState.Checked, Qt.CheckState.Unchecked


class ApplyToBoardsDialog(ReusedDialog):
    """Shows what a file changes of each board, then writes it to those that are checked.

    Not modal. Closing it ends the work after the present board, and the window reports the outcome.
    """

    def __init__(self, boards: BoardList, device: Device, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("applyToBoardsDialog")
        resize_with_font(self, 880, 520)
        self._boards = boards
        self._device = device
        self.work = ApplyToBoards(boards, device, self)
        self._name = ""
        self._cleared: set[int] = set()  # boards whose check box the user has cleared
        self._is_filling = False

        text = tr(
            "Each checked board gets these settings, one board after the other, with a snapshot "
            "before. Each keeps its device number and its serial settings. The first error while "
            "writing ends the work."
        )
        intro = ui.label(self, "applyToBoardsIntro", text, wrap=True)
        title = tr("Boards to write to")
        self._table = ui.flat_table(QTableWidget(0, 3, self), "boardsToWrite", title)
        self._table.setHorizontalHeaderLabels([tr("Board"), tr("Changes"), tr("Result")])
        header = self._table.horizontalHeader()
        for column in (0, 1):
            header.setSectionResizeMode(column, QHeaderView.ResizeMode.ResizeToContents)
        header.setStretchLastSection(True)
        self._table.setWordWrap(True)
        self._heading = ui.label(self, "boardChangesTitle", bold=True)
        self._changes = ComparisonView(self)
        self._findings = FindingsList("boards", self._changes, self, is_wide=True)
        self._findings_area = ScrollBox(self._findings, self)
        self._note = ui.named(Note(2, self), "applyToBoardsNote")
        self._question = ui.named(LimitsPrompt(self), "boardsQuestion")
        bar = ActionBar(device, "boardsStopButton", self)
        self._write = ui.button(
            self, "writeBoardsButton", icon="apply", default=True, on_click=self._on_write_clicked
        )
        self._end = ui.button(self, "endBoardsButton", tr("&End after this board"))
        close = ui.button(
            self, "closeBoardsButton", tr("Close"), default=False, on_click=self.close
        )

        tables = (self._table, 2), self._heading, (self._changes, 3), (self._findings_area, 1)
        question = MessageRoom(self, self._question)
        ui.row(bar.stop, 1, self._write, self._end, close, into=bar)
        ui.column(intro, *tables, self._note, question, bar, into=self)

        self._end.clicked.connect(self.work.cancel)
        self._table.itemChanged.connect(self._on_item_changed)
        self._table.currentCellChanged.connect(self._show_changes)
        self.work.changed.connect(self._update)
        self.work.finished.connect(self._on_finished)
        self.rejected.connect(self.work.cancel)
        for changed in (device.link_changed, device.motors.arming_changed):
            changed.connect(self._update)

    def open_file(self, document: SettingsDocument) -> None:
        """Read every board on the line, and show what a file would change of each."""
        if self.work.is_running:
            self.show_in_front()
            return
        self._name = document.name
        self.setWindowTitle(tr("Apply {0} to several boards").format(document.name))
        self._cleared.clear()
        self._note.show_note("")
        self._changes.show_nothing()
        self._heading.setText("")
        if document.settings is None:
            text = tr("This file cannot be used: it has errors. Nothing was changed.")
            self._note.show_note(text, alarming=True)
        else:
            self.work.review(document.settings, [one.number for one in self._boards.boards])
        self._update()
        self.show_in_front()

    def _chosen(self) -> list[int]:
        plans = (plan for plan in self.work.plans if plan.step is BoardStep.REVIEWED)
        writable = (plan.number for plan in plans if plan.to_write)
        return [number for number in writable if number not in self._cleared]

    @Slot()
    def _update(self) -> None:
        self._is_filling = True
        names = {one.number: board_name(one) for one in self._boards.boards}
        plans = self.work.plans
        self._table.setRowCount(len(plans))
        for row, plan in enumerate(plans):
            can_check = plan.step is BoardStep.REVIEWED and bool(plan.to_write)
            texts = (names.get(plan.number, str(plan.number)), *self._texts(plan))
            for column, text in enumerate(texts):
                item = self._table.item(row, column) or QTableWidgetItem()
                item.setText(text)
                if column == 0:
                    checkable = Qt.ItemFlag.ItemIsUserCheckable
                    flags = item.flags() & ~checkable
                    item.setFlags(flags | checkable if can_check else flags)
                    state = _CLEARED if plan.number in self._cleared else _CHECKED
                    role = Qt.ItemDataRole.CheckStateRole
                    item.setData(role, state if can_check else None)  # `None`: no check box
                if self._table.item(row, column) is None:
                    self._table.setItem(row, column, item)
        self._is_filling = False
        self._table.resizeRowsToContents()
        self._update_buttons()
        self._show_changes()

    def _texts(self, plan: BoardPlan) -> tuple[str, str]:
        """Return how many settings change, and how far the board is."""
        changes = ""
        if plan.changes is not None:
            changes = tr("%n setting(s)", "", plan.to_write) if plan.to_write else tr("none")
        read = tr("nothing to write")
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

    def _update_buttons(self) -> None:
        running, chosen = self.work.is_running, self._chosen()
        is_driven = self._device.motors.armed or self._device.may_move
        text = tr("&Write to %n board(s)", "", len(chosen))
        self._write.setText(text if chosen else tr("&Write to boards"))
        can_write = self._device.is_writable and not is_driven
        self._write.setEnabled(bool(chosen) and not running and can_write)
        self._end.setEnabled(running)
        self._question.reconsider()

    @Slot(QTableWidgetItem)
    def _on_item_changed(self, item: QTableWidgetItem) -> None:
        if self._is_filling or item.column() != 0 or item.row() >= len(self.work.plans):
            return
        number = self.work.plans[item.row()].number
        if item.checkState() is _CHECKED:
            self._cleared.discard(number)
        else:
            self._cleared.add(number)
        self._update_buttons()

    @Slot()
    def _show_changes(self) -> None:
        """Show what changes of the board in the current row."""
        plans, row = self.work.plans, self._table.currentRow()
        if not 0 <= row < len(plans):
            row = next((i for i, plan in enumerate(plans) if plan.to_write), -1)
        plan = plans[row] if row >= 0 else None
        findings = () if plan is None else plan.findings
        # Without buttons: what is written is the file, which the user can edit.
        self._findings.show_findings(replace(one, change={}) for one in findings)
        self._findings_area.setVisible(bool(findings))
        if plan is None or plan.changes is None:
            self._heading.setText("")
            self._changes.show_nothing()
            return
        heading = tr("Changes of board {0}").format(plan.number)
        if heading == self._heading.text() and plan.step is not BoardStep.REVIEWED:
            return  # the same rows, which may have been scrolled
        self._heading.setText(heading)
        rows = tuple(one for one in plan.changes.rows if one.after is not None)
        given = Comparison(rows, plan.changes.left_out)
        self._changes.show_comparison(given, tr("Stored"), tr("File"), with_ticks=False)

    @Slot()
    def _on_write_clicked(self) -> None:
        self._note.show_note("")
        self._question.ask_before(lambda: self.work.write(self._chosen()), self._doubts)

    def _doubts(self) -> list[str]:
        """Return the values of the chosen boards of which only the boards can tell."""
        if not self._write.isEnabled():
            return []
        chosen = self._chosen()
        plans = [plan for plan in self.work.plans if plan.number in chosen]
        return list(dict.fromkeys(doubt for plan in plans for doubt in plan.doubts))

    @Slot()
    def _on_finished(self) -> None:
        self._update()
        steps = [plan.step for plan in self.work.plans]
        written = steps.count(BoardStep.WRITTEN)
        if not written and BoardStep.FAILED not in steps and not self.work.was_stopped:
            return
        left_out = [plan for plan in self.work.plans if plan.step in _LEFT_OUT]
        texts = []
        if self.work.was_stopped:
            texts.append(tr("Stop was pressed, which has ended the work."))
        if written:
            texts.append(tr("Written to %n board(s).", "", written))
        if not self.isVisible() and self.work.is_writing:
            for plan in left_out:
                text = tr("Board {0}: {1}").format(plan.number, self._texts(plan)[1])
                texts.append(text if text.endswith(".") else f"{text}.")
            notifier = self._device.notifier
            say = notifier.error if BoardStep.FAILED in steps else notifier.info
            say.emit(" ".join(texts))
        elif left_out:
            text = tr("%n board(s) left out; the reason is beside each.", "", len(left_out))
            texts.append(text)
        self._note.show_note(" ".join(texts), alarming=bool(left_out))
