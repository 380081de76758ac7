"""Above the curve: the channel, its function, and the choice of the input source."""

from PySide6.QtCore import QSignalBlocker, Signal, Slot
from PySide6.QtGui import QResizeEvent
from PySide6.QtWidgets import QSizePolicy, QTabBar, QWidget

from trex_gui.devices.trex.client.reading import DeviceState
from trex_gui.devices.trex.model.calibration.channel_curve import ChannelCurve
from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.protocol import channel_text
from trex_gui.devices.trex.protocol.flags import InputSource, channels_in
from trex_gui.devices.trex.protocol.parameters import ParameterKey
from trex_gui.ui.devices.connection_state import ConnectionState
from trex_gui.ui.widgets.builders import button, column, label, named, row
from trex_gui.ui.widgets.labels import Note

_KEY = ParameterKey.CHANNEL_INPUT_SOURCE
_SOURCES = (InputSource.RC, InputSource.ANALOG)


class ChannelHeading(QWidget):
    """Name and meaning of a channel, and the choice between pulses and voltages.

    Signals:
        source_chosen: the input source of the calibrations to show.
    """

    source_chosen = Signal(object)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._flag = ""
        self._title = label(self, "channelTitle", bold=True)
        self._learned = label(self, "learnedLabel")
        self._learned.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Preferred)
        self._sources = named(QTabBar(self), "sourceTabs", accessible=self.tr("Input source"))
        self._sources.setDrawBase(False)
        for _ in _SOURCES:
            self._sources.addTab("")
        self._function = named(Note(1, self), "channelDoes")
        line = row(self._title, (self._learned, 1), self._sources, spacing=12)
        column(line, self._function, into=self, margins=0)

        self._sources.currentChanged.connect(self._on_tab_changed)

    def show_sources(self, shown: InputSource, in_force: InputSource) -> None:
        """Mark the source that the board reads, and select the one that is shown."""
        with QSignalBlocker(self._sources):
            for index, source in enumerate(_SOURCES):
                text = (
                    self.tr("RC pulses") if source is InputSource.RC else self.tr("Analog voltages")
                )
                if source is in_force:
                    text = self.tr("{0} (in force)").format(text)
                self._sources.setTabText(index, text)
            self._sources.setCurrentIndex(_SOURCES.index(shown))
        self._function.setVisible(shown is in_force)

    def show_channel(
        self,
        channel: int,
        state: DeviceState | None,
        curve: ChannelCurve | None,
        source: InputSource,
        *,
        edited: bool,
        joint: bool,
        mixed: bool | None,
    ) -> None:
        """Describe a channel; `curve` is that after Apply.

        `edited`: Apply would change its calibration. `mixed`: whether the mix jumper is on.
        """
        name = channel_text.CHANNEL_NAMES[channel]
        self._title.setText(self.tr("Channel {0}: {1}").format(channel, name))
        if state is None:
            self._flag = ""
            self._show_flag()
            self._function.show_note("")
            return
        learned = channel in channels_in(state.calibrated)
        in_force = source is state.source
        if learned:
            self._flag = self.tr("learned: has its own calibration")
        elif edited:
            self._flag = self.tr("not learned yet: will be after Apply")
        else:
            self._flag = self.tr("not learned: has factory defaults")
        self._learned.setVisible(in_force)
        self._show_flag()
        self._learned.setToolTip(channel_text.learned_words(learned))
        at = ""
        threshold = curve.threshold(channel) if curve is not None else None
        if curve is not None and threshold is not None:
            side = self.tr("above about {0}") if curve.reversed_ else self.tr("below about {0}")
            at = side.format(source.text(threshold))
        ignored = curve is not None and curve.ignored
        self._function.show_note(
            channel_text.what_it_does(
                channel, state.mode, joint=joint, ignored=ignored, switches_at=at, mixed=mixed
            )
        )

    def _show_flag(self) -> None:
        """Show the whole text where there is room, else its first words."""
        room = self._sources.x() - self._learned.x()
        fits = self._learned.fontMetrics().horizontalAdvance(self._flag) < room
        self._learned.setText(self._flag if fits else self._flag.partition(":")[0])

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        self._show_flag()

    @Slot(int)
    def _on_tab_changed(self, index: int) -> None:
        if 0 <= index < len(_SOURCES):
            self.source_chosen.emit(_SOURCES[index])


class OtherSource(QWidget):
    """Explains how to make the board read the other input source, and makes the edit.

    Signals:
        power_cycle_requested: the edit is stored; guide the user through a power cycle.
    """

    power_cycle_requested = Signal()

    def __init__(self, device: Device, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._device = device
        self._source = InputSource.ANALOG
        self._text = label(self, "otherSourceWords", wrap=True)
        self._switch = button(
            self,
            "switchSourceButton",
            icon="calibrate",
            accessible=self.tr("Read the other input source"),
            on_click=self._on_switch_clicked,
        )
        self._cycle = button(
            self,
            "switchSourceCycleButton",
            self.tr("Make active…"),
            icon="power",
            on_click=self.power_cycle_requested,
        )
        column(self._text, row(self._switch, self._cycle, 1), into=self, margins=0)

    def show_source(self, source: InputSource, seen: bool) -> None:
        """Describe a source that the board does not read; `seen`: its calibrations are shown."""
        state = self._device.state
        self._source = source
        name = channel_text.SOURCE_NAMES[source]
        self._switch.setText(self.tr("Read {0} after the next power cycle").format(name))
        if state is None:
            self._text.setText(self.tr("No board responds."))
            self._switch.hide()
            self._cycle.hide()
            return
        parameters, wire = self._device.parameters, int(source is InputSource.ANALOG)
        is_connected = self._device.link is ConnectionState.CONNECTED
        is_edited = parameters.value_of(_KEY) == wire
        is_stored = parameters.stored_of(_KEY) == wire
        text = channel_text.way_to(source, state.mode)
        if state.mode.is_serial and is_stored and is_edited:
            text = self.tr("Stored: the board reads {0} after the next power cycle.").format(name)
        elif state.mode.is_serial and is_edited:
            text = self.tr("Edited: apply it, then power-cycle the board to read {0}.").format(name)
        kept = (
            self.tr("The values below were read earlier.")
            if seen
            else self.tr("Its values have not been read yet.")
        )
        self._text.setText(f"{text} {kept}")
        self._switch.setVisible(state.mode.is_serial and not is_edited)
        self._switch.setEnabled(is_connected and parameters.knows(_KEY))
        self._cycle.setVisible(state.mode.is_serial and is_edited and is_stored)
        self._cycle.setEnabled(is_connected)

    @Slot()
    def _on_switch_clicked(self) -> None:
        self._device.parameters.edit(_KEY, int(self._source is InputSource.ANALOG))
