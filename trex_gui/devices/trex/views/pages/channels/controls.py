"""Controls of one channel: calibration, options and input source."""

from dataclasses import replace
from functools import partial

from PySide6.QtCore import QSignalBlocker, Signal, Slot
from PySide6.QtWidgets import QWidget

from trex_gui.core.translation import tr, tr_noop
from trex_gui.devices.trex.calibration.channel_curve import ChannelCurve
from trex_gui.devices.trex.model import channel_text
from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.model.parameters.parameters import ParameterModel
from trex_gui.devices.trex.protocol.calibration import Calibration
from trex_gui.devices.trex.protocol.flags import InputSource, Mode
from trex_gui.devices.trex.protocol.parameters import ParameterKey
from trex_gui.devices.trex.settings.board_records import Provenance
from trex_gui.devices.trex.views.count_editor import CountEditor
from trex_gui.ui.theme.theme import follow_theme
from trex_gui.ui.widgets import builders as ui
from trex_gui.ui.widgets.bar import NO_VALUE

_SOURCE = ParameterKey.CHANNEL_INPUT_SOURCE


class CalibrationFields(QWidget):
    """Four fields in µs, V or counts. Arrow keys change a value by one count."""

    edited = Signal(object, object)  # valid `Calibration`; key of its undo step, or `None`
    rejected = Signal(str)  # reason why a value is invalid, for the user

    def __init__(self, parent: QWidget) -> None:
        super().__init__(parent)
        self._source = InputSource.RC
        self._calibration: Calibration | None = None
        self._editors: dict[str, CountEditor] = {}
        self._undo_step = object()
        titles = {
            "minimum": tr("&Minimum"),
            "neutral": tr("Ne&utral"),
            "maximum": tr("Ma&ximum"),
            "deadband": tr("Dead&band ±"),
        }
        stretch = [(column, 1) for column in range(len(titles))]
        layout = ui.grid(self, margins=0, spacing=(8, 2), stretch=stretch)
        for column, (field, title) in enumerate(titles.items()):
            accessible = title.replace("&", "")
            editor = ui.named(
                CountEditor(self._source, self), f"{field}Edit", accessible=accessible
            )
            layout.addWidget(ui.label(self, text=title, buddy=editor), 0, column)
            layout.addWidget(editor, 1, column)
            follow_theme(editor, "width", partial(_fit, editor))
            editor.valueChanged.connect(partial(self._on_value_changed, field))
            editor.editingFinished.connect(self._on_step_ended)
            editor.rejected.connect(self.rejected)
            self._editors[field] = editor

    def show_calibration(
        self, source: InputSource, calibration: Calibration | None, *, editable: bool
    ) -> None:
        self._source = source
        self._calibration = calibration
        for field, editor in self._editors.items():
            editor.set_source(source)
            editor.setEnabled(editable and calibration is not None)
            count = getattr(calibration, field) if calibration is not None else 0
            with QSignalBlocker(editor):
                editor.setSpecialValueText(NO_VALUE if calibration is None else "")
                editor.setValue(count)

    def _on_value_changed(self, field: str, count: int) -> None:
        calibration = self._calibration
        if calibration is None:
            return
        edited = replace(calibration, **{field: count})
        if problem := channel_text.wrong_order(edited, self._source):
            self.show_calibration(self._source, calibration, editable=True)
            self.rejected.emit(problem)
        elif self._editors[field].is_stepping:
            self.edited.emit(edited, self._undo_step)
        else:
            self._on_step_ended()
            self.edited.emit(edited, None)

    @Slot()
    def _on_step_ended(self) -> None:
        self._undo_step = object()


def _fit(editor: CountEditor) -> None:
    """Fit the minimum width to a typical value. Qt alone would fit it to the widest value."""
    editor.setMinimumWidth(editor.fontMetrics().horizontalAdvance("0000 µs") + 44)


CHANNEL_OPTIONS = {  # key → title and tool tip
    ParameterKey.REVERSED_CHANNELS: (
        tr_noop("Re&versed"),
        tr_noop("The output changes its sign: forward and reverse are swapped"),
    ),
    ParameterKey.PARABOLIC_CHANNELS: (
        tr_noop("Parab&olic"),
        tr_noop("Gentle near neutral, steep near the ends"),
    ),
    ParameterKey.IGNORED_CHANNELS: (
        tr_noop("I&gnored"),
        tr_noop(
            "Holds the channel at neutral regardless of its input. For channels without a cable"
        ),
    ),
    ParameterKey.REQUIRED_CHANNELS: (
        tr_noop("Re&quired in RC mode"),
        tr_noop("The motors stop when the pulses of this channel are missing for half a second"),
    ),
}


class ChannelOptions(QWidget):
    def __init__(self, parameters: ParameterModel, parent: QWidget) -> None:
        super().__init__(parent)
        self._parameters = parameters
        self._channel = 1
        self._is_editable = False
        self._blocker = ""
        self._boxes = {
            key: ui.check_box(
                self,
                key.removesuffix("_channels") + "Box",
                tr(title),
                accessible=tr(title).replace("&", ""),
                on_toggle=lambda checked, key=key: self._set(key, self._channel, checked),
            )
            for key, (title, _) in CHANNEL_OPTIONS.items()
        }
        ui.row(*self._boxes.values(), 1, into=self, margins=0, spacing=8)
        parameters.dataChanged.connect(self._refresh)
        parameters.modelReset.connect(self._refresh)
        self._refresh()

    def show_channel(
        self, channel: int, source: InputSource, *, editable: bool, blocker: str = ""
    ) -> None:
        """Show the options for an input source. `blocker` is the reason why they are disabled."""
        self._channel, self._is_editable = channel, editable and not blocker
        self._blocker = blocker
        self._boxes[ParameterKey.REQUIRED_CHANNELS].setVisible(source is InputSource.RC)
        self._refresh()

    def curve(self, channel: int, calibration: Calibration | None) -> ChannelCurve | None:
        if calibration is None:
            return None
        return ChannelCurve(
            calibration,
            reversed_=self._bit(ParameterKey.REVERSED_CHANNELS, channel),
            parabolic=self._bit(ParameterKey.PARABOLIC_CHANNELS, channel),
            ignored=self._bit(ParameterKey.IGNORED_CHANNELS, channel),
        )

    def _bit(self, key: str, channel: int, *, stored: bool = False) -> bool:
        """Return a channel's bit in a mask, or false if the mask is unknown."""
        if not self._parameters.values.can_edit(key):
            return False
        read = self._parameters.values.stored.get if stored else self._parameters.values.value_of
        return bool((read(key) or 0) >> (channel - 1) & 1)

    def is_edited(self, channel: int) -> bool:
        return any(self._is_edited(key, channel) for key in self._boxes)

    def _is_edited(self, key: str, channel: int) -> bool:
        return self._bit(key, channel) != self._bit(key, channel, stored=True)

    def restore(self, channel: int) -> None:
        for key in self._boxes:
            self._set(key, channel, self._bit(key, channel, stored=True))

    @Slot()
    def _refresh(self) -> None:
        """Show the options as they will be after Apply. Edited options are bold."""
        for key, box in self._boxes.items():
            with QSignalBlocker(box):
                box.setChecked(self._bit(key, self._channel))
            box.setEnabled(self._is_editable and self._parameters.values.can_edit(key))
            box.setToolTip(ui.plain(self._blocker or tr(CHANNEL_OPTIONS[key][1])))
            ui.set_bold(box, self._is_edited(key, self._channel))

    def _set(self, key: str, channel: int, on: bool) -> None:
        if self._parameters.values.can_edit(key):
            bit = 1 << (channel - 1)
            wire = self._parameters.values.value_of(key) or 0
            self._parameters.edit(key, wire | bit if on else wire & ~bit)


class OtherSource(QWidget):
    power_cycle_requested = Signal()

    def __init__(self, device: Device, parent: QWidget) -> None:
        super().__init__(parent)
        self._device = device
        self._source = InputSource.ANALOG
        self._text = ui.label(self, "otherSourceWords", wrap=True)
        accessible = tr("Read the other input source")
        self._switch = ui.button(
            self, "switchSourceButton", icon="calibrate", accessible=accessible
        )
        title = tr("Ma&ke active…")
        self._cycle = ui.button(self, "switchSourceCycleButton", title, icon="power")
        ui.column(self._text, ui.row(self._switch, self._cycle, 1), into=self, margins=0)

        def on_switch() -> None:
            device.parameters.edit(_SOURCE, int(self._source is InputSource.ANALOG))

        self._switch.clicked.connect(on_switch)
        self._cycle.clicked.connect(self.power_cycle_requested)

    def show_source(self, source: InputSource, mode: Mode, provenance: Provenance | None) -> None:
        """Describe the inactive input source. `provenance` is the origin of its values."""
        parameters = self._device.parameters
        self._source = source
        name, wire = tr(channel_text.SOURCE_NAMES[source]), int(source is InputSource.ANALOG)
        is_serial = mode.is_serial
        is_edited = parameters.values.value_of(_SOURCE) == wire
        is_stored = parameters.values.stored.get(_SOURCE) == wire
        text = channel_text.source_instructions(source, mode)
        if is_serial and is_stored and is_edited:
            text = tr("Stored: the board reads {0} after the next power cycle.").format(name)
        elif is_serial and is_edited:
            text = tr("Edited: apply the change, then power-cycle the board to read {0}.").format(
                name
            )
        values = tr("The values of this input source have not been read yet.")
        if provenance is not None:
            origin = channel_text.provenance_text(provenance)
            values = tr("The values below were {0}.").format(origin)
        self._text.setText(f"{text} {values}")
        self._switch.setText(tr("Read {0} after the next power cycle").format(name))
        self._switch.setVisible(is_serial and not is_edited)
        self._switch.setEnabled(self._device.is_connected and parameters.values.can_edit(_SOURCE))
        self._cycle.setVisible(is_serial and is_edited and is_stored)
        self._cycle.setEnabled(self._device.is_connected)
