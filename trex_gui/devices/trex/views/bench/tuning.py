"""The parameters that a bench test tunes: edit, apply, test again."""

from functools import partial

from PySide6.QtCore import QSignalBlocker, Signal, Slot
from PySide6.QtWidgets import QGroupBox, QLabel, QWidget

from trex_gui.core.errors import BadRequest
from trex_gui.devices.trex.model.bench import Bench
from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.protocol.parameters import motor_name
from trex_gui.devices.trex.views.pages.parameters.editors import Editor, editor_for
from trex_gui.ui.devices.connection_state import ConnectionState
from trex_gui.ui.theme.theme import theme
from trex_gui.ui.widgets.builders import button, column, grid, label

_WIDEST = "127 per 100 ms (127 ms)"


class Tuning(QGroupBox):
    """Editors of one motor's acceleration, brake duration, current limit and P.

    They edit the draft of the Parameters page, and its review comes before writing.

    Signals:
        apply_requested: write the edits.
    """

    apply_requested = Signal()

    def __init__(self, device: Device, bench: Bench, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("benchTuning")
        self._device = device
        self._bench = bench
        self._shown: tuple[str, tuple[str, ...]] | None = None
        self._editors: dict[str, Editor] = {}
        self._names: dict[str, QLabel] = {}

        self._empty = label(
            self, text=self.tr("Connect to a board to see what it stores."), wrap=True
        )
        self._edited = label(self, "benchEdited", wrap=True)
        self._apply = button(
            self,
            "benchApplyButton",
            self.tr("A&pply…"),
            icon="apply",
            tip=self.tr("Review and write all pending edits, these included"),
            default=False,
            on_click=self.apply_requested,
        )
        self._grid = grid(stretch=[(1, 1)])
        self._grid.setVerticalSpacing(3)
        column(self._empty, self._grid, self._edited, 1, self._apply, into=self, spacing=4)

        bench.changed.connect(self._on_changed)
        device.state_changed.connect(self._on_changed)
        device.draft.pending_changed.connect(self._on_changed)
        device.link_changed.connect(self._on_changed)
        theme().changed.connect(self._show_values)
        self._on_changed()

    @Slot()
    def _on_changed(self) -> None:
        """Show the parameters of the planned motor."""
        device, motor = self._device, self._bench.plan.motor
        keys = tuple(key for key in self._bench.tuned_keys() if device.parameters.knows(key))
        shown = device.parameters.model_key, keys
        if shown != self._shown:
            self._shown = shown
            self._make_editors(keys)
        self.setTitle(self.tr("Settings of motor {0}").format(motor))
        self._empty.setVisible(not keys)
        self._show_values()
        can = (
            device.link is ConnectionState.CONNECTED
            and not device.applying
            and not self._bench.is_driving
        )
        for editor in self._editors.values():
            editor.setEnabled(can)
        self._apply.setEnabled(can and device.draft.pending > 0)

    def _make_editors(self, keys: tuple[str, ...]) -> None:
        for widgets in (self._editors, self._names):
            for widget in widgets.values():
                widget.setParent(None)
                widget.deleteLater()
            widgets.clear()
        for row, key in enumerate(keys):
            spec = self._device.parameters.spec_of(key)
            editor = editor_for(spec, self)
            editor.setObjectName(f"bench_{key}")
            editor.setAccessibleName(spec.name)
            editor.setToolTip(f"{spec.description} ({editor.toolTip()})")
            editor.setMinimumWidth(editor.fontMetrics().horizontalAdvance(_WIDEST) + 40)
            # The group names the motor; the long name of P would take half of the window.
            text = spec.name.removeprefix(motor_name(key)).strip()
            name = QLabel(
                text.replace("Current Limit Proportionality Constant ", self.tr("Limit "))
            )
            name.setToolTip(spec.description)
            self._grid.addWidget(name, row, 0)
            self._grid.addWidget(editor, row, 1)
            editor.valueChanged.connect(partial(self._on_edited, key))
            self._editors[key], self._names[key] = editor, name

    def _on_edited(self, key: str, wire: int) -> None:
        try:
            self._device.parameters.edit(key, wire, alone=True)
        except (BadRequest, KeyError):
            self._show_values()  # the board was disconnected meanwhile

    @Slot()
    def _show_values(self) -> None:
        parameters = self._device.parameters
        edited = []
        for key, editor in self._editors.items():
            wire, stored = parameters.value_of(key), parameters.stored_of(key)
            if wire is None:
                continue
            if editor.value() != wire:
                with QSignalBlocker(editor):
                    editor.setValue(wire)
            if parameters.is_modified(key) and stored is not None:
                text = self.tr("{0} (stored: {1})")
                spec = parameters.spec_of(key)
                edited.append(text.format(self._names[key].text(), spec.text(stored)))
        self._edited.setText(self.tr("Not applied: {0}").format(", ".join(edited)))
        self._edited.setVisible(bool(edited))
        palette = self.palette()
        palette.setColor(self._edited.foregroundRole(), theme().color("dirty"))
        self._edited.setPalette(palette)
