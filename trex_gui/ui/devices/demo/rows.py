"""Rows of a panel, in the same columns in every group: name, slider, value, check boxes."""

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from typing import Generic

from PySide6.QtCore import QCoreApplication, Qt
from PySide6.QtWidgets import QCheckBox, QGroupBox, QLabel, QPushButton, QWidget

from trex_gui.ui.devices.demo.device import DemoDevice, SnapshotT
from trex_gui.ui.widgets.builders import (
    NoWheelComboBox,
    button,
    check_box,
    combo_box,
    grid,
    label,
    named,
    row,
)
from trex_gui.ui.widgets.labels import Note
from trex_gui.ui.widgets.sliders import StickSlider

_NAME, _SLIDER, _VALUE, _TICK = range(4)
_GROOVE = 7  # pixels from the edge of a slider to its groove: half a handle

_NOISE_STEPS = 10  # slider positions per cent
_MAX_NOISE = 5  # per cent of the bytes; with more the line is unusable


@dataclass(frozen=True, slots=True)
class Columns:
    """The longest text of each column, which aligns the groups of a panel."""

    name: str
    value: str
    ticks: tuple[str, ...] = ()


class Rows(QGroupBox, Generic[SnapshotT]):
    """A group of rows.

    Controls are created by methods that connect them to the device and, with `read`, to its
    state. What is created is placed by `add_row`, `add_text` or `add_wide`.

    Attributes:
        controls: everything that takes the focus, in the order of Tab.
    """

    def __init__(self, title: str, columns: Columns, parent: QWidget | None = None) -> None:
        super().__init__(title, parent)
        self.controls: list[QWidget] = []
        self._updates: list[Callable[[SnapshotT], object]] = []
        self._row = 0
        self._grid = grid(self, margins=(8, 4, 8, 6), spacing=(6, 5), stretch=[(_SLIDER, 1)])
        widest = {_NAME: columns.name, _VALUE: columns.value}
        widest |= dict(enumerate(columns.ticks, start=_TICK))
        for column, text in widest.items():
            width = self.fontMetrics().horizontalAdvance(text)
            self._grid.setColumnMinimumWidth(column, width + 2)

    def show_snapshot(self, snapshot: SnapshotT) -> None:
        """Show the state of the device."""
        for update in self._updates:
            update(snapshot)

    def on_snapshot(self, update: Callable[[SnapshotT], object]) -> None:
        """Call `update` with every state."""
        self._updates.append(update)

    # --- Controls -----------------------------------------------------------------------

    def check_box(
        self,
        name: str,
        text: str,
        tip: str,
        on_click: Callable[[bool], object],
        read: Callable[[SnapshotT], bool] | None = None,
        *,
        accessible: str = "",
    ) -> QCheckBox:
        """Create a check box."""
        made = check_box(
            self, name, text, tip=tip, accessible=accessible or text, on_click=on_click
        )
        if read is not None:
            self.on_snapshot(lambda snapshot: made.setChecked(read(snapshot)))
        self.controls.append(made)
        return made

    def button(
        self, name: str, text: str, tip: str, on_click: Callable[[], object], *, icon: str = ""
    ) -> QPushButton:
        """Create a button."""
        made = button(self, name, text, tip=tip, icon=icon, on_click=on_click)
        self.controls.append(made)
        return made

    def combo_box(
        self,
        name: str,
        accessible: str,
        tip: str,
        items: Iterable[tuple[str, object]],
    ) -> NoWheelComboBox:
        """Create a combo box."""
        made = combo_box(self, name, accessible, items=items, tip=tip)
        self.controls.append(made)
        return made

    def slider(
        self,
        name: str,
        accessible: str,
        *,
        highest: float,
        steps: int,
        on_move: Callable[[float], object],
        read: Callable[[SnapshotT], float],
        show: Callable[[float], object],
        lowest: float = 0,
        color: str = "bar",
        tip: str = "",
    ) -> StickSlider:
        """Create a slider with `steps` positions per unit; `show` displays its value."""
        made = StickSlider(
            round(lowest * steps), round(highest * steps), round(lowest * steps), color, self
        )
        named(made, name, accessible=accessible, tip=tip)

        def move(position: int) -> None:
            show(position / steps)
            on_move(position / steps)

        def update(snapshot: SnapshotT) -> None:
            made.follow(round(read(snapshot) * steps))
            show(made.value() / steps)

        made.valueChanged.connect(move)
        self.on_snapshot(update)
        self.controls.append(made)
        return made

    def note(self, name: str, lines: int, read: Callable[[SnapshotT], tuple[str, bool]]) -> None:
        """Add a text over all columns, and whether it is alarming."""
        made = named(Note(lines, self), name)

        def update(snapshot: SnapshotT) -> None:
            text, alarming = read(snapshot)
            made.show_note(text, alarming=alarming)

        self.on_snapshot(update)
        self.add_wide(made)

    # --- Layout -------------------------------------------------------------------------

    def add_headings(self, slider: str, *ticks: str, over_value: bool = False) -> None:
        """Add headings of sliders (and their values) and check boxes."""
        row_number = self._next()
        for column, text in ((_SLIDER, slider), *enumerate(ticks, start=_TICK)):
            heading = QLabel(text, self)
            heading.setAlignment(Qt.AlignmentFlag.AlignHCenter)
            columns = 2 if over_value and column == _SLIDER else 1
            self._grid.addWidget(heading, row_number, column, 1, columns)

    def add_row(
        self, name: str, slider: QWidget, value: QLabel, ticks: Sequence[QWidget] = ()
    ) -> QLabel:
        """Add a row; return the label with the name.

        A widget other than a check box in `ticks` takes the width that is left.
        """
        row_number = self._next()
        made = label(self, text=name, buddy=slider)
        value.setAlignment(Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter)
        for column, widget in enumerate((made, slider, value)):
            self._grid.addWidget(widget, row_number, column)
        for column, tick in enumerate(ticks, start=_TICK):
            if isinstance(tick, QCheckBox):
                self._grid.addWidget(tick, row_number, column, Qt.AlignmentFlag.AlignHCenter)
            else:
                self._grid.addWidget(tick, row_number, column)
                self._grid.setColumnStretch(column, 1)
        return made

    def add_text(self, text: QLabel) -> None:
        """Add a text below the slider of the last row, over slider and value."""
        text.setIndent(_GROOVE)
        self._grid.addWidget(text, self._next(), _SLIDER, 1, 2)

    def add_wide(self, *widgets: QWidget | tuple[QWidget, int]) -> None:
        """Add widgets side by side over all columns, each with its stretch."""
        line = QWidget(self)
        row(*widgets, into=line, margins=0)
        self._grid.addWidget(line, self._next(), 0, 1, -1)

    def _next(self) -> int:
        self._row += 1
        return self._row


@dataclass(frozen=True, slots=True)
class CableTexts:
    """Tool tips of the cable's controls, and the faults that can be caused once.

    Attributes:
        fault_name: object name, accessible name and tool tip of the list of faults.
        faults: text and value of each.
        once: object name, text and tool tip of the button.
    """

    plugged: str
    mute: str
    noise: str
    fault_name: tuple[str, str, str]
    faults: Sequence[tuple[str, object]]
    once: tuple[str, str, str]


def cable_rows(
    device: DemoDevice[SnapshotT],
    prefix: str,
    columns: Columns,
    texts: CableTexts,
    *,
    cause: Callable[[str], object],
    parent: QWidget,
) -> Rows[SnapshotT]:
    """Return the group of the cable; object names begin with `prefix`.

    `cause` is called with the value of the fault that the user causes once.
    """
    rows: Rows[SnapshotT] = Rows(_tr("Cable"), columns, parent)
    plugged = rows.check_box(
        f"{prefix}Cable",
        _tr("Plugged in"),
        texts.plugged,
        device.set_plugged,
        lambda snapshot: snapshot.line.plugged,
        accessible=_tr("Cable plugged in"),
    )
    mute = rows.check_box(
        f"{prefix}Mute",
        _tr("Replies lost"),
        texts.mute,
        device.set_mute,
        lambda snapshot: snapshot.line.mute,
    )
    share = label(rows, f"{prefix}NoiseValue")
    noise = rows.slider(
        f"{prefix}Noise",
        _tr("Noise on the line"),
        highest=_MAX_NOISE,
        steps=_NOISE_STEPS,
        on_move=lambda per_cent: device.set_noise(per_cent / 100),
        read=lambda snapshot: snapshot.line.noise * 100,
        show=lambda per_cent: share.setText(f"{per_cent:.1f}\u00a0%"),
        tip=texts.noise,
    )
    noise.setPageStep(_NOISE_STEPS)
    faults = rows.combo_box(*texts.fault_name, texts.faults)
    once = rows.button(*texts.once, lambda: cause(str(faults.currentData())))

    rows.add_wide((plugged, 1), (mute, 1))
    rows.add_row(_tr("Noise"), noise, share)
    rows.add_wide((faults, 1), (once, 0))

    def enable(snapshot: SnapshotT) -> None:
        for control in rows.controls[1:]:
            control.setEnabled(snapshot.line.plugged)

    rows.on_snapshot(enable)
    return rows


def _tr(text: str) -> str:
    return QCoreApplication.translate("CableRows", text)
