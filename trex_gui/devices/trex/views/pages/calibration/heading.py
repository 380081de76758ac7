"""Above the curve: which channel it is, whether it is learned, what it does, which inputs."""

from PySide6.QtCore import QSignalBlocker, Signal, Slot
from PySide6.QtGui import QResizeEvent
from PySide6.QtWidgets import QHBoxLayout, QLabel, QSizePolicy, QTabBar, QVBoxLayout, QWidget

from trex_gui.devices.trex.client.reading import DeviceState
from trex_gui.devices.trex.model.calibration.channel_curve import ChannelCurve
from trex_gui.devices.trex.protocol import channel_text
from trex_gui.devices.trex.protocol.flags import InputSource, channels_in
from trex_gui.ui.widgets.note import Note

_SOURCES = (InputSource.RC, InputSource.ANALOG)


class ChannelHeading(QWidget):
    """Name and meaning of a channel, and the choice between pulses and voltages.

    Signals:
        source_chosen: the input source whose calibrations are wanted.
    """

    source_chosen = Signal(object)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._title = QLabel(self)
        self._title.setObjectName("channelTitle")
        font = self._title.font()
        font.setBold(True)
        self._title.setFont(font)
        self._flag = ""
        self._learned = QLabel(self)
        self._learned.setObjectName("learnedLabel")
        self._learned.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Preferred)
        self._sources = QTabBar(self)
        self._sources.setObjectName("sourceTabs")
        self._sources.setAccessibleName(self.tr("Input source"))
        self._sources.setDrawBase(False)
        for _ in _SOURCES:
            self._sources.addTab("")
        self._does = Note(1, self)
        self._does.setObjectName("channelDoes")

        line = QHBoxLayout()
        line.addWidget(self._title)
        line.addSpacing(12)
        line.addWidget(self._learned, 1)
        line.addWidget(self._sources)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.addLayout(line)
        layout.addWidget(self._does)

        self._sources.currentChanged.connect(self._on_tab_changed)

    def show_sources(self, shown: InputSource, in_force: InputSource) -> None:
        """Mark the source that the board reads, and choose the one whose values are shown."""
        with QSignalBlocker(self._sources):
            for index, source in enumerate(_SOURCES):
                text = (
                    self.tr("RC pulses") if source is InputSource.RC else self.tr("Analog voltages")
                )
                if source is in_force:
                    text = self.tr("{0} (in force)").format(text)
                self._sources.setTabText(index, text)
            self._sources.setCurrentIndex(_SOURCES.index(shown))
        self._does.setVisible(shown is in_force)

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
        """Say what a channel is; `curve` is what it would be after Apply.

        `edited`: it would have another calibration then. `mixed`: whether the mix jumper is on.
        """
        name = channel_text.CHANNEL_NAMES[channel]
        self._title.setText(self.tr("Channel {0}: {1}").format(channel, name))
        if state is None:
            self._flag = ""
            self._show_flag()
            self._does.show_note("")
            return
        learned = channel in channels_in(state.calibrated)
        in_force = source is state.source
        if learned:
            self._flag = self.tr("learned: has a calibration of its own")
        elif edited:
            self._flag = self.tr("not learned yet: will be after Apply")
        else:
            self._flag = self.tr("not learned: has the factory's values")
        self._learned.setVisible(in_force)
        self._show_flag()
        self._learned.setToolTip(channel_text.learned_words(learned))
        at = ""
        threshold = curve.threshold(channel) if curve is not None else None
        if curve is not None and threshold is not None:
            side = self.tr("above about {0}") if curve.reversed_ else self.tr("below about {0}")
            at = side.format(source.text(threshold))
        ignored = curve is not None and curve.ignored
        self._does.show_note(
            channel_text.what_it_does(
                channel, state.mode, joint=joint, ignored=ignored, switches_at=at, mixed=mixed
            )
        )

    def _show_flag(self) -> None:
        """Say it in full where there is room, else as short as can be."""
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
