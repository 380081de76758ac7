"""The list of the five channels, with their inputs and edits."""

from PySide6.QtCore import QSize, Qt, Signal, Slot
from PySide6.QtGui import QFontMetrics, QIcon, QPixmap
from PySide6.QtWidgets import QListWidget, QListWidgetItem, QWidget

from trex_gui.devices.trex.protocol.channel_text import CHANNEL_NAMES
from trex_gui.devices.trex.protocol.flags import CHANNELS
from trex_gui.ui.theme.icons import icon
from trex_gui.ui.theme.theme import theme


class ChannelList(QListWidget):
    """Two lines for each channel: its number, role and mark (edited or a problem), its input.

    Signals:
        chosen: another channel, 1 to 5.
    """

    chosen = Signal(int)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("calibrationChannels")
        self.setAccessibleName(self.tr("Channels"))
        self.setUniformItemSizes(True)
        self.setVerticalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAsNeeded)
        self.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        metrics = QFontMetrics(self.font())
        self.setIconSize(QSize(16, 16))
        self.setFixedWidth(metrics.horizontalAdvance("5  Auxiliary, edited") + 38)
        nothing = QPixmap(self.iconSize())
        nothing.fill(Qt.GlobalColor.transparent)
        self._no_icon = QIcon(nothing)  # keeps the names in one column
        self._inputs = dict.fromkeys(CHANNELS, "")
        self._marks = dict.fromkeys(CHANNELS, (False, ""))
        for channel in CHANNELS:
            item = QListWidgetItem(self)
            item.setSizeHint(QSize(0, 2 * metrics.lineSpacing() + 14))
            self._show_text(channel)
        self._show_icons()
        self.setCurrentRow(0)
        self.currentRowChanged.connect(self._on_row_changed)
        theme().changed.connect(self._show_icons)

    @property
    def channel(self) -> int:
        """The chosen channel."""
        return CHANNELS[max(self.currentRow(), 0)]

    def set_input(self, channel: int, text: str) -> None:
        """Show the input of a channel."""
        if text != self._inputs[channel]:
            self._inputs[channel] = text
            self._show_text(channel)

    def set_mark(self, channel: int, *, edited: bool, problem: str) -> None:
        """Mark a channel as edited, or as one with a problem."""
        if (edited, problem) != self._marks[channel]:
            self._marks[channel] = (edited, problem)
            self._show_text(channel)
            self._show_icons()

    def _show_text(self, channel: int) -> None:
        edited, problem = self._marks[channel]
        mark = self.tr(", problem") if problem else self.tr(", edited") if edited else ""
        name = f"{channel}  {CHANNEL_NAMES[channel]}{mark}"
        self.item(CHANNELS.index(channel)).setText(f"{name}\n{self._inputs[channel]}")

    @Slot()
    def _show_icons(self) -> None:
        for row, (edited, problem) in enumerate(self._marks.values()):
            name = "warning" if problem else "edited" if edited else ""
            self.item(row).setIcon(icon(name) if name else self._no_icon)
            self.item(row).setToolTip(problem)

    @Slot(int)
    def _on_row_changed(self, row: int) -> None:
        if 0 <= row < len(CHANNELS):
            self.chosen.emit(CHANNELS[row])
