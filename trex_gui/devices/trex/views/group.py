"""Dialog that joins boards into a group, and the cards of the boards."""

from itertools import product

from PySide6.QtCore import QSize, Slot
from PySide6.QtGui import QResizeEvent
from PySide6.QtWidgets import QBoxLayout, QCheckBox, QLabel, QWidget

from trex_gui.core.texts import title_of
from trex_gui.core.translation import Number, tr
from trex_gui.devices.trex.board.drive_status import drive_statuses
from trex_gui.devices.trex.driving.blockers import DriveBlocker, Effect
from trex_gui.devices.trex.driving.wheels import LEFT, RIGHT, Wheel
from trex_gui.devices.trex.model.boards import BoardList
from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.model.drive_status import drive_inputs
from trex_gui.devices.trex.model.group import BoardGroup
from trex_gui.devices.trex.views.motor_controls import MotorBar
from trex_gui.ui.widgets import builders as ui
from trex_gui.ui.widgets.behaviour import ReusedDialog
from trex_gui.ui.widgets.labels import Muted, Note
from trex_gui.ui.widgets.placement import resize_with_font

_NOT_DRIVEN = 0
_MIN_GAP = 40  # pixels between two boards


class GroupDialog(ReusedDialog):
    def __init__(
        self, device: Device, boards: BoardList, group: BoardGroup, parent: QWidget
    ) -> None:
        super().__init__(parent)
        self._boards, self._group = boards, group
        self._rows: dict[tuple[int, int], tuple[QLabel, ui.ComboBox, QCheckBox]] = {}
        self.setObjectName("groupDialog")
        self.setWindowTitle(title_of(tr("Drive together…")))
        resize_with_font(self, 560, 360)
        about = tr(
            "These boards are armed, driven and stopped together as one robot. If one board "
            "no longer follows, the others stop."
        )
        self._table = QWidget(self)
        self._grid = ui.grid(self._table, margins=0)
        bar = MotorBar(device, "groupStopButton", self)
        self._join = ui.button(
            bar, "joinBoards", tr("&Drive together"), default=True, on_click=self._on_join
        )
        close = ui.button(bar, "closeGroup", tr("Close"), default=False, on_click=self.close)
        bar.fill(bar.armed, 1, close, self._join)
        ui.column(Muted(about, self), self._table, 1, bar, into=self)

    def prompt(self) -> None:
        numbers = [board.number for board in self._boards.boards]
        self._create_rows(numbers)
        proposed = {(wheel.board, wheel.motor): wheel for wheel in self._group.proposed(numbers)}
        for key, (_, side, reversed_box) in self._rows.items():
            wheel = proposed.get(key)
            side.setCurrentIndex(side.findData(_NOT_DRIVEN if wheel is None else wheel.side))
            reversed_box.setChecked(wheel is not None and wheel.is_reversed)
        self.show_in_front()

    def _create_rows(self, numbers: list[int]) -> None:
        for number, motor in product(numbers, (1, 2)):
            if (number, motor) in self._rows:
                continue
            name, key = tr("Board {0}, motor {1}").format(number, motor), f"wheel{number}{motor}"
            sides = (tr("left"), LEFT), (tr("right"), RIGHT), (tr("not driven"), _NOT_DRIVEN)
            side = ui.combo_box(
                self._table, f"{key}Side", name, items=sides, on_change=self._on_changed
            )
            reversed_box = QCheckBox(tr("reversed"), self._table)
            ui.named(reversed_box, f"{key}Reversed", accessible=f"{name}, {tr('reversed')}")
            widgets = ui.label(self._table, text=name), side, reversed_box
            self._rows[number, motor] = widgets
            for column, widget in enumerate(widgets):
                self._grid.addWidget(widget, len(self._rows), column)
        for (number, _), widgets in self._rows.items():
            for widget in widgets:
                widget.setVisible(number in numbers)

    @property
    def wheels(self) -> tuple[Wheel, ...]:
        numbers = {board.number for board in self._boards.boards}
        return tuple(
            Wheel(board, motor, side.currentData(), reversed_box.isChecked())
            for (board, motor), (_, side, reversed_box) in self._rows.items()
            if board in numbers and side.currentData() != _NOT_DRIVEN
        )

    @property
    def _has_several_boards(self) -> bool:
        return len({wheel.board for wheel in self.wheels}) > 1

    @Slot(int)
    def _on_changed(self, _index: int) -> None:
        self._join.setEnabled(self._has_several_boards)

    @Slot()
    def _on_join(self) -> None:
        self.close()
        if self._has_several_boards:  # false if a board has disappeared
            self._group.join(self.wheels)


class SideBySide(QWidget):
    """Widgets in a row, or in a column if the row does not fit."""

    def __init__(self, parent: QWidget) -> None:
        super().__init__(parent)
        self._widgets: list[QWidget] = []
        self._box = ui.column(into=self, margins=0)

    def add(self, widget: QWidget) -> None:
        self._widgets.append(widget)
        self._box.addWidget(widget, 1)
        self._place()

    def remove(self, widget: QWidget) -> None:
        self._widgets.remove(widget)
        self._box.removeWidget(widget)
        widget.deleteLater()
        self._place()

    def minimumSizeHint(self) -> QSize:
        """Return the minimum size of a column, because a row may not fit."""
        widths = [widget.minimumSizeHint().width() for widget in self._widgets]
        return QSize(max(widths, default=0), self._box.minimumSize().height())

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        self._place()

    def _place(self) -> None:
        needed = sum(widget.minimumSizeHint().width() + _MIN_GAP for widget in self._widgets)
        is_wide = len(self._widgets) > 1 and self.width() >= needed
        directions = QBoxLayout.Direction
        self._box.setDirection(directions.LeftToRight if is_wide else directions.TopToBottom)
        self.updateGeometry()


class GroupCards(QWidget):
    """Currents and problems of each board in a group. Without a group, the widget is hidden."""

    def __init__(self, group: BoardGroup, parent: QWidget) -> None:
        super().__init__(parent)
        self.setObjectName("groupCards")
        self._group = group
        self._cards: list[_BoardCard] = []
        self._row = ui.row(into=self, margins=0)
        group.changed.connect(self._on_group_changed)
        self._on_group_changed()

    @Slot()
    def _on_group_changed(self) -> None:
        for card in self._cards:
            card.deleteLater()
        self._cards = [
            _BoardCard(number, device, self) for number, device in self._group.devices.items()
        ]
        for card in self._cards:
            self._row.addWidget(card, 1)
        self.setVisible(bool(self._cards))


class _BoardCard(ui.Card):
    def __init__(self, number: int, device: Device, parent: QWidget) -> None:
        super().__init__(tr("Board {0}").format(number), parent)
        ui.named(self, f"groupBoard{number}", accessible=tr("Board {0}").format(number))
        self._device = device
        self._currents = [ui.label(self, f"groupBoard{number}Motor{m}") for m in (1, 2)]
        self._problem = ui.named(Note(1, self), f"groupBoard{number}Problem")
        ui.column(ui.row(*((label, 1) for label in self._currents)), self._problem, into=self)
        device.telemetry.text_due.connect(self._show)
        device.link_changed.connect(self._show)
        device.main.motors.arming_changed.connect(self._show)
        self._show()

    @Slot()
    def _show(self) -> None:
        device = self._device
        currents = device.telemetry.motor_currents if device.is_connected else None
        for motor, label in enumerate(self._currents, 1):
            wheel = device.wheels.get(motor)
            sides = {LEFT: tr("left"), RIGHT: tr("right")}
            side = tr("not driven") if wheel is None else sides[wheel.side]
            text = "–" if currents is None else f"{Number(currents[motor - 1]):.2f} A"
            label.setText(f"{tr('Motor {0}').format(motor)} ({side}): {text}")
        status = drive_statuses(drive_inputs(device))[0]
        is_normal = status.blocker in {DriveBlocker.RUNNING, DriveBlocker.NOT_ARMED}
        text = tr("no problem") if is_normal else status.text
        self._problem.show_note(text, alarming=status.blocker.effect is Effect.STOPS)
