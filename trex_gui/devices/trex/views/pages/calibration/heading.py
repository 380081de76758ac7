"""Choice of channel and input source, with what is known of both; legend of the curve."""

from PySide6.QtCore import QSignalBlocker, QSize, Qt, Signal, Slot
from PySide6.QtGui import QAccessible, QIcon, QPixmap
from PySide6.QtWidgets import QListWidget, QListWidgetItem, QSizePolicy, QTabBar, QWidget

from trex_gui.core.translation import tr
from trex_gui.devices.trex.calibration.channel_curve import ChannelCurve
from trex_gui.devices.trex.model import channel_text
from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.protocol.flags import CHANNELS, InputSource, channels_in
from trex_gui.devices.trex.protocol.parameters import ParameterKey
from trex_gui.devices.trex.settings.board_records import Known
from trex_gui.ui.theme.icons import icon
from trex_gui.ui.theme.theme import follow_theme
from trex_gui.ui.widgets.builders import button, column, label, named, plain, row
from trex_gui.ui.widgets.labels import ElidedLabel, LegendKey, Note
from trex_gui.ui.widgets.painted import Painted

_KEY = ParameterKey.CHANNEL_INPUT_SOURCE
_AROUND_TEXT = 22  # pixels of a row of the list: frame, margins and icon
_SOURCES = (InputSource.RC, InputSource.ANALOG)


class ChannelList(QListWidget):
    """Two lines for each channel: its number, role and mark (edited or a problem), its input."""

    chosen = Signal(int)  # another channel, 1 to 5

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        named(self, "calibrationChannels", accessible=tr("Channels"))
        self.setUniformItemSizes(True)
        self.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self.setIconSize(QSize(16, 16))
        nothing = QPixmap(self.iconSize())
        nothing.fill(Qt.GlobalColor.transparent)
        self._no_icon = QIcon(nothing)  # keeps the names in one column
        self._inputs = dict.fromkeys(CHANNELS, "")
        self._marks = dict.fromkeys(CHANNELS, (False, ""))
        for channel in CHANNELS:
            QListWidgetItem(self)
            self._show_text(channel)
        self.setCurrentRow(0)
        self.currentRowChanged.connect(self._on_row_changed)
        follow_theme(self, "room", self._take_room)

    def _take_room(self) -> None:
        metrics = self.fontMetrics()
        marks = (tr(", problem"), tr(", edited"))
        names = (self._name(channel, mark) for channel in CHANNELS for mark in marks)
        self.setFixedWidth(max(map(metrics.horizontalAdvance, names)) + _AROUND_TEXT)
        for index in range(self.count()):
            self.item(index).setSizeHint(QSize(0, 2 * metrics.lineSpacing() + 14))
        self._show_icons()

    @property
    def channel(self) -> int:
        return CHANNELS[max(self.currentRow(), 0)]

    def set_input(self, channel: int, text: str) -> None:
        self._inputs[channel] = text
        self._show_text(channel)

    def set_mark(self, channel: int, *, edited: bool, problem: str) -> None:
        self._marks[channel] = (edited, problem)
        self._show_text(channel)
        self._show_icons()

    def _show_text(self, channel: int) -> None:
        edited, problem = self._marks[channel]
        mark = tr(", problem") if problem else tr(", edited") if edited else ""
        text = f"{self._name(channel, mark)}\n{self._inputs[channel]}"
        self.item(CHANNELS.index(channel)).setText(text)

    def _name(self, channel: int, mark: str) -> str:
        return f"{channel}  {tr(channel_text.CHANNEL_NAMES[channel])}{mark}"

    @Slot()
    def _show_icons(self) -> None:
        for row_number, (edited, problem) in enumerate(self._marks.values()):
            name = "warning" if problem else "edited" if edited else ""
            item = self.item(row_number)
            item.setIcon(icon(name) if name else self._no_icon)
            item.setToolTip(plain(problem))

    @Slot(int)
    def _on_row_changed(self, row_number: int) -> None:
        if row_number >= 0:
            self.chosen.emit(CHANNELS[row_number])


class ChannelHeading(QWidget):
    """Name and function of a channel, and the choice between pulses and voltages."""

    source_chosen = Signal(object)  # the input source of the calibrations to show

    def __init__(self, device: Device, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._device = device
        self._title = label(self, "channelTitle", bold=True)
        self._learned = named(ElidedLabel(tr("not learned"), self), "learnedLabel")
        self._learned.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Preferred)
        self._sources = named(QTabBar(self), "sourceTabs", accessible=tr("Input source"))
        self._sources.setDrawBase(False)
        for _ in _SOURCES:
            self._sources.addTab("")
        self._function = named(Note(1, self), "channelDoes")
        line = row(self._title, (self._learned, 1), self._sources, spacing=12)
        column(line, self._function, into=self, margins=0)

        self._sources.currentChanged.connect(self._on_tab_changed)

    def show_channel(
        self,
        channel: int,
        source: InputSource,
        curve: ChannelCurve | None,
        *,
        edited: bool,
        mixed: bool | None,
    ) -> None:
        """Describe a channel; `curve` after Apply. `edited`: Apply changes its calibration."""
        state, active = self._device.state, self._device.calibrations.source
        name = tr(channel_text.CHANNEL_NAMES[channel])
        self._title.setText(tr("Channel {0}: {1}").format(channel, name))
        self._show_sources(source, active)
        self._learned.setVisible(source is active)
        self._function.setVisible(source is active)
        if state is None:
            self._learned.show_text("")
            self._function.show_note("")
            return
        learned = channel in channels_in(state.calibrated)
        text = tr("not learned yet: will be after Apply") if edited else tr("not learned: defaults")
        self._learned.show_text(tr("learned: has its own calibration") if learned else text)
        self._learned.setToolTip(plain(channel_text.learned_text(learned)))
        switches_at = "" if curve is None else channel_text.switching_text(channel, curve, source)
        text = channel_text.function_text(
            channel,
            state.mode,
            joint=self._device.board.is_joint,
            ignored=curve is not None and curve.ignored,
            switches_at=switches_at,
            mixed=mixed,
        )
        self._function.show_note(text)

    def _show_sources(self, shown: InputSource, active: InputSource) -> None:
        names = (tr("RC pulses"), tr("Analog voltages"))
        with QSignalBlocker(self._sources):
            for index, (source, name) in enumerate(zip(_SOURCES, names, strict=True)):
                text = tr("{0} (active)").format(name) if source is active else name
                self._sources.setTabText(index, text)
            self._sources.setCurrentIndex(_SOURCES.index(shown))

    @Slot(int)
    def _on_tab_changed(self, index: int) -> None:
        if index >= 0:
            self.source_chosen.emit(_SOURCES[index])


class OtherSource(QWidget):
    """Explains how to make the board read the other input source, and edits the setting."""

    power_cycle_requested = Signal()

    def __init__(self, device: Device, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._device = device
        self._source = InputSource.ANALOG
        self._text = label(self, "otherSourceWords", wrap=True)
        accessible = tr("Read the other input source")
        self._switch = button(self, "switchSourceButton", icon="calibrate", accessible=accessible)
        title = tr("Ma&ke active…")
        self._cycle = button(self, "switchSourceCycleButton", title, icon="power")
        column(self._text, row(self._switch, self._cycle, 1), into=self, margins=0)

        self._switch.clicked.connect(self._on_switch_clicked)
        self._cycle.clicked.connect(self.power_cycle_requested)

    @Slot()
    def _on_switch_clicked(self) -> None:
        self._device.parameters.edit(_KEY, int(self._source is InputSource.ANALOG))

    def show_source(self, source: InputSource, known: Known | None) -> None:
        """Describe a source that the board does not read; `None`: no calibrations are shown."""
        state, parameters = self._device.state, self._device.parameters
        self._source = source
        if state is None:
            self._text.setText(tr("No board responds."))
            self._switch.hide()
            self._cycle.hide()
            return
        name, wire = tr(channel_text.SOURCE_NAMES[source]), int(source is InputSource.ANALOG)
        is_serial = state.mode.is_serial
        is_edited = parameters.values.value_of(_KEY) == wire
        is_stored = parameters.values.stored.get(_KEY) == wire
        text = channel_text.source_instructions(source, state.mode)
        if is_serial and is_stored and is_edited:
            text = tr("Stored: the board reads {0} after the next power cycle.").format(name)
        elif is_serial and is_edited:
            text = tr("Edited: apply it, then power-cycle the board to read {0}.").format(name)
        values = tr("Its values have not been read yet.")
        if known is not None:
            values = tr("The values below were {0}.").format(channel_text.known_text(known))
        self._text.setText(f"{text} {values}")
        self._switch.setText(tr("Read {0} after the next power cycle").format(name))
        self._switch.setVisible(is_serial and not is_edited)
        self._switch.setEnabled(self._device.is_connected and parameters.values.can_edit(_KEY))
        self._cycle.setVisible(is_serial and is_edited and is_stored)
        self._cycle.setEnabled(self._device.is_connected)


class CurveLegend(Painted):
    """One row: the live dot with its value, the curve, and the stored one while it differs."""

    spoken_role = QAccessible.Role.Grouping

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        named(self, "curveLegend", accessible=tr("Live value"))
        self._live = LegendKey("", "motor2", self, style=None)
        self._curve = LegendKey("", "motor1", self)
        self._stored = LegendKey(tr("stored now"), "muted", self, Qt.PenStyle.DashLine)
        # Values that change must not change the least width of the page.
        self._live.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Preferred)
        row((self._live, 1), self._curve, self._stored, into=self, margins=0, spacing=16)

    def spoken_state(self) -> str:
        return self._live.text()

    def set_live(self, text: str) -> None:
        self._live.show_text(text)

    def set_curves(self, known: bool, *, differs: bool, live: bool) -> None:
        """Name the curves: none, one, or a dashed second one that is stored."""
        self._live.set_color("motor2" if live else "muted")
        self._curve.setVisible(known)
        self._stored.setVisible(known and live and differs)
        present = tr("after Apply") if differs else tr("stored in the board")
        self._curve.setText(present if live else tr("as last seen"))
