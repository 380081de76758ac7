"""Panel of the boards on a line, and a dialog for the device number."""

from functools import partial

from PySide6.QtCore import QObject, Qt, Slot
from PySide6.QtWidgets import QListWidget, QListWidgetItem, QSizePolicy, QWidget

from trex_gui.core.texts import title_of
from trex_gui.core.translation import tr, tr_noop
from trex_gui.devices.trex.discovery import NUMBERS
from trex_gui.devices.trex.model.boards import BoardList, LineBoard, Presence
from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.model.group import BoardGroup
from trex_gui.devices.trex.protocol.parameters import ParameterKey
from trex_gui.devices.trex.settings.comparison import Comparison, compare, settings_after
from trex_gui.devices.trex.views.changes.dialog import Changes, ChangesDialog, Names, Rows, TickedOf
from trex_gui.devices.trex.views.group import GroupDialog
from trex_gui.ui.devices.connection import ConnectionState
from trex_gui.ui.theme.theme import follow_theme
from trex_gui.ui.widgets import builders as ui
from trex_gui.ui.widgets.labels import Muted

_NUMBER = Qt.ItemDataRole.UserRole
_WIDEST_NAME = "00 · TReX Jr 1.2  "
_STATES = {
    Presence.SELECTED: tr_noop("selected"),
    Presence.RESPONDING: tr_noop("responding"),
    Presence.SILENT: tr_noop("not responding"),
    Presence.UNREADABLE: tr_noop("reply unreadable"),
    Presence.UNKNOWN: tr_noop("not scanned yet"),
}


class BoardPanel(QWidget):
    """Panel for selecting a board. It is visible during a scan or with more than one board."""

    def __init__(
        self, boards: BoardList, device: Device, group: BoardGroup, parent: QWidget
    ) -> None:
        super().__init__(parent)
        self.setObjectName("boardPanel")
        self._boards = boards
        self._group = group
        self._device = device
        self._group_dialog: GroupDialog | None = None
        self._number_dialog: NumberDialog | None = None

        self._list = ui.named(QListWidget(self), "boardList", accessible=tr("Boards on this line"))
        self._list.setWordWrap(True)
        self._list.setSpacing(3)
        self._list.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        tip = tr("Click a board, or press Enter, to show it on every page. Motors stop first.")
        self._list.setToolTip(tip)
        self._list.itemClicked.connect(self._on_item_activated)
        self._list.itemActivated.connect(self._on_item_activated)
        self._progress = ui.progress_bar(self, "boardsProgress", tr("Progress of the search"))
        self._progress.setRange(0, NUMBERS)
        button = partial(ui.button, self)
        tip = tr("Search for boards at all device numbers. No settings change")
        self._scan = button(
            "scanBoardsButton", tr("Find boards"), icon="find", tip=tip, on_click=boards.scan
        )
        self._cancel = button("cancelScanButton", tr("Cancel"), on_click=boards.cancel_scan)
        tip = tr("Give the selected board another device number")
        self._change = button("changeNumberButton", tr("Change number…"), icon="edited", tip=tip)
        tip = tr("Drive several boards as one robot, with one pad and one Stop")
        self._drive_together = button("groupButton", tr("Drive together…"), icon="motor", tip=tip)
        alone = tr("Drive alone")
        self._drive_alone = button("partButton", alone, icon="motor", on_click=group.separate)

        title = ui.label(self, "boardsTitle", tr("Boards on this line"), bold=True, wrap=True)
        search = self._progress, self._scan, self._cancel
        commands = self._change, self._drive_together, self._drive_alone
        items = title, (self._list, 1), *search, *commands
        ui.column(*items, into=self, margins=(8, 8, 0, 8))
        self.setSizePolicy(QSizePolicy.Policy.Fixed, QSizePolicy.Policy.Preferred)
        follow_theme(self, "width", self._update_width)

        self._change.clicked.connect(self.change_number)
        self._drive_together.clicked.connect(self.join_boards)
        arming_changed = device.motors.arming_changed
        for changed in (group.changed, boards.changed, device.link_changed, arming_changed):
            changed.connect(self._update)
        self._update()

    @Slot()
    def change_number(self) -> None:
        if self._number_dialog is None:
            self._number_dialog = NumberDialog(self._boards, self._device, self.window())
        self._number_dialog.prompt()

    @property
    def can_join(self) -> bool:
        boards, group = self._boards, self._group
        is_idle = boards.can_change_number and boards.scanned is None
        return is_idle and boards.has_several and group.can_change and not group.devices

    @Slot()
    def join_boards(self) -> None:
        if self._group_dialog is None:
            self._group_dialog = GroupDialog(self._device, self._boards, self._group, self.window())
        self._group_dialog.prompt()

    def _update_width(self) -> None:
        buttons = self._scan, self._change, self._drive_together
        texts = _WIDEST_NAME, *(button.text() for button in buttons)
        width = max(map(self.fontMetrics().horizontalAdvance, texts))
        self.setFixedWidth(width + 5 * self.fontMetrics().height())

    @Slot(QListWidgetItem)
    def _on_item_activated(self, item: QListWidgetItem) -> None:
        self._boards.select(item.data(_NUMBER))
        self._update()  # restores the current item until the other board is read

    @Slot()
    def _update(self) -> None:
        boards, device = self._boards, self._device
        is_open = device.link not in {ConnectionState.DISCONNECTED, ConnectionState.DISCONNECTING}
        is_scanning = boards.scanned is not None
        self.setVisible(is_open and (boards.has_several or is_scanning))
        self._show_boards()
        self._progress.setValue(boards.scanned or 0)
        for widget in (self._progress, self._cancel):
            widget.setVisible(is_scanning)
        self._scan.setVisible(not is_scanning)
        self._scan.setEnabled(boards.can_scan)
        can_change = boards.can_change_number and boards.has_several
        self._change.setEnabled(can_change and not is_scanning)
        self._list.setEnabled(boards.can_select)
        is_group = bool(self._group.devices)
        self._drive_together.setVisible(not is_group and self._group.can_change)
        self._drive_together.setEnabled(self.can_join)
        self._drive_alone.setVisible(is_group and self._group.can_change)
        is_stopped = not device.motors.armed and not device.may_move
        self._drive_alone.setEnabled(device.is_writable and is_stopped)

    def _show_boards(self) -> None:
        """Update the items in place, so that the list keeps its focus and scroll position."""
        boards = self._boards.boards
        tips = {
            Presence.SILENT: tr("The board replied before. Check its power and its wires."),
            Presence.UNREADABLE: tr(
                "More than one board seems to have this number. Switch off all of them "
                "except one, and give that board a different number."
            ),
        }
        while self._list.count() > len(boards):
            self._list.takeItem(self._list.count() - 1)
        while self._list.count() < len(boards):
            QListWidgetItem(self._list)
        for row, board in enumerate(boards):
            item = self._list.item(row)
            item.setData(_NUMBER, board.number)
            item.setText(f"{board.name}\n{self._state_text(board)}")
            is_selected = board.presence is Presence.SELECTED
            font = self._list.font()
            font.setBold(is_selected)
            item.setFont(font)
            item.setToolTip(ui.plain(tips.get(board.presence, "")))
            if is_selected and not self._boards.is_selecting:
                self._list.setCurrentItem(item)

    def _state_text(self, board: LineBoard) -> str:
        device = self._device
        member = self._group.devices.get(board.number)
        if member is not None:
            if member.link is ConnectionState.NOT_RESPONDING:
                return tr("not responding")
            return tr("armed") if device.motors.armed else tr("driven together")
        match board.presence:
            case Presence.SELECTED if self._boards.is_selecting:
                return tr("deselecting …")
            case Presence.SELECTED if device.link is ConnectionState.NOT_RESPONDING:
                return tr("selected, not responding")
            case Presence.SELECTED if device.motors.armed:
                return tr("selected, armed")
            case Presence.SELECTED if device.may_move:
                return tr("selected, may be moving")
        return tr(_STATES[board.presence])


class NumberDialog(QObject):
    """Dialog for a new device number. The main window reports the result."""

    def __init__(self, boards: BoardList, device: Device, parent: QWidget) -> None:
        super().__init__(parent)
        self._boards = boards
        self._device = device
        field = QWidget(parent)
        self._number = ui.spin_box(field, "newNumberField", "", 0, NUMBERS - 1)
        title = ui.label(field, text=tr("&New number:"), buddy=self._number)
        self._problem = ui.named(Muted("", field), "numberKnown")
        ui.row(title, self._number, (self._problem, 1), into=field, margins=0)
        self._dialog = ChangesDialog(
            device,
            parent,
            names=Names("numberDialog", "number", "writeNumberButton", "closeNumberButton"),
            describe=self._describe,
            on_action=self._on_write_clicked,
            refresh_on=(boards.changed, device.link_changed, device.motors.arming_changed),
            above=field,
        )
        self._number.valueChanged.connect(self._dialog.refresh)

    def prompt(self) -> None:
        """Open the dialog with the next free device number."""
        current = self._boards.selected or 0
        taken = {board.number for board in self._boards.boards} | {current}
        numbers = [(current + step) % NUMBERS for step in range(1, NUMBERS)]
        free = (number for number in numbers if number not in taken)
        self._number.setValue(next(free, current))
        self._dialog.reset_and_show()
        self._number.setFocus()
        self._number.selectAll()

    def _describe(self, _ticked_of: TickedOf) -> Changes | None:
        boards, stored, new = self._boards, self._device.draft.stored, self._number.value()
        owner = next((board for board in boards.boards if board.number == new), None)
        problem = "" if owner is None else tr("Taken: {0}.").format(owner.name)
        if new == boards.selected:
            problem = tr("The board already has this number.")
        self._problem.setText(problem)
        if stored is None:
            return None
        after = settings_after(stored, [(ParameterKey.DEVICE_NUMBER, new)])
        text = tr(
            "The line is first searched for the new number. If another board has this "
            "number, nothing is written. A board that is off or uses other serial settings "
            "cannot be found. If the number is free, a snapshot is saved and the new number "
            "is written. It takes effect at once."
        )
        return Changes(
            title_of(tr("Change device nu&mber…")),
            caption=text,
            rows=Comparison(compare(stored, after).differing),
            sides=(tr("Board now"), tr("After", "value")),
            with_ticks=False,
            summary=" ",
            action=tr("&Write number"),
            can_act=boards.can_change_number and not problem,
        )

    def _on_write_clicked(self, _rows: Rows) -> None:
        self._dialog.close()
        self._device.writer.set_device_number(self._number.value())
