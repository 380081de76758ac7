"""Dock of a simulated device, with its state, groups of controls and a reset button."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any, Generic

from PySide6.QtCore import QSize, Qt, Signal, Slot
from PySide6.QtGui import QCloseEvent, QHideEvent, QShowEvent
from PySide6.QtWidgets import (
    QAbstractButton,
    QCheckBox,
    QDockWidget,
    QLabel,
    QPushButton,
    QSizePolicy,
    QWidget,
)

from trex_gui.core.translation import Number, tr
from trex_gui.ui.devices.controller import DeviceController
from trex_gui.ui.devices.simulator import DemoDevice, SnapshotT
from trex_gui.ui.preferences import Preferences
from trex_gui.ui.theme.icons import set_icon
from trex_gui.ui.widgets import builders as ui
from trex_gui.ui.widgets.labels import LiveLabel, Note
from trex_gui.ui.widgets.scroll_box import ScrollBox
from trex_gui.ui.widgets.sliders import StickSlider

_NAME, _SLIDER, _VALUE, _TICK = range(4)

_EXTRA_WIDTH = 34  # pixels, including space for a scroll bar
_NOISE_STEPS = 10  # slider positions per percent
_MAX_NOISE = 5  # percent of the bytes; more noise makes the line unusable


@dataclass(frozen=True, slots=True)
class Columns:
    """Longest text of each column, which aligns the groups of a panel."""

    name: str = ""
    value: str = ""
    ticks: tuple[str, ...] = ()  # columns of check boxes


class Rows(ui.Card, Generic[SnapshotT]):
    def __init__(self, title: str, columns: Columns, parent: QWidget | None = None) -> None:
        super().__init__(title, parent)
        self.controls: list[QWidget] = []  # in Tab order
        self._updates: list[Callable[[SnapshotT], object]] = []
        self._row = 0
        self._grid = ui.grid(self, margins=(4, 4, 2, 6), spacing=(3, 5), stretch=[(_SLIDER, 1)])
        widest = {_NAME: columns.name, _VALUE: columns.value}
        widest |= dict(enumerate(columns.ticks, start=_TICK))
        for column, text in widest.items():
            width = self.fontMetrics().horizontalAdvance(text)
            self._grid.setColumnMinimumWidth(column, width + 2)

    def show_snapshot(self, snapshot: SnapshotT) -> None:
        for update in self._updates:
            update(snapshot)

    def on_snapshot(self, update: Callable[[SnapshotT], object]) -> None:
        self._updates.append(update)

    def check_box(
        self,
        name: str,
        text: str,
        tip: str,
        on_click: Callable[[bool], object],
        read: Callable[[SnapshotT], bool],
        *,
        accessible: str = "",
    ) -> QCheckBox:
        box = ui.check_box(
            self, name, text, tip=tip, accessible=accessible or text, on_click=on_click
        )
        self.on_snapshot(lambda snapshot: box.setChecked(read(snapshot)))
        return box

    def connect_slider(
        self,
        slider: StickSlider,
        on_move: Callable[[float], object],
        read: Callable[[SnapshotT], float],
        show: Callable[[float], object],
    ) -> None:
        """Connect a slider and a value in both directions.

        `on_move` sets the value in the device, `read` returns it, and `show` displays it.
        """
        steps = slider.positions_per_unit

        def move(position: int) -> None:
            show(position / steps)
            on_move(position / steps)

        def update(snapshot: SnapshotT) -> None:
            slider.follow(round(read(snapshot) * steps))
            show(slider.value() / steps)

        slider.valueChanged.connect(move)
        self.on_snapshot(update)

    def add_note(
        self, name: str, lines: int, read: Callable[[SnapshotT], tuple[str, bool]]
    ) -> None:
        """Add a note across all columns. `read` returns its text, and True for an alarm."""
        note = ui.named(Note(lines, self), name)

        def update(snapshot: SnapshotT) -> None:
            text, alarming = read(snapshot)
            note.show_note(text, alarming=alarming)

        self.on_snapshot(update)
        self.add_wide(note)

    def add_headings(self, slider: str, *ticks: str) -> None:
        row_number = self._next()
        for column, text in ((_SLIDER, slider), *enumerate(ticks, start=_TICK)):
            heading = ui.label(self, text=text)
            heading.setAlignment(Qt.AlignmentFlag.AlignHCenter)
            self._grid.addWidget(heading, row_number, column, 1, 2 if column == _SLIDER else 1)

    def add_row(
        self, name: str, slider: QWidget, value: QLabel, ticks: Sequence[QWidget] = ()
    ) -> QLabel:
        """Add a row. Return the label that shows `name`."""
        row_number = self._next()
        label = ui.label(self, text=name, buddy=slider)
        label.setTextFormat(Qt.TextFormat.AutoText)  # markup in `name` may set a number in bold
        if isinstance(slider, StickSlider):
            slider.value_label = value
        value.setAlignment(Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter)
        for column, widget in enumerate((label, slider, value)):
            self._grid.addWidget(widget, row_number, column)
        self.controls += slider, *ticks
        for column, tick in enumerate(ticks, start=_TICK):
            self._grid.addWidget(tick, row_number, column, Qt.AlignmentFlag.AlignHCenter)
        return label

    def add_wide(self, *widgets: QWidget | tuple[QWidget, int]) -> None:
        line = QWidget(self)
        ui.row(*widgets, into=line, margins=0)
        self.controls.append(line)
        self._grid.addWidget(line, self._next(), 0, 1, -1)

    def _next(self) -> int:
        self._row += 1
        return self._row


def add_cable(
    rows: Rows[SnapshotT],
    device: DemoDevice[SnapshotT],
    prefix: str,
    *,
    mute: str,
    noise: str,
    faults: Sequence[tuple[str, object]],
    choice: tuple[str, str, str],
    once: tuple[str, str, str],
    cause: Callable[[str], object],
    before: Sequence[tuple[QWidget, int]] = (),
) -> None:
    """Add controls that disturb the cable.

    `prefix`: prefix of object names. `mute`, `noise`: tool tips. `faults`: texts in the fault
    list, with values for `cause`. `choice`, `once`: object name, text and tool tip of the fault
    list, and of the button that causes the selected fault. `before`: widgets on the left, with
    their stretch.
    """
    mute_box = rows.check_box(
        f"{prefix}Mute",
        tr("Replies lost"),
        mute,
        device.set_mute,
        lambda snapshot: snapshot.line.mute,
    )
    noise_label = LiveLabel(f"{prefix}NoiseValue", tr("Noise on the line"), rows)
    slider = StickSlider(0, _MAX_NOISE * _NOISE_STEPS, 0, "bar", rows)
    ui.named(slider, f"{prefix}Noise", accessible=tr("Noise on the line"), tip=noise)
    slider.positions_per_unit = _NOISE_STEPS
    slider.setPageStep(_NOISE_STEPS)
    rows.connect_slider(
        slider,
        lambda percent: device.set_noise(percent / 100),
        lambda snapshot: snapshot.line.noise * 100,
        lambda percent: noise_label.setText(f"{Number(percent):.1f}\u00a0%"),
    )
    name, text, tip = choice
    fault_list = ui.combo_box(rows, name, text, items=faults, tip=tip)
    name, text, tip = once
    button = ui.button(rows, name, text, tip=tip)
    button.clicked.connect(lambda: cause(str(fault_list.currentData())))

    rows.add_wide(*before, (mute_box, 1))
    rows.add_row(tr("Noise"), slider, noise_label)
    rows.add_wide((fault_list, 1), (button, 0))

    def enable(snapshot: SnapshotT) -> None:
        for control in (mute_box, slider, fault_list, button):
            control.setEnabled(snapshot.line.plugged)

    rows.on_snapshot(enable)


class DemoDock(QDockWidget):
    """Dock that is visible while the simulated device is in use."""

    wanted_changed = Signal(bool)  # new value of `wanted`

    def __init__(
        self,
        name: str,
        key: str,
        controller: DeviceController[Any],
        create: Callable[[QWidget], QWidget],
        parent: QWidget | None = None,
    ) -> None:
        """`key`: preference that stores `wanted`. `create`: called when the dock is first shown."""
        super().__init__(parent)
        self.setObjectName(name)
        self._key = key
        self._create = create
        self._controller = controller
        self._store = Preferences()
        # Widths of the window after and before the dock widened the window.
        self._widened_width = self._original_width = 0
        # True if the dock is visible whenever the device is in use.
        self.wanted = self._store.flag(key, default=True)
        # Queued, because Qt sets its own icons after it emits the signal.
        self.visibilityChanged.connect(self._show_icons, Qt.ConnectionType.QueuedConnection)
        controller.changed.connect(self.show_if_wanted)
        self.hide()

    @Slot()
    def _show_icons(self) -> None:
        """Replace the style's icons, which reappear whenever the dock is detached or docked."""
        for name, icon in (("floatbutton", "float"), ("closebutton", "clear")):
            button = self.findChild(QAbstractButton, f"qt_dockwidget_{name}")
            if button is not None:
                set_icon(button, icon)

    def set_wanted(self, wanted: bool) -> None:
        if wanted != self.wanted:
            self.wanted = wanted
            self._store.set(self._key, wanted)
            self.wanted_changed.emit(wanted)
        self.show_if_wanted()

    @Slot()
    def toggle(self) -> None:
        self.set_wanted(not self.wanted)

    @Slot()
    def show_if_wanted(self) -> None:
        is_shown = self.wanted and self._controller.demo_in_use
        if is_shown and self.isHidden():
            if self.widget() is None:
                # The content scrolls, because the pages need the space on small screens.
                self.setWidget(ScrollBox(self._create, self, sideways=True))
            self._widen_window()
            self.show()
        elif not is_shown and not self.isHidden():
            self.hide_dock()

    def hide_dock(self) -> None:
        """Hide the dock. Restore the window's width if the user has not changed it."""
        window = self.parentWidget()
        unchanged = window is not None and window.width() in {
            self._widened_width,
            window.minimumSizeHint().width(),
        }
        self.hide()
        if window is not None and unchanged and self._original_width:
            if layout := window.layout():
                layout.activate()
            window.resize(self._original_width, window.height())
        self._original_width = 0

    def _widen_window(self) -> None:
        window = self.parentWidget()
        if window is None or self.isFloating() or not window.isVisible() or window.isMaximized():
            return
        free = window.screen().availableGeometry().right() - window.frameGeometry().right()
        self._original_width = window.width()
        self._widened_width = window.width() + max(min(self.sizeHint().width(), free), 0)
        window.resize(self._widened_width, window.height())

    def closeEvent(self, event: QCloseEvent) -> None:
        super().closeEvent(event)
        self.set_wanted(False)


class DemoPanelBody(QWidget, Generic[SnapshotT]):
    """Controls of a simulated device. A subclass calls `arrange` once."""

    def __init__(
        self,
        device: DemoDevice[SnapshotT],
        controller: DeviceController[Any],
        state_name: str,
        state_text: Callable[[SnapshotT], str],
        parent: QWidget | None = None,
    ) -> None:
        """`state_name`: object name of the note that shows the state."""
        super().__init__(parent)
        self._device = device
        self._controller = controller
        self._state_text = state_text
        self._groups: Sequence[Rows[SnapshotT]] = ()
        self._reset: QPushButton | None = None
        self.setSizePolicy(QSizePolicy.Policy.Preferred, QSizePolicy.Policy.Preferred)
        self._state = ui.named(Note(2, self), state_name)

    def arrange(
        self, groups: Sequence[Rows[SnapshotT]], reset: QPushButton, *header: QWidget
    ) -> None:
        """Lay out the panel. Tab visits the groups, then `reset`."""
        self._groups, self._reset = groups, reset
        right = (reset, 0, Qt.AlignmentFlag.AlignRight)
        ui.column(*header, self._state, *groups, right, 1, into=self, margins=3, spacing=6)
        ui.tab_order(*(control for group in groups for control in group.controls), reset)
        self._device.changed.connect(self.refresh)
        self._controller.changed.connect(self.refresh)
        self.refresh()

    def show_header(self, snapshot: SnapshotT | None) -> None:
        """Update the header. `None`: the simulator is not running."""
        raise NotImplementedError

    def sizeHint(self) -> QSize:
        """Return a width close to the minimum, because the pages need the space."""
        return QSize(self.minimumSizeHint().width() + _EXTRA_WIDTH, super().sizeHint().height())

    def showEvent(self, event: QShowEvent) -> None:
        super().showEvent(event)
        self._device.watch(True)
        self.refresh()

    def hideEvent(self, event: QHideEvent) -> None:
        super().hideEvent(event)
        self._device.watch(False)

    @Slot()
    def refresh(self) -> None:
        snapshot = self._device.snapshot
        for widget in (*self._groups, self._reset):
            if widget is not None:
                widget.setEnabled(snapshot is not None)
        self.show_header(snapshot)
        if snapshot is None:
            starting = self._controller.starting or self._controller.port is not None
            text = tr("The Demo {0} is not running. Press Connect.")
            if starting:
                text = tr("The Demo {0} is starting …")
            self._state.show_note(text.format(self._controller.plugin.name), alarming=not starting)
            return
        todo = self._todo(snapshot)
        self._state.show_note(todo or self._state_text(snapshot), alarming=bool(todo))
        for group in self._groups:
            group.show_snapshot(snapshot)

    def _todo(self, snapshot: SnapshotT) -> str:
        if not snapshot.line.plugged:
            return tr("The cable is unplugged. Plug it in, then press Connect.")
        if self._controller.demo_in_use and self._controller.port is None:
            if not snapshot.power:
                return tr("The power is off. Switch it on, then press Connect.")
            return tr("The cable is plugged in again. Press Connect.")
        return ""
