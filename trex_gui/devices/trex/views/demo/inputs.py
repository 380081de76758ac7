"""The five sticks of the simulated board."""

from PySide6.QtCore import QObject, Qt, Slot
from PySide6.QtWidgets import QCheckBox, QLabel, QPushButton, QWidget

from trex_gui.devices.trex.client.explanations import CHANNEL_ROLES
from trex_gui.devices.trex.model.demo.board import DemoBoard
from trex_gui.devices.trex.model.demo.snapshot import STICK_ENDS, DemoChannel, DemoSnapshot
from trex_gui.devices.trex.protocol.flags import CHANNELS, InputSource
from trex_gui.devices.trex.views.demo.words import columns, input_roles
from trex_gui.ui.devices.demo.rows import Rows, side_by_side
from trex_gui.ui.widgets.sliders import StickSlider

_STEPS = {InputSource.RC: 1, InputSource.ANALOG: 100}
"""Slider positions in a µs, and in a V."""

_SINGLE_STEP = {InputSource.RC: 10, InputSource.ANALOG: 5}


class InputRow(QObject):
    """One input: its stick, what that gives, and whether anything arrives at all."""

    def __init__(self, channel: int, board: DemoBoard, rows: Rows[DemoSnapshot]) -> None:
        super().__init__(rows)
        self._channel = channel
        self._board = board
        self._source = InputSource.RC
        low, high = (round(end) for end in STICK_ENDS[InputSource.RC])

        self.slider = StickSlider(low, high, (low + high) // 2, "bar", rows)
        self.slider.setObjectName(f"demoInput{channel}")
        self.slider.setSingleStep(_SINGLE_STEP[InputSource.RC])
        self.slider.setAccessibleName(self.tr("Stick of input {0}").format(channel))
        self.slider.setToolTip(
            self.tr(
                "Input {0}: {1} in RC and analog mode, only measured in serial mode. "
                "A double click centres it."
            ).format(channel, CHANNEL_ROLES[channel])
        )
        self._value = QLabel(rows)
        self._value.setObjectName(f"demoValue{channel}")
        self.silent = QCheckBox(rows)
        self.silent.setObjectName(f"demoNoSignal{channel}")
        self.silent.setAccessibleName(self.tr("No signal at input {0}").format(channel))
        self.silent.setToolTip(
            self.tr("Pull the plug of input {0}: an RC input is invalid 0.1 s later").format(
                channel
            )
        )

        self._name = rows.add_row("", self.slider, self._value, (self.silent,))

        self.slider.valueChanged.connect(self._on_moved)
        self.silent.clicked.connect(self._on_silent_clicked)

    def show_input(self, seen: DemoChannel, source: InputSource, role: str) -> None:
        """Show what the board measures."""
        self._name.setText(f"<b>{self._channel}</b>&ensp;{role}")
        if source is not self._source:
            self._take_source(source)
        self.silent.setChecked(not seen.has_signal)
        self.slider.setEnabled(seen.has_signal)
        value = seen.stick(source)
        if value is None:
            self._value.setText(self.tr("invalid"))
        else:
            self.slider.follow(round(value * _STEPS[source]))
            self._show_value()

    def _take_source(self, source: InputSource) -> None:
        self._source = source
        low, high = (round(end * _STEPS[source]) for end in STICK_ENDS[source])
        self.slider.set_scale(low, high, (low + high) // 2)
        self.slider.setSingleStep(_SINGLE_STEP[source])
        self.slider.setPageStep((high - low) // 10)

    def _show_value(self) -> None:
        value = self.slider.value() / _STEPS[self._source]
        decimals = 0 if self._source is InputSource.RC else 2
        self._value.setText(f"{value:.{decimals}f}\u00a0{self._source.unit}")

    @Slot(int)
    def _on_moved(self, position: int) -> None:
        self._show_value()
        self._board.hold_stick(self._channel, position / _STEPS[self._source])

    @Slot(bool)
    def _on_silent_clicked(self, silent: bool) -> None:
        self._board.set_silent(self._channel, silent)


class DemoInputs(Rows[DemoSnapshot]):
    """A row an input, and who moves the sticks."""

    def __init__(self, board: DemoBoard, parent: QWidget | None = None) -> None:
        super().__init__(columns(), parent)
        self.setTitle(self.tr("Inputs"))
        self._board = board

        self.add_headings("", self.tr("No signal"))
        self._rows = [InputRow(channel, board, self) for channel in CHANNELS]
        self._automatic = QCheckBox(self.tr("Sticks move by themselves"), self)
        self._automatic.setObjectName("demoAutomatic")
        self._automatic.setAccessibleName(self.tr("Sticks move by themselves"))
        self._automatic.setToolTip(
            self.tr("All sticks swing slowly; moving one takes that one in your hand")
        )
        self._centre = QPushButton(self.tr("Centre"), self)
        self._centre.setObjectName("demoCentre")
        self._centre.setAccessibleName(self.tr("Centre all sticks"))
        self._centre.setToolTip(self.tr("Hold all sticks in the middle: what safe-start waits for"))

        self.add_wide(side_by_side(self, (self._automatic, 1), (self._centre, 0)))

        self._automatic.clicked.connect(self._on_automatic_clicked)
        self._centre.clicked.connect(board.centre_sticks)

    def show_snapshot(self, snapshot: DemoSnapshot) -> None:
        """Show what the board measures, and which sticks move by themselves."""
        roles = input_roles(snapshot)
        for row, seen, role in zip(self._rows, snapshot.channels, roles, strict=True):
            row.show_input(seen, snapshot.source, role)
        moving = len(self._board.automatic)
        some = Qt.CheckState.PartiallyChecked if moving else Qt.CheckState.Unchecked
        self._automatic.setCheckState(Qt.CheckState.Checked if moving == len(CHANNELS) else some)

    def controls(self) -> list[QWidget]:
        """Return everything that takes the focus, in the order of Tab."""
        rows = [widget for row in self._rows for widget in (row.slider, row.silent)]
        return [*rows, self._automatic, self._centre]

    @Slot()
    def _on_automatic_clicked(self) -> None:
        # Of a half ticked box, and of one that was not ticked, a click makes a ticked one.
        self._board.set_automatic(len(self._board.automatic) < len(CHANNELS))
