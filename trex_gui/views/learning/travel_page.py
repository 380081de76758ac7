"""Every stick to all its ends: how far each channel went, to each side."""

from PySide6.QtCore import Slot
from PySide6.QtWidgets import QGridLayout, QHBoxLayout, QLabel, QVBoxLayout, QWidget

from trex_gui.learning.neutral import no_signal
from trex_gui.learning.travel import Task, Travel, Way
from trex_gui.model.learned_channel import LearnedChannel
from trex_gui.model.learning import Learning
from trex_gui.protocol.calibration import Calibration
from trex_gui.views.learning.parts import Sign, channel_label
from trex_gui.views.widgets.channel_bar import ChannelBar
from trex_gui.views.widgets.note import Note


class TravelPage(QWidget):
    """A row a channel: the live bar with the ends so far as marks, a tick a direction."""

    def __init__(self, learning: Learning, parent: QWidget | None = None) -> None:
        super().__init__(parent)

        self._rows = [_TravelRow(channel, self) for channel in learning.channels]

        grid = QGridLayout()
        grid.setHorizontalSpacing(12)
        grid.setColumnStretch(1, 3)
        grid.setColumnStretch(2, 2)
        for number, row in enumerate(self._rows):
            row.put_into(grid, 2 * number)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.addLayout(grid)
        layout.addStretch(1)

        learning.changed.connect(self._on_changed)
        learning.measured.connect(self._on_changed)
        self._on_changed()

    @Slot()
    def _on_changed(self) -> None:
        for row in self._rows:
            row.refresh()


class _TravelRow:
    """One channel."""

    def __init__(self, channel: LearnedChannel, page: QWidget) -> None:
        self._channel = channel
        self._page = page
        number = channel.number
        self._name = channel_label(number, page)
        self._bar = ChannelBar(page)
        self._bar.setAccessibleName(page.tr("Raw input of channel {0}").format(number))
        self._bar.set_connected(True)
        self._bar.set_source(channel.source)
        self._signs = {way: Sign(page) for way in Way}
        self._reached = QLabel(page)
        self._reached.setObjectName(f"learnTravel{number}")
        self._reached.setWordWrap(True)
        self._problem = Note(1, page)
        self._problem.setObjectName(f"learnProblem{number}")

    def put_into(self, grid: QGridLayout, row: int) -> None:
        told = QHBoxLayout()
        told.addWidget(self._signs[Way.DOWN])
        told.addWidget(self._signs[Way.UP])
        told.addSpacing(4)
        told.addWidget(self._reached, 1)
        grid.addWidget(self._name, row, 0)
        grid.addWidget(self._bar, row, 1)
        grid.addLayout(told, row, 2)
        grid.addWidget(self._problem, row + 1, 1, 1, 2)

    def refresh(self) -> None:
        travel = self._channel.travel
        self._bar.set_raw(self._channel.raw)
        if travel is None:
            self._reached.setText(self._page.tr("Left out: where it rests is not known."))
            self._problem.show_note("")
            return
        if travel.low is not None and travel.high is not None:
            low, high = min(travel.low, travel.neutral), max(travel.high, travel.neutral)
            self._bar.set_calibration(Calibration(low, travel.neutral, high, travel.deadband))
        for way, sign in self._signs.items():
            sign.show_sign("ok" if travel.reached(way) else "", "good")
        self._reached.setText(self._text(travel))
        silent = travel.is_silent
        self._problem.show_note(no_signal(travel.source).text if silent else "", alarming=silent)

    def _text(self, travel: Travel) -> str:
        down, up = travel.reached(Way.DOWN), travel.reached(Way.UP)
        low, high = (travel.source.text(end or 0) for end in (travel.low, travel.high))
        if down and up:
            return self._page.tr("Both ends reached: {0} and {1}.").format(low, high)
        if (down or up) and travel.task is not Task.STICK:
            return self._page.tr("Reached: {0}.").format(low if down else high)
        if down:
            return self._page.tr("Low end reached: {0}. Now the other way.").format(low)
        if up:
            return self._page.tr("High end reached: {0}. Now the other way.").format(high)
        if travel.task is Task.SWITCH:
            return self._page.tr("Not moved yet. Use every position.")
        return self._page.tr("No end reached yet.")
